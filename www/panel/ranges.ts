/**
 * Random values within the ranges in which most pictures look good; the ranges follow the presets. The picture's side
 * and parameters that serve only comparison keep their values.
 *
 * Each group has a table of ranges with weights. A row may depend on the rows before it. A parameter without effect in
 * the new recipe gets its default, so that links stay short.
 */

import type { Parameter } from '../module/types';
import { applies, type Recipe } from '../state/rules';

/** Words with their weights. */
type Words = Record<string, number>;

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

export type Row = readonly [key: string, pick: Words | Range | '', when?: When];

const SKIN: When = { stone: ['skin'] };
const TILE: When = { tile: ['1'] };
const ROADS = ['road_s', 'road_straight', 'road_spiral', 'y_fork', 'crossing', 'road_notch', 'l_shape', 'annulus'];
export const STONE_PALETTES: Words = { granite: 2, basalt: 2, sandstone: 2, terracotta: 2, marble: 2, porphyry: 2, slate: 1, mossy: 1, limestone: 2 };

/** The cells stay stones, or stay skin, unless all of these groups are randomised. */
const FAMILY = ['Cells', 'Relief', 'Surface'];

export const range = (from: number, to: number, step: number, more: Pick<Range, 'plain' | 'per'> = {}): Range => ({ from, to, step, ...more });
/** Mostly 0. */
export const rarely = (part: number, from: number, to: number, step = 0.05): Range => range(from, to, step, { plain: [0, 1 - part] });

/** Rows by group, in the order of randomising: later rows depend on earlier ones. */
export type Table = Record<string, readonly Row[]>;

export const PLANE: Table = {
  Outline: [
    ['tile', { '0': 2, '1': 1 }, SKIN],
    ['tile', { '0': 5, '1': 1 }],
    ['outline', { square: 5, star: 2, annulus: 2, road_s: 2, plaza: 1, y_fork: 1 }, SKIN],
    ['outline', { annulus: 2, road_s: 3, road_spiral: 3, y_fork: 2, crossing: 2, plaza: 3, road_notch: 1, l_shape: 1, star: 3, square: 3 }],
    ['lines', ''],
    ['ow', range(1.1, 1.55, 0.05), { outline: ROADS }],
    ['ow', range(0.8, 1.3, 0.05), { outline: ['plaza'] }],
    ['ow', range(1.2, 1.5, 0.05), { outline: ['star'] }],
    ['ow', { '1': 1 }],
    ['on', range(5, 9, 1), { outline: ['star'] }],
    ['on', range(1, 4, 1), { outline: ['plaza'] }],
    ['on', range(2, 4, 1), { outline: ['road_s'] }],
    ['on', { '0': 1 }],
    ['oa', range(-30, 30, 5, { plain: [0, 0.75] })],
  ],
  Cells: [
    ['kind', { circle: 1 }, { stone: ['skin'], tile: ['0'], outline: ['star'] }],
    ['kind', { circle: 3, ellipse: 4 }, { stone: ['skin'], tile: ['0'], outline: ['square', 'plaza', 'annulus'] }],
    ['kind', { circle: 3, ellipse: 4, rectangle: 2 }, SKIN],
    ['kind', { square: 4, rectangle: 4, circle: 1 }, { stone: ['flag'] }],
    ['kind', { square: 6, rectangle: 2, circle: 2, ellipse: 2 }],
    ['parts', ''],
    ['ca', range(1.2, 1.5, 0.05), SKIN],
    ['ca', range(1.4, 2.1, 0.05)],
    ['cb', { '1': 1 }],
    ['stretch', ''],
  ],
  Size: [
    ['cs', range(0.03, 0.06, 0.001, { per: 'size' }), SKIN],
    ['cs', range(0.028, 0.046, 0.001, { per: 'size' }), { outline: ROADS, tile: ['0'] }],
    ['cs', range(0.031, 0.064, 0.001, { per: 'size' })],
    ['gx', rarely(0.12, -0.4, 0.4)],
    ['gy', rarely(0.12, -0.4, 0.4)],
    ['gr', rarely(0.25, 0.2, 0.6)],
    ['gb', range(0.6, 0.85, 0.05, { plain: [1, 0.8] })],
    ['gd', range(0.15, 0.3, 0.01)],
    ['spots', ''],
  ],
  Direction: [
    ['dir', { constant: 1 }, TILE],
    ['dir', { boundary: 3, constant: 3, circular: 2, spiral: 1 }, { outline: ['square'] }],
    ['dir', { boundary: 6, circular: 1, spiral: 1 }, { outline: ['star', 'plaza'] }],
    ['dir', { boundary: 1 }],
    ['angle', { '90': 3, '0': 1 }, SKIN],
    ['angle', { '0': 3, '45': 2, '-45': 1, '90': 1 }],
    ['fx', range(0.3, 0.7, 0.01, { plain: [0.5, 0.6] })],
    ['fy', range(0.3, 0.7, 0.01, { plain: [0.5, 0.6] })],
    ['fa', range(35, 75, 1)],
    ['strokes', ''],
  ],
  Packing: [
    ['vs', rarely(0.6, 0.05, 0.2, 0.01)],
    ['cells', { fitted: 1 }, SKIN],
    ['cells', { fitted: 14, lloyd: 1 }, { kind: ['circle'] }],
    ['cells', { fitted: 1 }],
  ],
  Relief: [
    ['sv', range(1.25, 1.45, 0.01), { stone: ['skin'], kind: ['circle', 'square'] }],
    ['sv', range(1.35, 1.65, 0.01), SKIN],
    ['sv', range(0.95, 0.98, 0.01), { stone: ['flag'] }],
    ['sv', range(0.96, 1.02, 0.01)],
    ['hs', range(0.35, 0.5, 1, { per: 'cs' }), { stone: ['flag'] }],
    ['hs', range(0.55, 0.85, 1, { per: 'cs' })],
    ['sr', range(0.4, 0.9, 0.05)],
    ['sc', range(0, 0.4, 0.05), { kind: ['circle', 'square'] }],
    ['sc', range(0.5, 1.6, 0.05)],
    ['tilt', range(0.05, 0.18, 0.01)],
    ['sa', { '0': 3, '180': 1 }],
    ['tc', range(0.2, 0.5, 0.01)],
    ['flat', rarely(0.4, 0.2, 0.5)],
    ['keel', rarely(0.45, 0.3, 0.8)],
    ['rings', rarely(0.12, 4, 7, 1)],
    ['dr', range(0.02, 0.12, 0.01), SKIN],
    ['dr', range(0.08, 0.18, 0.01), { stone: ['flag'] }],
    ['dr', range(0.15, 0.4, 0.01)],
    ['bh', range(0.1, 0.2, 0.01)],
  ],
  Surface: [
    ['fd', range(1.1, 1.4, 0.01), SKIN],
    ['fd', range(1.25, 1.5, 0.01)],
    ['af', range(0.02, 0.06, 0.01), SKIN],
    ['af', range(0.04, 0.075, 0.05, { per: 'cs' })],
    [
      'palette',
      { crocodile: 1, lizard: 2, snake: 1, coral: 1, fish: 1, koi: 1, tortoise: 1, armadillo: 1, pangolin: 1, desert: 1, cone: 1, dragon: 2 },
      SKIN,
    ],
    ['palette', STONE_PALETTES],
    ['vary', range(0.5, 1.2, 0.05), SKIN],
    ['vary', range(0.8, 1.3, 0.05)],
    ['ground', { hide: 1 }, SKIN],
    ['ground', { mortar: 3, soil: 1, dark: 1, sand: 1 }, { stone: ['flag'] }],
    ['ground', { sand: 2, soil: 3, dark: 2, moss: 1, gravel: 2, mortar: 1 }],
    ['gloss', { own: 5, glossy: 1 }, SKIN],
    ['gloss', { own: 1 }],
  ],
  Colour: [
    ['pattern', { none: 3, bands: 1, spots: 1, rosettes: 2, blotches: 2, turing: 2 }, SKIN],
    ['pattern', { none: 9, bands: 1, blotches: 1, boundary: 1 }],
    ['pn', range(0.15, 0.2, 0.01), { pattern: ['turing'] }],
    ['pn', range(0.2, 0.3, 0.01), { pattern: ['rosettes', 'spots'] }],
    ['pn', range(0.15, 0.45, 0.01)],
    ['pa', { '0': 1, '90': 2, '45': 1 }],
    ['ps', range(0.7, 0.9, 0.05)],
    ['pc', range(0.35, 0.55, 0.01)],
    ['pm', range(0.8, 1, 0.05), SKIN],
    ['pm', range(0.5, 0.8, 0.05)],
    ['rim', rarely(0.4, 0.1, 0.4)],
    ['belly', rarely(0.35, 0.4, 0.7), SKIN],
    ['belly', { '0': 1 }],
    ['ba', { '90': 3, '0': 1, '45': 1 }],
  ],
  Weather: [
    ['wear', { '0': 1 }, SKIN],
    ['wear', rarely(0.25, 0.3, 0.8)],
    ['moss', { '0': 1 }, SKIN],
    ['moss', rarely(0.2, 0.3, 0.7)],
    ['dirt', rarely(0.15, 0.1, 0.3), SKIN],
    ['dirt', rarely(0.3, 0.2, 0.5)],
    ['wet', { '0': 1 }, SKIN],
    ['wet', rarely(0.15, 0.4, 0.8)],
  ],
  Light: [
    ['light', { parallel: 7, point: 1 }],
    ['az', range(200, 320, 1)],
    ['el', range(32, 50, 1)],
    ['lx', range(0.2, 0.8, 0.01)],
    ['ly', range(0.1, 0.4, 0.01)],
    ['lz', range(0.3, 0.6, 0.01)],
    ['amb', range(1, 1.3, 0.05)],
    ['diff', range(1.1, 1.5, 0.05), { light: ['point'] }],
    ['diff', range(1, 1.3, 0.05)],
    ['spec', range(0.9, 1.4, 0.05)],
    ['shin', { '1': 1 }],
    ['shadow', { '1': 1 }],
    ['occl', range(0.7, 1, 0.05)],
  ],
};

/**
 * New values of these groups by a table. `random` returns numbers in 0..1, and `get` a parameter's present value. A
 * parameter without effect in the new recipe gets its default, so that links stay short.
 */
export function thrown(table: Table, random: () => number, groups: readonly string[], schema: readonly Parameter[], get: (key: string) => string): [key: string, text: string][] {
  const values = new Map<string, string>();
  const now = (key: string): string => values.get(key) ?? get(key);
  if (groups.includes('Relief') && schema.some(({ key }) => key === 'stone')) values.set('stone', stone(random, FAMILY.every((group) => groups.includes(group)), get('stone')));
  for (const [group, rows] of Object.entries(table)) {
    if (!groups.includes(group)) continue;
    const done = new Set<string>();
    for (const [key, pick, when = {}] of rows) {
      if (done.has(key) || !schema.some((one) => one.key === key) || !Object.entries(when).every(([other, words]) => words?.includes(now(other)))) continue;
      done.add(key);
      values.set(key, pick === '' ? '' : isRange(pick) ? inRange(random, pick, now) : word(random, pick));
    }
  }
  // Parameters with rows of their own, and the one that is randomised apart.
  const known = new Set([...Object.values(table).flatMap((rows) => rows.map(([key]) => key)), 'stone']);
  for (const parameter of schema) {
    if (groups.includes(parameter.group) && !parameter.steady && !known.has(parameter.key)) values.set(parameter.key, anywhere(random, parameter));
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

/**
 * A value for a parameter without rows: any of its words, or a number from the middle half of its range. Texts stay
 * as they are.
 */
function anywhere(random: () => number, { kind, min, max, step, choices, default: plain }: Parameter): string {
  if (kind === 'text') return plain;
  if (kind === 'choice') return choices[Math.floor(random() * choices.length)]?.word ?? plain;
  const place = 0.25 + 0.5 * random();
  return rounded(min + place * (max - min), step);
}

function isRange(pick: Words | Range): pick is Range {
  return 'step' in pick;
}

function word(random: () => number, weights: Words): string {
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
