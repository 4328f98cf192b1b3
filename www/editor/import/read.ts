/**
 * Outlines from text: polygon JSON, SVG, or an SVG path alone.
 *
 * What comes out is thinned to the points that an outline may have. Where its rings touch, a second outline is tried,
 * a grain smaller all around. The limits of shapes and points are checked before the work that they forbid.
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

/** How far an outline of a drawing may be off, in sides, and how much farther where it has too many points for that. */
const TOLERANCE = 0.0003;
const COARSER = 8;

/** Points that the program takes, and the smallest area of a ring as a square, in sides (src/domain/check.rs). */
const MOST = 4096;
const SMALLEST = 1 / 128;

/** What is taken away around an area so that its rings do not touch, in grains of a link's grid. */
const APART = 2;
const GRAINS = 32768;

/** An outline that may do, and what became of the file on the way to it. */
export interface Try {
  rings: Ring[];
  left: Count;
  /** Points that it had, where it has fewer now than it should. */
  coarse?: number;
}

/** Reads an outline for a picture of this side, at least one: where the first cannot be used, the next one may. */
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

/** Whether all points of a drawing are given: those are taken as they are, as long as they are not too many. */
function isStraight({ pieces }: Drawing): boolean {
  return pieces.every(({ runs, pen, clips }) => !pen && !clips.length && runs.every(({ curves }) => curves.every((curve) => curve.length === 1)));
}

/** The rings of a drawing with as few points as will do. */
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

/** What rings enclose, none of them touching another or itself. */
function apart(rings: Ring[], rule: Rule, side: number, before: Count = {}): Try[] {
  const scale = STEPS / side;
  const area = areaOf(rings, rule, ([x, y]) => [x * scale, y * scale]);
  const left = { ...before };
  const loose = shrunk(area, (APART * STEPS) / GRAINS).map((path) => path.map(({ x, y }): Point => [x / scale, y / scale]));
  // Shrunk corners may have more points than they need.
  const large = withoutSpecks(thinned(loose, side / GRAINS / 2, Infinity), side, left);
  return large.length ? [{ rings: arranged(large), left }] : [];
}

function withoutSpecks(rings: Ring[], side: number, left: Count): Ring[] {
  // A little more, as rings lose some by what follows.
  const least = 1.05 * (SMALLEST * side) ** 2;
  const large = rings.filter((ring) => Math.abs(areaIn(ring)) >= least);
  if (large.length < rings.length) left.speck = (left.speck ?? 0) + rings.length - large.length;
  return large;
}

/** The ring begun at its leftmost point, so that it is thinned alike wherever it began. */
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

/** Without points that repeat the one before. */
function plain(ring: Ring): Ring {
  return ring.filter(([x, y], k) => {
    const [u, v] = ring[(k || ring.length) - 1] ?? [x, y];
    return ring.length < 2 || Math.abs(x - u) + Math.abs(y - v) > 1e-9;
  });
}
