/** Recipes as JSON files: `{"program", "version", "link", "recipe", "parameters": {...}}`; `recipe` is what counts. */
import { version } from '../../package.json';
import type { Engine } from '../engine';
import { pageAddress } from '../link';
import { passing } from '../messages';
import type { Parameter } from '../types';
import type { Work } from '../work';
import { t } from './words';

const PROGRAM = 'Bubblestone';

/** Bytes; a link of a thousand points has some ten thousand. */
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

/** Opens a recipe's file; false where it is something else. */
export async function openRecipe(work: Work, file: File): Promise<boolean> {
  const recipe = file.size <= LARGEST ? recipeIn(await file.text()) : undefined;
  if (recipe === undefined) return false;
  work.open(recipe, true);
  passing('files', t('opened', { name: file.name }));
  return true;
}

/** The link that such a file's text holds; undefined where it is something else. */
function recipeIn(text: string): string | undefined {
  try {
    const { program, recipe } = JSON.parse(text) as { program?: unknown; recipe?: unknown };
    return program === PROGRAM && typeof recipe === 'string' ? recipe : undefined;
  } catch {
    return undefined;
  }
}
