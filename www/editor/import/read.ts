/**
 * Reads outlines from text: polygon JSON, SVG, or SVG path data alone.
 *
 * The result is thinned to the number of points that an outline may have. A second outline, smaller by a grain all
 * around, is tried where rings of the first touch. The numbers of shapes and points are checked before the costly work
 * on them.
 */
import type { Point, Ring } from '../../module/types';
import { fitted } from '../geometry/fit';
import { area as areaIn } from '../geometry/plane';
import { arranged } from '../geometry/rings';
import { thinned } from '../geometry/simplify';
import { areaOf, shrunk, STEPS, type Rule } from '../svg/area';
import { drawingOf, type Drawing } from '../svg/drawing';
import { STILL } from '../svg/matrix';
import { parsePath } from '../svg/path';
import { Refusal, type Count } from '../svg/refusal';
import { seen } from '../svg/seen';

/** Largest error of a drawing's outline, in sides; up to COARSER times that if there are too many points. */
const TOLERANCE = 0.0003;
const COARSER = 8;

/** MOST points are the limit of the program; a ring's area is at least SMALLEST squared, in sides (src/domain/check.rs). */
const MOST = 4096;
const SMALLEST = 1 / 128;

/** Rings shrink by APART grains of a link's grid so that they do not touch; a side has GRAINS of them. */
const APART = 2;
const GRAINS = 32768;

/** A candidate for the outline, and the counts of features that the file lost. */
export interface Try {
  rings: Ring[];
  left: Count;
  /** The number of points before thinning, set only if the limit made the outline coarser. */
  coarse?: number;
}

/** Reads at least one outline for a picture of this side. If the engine refuses the first, the next may do. */
export function outlines(text: string, side: number, progress: (done: number) => void): Try[] {
  const start = text.trimStart().slice(0, 1);
  if (start === '[' || start === '{') return polygons(text, side);
  const drawing = start === '<' ? drawingOf(text) : pathAlone(text);
  if (!drawing) throw new Refusal('no_shapes');
  progress(0.1);
  const page = drawing.frame && drawing.frame.x === 0 && drawing.frame.y === 0 && drawing.frame.width === drawing.frame.height ? drawing.frame.width : undefined;
  const rings = seen(drawing, (done) => progress(0.1 + 0.85 * done));
  if (!rings.length) throw new Refusal(drawing.pieces.length ? 'no_area' : 'no_shapes', {}, drawing.left);
  return drawn(fitted(rings, side, page), side, drawing.left, isStraight(drawing) ? 0 : TOLERANCE);
}

/** Path data as a drawing of one shape. */
function pathAlone(text: string): Drawing {
  const runs = parsePath(text.trim());
  if (!runs.some(({ curves }) => curves.length > 1)) throw new Refusal('no_path');
  return { pieces: [{ runs, matrix: STILL, rule: 'nonzero', paint: 'ink', clips: [] }], frame: undefined, left: {} };
}

/** Whether a drawing consists of straight lines. Its points are kept as they are unless there are too many. */
function isStraight({ pieces }: Drawing): boolean {
  return pieces.every(({ runs, pen, clips }) => !pen && !clips.length && runs.every(({ curves }) => curves.every((curve) => curve.length === 1)));
}

/** The rings of a drawing, with as few points as the tolerance allows. */
function drawn(rings: Ring[], side: number, left: Count, tolerance: number): Try[] {
  const large = withoutSpecks(rings, side, left);
  if (!large.length) throw new Refusal('no_area', {}, left);
  const begun = large.map(fromEdge);
  const fine = tolerance > 0 ? thinned(begun, tolerance * side, Infinity) : begun;
  const few = points(fine) > MOST ? thinned(begun, TOLERANCE * side, MOST, COARSER) : fine;
  if (points(few) > MOST) throw new Refusal('too_many_rings', { n: points(few), rings: few.length, most: MOST }, left);
  const coarse = few === fine ? {} : { coarse: points(fine) };
  return [{ rings: arranged(few), left, ...coarse }, ...apart(few, 'nonzero', side, left).map((loose) => ({ ...loose, ...coarse }))];
}

/** The area that rings enclose, as rings that touch neither each other nor themselves. */
function apart(rings: Ring[], rule: Rule, side: number, before: Count = {}): Try[] {
  const scale = STEPS / side;
  const area = areaOf(rings, rule, ([x, y]) => [x * scale, y * scale]);
  const left = { ...before };
  const loose = shrunk(area, (APART * STEPS) / GRAINS).map((path) => path.map(({ x, y }): Point => [x / scale, y / scale]));
  // Shrinking may add points at corners.
  const large = withoutSpecks(thinned(loose, side / GRAINS / 2, Infinity), side, left);
  return large.length ? [{ rings: arranged(large), left }] : [];
}

function withoutSpecks(rings: Ring[], side: number, left: Count): Ring[] {
  // Somewhat more than the limit, as later steps make rings smaller.
  const least = 1.05 * (SMALLEST * side) ** 2;
  const large = rings.filter((ring) => Math.abs(areaIn(ring)) >= least);
  if (large.length < rings.length) left.speck = (left.speck ?? 0) + rings.length - large.length;
  return large;
}

/** The ring, begun at its leftmost point: thinning then does not depend on where it began. */
function fromEdge(ring: Ring): Ring {
  const at = ring.reduce((best, [x, y], k) => {
    const [u, v] = ring[best] ?? [x, y];
    return x < u || (x === u && y < v) ? k : best;
  }, 0);
  return [...ring.slice(at), ...ring.slice(0, at)];
}

function points(rings: Ring[]): number {
  return rings.reduce((sum, ring) => sum + ring.length, 0);
}

/** `{"size": [w, h], "outer": [[x, y], ...], "holes": [...]}`, `{"rings": [...]}`, or a list of points or rings. */
function polygons(text: string, side: number): Try[] {
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch {
    throw new Refusal('no_json');
  }
  const lists = Array.isArray(content) ? content : ringsIn(content);
  const found: unknown[] = lists.some(isPoint) ? [lists] : lists;
  if (!found.length || !found.every((ring) => Array.isArray(ring))) throw new Refusal('no_rings');
  const rings = found.map((ring, at) =>
    (ring as unknown[]).map((point, index): Point => {
      if (!isPoint(point)) throw new Refusal('no_point', { k: index + 1, ring: at + 1 });
      return [point[0], point[1]];
    }),
  );
  const given = rings.map(plain);
  if (points(given) > MOST) throw new Refusal('too_many_given', { n: points(given), most: MOST });
  if (!given.some((ring) => ring.length > 2)) throw new Refusal('no_area');
  const page = content instanceof Object && 'size' in content && isPoint(content.size) ? Math.max(...content.size) : undefined;
  const placed = fitted(given, side, page);
  return [{ rings: arranged(placed), left: {} }, ...apart(placed, 'evenodd', side)];
}

function ringsIn(content: unknown): unknown[] {
  if (!(content instanceof Object)) return [];
  const { rings, outer, holes } = content as Record<string, unknown>;
  const list = (value: unknown): unknown[] => (Array.isArray(value) ? value : []);
  return [...(outer === undefined ? [] : [outer]), ...list(holes), ...list(rings)];
}

function isPoint(point: unknown): point is Point {
  return Array.isArray(point) && point.length === 2 && point.every((number) => typeof number === 'number' && Number.isFinite(number));
}

/** The ring without points that repeat the previous one. */
function plain(ring: Ring): Ring {
  return ring.filter(([x, y], k) => {
    const [u, v] = ring[(k || ring.length) - 1] ?? [x, y];
    return ring.length < 2 || Math.abs(x - u) + Math.abs(y - v) > 1e-9;
  });
}
