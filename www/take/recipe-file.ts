/**
 * Files that open as a recipe. These are JSON files `{"program", "version", "link", "recipe", "parameters": {...}}`,
 * of which `recipe` is read, together with the files of the models that it names; and saved pictures and drawings.
 */
import { version } from '../../package.json';
import type { Parameter } from '../module/types';
import { t } from '../words/take';
import { passing } from '../base/messages';
import type { Task } from '../late/task';
import type { Engine } from '../state/engine';
import { pageAddress } from '../state/link';
import type { Work } from '../state/work';
import { originIn, PROGRAM } from './origin';
import { headOf, keepFiles, withFiles } from './packed-file';

/** The most bytes that are read, apart from the models inside; a link of a thousand points has about ten thousand. */
const LARGEST = 200_000;

/** Throws a sentence if it cannot be made. */
export async function recipeFile(engine: Engine, task: Task): Promise<Blob> {
  const recipe = engine.link();
  const parameters = Object.fromEntries(engine.schema.map((parameter) => [parameter.key, valueOf(parameter, engine.get(parameter.key))]));
  const text = JSON.stringify({ program: PROGRAM, version, link: pageAddress(recipe), recipe, parameters }, null, 2);
  return new Blob(await withFiles(`${text}\n`, engine, task), { type: 'application/json' });
}

function valueOf({ kind }: Parameter, text: string): string | number {
  return kind === 'number' || kind === 'int' ? Number(text) : text;
}

/** Opens the recipe in a file; false if the file has none. */
export async function openRecipe(work: Work, file: File): Promise<boolean> {
  const bytes = new Uint8Array(await file.slice(0, LARGEST).arrayBuffer());
  const origin = originIn(bytes);
  const { text, at } = headOf(bytes);
  const inside = origin === undefined ? recipeIn(text) : { recipe: origin.replace(/^[^#]*#?/, ''), file: undefined };
  if (!inside) return false;
  const { recipe, file: model } = inside;
  // If the model is missing or broken, the page asks for it.
  if (model && at !== undefined) await keepFiles(file, at, model).catch(() => undefined);
  work.open(recipe, { own: true });
  passing('files', t('opened', { name: file.name }));
  return true;
}

/** The link in a recipe's file, and the description of its first model; undefined if it is not such a file. */
function recipeIn(text: string): { recipe: string; file: object | undefined } | undefined {
  try {
    const { program, recipe, file, files } = JSON.parse(text) as { program?: unknown; recipe?: unknown; file?: unknown; files?: unknown };
    const first: unknown = Array.isArray(files) ? files[0] : file;
    return program === PROGRAM && typeof recipe === 'string' ? { recipe, file: first instanceof Object ? first : undefined } : undefined;
  } catch {
    return undefined;
  }
}
