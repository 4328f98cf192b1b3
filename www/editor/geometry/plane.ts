/** Points of the plane, with y down. Differences are vectors; complex numbers stand for rotations with scale. */
import type { Point, Ring } from '../../module/types';

export function distance(from: Point, to: Point): number {
  return Math.hypot(to[0] - from[0], to[1] - from[1]);
}

export function same(a: Point, b: Point): boolean {
  return a[0] === b[0] && a[1] === b[1];
}

export function sum(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

export function minus(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1]];
}

/** The complex product: `a` rotated by the angle of `b` and scaled by its length. */
export function times(a: Point, b: Point): Point {
  return [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
}

/** The complex quotient; 1 if it does not exist. */
export function over(a: Point, b: Point): Point {
  const square = b[0] * b[0] + b[1] * b[1];
  return square > 0 ? times(a, [b[0] / square, -b[1] / square]) : [1, 0];
}

/** The unit vector of a vector; the zero vector stays. */
export function unit([x, y]: Point): Point {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

/** The point at this share of the way, 0..1. */
export function between(from: Point, to: Point, part: number): Point {
  return [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
}

/** The parameter, 0 at `from` and 1 at `to`, of the place of a segment nearest to a point. */
function along(point: Point, from: Point, to: Point): number {
  const [x, y] = minus(to, from);
  const square = x * x + y * y;
  const part = square > 0 ? ((point[0] - from[0]) * x + (point[1] - from[1]) * y) / square : 0;
  return Math.min(1, Math.max(0, part));
}

/** The place of a segment nearest to a point. */
export function onSegment(point: Point, from: Point, to: Point): Point {
  return between(from, to, along(point, from, to));
}

/** Distance from a point to a segment. */
export function toSegment(point: Point, from: Point, to: Point): number {
  const t = along(point, from, to);
  return Math.hypot(point[0] - from[0] - t * (to[0] - from[0]), point[1] - from[1] - t * (to[1] - from[1]));
}

/** The index of the least distance, the first of equal ones. */
export function nearest(distances: number[]): number {
  return distances.reduce((best, far, k) => (far < (distances[best] ?? Infinity) ? k : best), 0);
}

/** The signed area of a ring: positive if it runs clockwise on the screen. */
export function area(ring: Ring): number {
  return ring.reduce((total, [x, y], k) => {
    const [u, v] = ring[(k + 1) % ring.length] ?? [x, y];
    return total + (x * v - y * u) / 2;
  }, 0);
}

/** Whether a point lies in a ring. */
export function within([x, y]: Point, ring: Ring): boolean {
  return ring.reduce((inside, [ax, ay], k) => {
    const [bx, by] = ring[(k + 1) % ring.length] ?? [ax, ay];
    return ay > y !== by > y && x < ax + ((y - ay) * (bx - ax)) / (by - ay) ? !inside : inside;
  }, false);
}
