/** The file of a model inside a recipe's file: its bytes, compressed, as text, at the end. Both ways work piece by piece. */
import { findFile, keepFile } from '../module/shelf';
import { piecesOf } from '../module/given';
import { t } from '../words/take';
import type { Task } from '../late/task';
import type { Engine } from '../state/engine';
import { filesOf } from '../state/rules';
import { Parts } from './files/parts';

/** Between what tells of the file and its bytes. */
const BYTES = '"gzip": "';

/** Bytes of a piece, and of its text. */
const PIECE = 3 << 16;
const TEXT = 4 << 16;

/** The file that a recipe names: its digest as 16 hex digits, and its name. */
function named(engine: Engine): { digest: string; name: string } | undefined {
  const [row] = filesOf(engine).flatMap(({ key }) => engine.list(key));
  if (!row) return undefined;
  const digest = row.slice(0, 4).map((number) => number.toString(16).padStart(4, '0'));
  return { digest: digest.join(''), name: String.fromCodePoint(...row.slice(4)) };
}

/** The text of a recipe's file with that of the model at its end; `text` is that of an object. Throws a sentence where it is not to be had. */
export async function withModel(text: string, engine: Engine, task: Task): Promise<BlobPart[]> {
  const model = named(engine);
  if (!model) return [text];
  const file = await findFile(model.digest);
  if (!file) throw new Error(t('no_model', { name: model.name }));
  if (typeof CompressionStream !== 'function') throw new Error(t('old'));
  const head = JSON.stringify({ ...model, size: file.size }).slice(0, -1);
  const parts = new Parts();
  let read = 0;
  const told = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
    transform: (piece, stream) => {
      task.progress((read += piece.length) / file.size);
      stream.enqueue(piece);
    },
  });
  const packed = from(piecesOf(file)).pipeThrough(told).pipeThrough(new CompressionStream('gzip'), { signal: task.signal });
  const utf8 = new TextEncoder();
  for await (const piece of inThrees(packed.getReader())) parts.add(utf8.encode(btoa(lettersOf(piece))));
  return [`${text.slice(0, text.lastIndexOf('}')).trimEnd()},\n  "file": ${head},${BYTES}`, parts.file(''), '"}\n}\n'];
}

/** The text of a recipe's file as far as it can be read at once, and where in the file the model's bytes begin. */
export function headOf(bytes: Uint8Array): { text: string; at: number | undefined } {
  const at = new TextDecoder('latin1').decode(bytes).indexOf(BYTES);
  if (at < 0) return { text: new TextDecoder().decode(bytes), at: undefined };
  const begin = at + BYTES.length;
  return { text: `${new TextDecoder().decode(bytes.subarray(0, begin))}"}}`, at: begin };
}

/** Keeps the model of a recipe's file, so that the recipe finds it. Whether it is what it should be the engine sees. */
export async function keepModel(file: Blob, at: number, { digest, name }: { digest?: unknown; name?: unknown }): Promise<void> {
  if (typeof digest !== 'string' || typeof name !== 'string') return;
  const unpacked = from(bytesFrom(file, at)).pipeThrough(new DecompressionStream('gzip'));
  await keepFile(digest, name, await new Response(unpacked).blob());
}

/** The bytes that a text in a file stands for, up to its end. */
async function* bytesFrom(file: Blob, begin: number): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  for (let at = begin; at < file.size; at += TEXT) {
    const text = new TextDecoder('latin1').decode(await file.slice(at, at + TEXT).arrayBuffer());
    const end = text.indexOf('"');
    yield Uint8Array.from(atob(end < 0 ? text : text.slice(0, end)), (letter) => letter.charCodeAt(0));
    if (end >= 0) return;
  }
}

function from(pieces: AsyncGenerator<Uint8Array<ArrayBuffer>>): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new ReadableStream({
    pull: async (stream) => {
      const next = await pieces.next();
      if (next.done) stream.close();
      else stream.enqueue(next.value);
    },
  });
}

/** Pieces of whole threes of bytes, which texts of four letters stand for. */
async function* inThrees(reader: ReadableStreamDefaultReader<Uint8Array<ArrayBuffer>>): AsyncGenerator<Uint8Array> {
  const held = new Uint8Array(PIECE);
  let filled = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    for (let at = 0; at < value.length; ) {
      const some = value.subarray(at, at + PIECE - filled);
      held.set(some, filled);
      filled += some.length;
      at += some.length;
      if (filled < PIECE) continue;
      yield held;
      filled = 0;
    }
  }
  yield held.subarray(0, filled);
}

function lettersOf(bytes: Uint8Array): string {
  let letters = '';
  // A call of String.fromCharCode takes at most about 65,000 arguments; 8192 are safe in every browser.
  for (let at = 0; at < bytes.length; at += 8192) letters += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return letters;
}
