/**
 * Rings as lines through few handles. Between two handles runs a stretch of the ring's points. It stays what it is to
 * the last bit as long as neither is moved; else it is turned and stretched to where they are, and bent so that at
 * smooth handles the line goes on in one direction. A handle that is not moved keeps that direction, so what lies
 * beyond it stays.
 */
import type { Point, Ring } from '../types';
import type { Figure } from './figures';
import { distance, toSegment } from './simplify';

/** What runs from a handle to the next one. */
export interface Stretch {
  /** The handle at its beginning is smooth; else it is a corner. */
  smooth: boolean;
  /** Where its ends were when it was made, and how long it was. */
  from: Point;
  to: Point;
  length: number;
  /** Places between them, each with the part of the length before it. */
  inner: { at: Point; along: number }[];
}

/** Chords leave a curve by at most this many sides, as those of the built-in outlines do. */
const SAGITTA = 1 / 6000;

/** A stretch along these points, both ends included. */
export function stretchAlong(line: Ring, smooth: boolean): Stretch {
  const lengths = line.map((at, k) => distance(line[k - 1] ?? at, at));
  const length = lengths.reduce((sum, piece) => sum + piece, 0);
  let along = 0;
  const inner = line.map((at, k) => ({ at, along: (along += (lengths[k] ?? 0) / (length || 1)) })).slice(1, -1);
  return { smooth, from: line[0] ?? [0, 0], to: line.at(-1) ?? [0, 0], length, inner };
}

/** For each handle the line from it up to the next one, without that. Figures without stretches are straight between their points. */
export function lines(figure: Figure, side: number): Point[][] {
  const { points, stretches } = figure;
  return points.map((from, k) => (stretches ? [from, ...bent(stretches, points, k, side)] : [from]));
}

/** All points of a ring. */
export function ringOf(figure: Figure, side: number): Ring {
  return lines(figure, side).flat();
}

/** Moves go on from what is there now. */
export function settle(figure: Figure, side: number): void {
  const { points, stretches } = figure;
  if (!stretches) return;
  const now = lines(figure, side);
  figure.stretches = stretches.map((stretch, k) => {
    const [from, to] = [points[k] ?? stretch.from, points[(k + 1) % points.length] ?? stretch.to];
    return same(from, stretch.from) && same(to, stretch.to) ? stretch : stretchAlong([[...from], ...(now[k] ?? []).slice(1), [...to]], stretch.smooth);
  });
}

/** The places between a handle and the next one. */
function bent(stretches: Stretch[], points: Point[], index: number, side: number): Point[] {
  const next = (index + 1) % points.length;
  const [stretch, start, end] = [stretches[index], points[index], points[next]];
  if (!stretch || !start || !end) return [];
  const { from, to, length, inner } = stretch;
  if (same(start, from) && same(end, to)) return inner.map(({ at }) => at);
  // Directions and turns are complex numbers.
  const turn = over(minus(end, start), minus(to, from));
  const scale = Math.hypot(...turn);
  const pull = (handle: number): Point => {
    if (!stretches[handle]?.smooth) return [0, 0];
    const kept = times(swing(stretches, points, handle), [scale, 0]);
    return times(times(minus(kept, turn), [length, 0]), direction(stretches, handle));
  };
  const [leaves, comes] = [pull(index), pull(next)];
  const parts = Math.sqrt((Math.hypot(...leaves) + Math.hypot(...comes)) / (2 * SAGITTA * side));
  return finer(stretches, index, parts, Math.sqrt(scale)).map(({ at, along: t }): Point => {
    const laid = sum(start, times(turn, minus(at, from)));
    const [a, b] = [t * (1 - t) * (1 - t), -t * t * (1 - t)];
    return [laid[0] + a * leaves[0] + b * comes[0], laid[1] + a * leaves[1] + b * comes[1]];
  });
}

/** The direction in which stretches that were not moved go through a smooth handle. */
function direction(stretches: Stretch[], index: number): Point {
  const [before, behind] = [stretches.at(index - 1), stretches[index]];
  if (!before || !behind) return [1, 0];
  const [last, next] = [before.inner.at(-1)?.at ?? before.from, behind.inner[0]?.at ?? behind.to];
  return unit(sum(unit(minus(behind.from, last)), unit(minus(next, behind.from))));
}

/** How a smooth handle turned: if it was moved, as the direction from the handle before it to the one behind it did. */
function swing(stretches: Stretch[], points: Point[], index: number): Point {
  const [before, here, next] = [points.at(index - 1), points[index], points[(index + 1) % points.length]];
  const [last, base] = [stretches.at(index - 1), stretches[index]];
  if (!before || !here || !next || !last || !base || same(here, base.from)) return [1, 0];
  const through = (a: Point, b: Point, c: Point): Point => sum(unit(minus(b, a)), unit(minus(c, b)));
  return unit(over(through(before, here, next), through(last.from, base.from, base.to)));
}

/** The places of a stretch, with further ones on the curve through them: in all as many parts as that, and each piece at least as often divided as `least` says. */
function finer(stretches: Stretch[], index: number, parts: number, least: number): Stretch['inner'] {
  const stretch = stretches[index];
  if (!stretch) return [];
  const { from, to, length, inner } = stretch;
  const smoothEnd = stretches[(index + 1) % stretches.length]?.smooth ?? false;
  if (!inner.length && !stretch.smooth && !smoothEnd) return [];
  const knots = [{ at: from, along: 0 }, ...inner, { at: to, along: 1 }];
  const slopes = knots.map((knot, k): Point => {
    if (k === 0 && stretch.smooth) return times(direction(stretches, index), [length, 0]);
    if (k === knots.length - 1 && smoothEnd) return times(direction(stretches, (index + 1) % stretches.length), [length, 0]);
    const [before, behind] = [knots[k - 1] ?? knot, knots[k + 1] ?? knot];
    return times(minus(behind.at, before.at), [1 / (behind.along - before.along), 0]);
  });
  return knots.slice(1).flatMap((next, k) => {
    const last = knots[k] ?? next;
    const gap = next.along - last.along;
    const pieces = inner.length ? Math.max(Math.ceil(gap * parts), Math.ceil(least - 0.1), 1) : Math.max(1, Math.ceil(parts));
    return Array.from({ length: pieces }, (_, n) => {
      const t = (n + 1) / pieces;
      if (n + 1 === pieces) return next;
      const at = inner.length ? hermite(last.at, times(slopes[k] ?? [0, 0], [gap, 0]), next.at, times(slopes[k + 1] ?? [0, 0], [gap, 0]), t) : between(last.at, next.at, t);
      return { at, along: last.along + t * gap };
    });
  }).slice(0, -1);
}

function hermite(from: Point, leaves: Point, to: Point, comes: Point, t: number): Point {
  const s = 1 - t;
  const [a, b, c, d] = [s * s * (1 + 2 * t), s * s * t, -t * t * s, t * t * (1 + 2 * s)];
  return [0, 1].map((axis) => a * (from[axis] ?? 0) + b * (leaves[axis] ?? 0) + c * (comes[axis] ?? 0) + d * (to[axis] ?? 0)) as Point;
}

/** Half the way along a line that ends at `to`. */
export function middle(line: Point[], to: Point): Point {
  const whole = [...line, to];
  let left = whole.reduce((sum, at, k) => sum + distance(whole[k - 1] ?? at, at), 0) / 2;
  for (const [k, at] of line.entries()) {
    const next = whole[k + 1] ?? at;
    const length = distance(at, next);
    if (left <= length) return between(at, next, length > 0 ? left / length : 0);
    left -= length;
  }
  return to;
}

/** Puts a handle into a ring behind that one, where its line comes nearest to a place: smooth on a curve, a corner on a straight line. */
export function divide(figure: Figure, index: number, near: Point | undefined, side: number): void {
  const { points } = figure;
  const all = stretched(figure, side);
  const stretch = all[index];
  const to = points[(index + 1) % points.length];
  if (!stretch || !to) return;
  const line = lines(figure, side)[index] ?? [];
  const whole = [...line, to];
  const place = near ?? middle(line, to);
  const cut = nearest(line.map((from, k) => toSegment(place, from, whole[k + 1] ?? to)));
  const at = onSegment(place, whole[cut] ?? to, whole[cut + 1] ?? to);
  const [before, behind] = [whole.slice(0, cut + 1), whole.slice(cut + 1)].map((half) => half.filter((point) => distance(point, at) > 1e-9 * side)) as [Ring, Ring];
  points.splice(index + 1, 0, at);
  all.splice(index, 1, stretchAlong([...before, at], stretch.smooth), stretchAlong([at, ...behind], line.length > 1));
}

/** The handle whose line to the next one comes nearest to a place. */
export function nearestLine(figure: Figure, place: Point, side: number): number {
  const all = lines(figure, side);
  return nearest(all.map((line, k) => Math.min(...line.map((from, n) => toSegment(place, from, line[n + 1] ?? all[(k + 1) % all.length]?.[0] ?? from)))));
}

/** Takes a handle out of a ring: one line, as smooth as the two were at their other ends, comes in the place of two. */
export function join(figure: Figure, index: number, side: number): void {
  const { points } = figure;
  const all = stretched(figure, side);
  const before = (index + points.length - 1) % points.length;
  const [first, second] = [lines(figure, side)[before] ?? [], lines(figure, side)[index] ?? []];
  const [from, to] = [points[before], points[(index + 1) % points.length]];
  const [start, end] = [all[before], all[(index + 1) % points.length]];
  if (!from || !to || !start || !end) return;
  const leaves = start.smooth || first.length > 1 ? heading(figure, before, start.smooth, true, side) : undefined;
  const comes = end.smooth || second.length > 1 ? heading(figure, (index + 1) % points.length, end.smooth, false, side) : undefined;
  all[before] = stretchAlong(swung(from, to, leaves, comes, side), start.smooth);
  points.splice(index, 1);
  all.splice(index, 1);
}

/** The direction in which a ring goes through a handle; where that is a corner, of what leaves it or comes to it. */
function heading(figure: Figure, index: number, smooth: boolean, leaves: boolean, side: number): number {
  const all = lines(figure, side);
  const here = all[index]?.[0] ?? [0, 0];
  const before = all.at(index - 1)?.at(-1) ?? here;
  const next = all[index]?.[1] ?? all[(index + 1) % all.length]?.[0] ?? here;
  const [dx, dy] = smooth ? sum(unit(minus(here, before)), unit(minus(next, here))) : leaves ? minus(next, here) : minus(here, before);
  return Math.atan2(dy, dx);
}

/** A curve that leaves and comes in these directions, nearly a circle's arc where it can be; where just one is given, an arc. */
function swung(from: Point, to: Point, leaves: number | undefined, comes: number | undefined, side: number): Ring {
  const chord = minus(to, from);
  const along = Math.atan2(chord[1], chord[0]);
  const off = (angle: number): number => Math.atan2(Math.sin(angle - along), Math.cos(angle - along));
  const [a, b] = [leaves ?? (comes === undefined ? along : along - off(comes)), comes ?? (leaves === undefined ? along : along - off(leaves))];
  const arm = Math.hypot(...chord) / (3 * Math.max(0.25, Math.cos((Math.abs(off(a)) + Math.abs(off(b))) / 4) ** 2));
  const [p, q]: Point[] = [
    [from[0] + arm * Math.cos(a), from[1] + arm * Math.sin(a)],
    [to[0] - arm * Math.cos(b), to[1] - arm * Math.sin(b)],
  ] as [Point, Point];
  const bend = Math.max(...[[from, p, q], [p, q, to]].map(([u, v, w]) => (u && v && w ? Math.hypot(u[0] - 2 * v[0] + w[0], u[1] - 2 * v[1] + w[1]) : 0)));
  const pieces = Math.max(1, Math.ceil(Math.sqrt((0.75 * bend) / (SAGITTA * side)) - 1e-6));
  return Array.from({ length: pieces + 1 }, (_, k) => {
    const t = k / pieces;
    const ends = [between(between(from, p, t), between(p, q, t), t), between(between(p, q, t), between(q, to, t), t)] as const;
    return k === 0 ? from : k === pieces ? to : between(...ends, t);
  });
}

/** The stretches of a ring as it is now; straight ones where it has none yet. */
function stretched(figure: Figure, side: number): Stretch[] {
  const { points } = figure;
  settle(figure, side);
  return (figure.stretches ??= points.map((from, k) => stretchAlong([[...from], [...(points[(k + 1) % points.length] ?? from)]], false)));
}

/** Many times as large. */
export function scaled({ points, value, stretches }: Figure, by: number): Figure {
  const place = ([x, y]: Point): Point => [x * by, y * by];
  const larger = ({ smooth, from, to, length, inner }: Stretch): Stretch => ({ smooth, from: place(from), to: place(to), length: length * by, inner: inner.map(({ at, along }) => ({ at: place(at), along })) });
  return { points: points.map(place), value, ...(stretches && { stretches: stretches.map(larger) }) };
}

/** The place of the least of some distances. */
export function nearest(distances: number[]): number {
  return distances.reduce((best, far, k) => (far < (distances[best] ?? Infinity) ? k : best), 0);
}

function onSegment(place: Point, from: Point, to: Point): Point {
  const [x, y] = minus(to, from);
  const length = x * x + y * y;
  const along = length > 0 ? ((place[0] - from[0]) * x + (place[1] - from[1]) * y) / length : 0;
  return between(from, to, Math.min(1, Math.max(0, along)));
}

function same(a: Point, b: Point): boolean {
  return a[0] === b[0] && a[1] === b[1];
}

function times(a: Point, b: Point): Point {
  return [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
}

function over(a: Point, b: Point): Point {
  const square = b[0] * b[0] + b[1] * b[1];
  return square > 0 ? times(a, [b[0] / square, -b[1] / square]) : [1, 0];
}

function minus(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1]];
}

function sum(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

function unit([x, y]: Point): Point {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

function between(from: Point, to: Point, part: number): Point {
  return [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
}
