/** Fewer points for an outline that people edit by hand: Douglas and Peucker (1973), ring by ring. */
import type { Point, Ring } from '../../module/types';
import { distance, toSegment } from './plane';

/** The first tolerance, as a fraction of the picture's side, and its factor of growth until the points are few. */
const FIRST_TOLERANCE = 0.0008;
const GROWTH = 1.35;

/** The same outline with at most `most` points in all; rings keep at least three. */
export function simplify(rings: Ring[], side: number, most: number): Ring[] {
  return count(rings) > most ? thinned(rings, FIRST_TOLERANCE * side, most) : rings;
}

/**
 * The same outline without the points that lie within `tolerance` of it. The tolerance grows, up to `coarser` times,
 * until at most `most` points are left.
 */
export function thinned(rings: Ring[], tolerance: number, most: number, coarser = 1000): Ring[] {
  let fewer = rings.map((ring) => thin(ring, tolerance));
  for (let wider = tolerance * GROWTH; count(fewer) > most && wider < coarser * tolerance; wider *= GROWTH) {
    fewer = rings.map((ring) => thin(ring, wider));
  }
  return fewer;
}

function count(rings: Ring[]): number {
  return rings.reduce((total, ring) => total + ring.length, 0);
}

/** Cuts a ring at its first point and at the one farthest from it, and thins each half as an open line. */
function thin(ring: Ring, tolerance: number): Ring {
  const first = ring[0];
  if (!first || ring.length < 5) return ring;
  const half = farthest(ring, (point) => distance(point, first)).index;
  const there = thinLine(ring.slice(0, half + 1), tolerance);
  const back = thinLine([...ring.slice(half), first], tolerance);
  const thinned = [...there.slice(0, -1), ...back.slice(0, -1)];
  return thinned.length < 3 ? ring : thinned;
}

/** Thins an open line. Its ends stay. */
export function thinLine(line: Ring, tolerance: number): Ring {
  const kept: Ring = line.slice(0, 1);
  // A stack of parts to do: recursion could go as deep as there are points.
  const parts = [line];
  for (let part = parts.pop(); part; part = parts.pop()) {
    const [from, to] = [part[0], part.at(-1)];
    if (!from || !to || part.length < 2) continue;
    const { index, distance } = farthest(part, (point) => toSegment(point, from, to));
    if (part.length < 3 || distance <= tolerance) kept.push(to);
    else parts.push(part.slice(index), part.slice(0, index + 1));
  }
  return kept;
}

function farthest(line: Ring, measure: (point: Point) => number): { index: number; distance: number } {
  let found = { index: 0, distance: -1 };
  line.forEach((point, index) => {
    const distance = measure(point);
    if (distance > found.distance) found = { index, distance };
  });
  return found;
}
