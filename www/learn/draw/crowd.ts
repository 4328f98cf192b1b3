/** The cells of a packing in their outline, with the net force on each. */
import { crowdAt, nearestTo, packedOf } from '../figures/crowds';
import type { PackedCell, Plate, Trace, View } from '../figures/figure';
import { arrowTo, at, circle, svg, WIDTH } from './plate';

/** The side of the picture on the plate. */
export const SIDE = WIDTH;

/** The length of an arrow for a force of 1, in sizes of its cell, and the longest arrow. */
const FORCE = 2;
const LONGEST = 1;

/** A force is drawn if its arrow is longer than this, in units of the plate. */
const LEAST = 1.5;

export function crowd(view: View, { packing, forces, title }: Plate): string {
  const trace = view.traces[packing];
  const now = trace && crowdAt(trace, view.step);
  if (!trace || !now) return svg(SIDE, '', '');
  const cells = packedOf(now, trace.side);
  const own = view.at.length > 1 ? nearestTo(cells, view.at) : undefined;
  const arrows = forces ? cells.map(arrowOf).join('') : '';
  const shapes = trace.value('kind') === 'circle' ? [] : trace.shapes(now.step);
  const drawn = cells.map((cell, k) => cellShape(cell, shapes[k], cell === own ? 'bubble own' : 'bubble')).join('');
  const said = view.language === 'ja' ? `輪郭の中の${cells.length}個のバブル` : `${cells.length} bubbles in their outline`;
  return svg(SIDE, title ? `${title[view.language]}. ${said}` : said, `${outlineOf(trace)}${drawn}${arrows}`);
}

/** The walls. */
export function outlineOf({ outline }: Trace): string {
  return `<path class="outline" d="${outline.map(ringPath).join('')}"/>`;
}

/** A closed line through points in shares of the picture's side. */
export function ringPath(points: readonly number[]): string {
  const corner = (_: unknown, k: number): string => `${at((points[2 * k] ?? 0) * SIDE)} ${at((points[2 * k + 1] ?? 0) * SIDE)}`;
  return `M${Array.from({ length: points.length / 2 }, corner).join('L')}z`;
}

/** A cell as a circle, or by its outline if it has corners. */
export function cellShape({ x, y, size }: PackedCell, outline: readonly number[] | undefined, kind: string): string {
  if (outline) return `<path class="${kind}" d="${ringPath(outline)}"/>`;
  return circle([x * SIDE, y * SIDE], (size / 2) * SIDE, kind);
}

/** The arrow of the net force on a cell, from its centre; '' if it is too short to see. */
function arrowOf({ x, y, size, force: [fx, fy] }: PackedCell): string {
  const length = Math.hypot(fx, fy);
  const drawn = Math.min(LONGEST, FORCE * length) * size * SIDE;
  return drawn < LEAST ? '' : arrowTo([x * SIDE, y * SIDE], [(fx / length) * drawn, (fy / length) * drawn], 'sum');
}
