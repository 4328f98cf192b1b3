/**
 * The height field as a closed slab in an STL file for 3D printing. Units are millimetres, axes are right-handed with
 * z up, and the picture is seen from above.
 *
 * The file is binary STL (3D Systems, 1989): an 80-byte title, the count of triangles, and for each triangle its
 * normal and corners as floats and two empty bytes. The top has two triangles for each square of a grid, each wall
 * has one such square below each edge of the grid, and the base is a fan.
 */
import type { PixelMap } from '../../module/types';
import type { Progress } from './worked';

/** Lengths are in millimetres. */
export interface Slab {
  side: number;
  /** The thickness under the lowest point. */
  base: number;
  /** The height from the lowest to the highest point. */
  relief: number;
  squares: number;
}

const HEAD = 84;
const TRIANGLE = 50;

type Corner = readonly [x: number, y: number, z: number];

/** The size of a file with `squares` squares along a side. */
export function slabSize(squares: number): { triangles: number; bytes: number } {
  const triangles = 2 * squares * squares + 12 * squares;
  return { triangles, bytes: HEAD + TRIANGLE * triangles };
}

/** The file of a map of heights as floats. Heights of a tile are continued beyond its edges. */
export function slabFile(slab: Slab, map: PixelMap, tile: boolean, progress: Progress): Blob {
  const { side, base, relief, squares: n } = slab;
  const { triangles, bytes } = slabSize(n);
  const file = new DataView(new ArrayBuffer(bytes));
  new Uint8Array(file.buffer).set(new TextEncoder().encode('Made by Bubblestone. Millimetres.'.padEnd(HEAD - 4)));
  file.setUint32(HEAD - 4, triangles, true);
  let at = HEAD;
  /** Writes a triangle. Its corners are counter-clockwise seen from outside. */
  const put = (a: Corner, b: Corner, c: Corner): void => {
    for (const corner of [normal(a, b, c), a, b, c]) {
      for (const v of corner) {
        file.setFloat32(at, v, true);
        at += 4;
      }
    }
    at += 2;
  };
  const heights = crossings(map, n, tile, (done) => progress(0.8 * done));
  const [low, high] = heightRange(map);
  const rise = high > low ? relief / (high - low) : 0;
  const corner = (i: number, j: number, z: number): Corner => [(i * side) / n, ((n - j) * side) / n, z];
  const top = (i: number, j: number): Corner => corner(i, j, base + ((heights[j * (n + 1) + i] ?? low) - low) * rise);
  const middle: Corner = [side / 2, side / 2, 0];
  /**
   * A square of a wall and its triangle of the base, below two grid points that follow each other clockwise seen from
   * above.
   */
  const wall = (i: number, j: number, k: number, l: number): void => {
    const [a, b, c, d] = [top(i, j), top(k, l), corner(i, j, 0), corner(k, l, 0)];
    put(a, b, d);
    put(a, d, c);
    put(c, d, middle);
  };
  for (let j = 0; j < n; j += 1) {
    for (let i = 0; i < n; i += 1) {
      const [a, b, c, d] = [top(i, j), top(i + 1, j), top(i, j + 1), top(i + 1, j + 1)];
      put(a, d, b);
      put(a, c, d);
    }
    wall(j, 0, j + 1, 0);
    wall(n, j, n, j + 1);
    wall(n - j, n, n - j - 1, n);
    wall(0, n - j, 0, n - j - 1);
  }
  progress(1);
  return new Blob([file.buffer], { type: 'model/stl' });
}

/** The mean height around each point of a grid with `n` squares a side, row by row. */
function crossings({ side, bytes }: PixelMap, n: number, tile: boolean, progress: Progress): Float32Array {
  const values = new DataView(bytes.buffer, bytes.byteOffset);
  const half = Math.max(0.5, side / n / 2);
  /** The pixels around a grid point, along a row or column. */
  const around = (k: number): number[] => {
    const place = tile && k === n ? 0 : (k * side) / n;
    const [from, to] = [Math.floor(place - half), Math.ceil(place + half)];
    const all = Array.from({ length: to - from }, (_, by) => from + by);
    return tile ? all.map((v) => (v + side) % side) : all.filter((v) => v >= 0 && v < side);
  };
  const spans = Array.from({ length: n + 1 }, (_, k) => around(k));
  const means = new Float32Array((n + 1) ** 2);
  spans.forEach((rows, j) => {
    spans.forEach((columns, i) => {
      let sum = 0;
      for (const y of rows) for (const x of columns) sum += values.getFloat32(4 * (y * side + x));
      means[j * (n + 1) + i] = sum / (rows.length * columns.length);
    });
    progress(j / n);
  });
  return means;
}

function heightRange({ side, bytes }: PixelMap): [low: number, high: number] {
  const values = new DataView(bytes.buffer, bytes.byteOffset);
  let [low, high] = [Infinity, -Infinity];
  for (let at = 0; at < 4 * side * side; at += 4) {
    const height = values.getFloat32(at);
    low = Math.min(low, height);
    high = Math.max(high, height);
  }
  return [low, high];
}

function normal(a: Corner, b: Corner, c: Corner): Corner {
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}
