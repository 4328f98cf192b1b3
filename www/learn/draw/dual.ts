/**
 * Bubbles, their mesh and their cells, a layer at a time: first one cell with a corner in each triangle, then those
 * around it, then all.
 */
import type { Plate, View } from '../figures/figure';
import { nearestPoint, type JoinedCells } from '../figures/joined';
import { outlineOf, ringPath, SIDE } from './crowd';
import { dots, linesOf, onPlate } from './mesh';
import { circle, svg } from './plate';

/** The layers at which the mesh, one cell, its neighbours and all cells come. */
const [MESH, ONE, AROUND, ALL] = [1, 2, 3, 4];

export function dual(view: View, { packing }: Plate): string {
  const { step, language } = view;
  const trace = view.traces[packing];
  if (!trace?.cells.length) return svg(SIDE, '', '');
  const joined = trace.joined(step);
  const own = nearestPoint(joined, view.at) ?? 0;
  const said = language === 'ja' ? `${joined.points.size}個のバブル${step >= MESH ? 'とメッシュ' : ''}${step >= ONE ? 'とセル' : ''}` : `${joined.points.size} bubbles${step >= MESH ? ' and their mesh' : ''}${step >= ONE ? ' and cells' : ''}`;
  const bubbles = trace.cells.map(({ id, x, y, radius }) => circle([x * SIDE, y * SIDE], radius * SIDE, `bubble${id === own && step < ONE ? ' own' : ''}${step >= AROUND ? ' behind' : ''}`));
  const drawn = [outlineOf(trace), ...bubbles, cellsIn(joined, own, step), meshIn(joined, own, step), step >= ONE ? ringOf(joined, own) : ''];
  return svg(SIDE, said, drawn.join(''));
}

function meshIn({ points, faces }: JoinedCells, own: number, step: number): string {
  if (step < MESH) return '';
  const around = faces.filter((face) => face.includes(own));
  const spokes = around.flatMap((face) => face.filter((id) => id !== own).map((id) => [own, id]));
  const isWhole = step >= AROUND;
  return `${linesOf(points, faces, `mesh-edge${isWhole ? ' fine' : ''}`)}${step >= ONE ? linesOf(points, spokes, 'mesh-edge own') : ''}${dots(points, 3)}`;
}

/** The cells of a layer. */
function cellsIn({ cells, faces }: JoinedCells, own: number, step: number): string {
  const around = new Set(faces.filter((face) => face.includes(own)).flat());
  const shown = [...cells].filter(([id]) => step >= ALL || (step === AROUND && around.has(id)) || (step === ONE && id === own));
  return shown.map(([id, ring]) => `<path class="dual-cell${id === own ? ' own' : ''}" d="${ringPath(ring)}"/>`).join('');
}

/** The outline of the cell that is looked at, with a dot at each corner. */
function ringOf({ cells }: JoinedCells, own: number): string {
  const ring = cells.get(own) ?? [];
  const corners = Array.from({ length: ring.length / 2 }, (_, k) => onPlate([ring[2 * k] ?? 0, ring[2 * k + 1] ?? 0]));
  return `<path class="dual-ring" d="${ringPath(ring)}"/>${corners.map((corner) => circle(corner, 4, 'dual-corner')).join('')}`;
}
