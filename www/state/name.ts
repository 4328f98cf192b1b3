/** The words for a recipe without a name. */
import type { Parameter } from '../module/types';
import type { Engine } from './engine';
import { applies, recipeOf } from './rules';

/** The parameters that describe a recipe best. If one of them depends on another, only the dependent one is named. */
export function telling(engine: Engine): Parameter[] {
  const recipe = recipeOf(engine);
  const { names } = engine.generator;
  const told = recipe.schema.filter((row) => names.includes(row.key) && applies(row, recipe));
  return told.filter(({ key }) => !told.some(({ shownFor }) => shownFor?.key === key));
}
