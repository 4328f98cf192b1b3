/** A square beside one that is held, and squares that share an edge, found in the engine's numbers. */
import { crowdAt, packedOf } from './crowds';
import type { PackedCell, Trace } from './figure';

/** The second square as seen from the first. Lengths are in stable distances, y up, energies in k0. */
export interface Neighbour {
  readonly x: number;
  readonly y: number;
  readonly w: number;
  /** Degrees: its direction, counter-clockwise from the right, and that from the nearest edge's middle. */
  readonly angle: number;
  readonly aside: number;
  readonly speed: number;
  readonly force: readonly [x: number, y: number];
  readonly energy: number;
}

export function neighbourAt(trace: Trace, step: number): Neighbour | undefined {
  const crowd = crowdAt(trace, step);
  const [held, free] = crowd ? packedOf(crowd, trace.side) : [];
  if (!crowd || !held || !free) return undefined;
  const [x, y] = [(free.x - held.x) / free.size, (held.y - free.y) / free.size];
  const angle = (Math.atan2(y, x) * 180) / Math.PI;
  const aside = Math.abs(angle - 90 * Math.round(angle / 90));
  return { x, y, w: Math.hypot(x, y), angle, aside, speed: Math.hypot(...free.speed), force: free.force, energy: crowd.pairs };
}

/** How near to an edge's middle, in degrees, and how slow a square is that has come to rest there. */
const AT_EDGE = 3;
const STILL = 0.01;

/** How far from the diagonal, in degrees, a square may be that is dropped at 45 degrees. */
const NEAR_DIAGONAL = 8;

export const isAtEdge = ({ aside, speed }: Neighbour): boolean => aside < AT_EDGE && speed < STILL;

export const isAtCorner = ({ aside }: Neighbour): boolean => aside > 45 - NEAR_DIAGONAL;

export const isStill = ({ speed }: Neighbour): boolean => speed < STILL;

/** The first step after which the square stays where it is. */
export function restsAt(trace: Trace): number | undefined {
  const all = trace.steps.map((_, step) => neighbourAt(trace, step));
  const end = all.at(-1);
  if (!end || !isStill(end)) return undefined;
  const last = all.findLastIndex((one) => !one || !isStill(one) || Math.hypot(one.x - end.x, one.y - end.y) > STILL);
  return last + 1 < all.length ? last + 1 : undefined;
}

/** The first step at which the square is before the middle of an edge. */
export function reachesEdge(trace: Trace): number | undefined {
  const found = trace.steps.findIndex((_, step) => step > 0 && (neighbourAt(trace, step)?.aside ?? 45) < AT_EDGE);
  return found < 0 ? undefined : found;
}

/** Two squares that touch along an edge: the ends of that edge, in shares of the picture's side. */
type SharedEdge = readonly [x: number, y: number, u: number, v: number];

/** Largest distance of neighbours; largest gap and shift of two that share an edge. All in sizes. */
const NEIGHBOURS = 1.25;
const BESIDE = 0.08;
const SHIFTED = 0.12;

/** The neighbours among upright squares, and the edges that they share. */
export function edgesOf(cells: readonly PackedCell[]): { readonly neighbours: number; readonly edges: readonly SharedEdge[] } {
  const pairs = cells.flatMap((one, k) => cells.slice(k + 1).map((other) => [one, other] as const));
  const near = pairs.filter(([one, other]) => Math.hypot(other.x - one.x, other.y - one.y) < NEIGHBOURS * one.size);
  return { neighbours: near.length, edges: near.flatMap(([one, other]) => sharedEdge(one, other)) };
}

function sharedEdge(one: PackedCell, other: PackedCell): SharedEdge[] {
  const [dx, dy] = [(other.x - one.x) / one.size, (other.y - one.y) / one.size];
  const isAside = Math.abs(dx) > Math.abs(dy);
  const [along, across] = isAside ? [dx, dy] : [dy, dx];
  if (Math.abs(Math.abs(along) - 1) > BESIDE || Math.abs(across) > SHIFTED) return [];
  const [x, y, half] = [(one.x + other.x) / 2, (one.y + other.y) / 2, (one.size / 2) * (1 - Math.abs(across))];
  return [isAside ? [x, y - half, x, y + half] : [x - half, y, x + half, y]];
}
