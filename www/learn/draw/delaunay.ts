/**
 * Points that the reader moves, with the edges of their Delaunay triangulation. A plate marks the edge that is looked
 * at, with the angles that face it and the circle of one of its triangles. Or it marks the triangle with the smallest
 * angle, with its circle.
 */
import type { Plate, View } from '../figures/figure';
import { acrossOf, distance, nearestEdge, placeOf, triangleAt, worstOf, type Flip, type InnerEdge, type JoinedCells, type Triangle } from '../figures/joined';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { linesOf, loop, onPlate, tinted } from './mesh';
import { at, circle, line, svg, symbol, text, unit } from './plate';

/** The radius of an angle's sector, and how far beyond the corner its number stands. */
const SECTOR = 40;
const NAMED = 21;

/** The width reserved for the text, in units of the drawing. */
const EDGE = 66;

/**
 * NODE: radius of a point with its number inside. DOT: radius of a point whose number is BESIDE units from its centre.
 */
const NODE = 8.5;
const [DOT, BESIDE] = [3.5, 13];

export function delaunay(view: View, { packing, marked, title }: Plate): string {
  const { language } = view;
  const trace = view.traces[packing];
  const joined = trace?.joined(0);
  if (!trace || !joined) return svg(SIDE, '', '');
  const [n, count] = [joined.points.size, joined.triangles.length];
  const said = language === 'ja' ? `${n}個の点と${count}個の三角形` : `${n} points and ${count} triangles`;
  const inside = marked === 'smallest' ? smallest(joined) : looked(joined, [view.at[0] ?? 0.5, view.at[1] ?? 0.5], trace.flip);
  return svg(SIDE, `${title ? `${title[language]}. ` : ''}${said}`, `${inside}${nodes(joined)}`);
}

/** The points with their numbers, as the handles name them; the numbers of two that nearly touch stand beside them. */
function nodes({ points }: JoinedCells): string {
  const all = [...points].map(([id, place]) => [id, onPlate(place)] as const);
  return all.map(([id, place]) => node(id, place, all.find(([other, near]) => other !== id && distance(near, place) < 2 * NODE)?.[1])).join('');
}

function node(id: number, [x, y]: Place, near: Place | undefined): string {
  const [u, v] = near ? unit(near, [x, y]) : [0, 0];
  const name = text(x + BESIDE * u, y + BESIDE * v + 4, String(id + 1), `node-number${near ? ' halo' : ''}`);
  return `${circle([x, y], near ? DOT : NODE, near ? 'numbered dot' : 'numbered')}${name}`;
}

const around = (centre: Place, radius: number, kind: string): string => circle(onPlate(centre), radius * SIDE, kind);

const edges = ({ points, triangles }: JoinedCells): string => linesOf(points, triangles.map(({ ids }) => ids), 'mesh-edge');

function smallest(joined: JoinedCells): string {
  const worst = worstOf(joined);
  const filled = tinted(joined, joined.triangles);
  return `${filled}${edges(joined)}${worst ? `${around(worst.centre, worst.radius, 'empty-circle')}${outlined(joined, worst)}` : ''}`;
}

const outlined = ({ points }: JoinedCells, { ids }: Triangle): string => `<path class="looked-at" d="${loop(ids.map((id) => placeOf(points, id)))}"/>`;

function looked(joined: JoinedCells, to: Place, flip: Flip | undefined): string {
  const edge = nearestEdge(joined, to);
  if (!edge) return edges(joined);
  const triangle = triangleAt(joined, edge, to);
  const both = joined.triangles.filter(({ ids }) => edge.ends.every((id) => ids.includes(id)));
  const filled = both.map(({ ids }) => `<path class="beside-edge" d="${loop(ids.map((id) => placeOf(joined.points, id)))}"/>`).join('');
  const round = triangle && !flip ? around(triangle.centre, triangle.radius, 'empty-circle') : '';
  const [a, b] = edge.ends.map((id) => onPlate(placeOf(joined.points, id)));
  const own = a && b ? line(a, b, 'own-edge') : '';
  const sectors = edge.facing.map(({ id, angle }, k) => sector(joined, edge, id, angle, k ? 'beta' : 'alpha')).join('');
  return `${filled}${edges(joined)}${round}${flip ? moment(flip) : ''}${own}${sectors}`;
}

/** The moment of a flip: the circle through all four corners, and the edge that went. */
function moment({ centre, radius, before, points }: Flip): string {
  const [a, b] = before.ends.map((id) => onPlate(placeOf(points, id)));
  const four = [...before.ends, ...acrossOf(before)].map((id) => around(placeOf(points, id), (NODE + 4) / SIDE, 'of-four')).join('');
  return `${around(centre, radius, 'empty-circle of-flip')}${a && b ? line(a, b, 'gone-edge') : ''}${four}`;
}

/** The angle at a corner that faces an edge, with its number. */
function sector({ points }: JoinedCells, { ends }: InnerEdge, id: number, angle: number, name: 'alpha' | 'beta'): string {
  const corner = onPlate(placeOf(points, id));
  const [from, to] = ends.map((end) => unit(corner, onPlate(placeOf(points, end))));
  if (!from || !to) return '';
  const [mx, my] = middleOf(from, to);
  const letter = symbol(name, name === 'alpha' ? 'α' : 'β');
  const [x, y, anchor] = outside(corner, [mx, my]);
  return `<path class="sector ${name}" d="${sectorPath(corner, from, to, SECTOR)}"/>${text(x, y, `${letter} ${number(angle, 1)}°`, 'angle-name', anchor)}`;
}

/** The place and the anchor of words beyond a corner, away from a direction; at the border of the plate they stand above or below it. */
function outside([cx, cy]: Place, [mx, my]: Place): readonly [x: number, y: number, anchor: string] {
  const [x, y] = [cx - mx * NAMED, cy - my * (NAMED + 6) + 5];
  const side = Math.abs(mx) > 0.3 ? -Math.sign(mx) : 0;
  const hasRoom = x - (EDGE * (1 - side)) / 2 > 0 && x + (EDGE * (1 + side)) / 2 < SIDE;
  if (hasRoom) return [x, Math.max(16, Math.min(SIDE - 6, y)), side ? (side > 0 ? 'start' : 'end') : 'middle'];
  return [Math.max(4, Math.min(SIDE - 4, cx)), cy + (cy > SIDE / 2 ? -18 : 28), cx < SIDE / 2 ? 'start' : 'end'];
}

/** The unit vector halfway between two others. */
export const middleOf = ([x, y]: Place, [u, v]: Place): Place => unit([0, 0], [x + u, y + v]);

/** A sector at a corner between two directions. */
export function sectorPath([x, y]: Place, [a, b]: Place, [u, v]: Place, radius: number): string {
  const sweep = a * v - b * u > 0 ? 1 : 0;
  return `M${at(x)} ${at(y)}L${at(x + radius * a)} ${at(y + radius * b)}A${radius} ${radius} 0 0 ${sweep} ${at(x + radius * u)} ${at(y + radius * v)}z`;
}
