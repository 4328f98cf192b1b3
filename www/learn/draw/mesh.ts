/** A mesh of points, its triangles tinted by their smallest angles: thin ones stand out. */
import type { Plate, View } from '../figures/figure';
import { edgeKey, LARGEST, placeOf, smallestOf, type JoinedCells, type Triangle } from '../figures/joined';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { outlineOf, SIDE } from './crowd';
import { hatched } from './hatching';
import { circle, svg } from './plate';

/** The tints, from the thinnest triangles to those with three equal angles. */
const TINTS = 6;

/** Triangles of these first tints are thin: below 30°. Lines cross them, so that they stand out in grey, too. */
const THIN = 3;

export const tintOf = (angle: number): number => Math.min(TINTS - 1, Math.floor((angle / LARGEST) * TINTS));

export const isThin = (angle: number): boolean => tintOf(angle) < THIN;

/** A place on the plate. */
export const onPlate = ([x, y]: Place): Place => [x * SIDE, y * SIDE];

/** A length as text: a tenth is fine enough for points as small as these. */
const tenth = (value: number): string => String(Math.round(value * 10) / 10);

/** A closed line through points. */
export function loop(places: readonly Place[]): string {
  return `M${places.map((place) => onPlate(place).map(tenth).join(' ')).join('L')}z`;
}

const corners = (points: ReadonlyMap<number, Place>, ids: readonly number[]): Place[] => ids.map((id) => placeOf(points, id));

/** Triangles in one path for each tint, and the lines across thin ones. */
export function tinted({ points }: JoinedCells, triangles: readonly Triangle[]): string {
  const thin = triangles.filter((triangle) => isThin(smallestOf(triangle))).map(({ ids }) => corners(points, ids).map(onPlate));
  const filled = Array.from({ length: TINTS }, (_, tint) => {
    const own = triangles.filter((triangle) => tintOf(smallestOf(triangle)) === tint);
    return own.length ? `<path class="triangle tint-${tint}" d="${own.map(({ ids }) => loop(corners(points, ids))).join('')}"/>` : '';
  });
  return `${filled.join('')}${hatched(thin)}`;
}

export function dots(points: ReadonlyMap<number, Place>, radius: number): string {
  return [...points.values()].map(onPlate).map((place) => circle(place, radius, 'node')).join('');
}

/** The triangles of the mesh's elements: the mesh leaves out slivers along the border. */
function meshedOf({ faces, triangles }: JoinedCells): Triangle[] {
  const key = (ids: readonly number[]): string => [...ids].sort((a, b) => a - b).join(' ');
  const wanted = new Set(faces.map(key));
  return triangles.filter(({ ids }) => wanted.has(key(ids)));
}

export function mesh(view: View, { packing, always, title }: Plate): string {
  const trace = view.traces[packing];
  if (!trace) return svg(SIDE, '', '');
  const joined = trace.joined(always ?? view.step);
  const [n, median] = [joined.points.size, number(joined.median, 1)];
  const said = view.language === 'ja' ? `${n}個の点のメッシュ。最小角の中央値${median}°` : `The mesh of ${n} points. The median of the smallest angles is ${median}°`;
  const all = linesOf(joined.points, joined.triangles.map(({ ids }) => ids), 'left-out');
  return svg(SIDE, `${title ? `${title[view.language]}. ` : ''}${said}`, `${outlineOf(trace)}${all}${tinted(joined, meshedOf(joined))}${dots(joined.points, 2.4)}`);
}

/** The lines of edges, each once. */
export function linesOf(points: ReadonlyMap<number, Place>, faces: readonly (readonly number[])[], kind: string): string {
  const keys = new Set(faces.flatMap((face) => face.map((id, k) => edgeKey(id, face[(k + 1) % face.length] ?? id))));
  const d = [...keys].map((key) => corners(points, key.split(' ').map(Number)).map((place) => onPlate(place).map(tenth).join(' ')).join('L'));
  return d.length ? `<path class="${kind}" d="M${d.join('M')}"/>` : '';
}
