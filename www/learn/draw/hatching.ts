/** Slanted lines in polygons: they tell a tint without its colour. */
import type { Place } from '../figures/place';

/** Between two lines along x, in units of the plate. */
const APART = 7;

/** Lines with one sum of x and y for each, as long as they are in one of these convex polygons. '' if none is. */
export function hatched(polygons: readonly (readonly Place[])[]): string {
  const chords = polygons.flatMap((polygon) => {
    const sums = polygon.map(([x, y]) => x + y);
    const first = Math.ceil(Math.min(...sums) / APART);
    const count = Math.max(0, Math.floor(Math.max(...sums) / APART) - first + 1);
    return Array.from({ length: count }, (_, k) => chord(polygon, (first + k) * APART));
  });
  const d = chords.join('');
  return d && `<path class="hatch by-tint" d="${d}"/>`;
}

/** The part of a line in a polygon, from a whole x to a whole x: as text that is shorter, and hidden by edges. */
function chord(polygon: readonly Place[], sum: number): string {
  const ends = polygon.flatMap(([x, y], k): Place[] => {
    const [u, v] = polygon[(k + 1) % polygon.length] ?? [x, y];
    const [here, there] = [x + y - sum, u + v - sum];
    const share = here / (here - there);
    return here < 0 === there < 0 ? [] : [[x + share * (u - x), y + share * (v - y)]];
  });
  const [left, right] = [Math.ceil(Math.min(...ends.map(([x]) => x))), Math.floor(Math.max(...ends.map(([x]) => x)))];
  return right - left < 1 || ends.length < 2 ? '' : `M${left} ${sum - left}l${right - left} ${left - right}`;
}
