/** Reads cells that the module has joined to a mesh and to polygons. */
import type { JoinedCells, Triangle } from '../figures/joined';
import type { Place } from '../figures/place';
import type { Studio } from './studio';

/** How many numbers a point, an element, and a triangle have. */
const [POINT, FACE, TRIANGLE] = [3, 4, 10];

/** Joins the cells of the step that the studio holds. */
export function joinedBy(studio: Studio, side: number): JoinedCells {
  while (!studio.joinCells(50));
  const [median = 0, ...counts] = studio.joined('angles');
  return {
    points: new Map(rowsOf(studio.joined('points'), POINT).map(([id = 0, x = 0, y = 0]) => [id, [x / side, y / side]])),
    faces: rowsOf(studio.joined('faces'), FACE).map((ids) => ids.filter((id) => id >= 0)),
    triangles: rowsOf(studio.joined('triangles'), TRIANGLE).map((row) => triangle(row, side)),
    cells: cellsIn(studio.joined('cells'), side),
    median,
    counts,
  };
}

function rowsOf(numbers: Float64Array, width: number): number[][] {
  return Array.from({ length: numbers.length / width }, (_, k) => Array.from(numbers.subarray(k * width, (k + 1) * width)));
}

function triangle(row: readonly number[], side: number): Triangle {
  const [shortest = 0, x = 0, y = 0, radius = 0] = row.slice(6).map((length) => length / side);
  const centre: Place = [x, y];
  return { ids: row.slice(0, 3), angles: row.slice(3, 6), shortest, centre, radius };
}

/** Polygons one after the other, each with its id and the number of its corners before them. */
function cellsIn(numbers: Float64Array, side: number): Map<number, number[]> {
  const cells = new Map<number, number[]>();
  for (let from = 0; from < numbers.length; ) {
    const [id = 0, corners = 0] = numbers.subarray(from, from + 2);
    const end = from + 2 + 2 * corners;
    cells.set(id, Array.from(numbers.subarray(from + 2, end), (value) => value / side));
    from = end;
  }
  return cells;
}
