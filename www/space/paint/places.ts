/** Places on a model, in steps of the box around it, and the rows of the recipe that hold them. */

export type ModelPlace = readonly [x: number, y: number, z: number];

/**
 * Steps along the box's longest side. The recipe's rows hold whole steps; the engine's lists hold fractions of that
 * side.
 */
export const STEPS = 4096;

/**
 * The first tolerance of a simplified line, in steps, and the factor by which it grows while the line has too many
 * points.
 */
const OFF = 10;
const COARSER = 1.5;

export function distance(a: ModelPlace, b: ModelPlace): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** The distance of a place from a segment. */
function fromSegment(p: ModelPlace, a: ModelPlace, b: ModelPlace): number {
  const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const square = dx * dx + dy * dy + dz * dz;
  const along = square > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy + (p[2] - a[2]) * dz) / square : 0;
  const t = Math.min(1, Math.max(0, along));
  return distance(p, [a[0] + t * dx, a[1] + t * dy, a[2] + t * dz]);
}

/** The distance of a place from a line. */
export function fromLine(p: ModelPlace, line: readonly ModelPlace[]): number {
  const [first] = line;
  if (!first) return Infinity;
  return line.slice(1).reduce((least, to, k) => Math.min(least, fromSegment(p, line[k] ?? to, to)), distance(p, first));
}

/** The line with at most `most` points and at least two (Douglas, Peucker 1973). */
export function simplified(line: readonly ModelPlace[], most: number): ModelPlace[] {
  for (let off = OFF; ; off *= COARSER) {
    const kept = within(line, off);
    if (kept.length <= Math.max(2, most)) return kept;
  }
}

function within(line: readonly ModelPlace[], off: number): ModelPlace[] {
  const kept = new Set([0, line.length - 1]);
  const open: [number, number][] = [[0, line.length - 1]];
  for (let next = open.pop(); next; next = open.pop()) {
    const [from, to] = next;
    const [a, b] = [line[from], line[to]];
    if (!a || !b) break;
    let [farthest, at] = [off, -1];
    for (let k = from + 1; k < to; k += 1) {
      const far = fromSegment(line[k] ?? a, a, b);
      if (far > farthest) [farthest, at] = [far, k];
    }
    if (at < 0) continue;
    kept.add(at);
    open.push([from, at], [at, to]);
  }
  return line.filter((_, k) => kept.has(k));
}

/** The places of a row, from a list of the engine. */
export function placesOf(row: readonly number[]): ModelPlace[] {
  const count = Math.floor(row.length / 3);
  return Array.from({ length: count }, (_, k) => [0, 1, 2].map((axis) => (row[3 * k + axis] ?? 0) * STEPS) as unknown as ModelPlace);
}

/** A row of places for the engine. */
export function rowOf(places: readonly ModelPlace[]): number[] {
  return places.flat().map((steps) => steps / STEPS);
}

export function textOf(rows: readonly (readonly number[])[]): string {
  return rows.map((row) => row.join()).join(';');
}
