/**
 * The model files inside a recipe's file: their bytes, compressed, as base64 at its end. Writing and reading go piece
 * by piece.
 */
import { findFile, keepFile } from '../module/shelf';
import { piecesOf } from '../module/given';
import { t } from '../words/take';
import type { Task } from '../late/task';
import type { Engine } from '../state/engine';
import { Parts } from './files/parts';

/** The text between a model's description and its bytes. */
const BYTES = '"gzip": "';

/** Bytes of a piece, and characters of its base64. */
const PIECE = 3 << 16;
const TEXT = 4 << 16;

/** The next model's bytes begin within this many bytes after the end of one. */
const HEAD = 4096;

/**
 * Adds the models of a recipe to the text of its file; `text` is a JSON object. Throws an Error with a sentence if a
 * model is missing.
 */
export async function withFiles(text: string, engine: Engine, task: Task): Promise<BlobPart[]> {
  const named = engine.files();
  if (!named.length) return [text];
  if (typeof CompressionStream !== 'function') throw new Error(t('old'));
  const parts: BlobPart[] = [`${text.slice(0, text.lastIndexOf('}')).trimEnd()},\n  "files": [`];
  for (const [k, one] of named.entries()) {
    const file = await findFile(one.digest);
    if (!file) throw new Error(t('no_model', { name: one.name }));
    const head = JSON.stringify({ ...one, size: file.size }).slice(0, -1);
    const packed = await packedText(file, task, (part) => (k + part) / named.length);
    parts.push(`${k > 0 ? ', ' : ''}${head},${BYTES}`, packed, '"}');
  }
  return [...parts, ']\n}\n'];
}

/** The bytes of a file, compressed, as base64; `overall` converts the progress of this file to that of all files. */
async function packedText(file: Blob, task: Task, overall: (part: number) => number): Promise<Blob> {
  const parts = new Parts();
  let read = 0;
  const counted = new TransformStream<Uint8Array<ArrayBuffer>, Uint8Array<ArrayBuffer>>({
    transform: (piece, stream) => {
      task.progress(overall((read += piece.length) / file.size));
      stream.enqueue(piece);
    },
  });
  const packed = from(piecesOf(file)).pipeThrough(counted).pipeThrough(new CompressionStream('gzip'), { signal: task.signal });
  const utf8 = new TextEncoder();
  for await (const piece of inThrees(packed.getReader())) parts.add(utf8.encode(btoa(lettersOf(piece))));
  return parts.file('');
}

/** The text of a recipe's file up to its first model, and the place in the file where that model's bytes begin. */
export function headOf(bytes: Uint8Array): { text: string; at: number | undefined } {
  const at = new TextDecoder('latin1').decode(bytes).indexOf(BYTES);
  if (at < 0) return { text: new TextDecoder().decode(bytes), at: undefined };
  const begin = at + BYTES.length;
  const text = new TextDecoder().decode(bytes.subarray(0, begin));
  // Older files have a single model instead of a list.
  return { text: `${text}"}${text.includes('"files": [') ? ']' : ''}}`, at: begin };
}

/** Stores the models of a recipe's file, so that the recipe finds them. The engine checks their digests. */
export async function keepFiles(file: Blob, at: number, first: object): Promise<void> {
  let next: { head: object; at: number } | undefined = { head: first, at };
  while (next) {
    await keepOne(file, next.at, next.head);
    next = await following(file, next.at);
  }
}

async function keepOne(file: Blob, at: number, { digest, name }: { digest?: unknown; name?: unknown }): Promise<void> {
  if (typeof digest !== 'string' || typeof name !== 'string') return;
  const unpacked = from(bytesFrom(file, at)).pipeThrough(new DecompressionStream('gzip'));
  await keepFile(digest, name, await new Response(unpacked).blob());
}

/** The model after the one whose bytes begin at `begin`; undefined after the last one. */
async function following(file: Blob, begin: number): Promise<{ head: object; at: number } | undefined> {
  for (let at = begin; at < file.size; at += TEXT) {
    const text = new TextDecoder('latin1').decode(await file.slice(at, at + TEXT).arrayBuffer());
    const end = text.indexOf('"');
    if (end < 0) continue;
    const behind = at + end + 1;
    const bytes = new Uint8Array(await file.slice(behind, behind + HEAD).arrayBuffer());
    const found = new TextDecoder('latin1').decode(bytes).indexOf(BYTES);
    if (found < 0) return undefined;
    const length = found + BYTES.length;
    const head = new TextDecoder().decode(bytes.subarray(0, length)).replace(/^\}\s*,\s*/, '');
    return { head: JSON.parse(`${head}"}`) as object, at: behind + length };
  }
  return undefined;
}

/** The bytes that a base64 text in a file encodes, up to its closing quote. */
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

/** Pieces whose length is a multiple of three bytes, as base64 needs. */
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
  // String.fromCharCode takes at most about 65,000 arguments; 8192 are safe in every browser.
  for (let at = 0; at < bytes.length; at += 8192) letters += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return letters;
}
