/**
 * Chance throws parameters within the ranges of a table (ranges.ts). The picture's side and parameters that serve only
 * comparison keep their values.
 *
 * Each group has a table of ranges with weights. A row may depend on the rows before it. A parameter without effect in
 * the new recipe gets its default, so that links stay short.
 */
import type { Parameter } from '../module/types';
import { applies, type Recipe } from '../state/rules';

/** Words with their weights. */
export type Weights = Record<string, number>;

interface Range {
  from: number;
  to: number;
  step: number;
  /** The usual value, and the share of throws that take it. */
  plain?: [value: number, part: number];
  /** The range is a multiple of this parameter's value. */
  per?: 'cs' | 'size';
}

/** A row applies where each of these parameters has one of these words. The first row of a key that applies counts. */
export type When = Partial<Record<string, readonly string[]>>;

export type Row = readonly [key: string, pick: Weights | Range | '', when?: When];

/** Rows by group, in the order of randomising: later rows depend on earlier ones. */
export type Table = Record<string, readonly Row[]>;

/** The cells stay stones, or stay skin, unless all of these groups are randomised. */
const FAMILY = ['Cells', 'Relief', 'Surface'];

export const range = (from: number, to: number, step: number, more: Pick<Range, 'plain' | 'per'> = {}): Range => ({ from, to, step, ...more });
/** A value that is mostly 0. */
export const rarely = (part: number, from: number, to: number, step = 0.05): Range => range(from, to, step, { plain: [0, 1 - part] });

/**
 * New values of these groups by a table, except for the keys in `stay`. `random` returns numbers in 0..1, and `get` a
 * parameter's present value. A parameter without effect in the new recipe gets its default, so that links stay short.
 */
export function thrown(
  table: Table,
  random: () => number,
  groups: readonly string[],
  schema: readonly Parameter[],
  get: (key: string) => string,
  stay: ReadonlySet<string> = new Set(),
): [key: string, text: string][] {
  const values = new Map<string, string>();
  const now = (key: string): string => values.get(key) ?? get(key);
  if (groups.includes('Relief') && schema.some(({ key }) => key === 'stone')) values.set('stone', stone(random, FAMILY.every((group) => groups.includes(group)), get('stone')));
  for (const [group, rows] of Object.entries(table)) {
    if (!groups.includes(group)) continue;
    const done = new Set<string>();
    for (const [key, pick, when = {}] of rows) {
      if (done.has(key) || stay.has(key) || !schema.some((one) => one.key === key) || !Object.entries(when).every(([other, words]) => words?.includes(now(other)))) continue;
      done.add(key);
      values.set(key, pick === '' ? '' : isRange(pick) ? inRange(random, pick, now) : word(random, pick));
    }
  }
  // Parameters with rows of their own, and the one that is randomised above.
  const known = new Set([...Object.values(table).flatMap((rows) => rows.map(([key]) => key)), 'stone']);
  for (const parameter of schema) {
    // A text is drawn work: it stays, and has no effect where another outline or body is chosen.
    if (parameter.kind !== 'text' && groups.includes(parameter.group) && !parameter.steady && !known.has(parameter.key) && !stay.has(parameter.key)) values.set(parameter.key, anywhere(random, parameter));
  }
  const recipe: Recipe = { schema, valuesOf: (key) => [now(key)], defaultOf: (parameter) => parameter.default };
  return [...values].map(([key, text]) => {
    const parameter = schema.find((one) => one.key === key);
    return [key, !parameter || applies(parameter, recipe) ? text : parameter.default];
  });
}

function stone(random: () => number, free: boolean, before: string): string {
  if (free) return word(random, { cobble: 4, flag: 3, skin: 4 });
  return before === 'skin' ? before : word(random, { cobble: 4, flag: 3 });
}

/** A value for a parameter without rows: any of its words, or a number from the middle half of its range. */
function anywhere(random: () => number, { kind, min, max, step, choices, default: plain }: Parameter): string {
  if (kind === 'choice') return choices[Math.floor(random() * choices.length)]?.word ?? plain;
  const place = 0.25 + 0.5 * random();
  return rounded(min + place * (max - min), step);
}

function isRange(pick: Weights | Range): pick is Range {
  return 'step' in pick;
}

function word(random: () => number, weights: Weights): string {
  let left = random() * Object.values(weights).reduce((sum, weight) => sum + weight, 0);
  for (const [text, weight] of Object.entries(weights)) if ((left -= weight) < 0) return text;
  return Object.keys(weights)[0] ?? '';
}

function inRange(random: () => number, { from, to, step, plain, per }: Range, now: (key: string) => string): string {
  if (plain && random() < plain[1]) return String(plain[0]);
  const place = from + random() * (to - from);
  if (!per) return rounded(place, step);
  return rounded(place * Number(now(per)), per === 'size' ? 1 : step);
}

/** The nearest step, without the rounding errors of binary fractions. */
function rounded(value: number, step: number): string {
  return String(Number((Math.round(value / step) * step).toFixed(4)));
}
