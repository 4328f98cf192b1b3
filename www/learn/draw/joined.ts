/** Reads cells that the module has joined to a mesh and to polygons. */
import type { JoinedCells, Triangle } from '../figures/joined';
import type { Place } from '../figures/place';
import { inRows, polygonsIn } from './rows';
import type { Studio } from './studio';

/** How many numbers a point, an element, and a triangle have. */
const [POINT, FACE, TRIANGLE] = [3, 4, 10];

/** Joins the cells of the step that the studio holds. */
export function joinedBy(studio: Studio, side: number): JoinedCells {
  while (!studio.joinCells(50));
  const [median = 0, ...counts] = studio.joined('angles');
  return {
    points: new Map(inRows(studio.joined('points'), POINT).map(([id = 0, x = 0, y = 0]) => [id, [x / side, y / side]])),
    faces: inRows(studio.joined('faces'), FACE).map((ids) => ids.filter((id) => id >= 0)),
    triangles: inRows(studio.joined('triangles'), TRIANGLE).map((row) => triangle(row, side)),
    cells: new Map(polygonsIn(studio.joined('cells')).map(([id, corners]) => [id, Array.from(corners, (value) => value / side)])),
    median,
    counts,
  };
}

function triangle(row: readonly number[], side: number): Triangle {
  const [shortest = 0, x = 0, y = 0, radius = 0] = row.slice(6).map((length) => length / side);
  const centre: Place = [x, y];
  return { ids: row.slice(0, 3), angles: row.slice(3, 6), shortest, centre, radius };
}
