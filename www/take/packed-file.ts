/**
 * The model files inside a recipe's file: their bytes, compressed, as base64 at its end. Writing and reading go piece
 * by piece. Such a file may come from anyone, so a model is kept only if it is the one that the recipe names.
 */
import { addFile, findFile } from '../module/shelf';
import { loadWhole } from '../module/load';
import type { Whole } from '../module/scene';
import { piecesOf } from '../module/given';
import { t } from '../words/take';
import { moreWords } from '../base/language';
import type { Task } from '../late/task';
import type { Engine } from '../state/engine';
import { FileParts } from './files/parts';

/** The text between a model's description and its bytes. */
const BYTES = '"gzip": "';

/** Bytes of a piece, and characters of its base64. */
const PIECE = 3 << 16;
const TEXT = 4 << 16;

/** Compressed bytes that are unpacked at a time: they become at most a thousand times as many. */
const PACKED = 1 << 13;

/** The most bytes of a model, as when it is opened by itself. */
const LARGEST = 400_000_000;

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
  const parts = new FileParts();
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

/** A model as a recipe's file describes it. */
interface Described {
  digest: string;
  name: string;
  size: number;
}

/** Names of models in a file: those that differ from their description, and those for which there was no room. */
export interface Unpacked {
  wrong: string[];
  unkept: string[];
}

/**
 * Stores the models of a recipe's file that the recipe names and that are not here yet. No stored file is replaced or
 * deleted for it. Throws an error when the task is stopped, or if the module does not load.
 */
export async function keepFiles(file: Blob, at: number, first: object, recipe: string, task: Task): Promise<Unpacked> {
  const [module] = await Promise.all([loadWhole(), moreWords()]);
  const asked = namedBy(module, recipe);
  const became: Unpacked = { wrong: [], unkept: [] };
  let next: { head: object; at: number } | undefined = { head: first, at };
  while (next) {
    const model = describedBy(next.head);
    if (model && asked.delete(model.digest) && !(await findFile(model.digest))) {
      const unpacked = await checked(module, bytesFrom(file, next.at), model, task);
      if (!unpacked) became.wrong.push(model.name);
      else if (!(await addFile(model.digest, model.name, unpacked))) became.unkept.push(model.name);
    }
    next = await following(file, next.at);
  }
  return became;
}

/** The digests of the files that a recipe names. */
function namedBy(module: Whole, recipe: string): Set<string> {
  const studio = new module.Bubblestone(recipe);
  try {
    return new Set(studio.recipeFiles().map(({ digest }) => digest));
  } finally {
    studio.free();
  }
}

function describedBy({ digest, name, size }: Partial<Record<keyof Described, unknown>>): Described | undefined {
  return typeof digest === 'string' && typeof name === 'string' && typeof size === 'number' ? { digest, name, size } : undefined;
}

/** Unpacks a model; undefined if its size or its digest is not the one described. No more than its size is unpacked. */
async function checked(module: Whole, packed: AsyncGenerator<Uint8Array<ArrayBuffer>>, { digest, size }: Described, task: Task): Promise<Blob | undefined> {
  if (!Number.isInteger(size) || size < 0 || size > LARGEST) return undefined;
  const own = new module.FileDigest(size);
  const parts = new FileParts();
  const reader = from(packed).pipeThrough(new DecompressionStream('gzip')).getReader();
  try {
    for (let read = 0; ; ) {
      const { done, value } = await reader.read();
      task.signal.throwIfAborted();
      if (done) return read === size && own.text() === digest ? parts.file('') : undefined;
      read += value.length;
      if (read > size) return undefined;
      own.add(value);
      parts.add(value);
      task.progress(read / size);
    }
  } catch {
    task.signal.throwIfAborted();
    return undefined;
  } finally {
    own.free();
    void reader.cancel().catch(() => undefined);
  }
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
    return { head: parsed(`${head}"}`), at: behind + length };
  }
  return undefined;
}

/** The object that a text describes; an empty one if it describes none. */
function parsed(text: string): object {
  try {
    return Object(JSON.parse(text)) as object;
  } catch {
    return {};
  }
}

/** The bytes that a base64 text in a file encodes, up to its closing quote. */
async function* bytesFrom(file: Blob, begin: number): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  for (let at = begin; at < file.size; at += TEXT) {
    const text = new TextDecoder('latin1').decode(await file.slice(at, at + TEXT).arrayBuffer());
    const end = text.indexOf('"');
    const bytes = Uint8Array.from(atob(end < 0 ? text : text.slice(0, end)), (letter) => letter.charCodeAt(0));
    for (let from = 0; from < bytes.length; from += PACKED) yield bytes.subarray(from, from + PACKED);
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
