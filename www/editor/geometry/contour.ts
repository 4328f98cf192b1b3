/** Contours at 0 of numbers on a grid: marching squares (Lorensen and Cline, 1987, in the plane), linear between nodes. */
import type { Point, Ring } from '../../module/types';
import { area, distance } from './plane';
import { thinned } from './simplify';

/**
 * The rings around the region above 0, in units of the grid. All rings close, as the nodes at the grid's border are not
 * above 0. Where two squares of the region touch at a corner only, the mean of the four nodes decides.
 */
export function contour(values: Float32Array, columns: number): Ring[] {
  const rows = values.length / columns;
  // Maps the grid line through which a ring enters a square to the one through which it leaves. From node n, line 2n
  // leads right and line 2n + 1 leads down.
  const next = new Map<number, number>();
  for (let row = 0; row + 1 < rows; row += 1) {
    for (let column = 0; column + 1 < columns; column += 1) {
      const node = row * columns + column;
      const a = values[node] ?? 0;
      const b = values[node + 1] ?? 0;
      const c = values[node + columns + 1] ?? 0;
      const d = values[node + columns] ?? 0;
      const inside = (a > 0 ? 1 : 0) + (b > 0 ? 2 : 0) + (c > 0 ? 4 : 0) + (d > 0 ? 8 : 0);
      if (inside === 0 || inside === 15) continue;
      const [top, right, bottom, left] = [2 * node, 2 * node + 3, 2 * (node + columns), 2 * node + 1];
      const full = a + b + c + d > 0;
      // Cases in this order: one corner inside, or all but one; two neighbouring corners; two opposite corners.
      if (inside === 1 || (inside === 5 && !full)) next.set(top, left);
      if (inside === 2 || (inside === 10 && !full)) next.set(right, top);
      if (inside === 4 || (inside === 5 && !full)) next.set(bottom, right);
      if (inside === 8 || (inside === 10 && !full)) next.set(left, bottom);
      if (inside === 14 || (inside === 10 && full)) next.set(left, top);
      if (inside === 13 || (inside === 5 && full)) next.set(top, right);
      if (inside === 11 || (inside === 10 && full)) next.set(right, bottom);
      if (inside === 7 || (inside === 5 && full)) next.set(bottom, left);
      if (inside === 3) next.set(right, left);
      if (inside === 12) next.set(left, right);
      if (inside === 6) next.set(bottom, top);
      if (inside === 9) next.set(top, bottom);
    }
  }
  const rings: Ring[] = [];
  for (const first of next.keys()) {
    const ring: Ring = [];
    for (let line: number | undefined = first; line !== undefined; ) {
      const to: number | undefined = next.get(line);
      if (to !== undefined) ring.push(crossing(values, columns, line));
      next.delete(line);
      line = to;
    }
    if (ring.length > 2) rings.push(ring);
  }
  return rings;
}

/** The place on a line of the grid where the numbers pass 0. */
function crossing(values: Float32Array, columns: number, line: number): Point {
  const node = line >> 1;
  const [from, to] = [values[node] ?? 0, values[node + (line & 1 ? columns : 1)] ?? 0];
  const part = from === to ? 0.5 : from / (from - to);
  const [x, y] = [node % columns, Math.floor(node / columns)];
  return line & 1 ? [x, y + part] : [x + part, y];
}

/** Rings with less area than a square of this side, in units of the grid, are dropped. */
const DUST = 4;

/** Longest piece, in units of the grid, by which a contour cuts off a corner. */
const CUT = 2.2;

/**
 * The same rings with fewer points and with sharp corners. Straight pieces are off by at most `tolerance`, or by up to
 * `coarser` times that where there would be more than `most` points in all.
 */
export function tidy(rings: Ring[], tolerance: number, most: number, coarser?: number): Ring[] {
  const whole = rings.filter((ring) => Math.abs(area(ring)) > DUST * DUST).map(fromCorner);
  return thinned(whole, tolerance, most, coarser).map(sharpened);
}

/** The ring, begun at the point farthest from its middle, so that no straight side is divided there. */
function fromCorner(ring: Ring): Ring {
  const middle: Point = [0, 1].map((axis) => ring.reduce((sum, point) => sum + (point[axis] ?? 0), 0) / ring.length) as Point;
  let [at, most] = [0, -1];
  ring.forEach((point, index) => {
    const far = distance(point, middle);
    if (far > most) [at, most] = [index, far];
  });
  return [...ring.slice(at), ...ring.slice(0, at)];
}

/** Replaces one or two short pieces by a corner, where the long sides beside them, extended, meet nearby. */
function sharpened(ring: Ring): Ring {
  const points = [...ring];
  for (let k = 0; k < points.length; k += 1) {
    // A corner beside a node of the grid is cut off by two pieces.
    for (const pieces of [1, 2]) {
      if (points.length < 4 + pieces) break;
      const around = [0, 1, 1 + pieces, 2 + pieces].map((step) => points[(k + step) % points.length]) as [Point, Point, Point, Point];
      const corner = meeting(...around);
      if (!corner) continue;
      const begin = (k + 2) % points.length;
      points[(k + 1) % points.length] = corner;
      for (let left = pieces; left > 0; left -= 1) points.splice(begin % points.length, 1);
      break;
    }
  }
  return points;
}

function meeting(a: Point, b: Point, c: Point, d: Point): Point | undefined {
  if (distance(b, c) > CUT || Math.min(distance(a, b), distance(c, d)) < 2 * CUT) return undefined;
  const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]];
  const turn = ux * vy - uy * vx;
  // A turn of less than 25 degrees is a bend, not a corner.
  if (Math.abs(turn) < 0.42 * Math.hypot(ux, uy) * Math.hypot(vx, vy)) return undefined;
  const along = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / turn;
  const corner: Point = [a[0] + along * ux, a[1] + along * uy];
  return distance(corner, b) < CUT && distance(corner, c) < CUT ? corner : undefined;
}
