/** The words for a recipe without a name. */
import type { Parameter } from '../module/types';
import type { Engine } from './engine';
import { applies, recipeOf } from './rules';

/** The parameters that tell most of it. One on which another of them depends gives way to that where it applies. */
export function telling(engine: Engine): Parameter[] {
  const recipe = recipeOf(engine);
  const { names } = engine.generator;
  const told = recipe.schema.filter((row) => names.includes(row.key) && applies(row, recipe));
  return told.filter(({ key }) => !told.some(({ shownFor }) => shownFor?.key === key));
}

/** The first of them in a word: that of a choice, or the parameter's own where the choice is yes or no; '' where there is none. */
export function wordOf(engine: Engine): string {
  const [first] = telling(engine);
  if (!first) return '';
  const value = engine.get(first.key);
  return /^\d+$/.test(value) ? first.key : value;
}
