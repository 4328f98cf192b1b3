/** Regions of equal height on a grid, by marching squares. */
import type { Place } from '../figures/place';

/** A height at a column and a row. */
export type Heights = (column: number, row: number) => number;

/** The first and the last column, and also the first and the last row. */
export type Range = readonly [first: number, last: number];

/** A part of a border through one grid square: its ends, and the number of the side that it goes to. */
interface BorderSegment {
  readonly from: Place;
  readonly to: Place;
  readonly side: number;
}

/** The parts of a border, by the numbers of the sides that they come from. */
type SegmentsBySide = Map<number, BorderSegment[]>;

/** More columns than any grid has. */
const WIDE = 4096;

/** The corners of a grid square in cyclic order. Side k joins corner k with the next one. */
const CORNERS: readonly Place[] = [[0, 0], [1, 0], [1, 1], [0, 1]];
const SIDES = [0, 1, 2, 3];

/** The height beside the grid: so low that borders there keep close to the grid. */
const DEEP = -1e9;

/** For each level, the borders of the ground from it up, all closed, as it falls beside the grid. Levels must rise. */
export function regions(heights: Heights, range: Range, levels: readonly number[]): Place[][][] {
  const work = tracing(heights, range, levels);
  for (;;) {
    const { done, value } = work.next();
    if (done) return value;
  }
}

/** Like `regions`, but in parts, each of which does a row of the grid. */
export function* tracing(heights: Heights, [first, last]: Range, levels: readonly number[]): Generator<undefined, Place[][][]> {
  const all = levels.map((level) => ({ level, parts: new Map<number, BorderSegment[]>() }));
  const high = (column: number, row: number): number => (column < first || row < first || column > last || row > last ? DEEP : heights(column, row));
  for (let row = first - 1; row <= last; row++) {
    let [below, above] = [high(first - 1, row), high(first - 1, row + 1)];
    for (let column = first - 1; column <= last; column++) {
      const [nextBelow, nextAbove] = [high(column + 1, row), high(column + 1, row + 1)];
      const [least, most] = [Math.min(below, nextBelow, nextAbove, above), Math.max(below, nextBelow, nextAbove, above)];
      for (const { level, parts } of all) {
        if (level > most) break;
        if (level > least) cross([below, nextBelow, nextAbove, above], level, [column, row], parts);
      }
      [below, above] = [nextBelow, nextAbove];
    }
    yield;
  }
  return all.map(({ parts }) => linked(parts));
}

/** Adds the parts of a border through one grid square: higher ground lies to the left. */
function cross(corners: readonly number[], level: number, square: Place, parts: SegmentsBySide): void {
  const ends = SIDES.filter((k) => rises(corners, level, k, false));
  SIDES.filter((k) => rises(corners, level, k, true)).forEach((side, k) => {
    const end = ends[k] ?? 0;
    const name = nameOf(square, side);
    const part = { from: crossing(corners, level, square, side), to: crossing(corners, level, square, end), side: nameOf(square, end) };
    parts.set(name, [...(parts.get(name) ?? []), part]);
  });
}

/** The number of a side, which is the same for both squares that share it. */
function nameOf([column, row]: Place, side: number): number {
  return ((row + (side === 2 ? 1 : 0)) * WIDE + column + (side === 1 ? 1 : 0)) * 2 + (side % 2);
}

/** Whether the ground rises past a level along a side, or falls past it. */
function rises(corners: readonly number[], level: number, side: number, isUp: boolean): boolean {
  const [from, to] = [(corners[side] ?? 0) >= level, (corners[(side + 1) % 4] ?? 0) >= level];
  return from !== to && to === isUp;
}

function crossing(corners: readonly number[], level: number, [column, row]: Place, side: number): Place {
  const [a, b] = [(corners[side] ?? 0) - level, (corners[(side + 1) % 4] ?? 0) - level];
  const [[x, y], [u, v]] = [CORNERS[side] ?? [0, 0], CORNERS[(side + 1) % 4] ?? [0, 0]];
  const share = a / (a - b);
  return [column + x + share * (u - x), row + y + share * (v - y)];
}

/** Joins the parts to closed borders. */
function linked(parts: SegmentsBySide): Place[][] {
  const borders: Place[][] = [];
  for (const start of parts.keys()) {
    const border: Place[] = [];
    for (let part = taken(start, parts); part; part = taken(part.side, parts)) border.push(part.from, part.to);
    borders.push(border.filter((_, k) => k % 2 === 0));
  }
  return borders;
}

/** Removes and returns a part that starts at this side; `undefined` if none is left. */
function taken(name: number, parts: SegmentsBySide): BorderSegment | undefined {
  const list = parts.get(name) ?? [];
  const part = list.pop();
  if (!list.length) parts.delete(name);
  return part;
}

/** The pieces of a closed border that are inside the grid. Where it enters and leaves, it has points on the grid's own lines. */
export function inside(border: readonly Place[], [first, last]: Range): Place[][] {
  const isIn = ([x, y]: Place): boolean => Math.min(x, y) >= first && Math.max(x, y) <= last;
  const begin = border.findIndex((point) => !isIn(point));
  if (begin < 0) return [[...border, ...border.slice(0, 1)]];
  const pieces: Place[][] = [[]];
  for (const point of [...border.slice(begin), ...border.slice(0, begin)]) {
    if (isIn(point)) pieces.at(-1)?.push(point);
    else if (pieces.at(-1)?.length) pieces.push([]);
  }
  return pieces.filter((piece) => piece.length > 1);
}

/** Leaves out points that are within the tolerance of the straight line between the points that stay. */
export function simplified(line: readonly Place[], tolerance: number): Place[] {
  const kept = line.slice(0, 1);
  let from = 0;
  line.forEach((_, to) => {
    if (to < from + 2 || !leaves(line, from, to, tolerance)) return;
    from = to - 1;
    kept.push(...line.slice(from, from + 1));
  });
  return line.length > 1 ? [...kept, ...line.slice(-1)] : kept;
}

/** Whether a line is farther than the tolerance from the straight line between two of its points. */
function leaves(line: readonly Place[], from: number, to: number, tolerance: number): boolean {
  const [[x, y], [u, v]] = [line[from] ?? [0, 0], line[to] ?? [0, 0]];
  const length = Math.hypot(u - x, v - y) || 1e-9;
  for (let k = from + 1; k < to; k++) {
    const [p, q] = line[k] ?? [0, 0];
    if (Math.abs((p - x) * (v - y) - (q - y) * (u - x)) > tolerance * length) return true;
  }
  return false;
}
