/** Affine maps of the plane: x to a x + c y + e, y to b x + d y + f. */
import type { Point } from '../../module/types';

export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

export const STILL: Matrix = [1, 0, 0, 1, 0, 0];

/** Radians per unit of angles. */
const TURNS: Record<string, number> = { '': Math.PI / 180, deg: Math.PI / 180, grad: Math.PI / 200, rad: 1, turn: 2 * Math.PI };

export function moved([a, b, c, d, e, f]: Matrix, [x, y]: Point): Point {
  return [a * x + c * y + e, b * x + d * y + f];
}

/** Applies `inner` first, then `outer`. */
export function times(outer: Matrix, inner: Matrix): Matrix {
  const [a, b, c, d] = outer;
  const [p, q, r, s] = inner;
  const [e, f] = moved(outer, [inner[4], inner[5]]);
  return [a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s, e, f];
}

export function shift(x: number, y: number): Matrix {
  return [1, 0, 0, 1, x, y];
}

export function stretch(x: number, y = x): Matrix {
  return [x, 0, 0, y, 0, 0];
}

/** The inverse; undefined if the map is singular. */
export function back([a, b, c, d, e, f]: Matrix): Matrix | undefined {
  const det = a * d - b * c;
  return det === 0 || !Number.isFinite(det) ? undefined : [d / det, -b / det, -c / det, a / det, (c * f - d * e) / det, (b * e - a * f) / det];
}

/** The largest factor by which lengths grow. */
export function growth([a, b, c, d]: Matrix): number {
  return Math.hypot(Math.hypot(a, b), Math.hypot(c, d));
}

/** The matrix of a transform attribute. As in browsers, one with a mistake is ignored. */
export function matrixOf(text: string): Matrix {
  const parts = [...text.matchAll(/([a-z]+)\s*\(([^()]*)\)/gi)];
  const known = parts.map(([, word = '', list = '']) => partOf(word.toLowerCase(), list.trim().split(/[\s,]+/)));
  const whole = known.reduce<Matrix>((all, part) => times(all, part ?? [NaN, NaN, NaN, NaN, NaN, NaN]), STILL);
  return whole.every(Number.isFinite) ? whole : STILL;
}

function partOf(word: string, list: string[]): Matrix | undefined {
  const number = (k: number, otherwise = 0): number => (list[k] === undefined ? otherwise : Number(list[k].replace(/px$/i, '')));
  const angle = (k: number): number => {
    const [, value, unit = ''] = /^([-+.\de]*\d)(deg|grad|rad|turn)?$/i.exec(list[k] ?? '0') ?? [];
    return Number(value) * (TURNS[unit.toLowerCase()] ?? NaN);
  };
  switch (word) {
    case 'matrix':
      return list.length === 6 ? [number(0), number(1), number(2), number(3), number(4), number(5)] : undefined;
    case 'translate':
      return shift(number(0), number(1));
    case 'translatex':
      return shift(number(0), 0);
    case 'translatey':
      return shift(0, number(0));
    case 'scale':
      return stretch(number(0, 1), number(1, number(0, 1)));
    case 'scalex':
      return stretch(number(0, 1), 1);
    case 'scaley':
      return stretch(1, number(0, 1));
    case 'rotate': {
      const [sin, cos] = [Math.sin(angle(0)), Math.cos(angle(0))];
      return times(times(shift(number(1), number(2)), [cos, sin, -sin, cos, 0, 0]), shift(-number(1), -number(2)));
    }
    case 'skewx':
      return [1, 0, Math.tan(angle(0)), 1, 0, 0];
    case 'skewy':
      return [1, Math.tan(angle(0)), 0, 1, 0, 0];
    default:
      return undefined;
  }
}
