/** Directions in the fields of a recipe, as the engine gives them. Places are in shares of the picture's side, y down. */
import type { Place, Vector } from './place';

/** The direction of squares at a place: along one of their sides, and how certain it is, from 0 to 1. */
export interface Direction {
  readonly place: Place;
  readonly along: Vector;
  readonly certainty: number;
}

/** A segment of the outline and its terms at a place, in shares of the lengths of all terms: as printed, and at four times the angle. */
export interface SegmentTerm {
  readonly from: Place;
  readonly to: Place;
  readonly printed: Vector;
  readonly turned: Vector;
}

/** The terms of all segments at a place. The lengths of sums are shares of the lengths of their terms. */
export interface SegmentTerms {
  readonly list: readonly SegmentTerm[];
  readonly printed: Vector;
  /** The length of the printed sum. */
  readonly share: number;
}

/** The direction at a place of a walk, and how far it has turned since the first one, in quarter turns. */
export interface Turned extends Direction {
  readonly quarters: number;
}

/** A place without a direction, and the quarter turns around it. */
export interface Singular {
  readonly place: Place;
  readonly quarters: number;
}

export interface Directions {
  readonly at: (place: readonly number[]) => Direction;
  readonly terms: (place: readonly number[]) => SegmentTerms;
  /** The directions on a circle about x, y with a radius, at its start and after each step; none if it leaves the outline. */
  readonly walk: (circle: readonly number[]) => readonly Turned[];
  readonly singular: () => readonly Singular[];
  /** The directions at places all over the inside. */
  readonly field: readonly Direction[];
}

/** The steps of a walk, and the degrees of each. */
export const STEPS = 72;
const STRIDE = 360 / STEPS;

/** The cosine and the sine of a degree. */
const [COS, SIN] = [0.9998476951563913, 0.01745240643728351];

/** The unit vector at a whole number of degrees, clockwise on screen, by products alone: all machines have the same bits. */
export function unitAt(degrees: number): Vector {
  const quarters = Math.floor(degrees / 90);
  let [x, y] = [1, 0];
  for (let k = 90 * quarters; k < degrees; k++) [x, y] = [x * COS - y * SIN, x * SIN + y * COS];
  for (let k = 0; k < ((quarters % 4) + 4) % 4; k++) [x, y] = [-y, x];
  return [x, y];
}

/** The places of a walk, without the first one again at its end. */
export function placesOn([x = 0, y = 0, radius = 0]: readonly number[]): Place[] {
  return Array.from({ length: STEPS }, (_, k) => {
    const [across, down] = unitAt(k * STRIDE);
    return [x + radius * across, y + radius * down];
  });
}

/** The angle of a vector in degrees, clockwise on screen. */
export const degreesOf = ([x = 0, y = 0]: readonly number[]): number => (Math.atan2(y, x) * 180) / Math.PI;

/** The angle of a direction of squares, which are alike after 90 degrees: above -45, and at most 45. */
export function asSquare(degrees: number): number {
  const rest = degrees - 90 * Math.round(degrees / 90);
  return rest <= -45 + 1e-9 ? rest + 90 : rest;
}
