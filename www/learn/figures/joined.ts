/** Points joined to a mesh, and rules on their triangles, found in the engine's numbers. Places are in shares of the picture's side. */
import type { Place } from './place';

/** A triangle of Delaunay's triangulation. Angles are in degrees, lengths in shares of the picture's side. */
export interface Triangle {
  readonly ids: readonly number[];
  /** The angles at its corners. */
  readonly angles: readonly number[];
  readonly shortest: number;
  /** The circle through its corners. */
  readonly centre: Place;
  readonly radius: number;
}

/** Cells that are joined: their centres, the elements of their mesh, Delaunay's triangles, and their polygons. */
export interface JoinedCells {
  readonly points: ReadonlyMap<number, Place>;
  /** The ids of each element's corners. */
  readonly faces: readonly (readonly number[])[];
  /** All Delaunay triangles, out to the convex hull. */
  readonly triangles: readonly Triangle[];
  /** The outlines of the cells by their ids: x, y, x, y, ... */
  readonly cells: ReadonlyMap<number, readonly number[]>;
  /** The smallest angles of the mesh's triangles: their median, and their counts in 30 classes from 0 to 60 degrees. */
  readonly median: number;
  readonly counts: readonly number[];
}

/** An edge between two triangles, with the corner of each that faces it and the angle there. */
export interface InnerEdge {
  readonly ends: readonly [number, number];
  readonly facing: readonly [{ readonly id: number; readonly angle: number }, { readonly id: number; readonly angle: number }];
}

/** A flip between two states: the edges before and after, and the moment when their four ends lay on one circle. */
export interface Flip {
  readonly before: InnerEdge;
  /** The sum of the facing angles, in degrees. */
  readonly sum: number;
  readonly points: ReadonlyMap<number, Place>;
  readonly centre: Place;
  readonly radius: number;
}

/** The largest possible value of a triangle's smallest angle, in degrees. */
export const LARGEST = 60;

export const smallestOf = ({ angles }: Triangle): number => Math.min(...angles);

/** The triangle with the smallest angle of all. */
export function worstOf({ triangles }: JoinedCells): Triangle | undefined {
  return triangles.reduce<Triangle | undefined>((worst, one) => (worst && smallestOf(worst) <= smallestOf(one) ? worst : one), undefined);
}

/** The smallest angle of all, in degrees; 0 without triangles. */
export function leastOf(joined: JoinedCells): number {
  const worst = worstOf(joined);
  return worst ? smallestOf(worst) : 0;
}

export const edgeKey = (a: number, b: number): string => (a < b ? `${a} ${b}` : `${b} ${a}`);

/** The edges of triangles by their ends, each with the corners that face it. */
function facingBy(triangles: readonly Triangle[]): Map<string, { readonly id: number; readonly angle: number }[]> {
  const found = new Map<string, { readonly id: number; readonly angle: number }[]>();
  for (const { ids, angles } of triangles) {
    ids.forEach((id, k) => {
      const key = edgeKey(ids[(k + 1) % 3] ?? 0, ids[(k + 2) % 3] ?? 0);
      found.set(key, [...(found.get(key) ?? []), { id, angle: angles[k] ?? 0 }]);
    });
  }
  return found;
}

/** The keys of all edges. */
export const edgeKeys = ({ triangles }: JoinedCells): ReadonlySet<string> => new Set(facingBy(triangles).keys());

export function innerEdges({ triangles }: JoinedCells): InnerEdge[] {
  return [...facingBy(triangles)].flatMap(([key, [one, other]]) => {
    const [a = 0, b = 0] = key.split(' ').map(Number);
    return one && other ? [{ ends: [a, b] as const, facing: [one, other] as const }] : [];
  });
}

/** The sum of the two angles that face an edge, in degrees. */
export const sumOf = ({ facing: [one, other] }: InnerEdge): number => one.angle + other.angle;

export function distance([x, y]: Place, [u, v]: Place): number {
  return Math.hypot(u - x, v - y);
}

/** The place of a point. */
export const placeOf = (points: ReadonlyMap<number, Place>, id: number): Place => points.get(id) ?? [0, 0];

/** The distance of two points. */
export const lengthOf = (points: ReadonlyMap<number, Place>, [a, b]: readonly [number, number]): number => distance(placeOf(points, a), placeOf(points, b));

/** The ends of the other diagonal of the two triangles at an edge. */
export const acrossOf = ({ facing: [one, other] }: InnerEdge): readonly [number, number] => [one.id, other.id];

/** The inner edge that is nearest to a place. */
export function nearestEdge(joined: JoinedCells, to: Place): InnerEdge | undefined {
  const far = ({ ends }: InnerEdge): number => fromEdge(to, placeOf(joined.points, ends[0]), placeOf(joined.points, ends[1]));
  return innerEdges(joined).reduce<InnerEdge | undefined>((best, edge) => (best && far(best) <= far(edge) ? best : edge), undefined);
}

/** The distance from a place to the segment between two others. */
function fromEdge(to: Place, a: Place, b: Place): number {
  const along = ((to[0] - a[0]) * (b[0] - a[0]) + (to[1] - a[1]) * (b[1] - a[1])) / distance(a, b) ** 2;
  const share = Math.max(0, Math.min(1, along));
  return distance(to, [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
}

/** The triangle at an edge on the side of a place. */
export function triangleAt({ triangles, points }: JoinedCells, edge: InnerEdge, to: Place): Triangle | undefined {
  const [a, b] = [placeOf(points, edge.ends[0]), placeOf(points, edge.ends[1])];
  const side = ([x, y]: Place): number => Math.sign((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]));
  const corner = edge.facing.find(({ id }) => side(placeOf(points, id)) === side(to)) ?? edge.facing[0];
  return triangles.find(({ ids }) => [...edge.ends, corner.id].every((id) => ids.includes(id)));
}

/** The point that is nearest to a place. */
export function nearestPoint({ points }: JoinedCells, [x = 0, y = 0]: readonly number[]): number | undefined {
  const far = (id: number): number => distance(placeOf(points, id), [x, y]);
  return [...points.keys()].reduce<number | undefined>((best, id) => (best !== undefined && far(best) <= far(id) ? best : id), undefined);
}

/** The number of edges at a point. */
export function edgesAt({ faces }: JoinedCells, id: number): number {
  return new Set(faces.filter((face) => face.includes(id)).flatMap((face) => face.filter((other) => other !== id))).size;
}

/** Whether the mesh's elements go all the way round a point. */
export function isInner({ faces }: JoinedCells, id: number): boolean {
  const own = faces.filter((face) => face.includes(id));
  return own.length > 2 && own.length === new Set(own.flatMap((face) => face.filter((other) => other !== id))).size;
}
