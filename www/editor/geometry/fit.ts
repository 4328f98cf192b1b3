/** Outlines of any size become outlines of the picture. */
import type { Point, Ring } from '../../module/types';

/** What stays free around an outline, in sides. */
const MARGIN = 0.05;

/** An outline that is smaller than this part of the picture is meant in other units. */
const SMALL = 0.2;

/**
 * Scales rings to a picture of this side: as a square page of the side `page` goes into it where they lie on that;
 * else as they are where they fit; else so that they fill the picture but for a margin.
 */
export function fitted(rings: Ring[], side: number, page?: number): Ring[] {
  const points = rings.flat();
  const [left, right, top, bottom] = [0, 1].flatMap((axis) => {
    const places = points.map((point) => point[axis] ?? 0);
    return [places.reduce((a, b) => Math.min(a, b), Infinity), places.reduce((a, b) => Math.max(a, b), -Infinity)];
  }) as [number, number, number, number];
  const width = Math.max(right - left, bottom - top);
  const lies = (on: number): boolean => Math.min(left, top) >= -1e-6 * on && Math.max(right, bottom) <= on * (1 + 1e-6);
  if (page !== undefined && page > 0 && lies(page)) return mapped(rings, ([x, y]) => [(x * side) / page, (y * side) / page]);
  if (page === undefined && lies(side) && width > SMALL * side) return rings;
  const scale = width > 0 ? ((1 - 2 * MARGIN) * side) / width : 1;
  return mapped(rings, ([x, y]) => [side / 2 + (x - (left + right) / 2) * scale, side / 2 + (y - (top + bottom) / 2) * scale]);
}

function mapped(rings: Ring[], place: (point: Point) => Point): Ring[] {
  return rings.map((ring) => ring.map(place));
}
