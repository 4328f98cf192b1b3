/** The cell that is looked at, magnified, with the force of each neighbour and of the walls, and their sum. */
import { crowdAt, nearestTo, packedOf } from '../figures/crowds';
import type { NearCell, PackedCell, Plate, View } from '../figures/figure';
import type { Vector } from '../figures/place';
import { number } from '../figures/words';
import { arrowTo, circle, path, svg, text, WIDTH } from './plate';

const MIDDLE = WIDTH / 2;

/** The radius of the cell. */
const RADIUS = 74;

/** The length of an arrow for a force of 1, and the longest arrow. */
const FORCE = 300;
const LONGEST = 120;

/** The shortest arrow that is drawn, in units of the plate. */
const LEAST = 2;

export function lens(view: View, { packing, title }: Plate): string {
  const trace = view.traces[packing];
  const now = trace && crowdAt(trace, view.step);
  const cells = trace && now ? packedOf(now, trace.side) : [];
  const own = nearestTo(cells, view.at);
  const said = view.language === 'ja' ? '一つのバブルに働く力' : 'The forces on one bubble';
  if (!trace || !now || !own) return svg(WIDTH, said, '');
  const near = trace.neighbours(now.step, own.id);
  const to = placeBy(own);
  const circles = cells.map((cell) => seen(to(cell.x, cell.y), (cell.size / own.size) * RADIUS, kindOf(cell, own, near))).join('');
  const walls = trace.outline.map((ring) => path(corners(ring, to), 'outline')).join('');
  return svg(WIDTH, `${title ? `${title[view.language]}. ` : ''}${said}`, `${walls}${circles}${arrows(own, near)}${distances(cells, near, to)}`);
}

/** Places on the plate, with the cell in the middle. */
function placeBy({ x, y, size }: PackedCell): (x: number, y: number) => Vector {
  const scale = (2 * RADIUS) / size;
  return (a, b) => [MIDDLE + (a - x) * scale, MIDDLE + (b - y) * scale];
}

const kindOf = (cell: PackedCell, own: PackedCell, near: readonly NearCell[]): string => (cell === own ? 'bubble own' : near.some(({ id, w }) => id === cell.id && w < 1.5) ? 'bubble' : 'bubble faint');

/** A circle, unless it lies beside the plate. */
function seen([x, y]: Vector, radius: number, kind: string): string {
  return Math.max(Math.abs(x - MIDDLE), Math.abs(y - MIDDLE)) > MIDDLE + radius ? '' : circle([x, y], radius, kind);
}

function corners(ring: readonly number[], to: (x: number, y: number) => Vector): Vector[] {
  const all = Array.from({ length: ring.length / 2 }, (_, k) => to(ring[2 * k] ?? 0, ring[2 * k + 1] ?? 0));
  return [...all, ...all.slice(0, 1)];
}

function arrows(own: PackedCell, near: readonly NearCell[]): string {
  const each = near.map(({ w, force }) => arrow(force, w < 1 ? 'push' : 'pull'));
  const walls = near.reduce<Vector>(([x, y], { force }) => [x - force[0], y - force[1]], own.force);
  return `${each.join('')}${arrow(walls, 'wall')}${circle([MIDDLE, MIDDLE], 4, 'centre')}${arrow(own.force, 'sum')}`;
}

function arrow([x, y]: Vector, kind: string): string {
  const length = Math.hypot(x, y);
  const drawn = Math.min(LONGEST, FORCE * length);
  return drawn < LEAST ? '' : arrowTo([MIDDLE, MIDDLE], [(x / length) * drawn, (y / length) * drawn], kind);
}

/** The distance of each neighbour, on its side of the cell that is looked at. */
function distances(cells: readonly PackedCell[], near: readonly NearCell[], to: (x: number, y: number) => Vector): string {
  const named = near.filter(({ w }) => w < 1.5).map(({ id, w, force }) => {
    const cell = cells.find((one) => one.id === id);
    const [x, y] = cell ? to(cell.x, cell.y) : [MIDDLE, MIDDLE];
    const inside = (value: number): number => Math.max(24, Math.min(WIDTH - 24, value));
    const kind = Math.hypot(...force) < LEAST / FORCE ? 'none' : w < 1 ? 'push' : 'pull';
    return text(inside(x), inside(y) + 5, number(w, 2), `near-name ${kind}`);
  });
  return named.join('');
}
