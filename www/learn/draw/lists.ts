/** Points in the lists of a recipe: rows of given bubbles are x, y, held; the outline is one row of its corners. */
import type { PlaceList, PointList } from '../figures/figure';
import { inRows } from './rows';

interface Rows {
  readonly numbers: Float64Array;
}

/** How many numbers a point has in each list. */
const WIDTHS: Readonly<Record<PlaceList, number>> = { given: 3, poly: 2, strokes: 2 };

/** The sign between two points in the text of a list. */
const BETWEEN: Readonly<Record<PointList, string>> = { given: ';', poly: ',' };

/** The decimals that name a point of a list exactly. */
const DIGITS = 9;

/** The points with all their numbers. */
export function rowsOf({ numbers }: Rows, list: PlaceList): number[][] {
  return inRows(numbers, WIDTHS[list]);
}

export function pointsIn(rows: Rows, list: PlaceList): (readonly [number, number])[] {
  return rowsOf(rows, list).map(([x = 0, y = 0]) => [x, y]);
}

/** The rows with one point moved. */
export function movedIn(rows: readonly (readonly number[])[], row: number, [x, y]: readonly [number, number]): (readonly number[])[] {
  return rows.map((numbers, k) => (k === row ? [x, y, ...numbers.slice(2)] : numbers));
}

/** The text of a list as a recipe takes it. */
export function listText(rows: readonly (readonly number[])[], list: PointList): string {
  return rows.map((numbers) => numbers.map((value) => String(Number(value.toFixed(DIGITS)))).join(',')).join(BETWEEN[list]);
}
