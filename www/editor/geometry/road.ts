/** The border of roads, from their middle lines. */
import type { Point, Ring } from '../../module/types';
import { contour, tidy } from './contour';
import type { Figure } from './figures';
import { distance } from './plane';

/** Squares of the grid along the picture's side. */
const GRID = 288;

/** TOLERANCE is the largest error of the border, in squares of the grid; MOST is the limit of its points. */
const TOLERANCE = 0.22;
const MOST = 300;

/**
 * The common border of all roads, within the picture. Joints are round, ends are cut straight, and roads may cross
 * themselves and each other. A place is inside where its distance to a middle line is less than half the width.
 */
export function roadRings(roads: Figure[], side: number): Ring[] {
  const columns = GRID + 1;
  const scale = side / GRID;
  const values = new Float32Array(columns * columns).fill(-1);
  for (const { points, value } of roads) pave(values, columns, points.map(([x, y]): Point => [x / scale, y / scale]), (value / 200) * GRID);
  // Nodes at the picture's border are not inside; their neighbours are inside by at most one square.
  for (let k = 0; k < columns; k += 1) {
    for (const rim of [0, 1, GRID - 1, GRID]) {
      const most = rim === 0 || rim === GRID ? 0 : 1;
      for (const node of [rim * columns + k, k * columns + rim]) values[node] = Math.min(values[node] ?? -1, most);
    }
  }
  return tidy(contour(values, columns), TOLERANCE, MOST).map((ring) => ring.map(([x, y]): Point => [x * scale, y * scale]));
}

/** Raises the numbers around a middle line to half the width minus the distance to it. */
function pave(values: Float32Array, columns: number, line: Point[], half: number): void {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return;
  // A line that ends where it began is closed: a ring road.
  const closed = line.length > 2 && distance(first, last) < half;
  const points = closed ? [...line, first] : line;
  points.slice(1).forEach((to, k) => {
    const from = points[k] ?? to;
    const length = distance(from, to);
    if (!(length > 0)) return;
    const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const cut = [!closed && k === 0, !closed && k === points.length - 2];
    const range = (axis: 0 | 1): [number, number] => [
      Math.max(0, Math.floor(Math.min(from[axis], to[axis]) - half - 2)),
      Math.min(columns - 1, Math.ceil(Math.max(from[axis], to[axis]) + half + 2)),
    ];
    const [left, right] = range(0);
    const [top, bottom] = range(1);
    for (let y = top; y <= bottom; y += 1) {
      for (let x = left; x <= right; x += 1) {
        const along = (x - from[0]) * ux + (y - from[1]) * uy;
        const across = (x - from[0]) * uy - (y - from[1]) * ux;
        const beyond = Math.max(-along, along - length, 0);
        let value = half - Math.hypot(across, beyond);
        if (cut[0]) value = Math.min(value, along, half - Math.abs(across));
        if (cut[1]) value = Math.min(value, length - along, half - Math.abs(across));
        const node = y * columns + x;
        if (value > (values[node] ?? -1)) values[node] = value;
      }
    }
  });
}
