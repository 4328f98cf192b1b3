/** Fits outlines of any size into the picture. */
import type { Point, Ring } from '../../module/types';

/** Margin around an outline, in sides. */
const MARGIN = 0.05;

/** An outline smaller than this share of the picture must be in other units. */
const SMALL = 0.2;

/**
 * Scales rings to a picture of this side. Rings on a square page of side `page` keep their place on it. Without a page,
 * rings that fit and are not too small stay as they are. All others are scaled to fill the picture up to a margin.
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
