/**
 * Files that are opened as a recipe: JSON files `{"program", "version", "link", "recipe", "parameters": {...}}`,
 * of which `recipe` is what counts, and pictures and drawings that were saved here.
 */
import { version } from '../../package.json';
import type { Parameter } from '../module/types';
import { t } from '../words/take';
import { passing } from '../base/messages';
import type { Engine } from '../state/engine';
import { pageAddress } from '../state/link';
import type { Work } from '../state/work';
import { originIn, PROGRAM } from './origin';

/** Of a file so many bytes are read; a link of a thousand points has some ten thousand. */
const LARGEST = 200_000;

export function recipeFile(engine: Engine): Blob {
  const recipe = engine.link();
  const parameters = Object.fromEntries(engine.schema.map((parameter) => [parameter.key, valueOf(parameter, engine.get(parameter.key))]));
  const text = JSON.stringify({ program: PROGRAM, version, link: pageAddress(recipe), recipe, parameters }, null, 2);
  return new Blob([`${text}\n`], { type: 'application/json' });
}

function valueOf({ kind }: Parameter, text: string): string | number {
  return kind === 'number' || kind === 'int' ? Number(text) : text;
}

/** Opens the recipe that a file holds; false where it is something else. */
export async function openRecipe(work: Work, file: File): Promise<boolean> {
  const bytes = new Uint8Array(await file.slice(0, LARGEST).arrayBuffer());
  const origin = originIn(bytes);
  const recipe = origin === undefined ? recipeIn(new TextDecoder().decode(bytes)) : origin.replace(/^[^#]*#?/, '');
  if (recipe === undefined) return false;
  work.open(recipe, { own: true });
  passing('files', t('opened', { name: file.name }));
  return true;
}

/** The link that a recipe's file holds; undefined where it is something else. */
function recipeIn(text: string): string | undefined {
  try {
    const { program, recipe } = JSON.parse(text) as { program?: unknown; recipe?: unknown };
    return program === PROGRAM && typeof recipe === 'string' ? recipe : undefined;
  } catch {
    return undefined;
  }
}
