/** The work of the visitor's own hand in a recipe: drawn outlines and letters, lines, strokes, spots, and model files. */
import { applies, type Recipe } from '../state/rules';

/** Parameters that decide whether there is an outline, and which body is painted on. */
const AREA = 'tile';
const BODY = 'form';

/**
 * The keys that hold this work, and those that decide whether it is seen. `given` are the values of the recipe's
 * preset, as `key=value`; they are not the visitor's.
 */
export function drawnIn(recipe: Recipe, given: readonly string[]): Set<string> {
  const keys = new Set<string>();
  for (const row of recipe.schema) {
    const [value = ''] = recipe.valuesOf(row.key);
    // Features are numbered by the building, so they mean nothing in another recipe.
    if (row.kind !== 'text' || row.item === 'feature' || value === '' || given.includes(`${row.key}=${value}`) || !applies(row, recipe)) continue;
    keys.add(row.key);
    for (let { shownFor: rule } = row; rule; ) {
      const { key } = rule;
      keys.add(key);
      rule = recipe.schema.find((one) => one.key === key)?.shownFor;
    }
    if (row.item === 'ring' || row.item === 'line') keys.add(AREA);
    if (row.item === 'trace' || row.item === 'patch') keys.add(BODY);
  }
  return keys;
}
