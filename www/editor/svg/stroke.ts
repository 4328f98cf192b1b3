/**
 * The area that a stroke covers. One ring (two for a closed line) follows both sides of the line, with joins at outer
 * bends and caps at the ends. At inner bends a side passes through the line's own point. All parts then have the same
 * orientation, so the non-zero rule fills exactly the area of a pen with that width.
 */
import type { Point, Ring } from '../../module/types';

export interface Pen {
  width: number;
  cap: string;
  join: string;
  /** The mitre limit, in widths. */
  limit: number;
  /** Alternating lengths of dashes and gaps; empty for a solid line. */
  dashes: number[];
  offset: number;
}

/** The finest step of a round part, in radians. */
const FINEST = 0.01;

/** Most dashes of a line. A line with more is drawn solid. */
const DASHES = 5000;

/** The rings around a line whose points do not repeat. Round parts are off by at most `tolerance`. */
export function stroked(line: Ring, closed: boolean, pen: Pen, tolerance: number): Ring[] {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last || !(pen.width > 0)) return [];
  const around = closed && line.length > 1 && first[0] === last[0] && first[1] === last[1] ? line.slice(0, -1) : line;
  const half = pen.width / 2;
  const step = Math.max(FINEST, 2 * Math.acos(Math.max(0, 1 - tolerance / half)));
  if (around.length < 2) return dot(first, half, pen.cap, step);
  const dashes = dashed(around, closed, pen);
  if (dashes) return dashes.flatMap((dash) => stroked(dash, false, { ...pen, dashes: [] }, tolerance));
  const way = (points: Ring): Ring => (closed ? [points.at(-1) ?? first, ...points, points[0] ?? first] : points);
  const [there, again] = [side(way(around), half, pen, step, !closed), side(way(around.toReversed()), half, pen, step, !closed)];
  return closed ? [there, again] : [[...there, ...again]];
}

/** The mark of a pen that does not move. */
function dot([x, y]: Point, half: number, cap: string, step: number): Ring[] {
  if (cap === 'round') return [turned([x, y], [half, 0], 2 * Math.PI, step)];
  return cap === 'square' ? [[[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]] : [];
}

/** The left side of a line, with the cap at its end if it has one. */
function side(line: Ring, half: number, pen: Pen, step: number, capped: boolean): Ring {
  const ring: Ring = [];
  let before: Point | undefined;
  for (let k = 0; k + 1 < line.length; k += 1) {
    const [from, to] = [line[k], line[k + 1]] as [Point, Point];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const along: Point = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    if (before) ring.push(...join(from, before, along, half, pen, step));
    else if (capped) ring.push(left(from, along, half));
    before = along;
    // A closed line repeats its first piece at its end.
    if (!capped && k + 2 === line.length) return ring;
  }
  const end = line.at(-1);
  if (end && before) ring.push(...capOf(end, before, half, pen.cap, step));
  return ring;
}

function left([x, y]: Point, [u, v]: Point, half: number): Point {
  return [x - v * half, y + u * half];
}

function join(at: Point, before: Point, after: Point, half: number, { join: kind, limit }: Pen, step: number): Ring {
  const [from, to] = [left(at, before, half), left(at, after, half)];
  const cross = before[0] * after[1] - before[1] * after[0];
  const dot = before[0] * after[0] + before[1] * after[1];
  if (cross > 0) return [from, at, to];
  if (kind === 'round') return turned(at, [from[0] - at[0], from[1] - at[1]], -Math.abs(Math.atan2(cross, dot)), step);
  // The mitre's length in widths is 1 / sin of half the angle between the pieces; its square is 2 / (1 + dot).
  if (kind === 'bevel' || kind === 'arcs' || 2 > limit * limit * (1 + dot)) return [from, to];
  const reach = half / (1 + dot);
  return [from, [at[0] - (before[1] + after[1]) * reach, at[1] + (before[0] + after[0]) * reach], to];
}

function capOf(end: Point, along: Point, half: number, cap: string, step: number): Ring {
  const from = left(end, along, half);
  const to = left(end, along, -half);
  if (cap === 'round') return turned(end, [from[0] - end[0], from[1] - end[1]], -Math.PI, step);
  if (cap !== 'square') return [from, to];
  const [u, v] = [along[0] * half, along[1] * half];
  return [from, [from[0] + u, from[1] + v], [to[0] + u, to[1] + v], to];
}

/** Points on an arc around a point, both ends included. */
function turned([x, y]: Point, [u, v]: Point, angle: number, step: number): Ring {
  const pieces = Math.max(1, Math.ceil(Math.abs(angle) / step));
  return Array.from({ length: pieces + 1 }, (_, k): Point => {
    const [sin, cos] = [Math.sin((angle * k) / pieces), Math.cos((angle * k) / pieces)];
    return [x + u * cos - v * sin, y + u * sin + v * cos];
  });
}

/** The dashes of a line; undefined if it is solid. */
function dashed(line: Ring, closed: boolean, { dashes, offset }: Pen): Ring[] | undefined {
  const pattern = dashes.length % 2 ? [...dashes, ...dashes] : dashes;
  const period = pattern.reduce((sum, length) => sum + length, 0);
  const way = closed && line[0] ? [...line, line[0]] : line;
  const total = way.reduce((sum, [x, y], k) => sum + Math.hypot(x - (way[k - 1]?.[0] ?? x), y - (way[k - 1]?.[1] ?? y)), 0);
  if (!(period > 0) || pattern.some((length) => !(length >= 0)) || !((total / period) * pattern.length < DASHES)) return undefined;
  let at = 0;
  let rest = ((offset % period) + period) % period;
  while (rest >= (pattern[at] ?? 0)) {
    rest -= pattern[at] ?? 0;
    at = (at + 1) % pattern.length;
  }
  const found: Ring[] = [];
  let room = (pattern[at] ?? 0) - rest;
  let dash: Ring | undefined = at % 2 ? undefined : [way[0] ?? [0, 0]];
  way.slice(1).forEach((to, k) => {
    const from = way[k] ?? to;
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    let gone = 0;
    while (length - gone > room) {
      gone += room;
      const place: Point = [from[0] + ((to[0] - from[0]) * gone) / length, from[1] + ((to[1] - from[1]) * gone) / length];
      if (dash) found.push([...dash, place]);
      at = (at + 1) % pattern.length;
      dash = at % 2 ? undefined : [place];
      room = pattern[at] ?? 0;
    }
    room -= length - gone;
    dash?.push(to);
  });
  if (!dash) return found.map(unrepeated);
  // A dash over the seam of a closed line is one dash.
  const [first] = found;
  const whole = closed && first && first[0] === way[0] ? [...dash.slice(0, -1), ...(found.shift() ?? [])] : dash;
  return [...found, whole].map(unrepeated);
}

function unrepeated(line: Ring): Ring {
  return line.filter(([x, y], k) => k === 0 || x !== line[k - 1]?.[0] || y !== line[k - 1]?.[1]);
}
