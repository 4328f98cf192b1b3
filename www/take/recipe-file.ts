/**
 * Files that open as a recipe. They are JSON files `{"program", "version", "link", "recipe", "parameters": {...}}`
 * with the model files that the recipe needs, and pictures and drawings saved here. Only `recipe` is read from the
 * JSON, besides the models.
 */
import { version } from '../../package.json';
import type { Parameter } from '../module/types';
import { t } from '../words/take';
import { notice } from '../base/messages';
import { stoppable, type Task } from '../late/task';
import type { Engine } from '../state/engine';
import { pageAddress } from '../state/link';
import type { Work } from '../state/work';
import { originIn, PROGRAM } from './origin';
import { headOf, keepFiles, withFiles, type Unpacked } from './packed-file';

/** The most bytes that are read of a file, besides its models. A link of a thousand points has some ten thousand. */
const LARGEST = 200_000;

/** Throws an Error with a sentence if the file cannot be made. */
export async function recipeFile(engine: Engine, task: Task): Promise<Blob> {
  const recipe = engine.link();
  const parameters = Object.fromEntries(engine.schema.map((parameter) => [parameter.key, valueOf(parameter, engine.get(parameter.key))]));
  const text = JSON.stringify({ program: PROGRAM, version, link: pageAddress(recipe), recipe, parameters }, null, 2);
  return new Blob(await withFiles(`${text}\n`, engine, task), { type: 'application/json' });
}

function valueOf({ kind }: Parameter, text: string): string | number {
  return kind === 'number' || kind === 'int' ? Number(text) : text;
}

/** Stops the opening that goes on now. */
let now: AbortController | undefined;

/** Opens the recipe that a file holds; false if the file is something else. */
export async function openRecipe(work: Work, file: File): Promise<boolean> {
  const bytes = new Uint8Array(await file.slice(0, LARGEST).arrayBuffer());
  const origin = originIn(bytes);
  const { text, at } = headOf(bytes);
  const inside = origin === undefined ? recipeIn(text) : { recipe: origin.replace(/^[^#]*#?/, ''), file: undefined };
  if (!inside) return false;
  const { recipe, file: model } = inside;
  now?.abort();
  const stopping = (now = new AbortController());
  const { name } = file;
  const found = model && at !== undefined ? unpacked(stopping, name, (task) => keepFiles(file, at, model, recipe, task)) : NOTHING;
  const { wrong, unkept } = await found;
  if (stopping.signal.aborted) {
    if (stopping === now) notice('files', t('not_opened', { name }));
    return true;
  }
  work.open(recipe, { own: true });
  const told = [...wrong.map((model) => t('model_wrong', { name, model })), ...unkept.map((model) => t('model_unkept', { model }))];
  notice('files', t('opened', { name }), ...told);
  return true;
}

const NOTHING: Unpacked = { wrong: [], unkept: [] };

/** Shows the unpacking of models with its progress. If it fails as a whole, the page asks the visitor for the models. */
async function unpacked(stopping: AbortController, name: string, work: (task: Task) => Promise<Unpacked>): Promise<Unpacked> {
  return stoppable({ topic: 'files', sentence: t('opening', { name }), name, stop: t('stop') }, stopping, work).catch(() => NOTHING);
}

/**
 * The link that a recipe's file holds, and the description of its first model; undefined if the file is something
 * else.
 */
function recipeIn(text: string): { recipe: string; file: object | undefined } | undefined {
  try {
    const { program, recipe, file, files } = JSON.parse(text) as { program?: unknown; recipe?: unknown; file?: unknown; files?: unknown };
    const first: unknown = Array.isArray(files) ? files[0] : file;
    return program === PROGRAM && typeof recipe === 'string' ? { recipe, file: first instanceof Object ? first : undefined } : undefined;
  } catch {
    return undefined;
  }
}
