/** Parses path data into lines and curves, and turns those into points. */
import type { Point, Ring } from '../../module/types';
import { moved, times, type Matrix } from './matrix';
import { Refusal } from './refusal';

/**
 * A subpath. Each curve begins at the end of the previous one, and has one more point (a line), two (quadratic) or
 * three (cubic).
 */
export interface Run {
  start: Point;
  curves: Point[][];
  closed: boolean;
}

/** Numbers per command. */
const TAKES: Record<string, number> = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0 };

/** Most points of all shapes of a drawing. */
export const POINTS = 200_000;

/** Most pieces of a curve. */
const PIECES = 400;

/** The runs of path data. As in browsers, the rest after a mistake is ignored. */
export function parsePath(text: string): Run[] {
  const runs: Run[] = [];
  let run: Run | undefined;
  let start: Point = [0, 0];
  let at: Point = [0, 0];
  // The last control point, which smooth curves mirror, and the kind of its curve.
  let control: { point: Point; of: string } | undefined;
  let count = 0;
  for (const { letter, numbers } of commands(text)) {
    if ((count += 1) > POINTS) throw new Refusal('too_many_points', { most: POINTS });
    const kind = letter.toLowerCase();
    const from = at;
    const [ox, oy] = letter === kind ? from : [0, 0];
    const pair = (k: number): Point => [(numbers[k] ?? 0) + ox, (numbers[k + 1] ?? 0) + oy];
    const mirrored = (of: string): Point => (control && control.of === of ? [2 * from[0] - control.point[0], 2 * from[1] - control.point[1]] : from);
    let next: typeof control;
    if (kind === 'z') {
      if (run) run.closed = true;
      run = undefined;
      at = start;
    } else if (kind === 'm') {
      at = start = pair(0);
      runs.push((run = { start, curves: [], closed: false }));
    } else {
      // After a close command, a new run begins at the start of the closed one.
      if (!run) runs.push((run = { start: at, curves: [], closed: false }));
      if (kind === 'l') run.curves.push([(at = pair(0))]);
      else if (kind === 'h') run.curves.push([(at = [(numbers[0] ?? 0) + ox, from[1]])]);
      else if (kind === 'v') run.curves.push([(at = [from[0], (numbers[0] ?? 0) + oy])]);
      else if (kind === 'a') run.curves.push(...arc(from, numbers, (at = pair(5))));
      else {
        const cubic = kind === 'c' || kind === 's';
        const whole = kind === 'c' || kind === 'q';
        at = pair(numbers.length - 2);
        const second = cubic ? pair(whole ? 2 : 0) : whole ? pair(0) : mirrored('q');
        run.curves.push(cubic ? [whole ? pair(0) : mirrored('c'), second, at] : [second, at]);
        next = { point: second, of: cubic ? 'c' : 'q' };
      }
    }
    control = next;
  }
  return runs;
}

/** The commands one by one. Further numbers repeat the command; after a move they are lines. */
function* commands(text: string): Generator<{ letter: string; numbers: number[] }> {
  const [command, number, flag] = [/[\s,]*([a-z])/iy, /[\s,]*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)/iy, /[\s,]*([01])/y];
  let at = 0;
  const next = (what: RegExp): string | undefined => {
    what.lastIndex = at;
    const found = what.exec(text);
    if (found) at = what.lastIndex;
    return found?.[1];
  };
  for (let letter = next(command); letter !== undefined; letter = next(command)) {
    const kind = letter.toLowerCase();
    const takes = TAKES[kind];
    if (takes === undefined) return;
    for (let more = true, first = true; more; first = false) {
      const numbers: number[] = [];
      while (numbers.length < takes) {
        // No space is needed after the two flags of an arc.
        const found = next(kind === 'a' && (numbers.length === 3 || numbers.length === 4) ? flag : number);
        // A number that overflows is a mistake, too.
        if (found === undefined || !Number.isFinite(Number(found))) break;
        numbers.push(Number(found));
      }
      if (numbers.length < takes) {
        if (first || numbers.length) return;
        break;
      }
      yield { letter: first || kind !== 'm' ? letter : letter === 'm' ? 'l' : 'L', numbers };
      more = takes > 0;
    }
  }
}

/** An elliptical arc as cubic curves of at most a quarter turn, by the implementation notes of the SVG specification. */
function arc(from: Point, [rx = 0, ry = 0, degrees = 0, large = 0, sweep = 0]: number[], to: Point): Point[][] {
  let [a, b] = [Math.abs(rx), Math.abs(ry)];
  const turn = (degrees * Math.PI) / 180;
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  const [hx, hy] = [(from[0] - to[0]) / 2, (from[1] - to[1]) / 2];
  const [x, y] = [cos * hx + sin * hy, cos * hy - sin * hx];
  if (hx === 0 && hy === 0) return [];
  if (!(a > 0 && b > 0)) return [[to]];
  const small = Math.hypot(x / a, y / b);
  if (small > 1) [a, b] = [a * small, b * small];
  const off = Math.sqrt(Math.max(0, 1 / ((x / a) ** 2 + (y / b) ** 2) - 1)) * (large === sweep ? -1 : 1);
  // The middle, on the circle's scale.
  const [mx, my] = [(off * y) / b, (-off * x) / a];
  const begin = Math.atan2(y / b - my, x / a - mx);
  let sweepBy = Math.atan2(-y / b - my, -x / a - mx) - begin;
  if (sweep && sweepBy < 0) sweepBy += 2 * Math.PI;
  if (!sweep && sweepBy > 0) sweepBy -= 2 * Math.PI;
  const place: Matrix = [cos * a, sin * a, -sin * b, cos * b, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const middle = times(place, [1, 0, 0, 1, mx, my]);
  const quarters = Math.max(1, Math.ceil(Math.abs(sweepBy) / (Math.PI / 2) - 1e-9));
  const step = sweepBy / quarters;
  const reach = (4 / 3) * Math.tan(step / 4);
  const curves = Array.from({ length: quarters }, (_, k): Point[] => {
    const [s, t] = [begin + k * step, begin + (k + 1) * step];
    const on = (angle: number, along: number): Point => moved(middle, [Math.cos(angle) - along * Math.sin(angle), Math.sin(angle) + along * Math.cos(angle)]);
    return [on(s, reach), on(t, -reach), on(t, 0)];
  });
  (curves.at(-1) ?? [])[2] = to;
  return curves;
}

/** A run as points, off by at most `tolerance`. No point repeats the previous one. */
export function flat({ start, curves }: Run, tolerance: number): Ring {
  const points: Ring = [start];
  let from = start;
  for (const curve of curves) {
    const whole = [from, ...curve];
    const to = curve.at(-1) ?? from;
    for (let k = 1, n = pieces(whole, tolerance); k < n; k += 1) points.push(on(whole, k / n));
    points.push(to);
    from = to;
  }
  return points.filter(([x, y], k) => k === 0 || x !== points[k - 1]?.[0] || y !== points[k - 1]?.[1]);
}

/** The number of pieces that keeps the error of a curve within `tolerance` (Wang's bound). */
function pieces(curve: Point[], tolerance: number): number {
  const order = curve.length - 1;
  if (order < 2) return 1;
  const bends = curve.slice(2).map(([x, y], k) => {
    const [[u, v], [r, s]] = [curve[k] ?? [0, 0], curve[k + 1] ?? [0, 0]];
    return Math.hypot(x - 2 * r + u, y - 2 * s + v);
  });
  const most = Math.sqrt((order * (order - 1) * Math.max(...bends)) / 8 / tolerance);
  return Math.min(PIECES, Math.max(1, Math.ceil(Number.isFinite(most) ? most : PIECES)));
}

function on(curve: Point[], t: number): Point {
  let left = curve;
  while (left.length > 1) left = left.slice(1).map(([x, y], n): Point => {
    const [u, v] = left[n] ?? [x, y];
    return [u + (x - u) * t, v + (y - v) * t];
  });
  return left[0] ?? [0, 0];
}
