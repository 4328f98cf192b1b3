/**
 * Rings as curves through a few handles. A stretch of the ring's points runs between two handles. It stays the same to the
 * last bit while neither handle moves. When one moves, the stretch is rotated and scaled to the new places, and bent so
 * that the curve stays smooth at smooth handles. A handle that does not move keeps its direction, so the curve beyond it
 * stays the same.
 */
import type { Point, Ring } from '../../module/types';
import type { Figure, Stretch } from './figures';
import { between, distance, minus, nearest, onSegment, over, same, sum, times, toSegment, unit } from './plane';

/** Chords differ from a curve by at most this many sides, as in the built-in outlines. */
const SAGITTA = 1 / 6000;

/** Makes a stretch of these points, both ends included. */
export function stretchAlong(line: Ring, smooth: boolean): Stretch {
  const lengths = line.map((at, k) => distance(line[k - 1] ?? at, at));
  const length = lengths.reduce((sum, piece) => sum + piece, 0);
  let along = 0;
  const inner = line.map((at, k) => ({ at, along: (along += (lengths[k] ?? 0) / (length || 1)) })).slice(1, -1);
  return { smooth, from: line[0] ?? [0, 0], to: line.at(-1) ?? [0, 0], length, inner };
}

/** For each handle, the points from it to before the next handle. Without stretches, the pieces are straight. */
export function lines(figure: Figure, side: number): Point[][] {
  const { points, stretches } = figure;
  return points.map((from, k) => (stretches ? [from, ...bent(stretches, points, k, side)] : [from]));
}

/** All points of a ring. */
export function ringOf(figure: Figure, side: number): Ring {
  return lines(figure, side).flat();
}

/** Makes the present curves the originals that later moves bend. */
export function settle(figure: Figure, side: number): void {
  const { points, stretches } = figure;
  if (!stretches) return;
  const now = lines(figure, side);
  figure.stretches = stretches.map((stretch, k) => {
    const [from, to] = [points[k] ?? stretch.from, points[(k + 1) % points.length] ?? stretch.to];
    return same(from, stretch.from) && same(to, stretch.to) ? stretch : stretchAlong([...(now[k] ?? [from]), to], stretch.smooth);
  });
}

/** The points between a handle and the next one. */
function bent(stretches: Stretch[], points: Point[], index: number, side: number): Point[] {
  const next = (index + 1) % points.length;
  const [stretch, start, end] = [stretches[index], points[index], points[next]];
  if (!stretch || !start || !end) return [];
  const { from, to, length, inner } = stretch;
  if (same(start, from) && same(end, to)) return inner.map(({ at }) => at);
  // Complex numbers stand for directions and rotations.
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

/** The unit tangent at a smooth handle, on the stretches as they were before any move. */
function direction(stretches: Stretch[], index: number): Point {
  const [before, behind] = [stretches.at(index - 1), stretches[index]];
  if (!before || !behind) return [1, 0];
  const [last, next] = [before.inner.at(-1)?.at ?? before.from, behind.inner[0]?.at ?? behind.to];
  return through(last, behind.from, next);
}

/** The mean of the directions from `a` to `b` and from `b` to `c`, as a unit vector. */
function through(a: Point, b: Point, c: Point): Point {
  return unit(sum(unit(minus(b, a)), unit(minus(c, b))));
}

/** How far the tangent at a smooth handle turns, as a complex number: 1 if the handle has not moved. */
function swing(stretches: Stretch[], points: Point[], index: number): Point {
  const [before, here, next] = [points.at(index - 1), points[index], points[(index + 1) % points.length]];
  const [last, base] = [stretches.at(index - 1), stretches[index]];
  if (!before || !here || !next || !last || !base || same(here, base.from)) return [1, 0];
  return over(through(before, here, next), through(last.from, base.from, base.to));
}

/**
 * The points of a stretch, and further ones on the curve through them: about `parts` pieces in all, and at least
 * `least` between two points.
 */
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

/** The point halfway along a line that ends at `to`. */
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

/**
 * Adds a handle to a ring after handle `index`, where the ring is nearest to `near`; halfway without `near`. It is
 * smooth on a curve, and a corner on a straight line.
 */
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

/** Index of the stretch nearest to a place, and so of the handle where it begins. */
export function nearestLine(figure: Figure, place: Point, side: number): number {
  const all = lines(figure, side);
  return nearest(all.map((line, k) => Math.min(...line.map((from, n) => toSegment(place, from, line[n + 1] ?? all[(k + 1) % all.length]?.[0] ?? from)))));
}

/** Removes a handle from a ring: one stretch replaces the two beside it. */
export function join(figure: Figure, index: number, side: number): void {
  const [before, next] = beside(figure, index);
  const all = stretched(figure, side);
  const ways = [way(all, before), way(all, next)] as const;
  lay(figure, before, next, ...ways, side);
  figure.points.splice(index, 1);
  all.splice(index, 1);
}

/** Makes a corner smooth, or a smooth handle a corner. The stretches beside it become as simple as possible. */
export function turnOver(figure: Figure, index: number, side: number): void {
  const [before, next] = beside(figure, index);
  const all = stretched(figure, side);
  const [stretch, from, here, to] = [all[index], ...[before, index, next].map((k) => figure.points[k])];
  if (!stretch || !from || !here || !to) return;
  const [first, last] = [way(all, before), way(all, next)];
  stretch.smooth = !stretch.smooth;
  const turned = stretch.smooth ? through(from, here, to) : undefined;
  lay(figure, before, index, first, turned, side);
  lay(figure, index, next, turned, last, side);
}

function beside({ points }: Figure, index: number): [before: number, next: number] {
  return [(index + points.length - 1) % points.length, (index + 1) % points.length];
}

/** The unit tangent at a handle; undefined at a corner. */
function way(stretches: Stretch[], index: number): Point | undefined {
  return stretches[index]?.smooth ? direction(stretches, index) : undefined;
}

/** Replaces the stretch after a handle by a curve with these end tangents; without tangents by a straight line. */
function lay({ points, stretches }: Figure, index: number, next: number, leaves: Point | undefined, comes: Point | undefined, side: number): void {
  const [from, to, stretch] = [points[index], points[next], stretches?.[index]];
  if (from && to && stretches && stretch) stretches[index] = stretchAlong(swung(from, to, leaves, comes, side), stretch.smooth);
}

/** A curve that starts and ends in these directions, close to a circular arc where possible. With one direction it is an arc. */
function swung(from: Point, to: Point, leaves: Point | undefined, comes: Point | undefined, side: number): Ring {
  const chord = minus(to, from);
  const way = unit(chord);
  const mirrored = ([x, y]: Point): Point => times(times(way, way), [x, -y]);
  const a = leaves ?? (comes ? mirrored(comes) : way);
  const b = comes ?? (leaves ? mirrored(leaves) : way);
  const turn = [a, b].reduce((whole, angle) => whole + Math.abs(Math.atan2(way[0] * angle[1] - way[1] * angle[0], way[0] * angle[0] + way[1] * angle[1])), 0);
  const speed: Point = [Math.hypot(...chord) / Math.max(0.25, Math.cos(turn / 4) ** 2), 0];
  const [out, back] = [times(a, speed), times(b, speed)];
  const bend = Math.max(...[[4, 2], [2, 4]].map(([m = 0, n = 0]) => Math.hypot(6 * chord[0] - m * out[0] - n * back[0], 6 * chord[1] - m * out[1] - n * back[1])));
  const pieces = Math.max(1, Math.ceil(Math.sqrt(bend / (8 * SAGITTA * side)) - 1e-6));
  return [from, ...Array.from({ length: pieces - 1 }, (_, k) => hermite(from, out, to, back, (k + 1) / pieces)), to];
}

/** The stretches of a ring as it is now; straight ones if it had none. */
function stretched(figure: Figure, side: number): Stretch[] {
  const { points } = figure;
  settle(figure, side);
  return (figure.stretches ??= points.map((from, k) => stretchAlong([from, points[(k + 1) % points.length] ?? from], false)));
}

/** The figure scaled by a factor. */
export function scaled({ points, value, stretches }: Figure, by: number): Figure {
  const place = ([x, y]: Point): Point => [x * by, y * by];
  const larger = ({ smooth, from, to, length, inner }: Stretch): Stretch => ({ smooth, from: place(from), to: place(to), length: length * by, inner: inner.map(({ at, along }) => ({ at: place(at), along })) });
  return { points: points.map(place), value, ...(stretches && { stretches: stretches.map(larger) }) };
}
