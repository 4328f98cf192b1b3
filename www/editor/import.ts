/** Outlines from text: polygon JSON, SVG, or an SVG path alone. */
import type { Point, Ring } from '../types';
import { fitted } from './fit';
import { paint } from './paint';
import { plain } from './path-data';
import { thinned } from './simplify';
import { pathRings, svgRings } from './svg';
import { tell } from './words';

/** Points that an outline gets at most, and how far it may be off, in sides. */
const MOST = 300;
const TOLERANCE = 0.0006;

export interface Imported {
  rings: Ring[];
  /** What the rings enclose together, where they cross. */
  loose: () => Ring[];
}

/** Whether text may be an outline, so that it is worth a sentence if it is not. */
export function looksLikeOutline(text: string): boolean {
  return /^\s*(<(\?xml|!--|!doctype svg|svg|path)|[[{]|m\s*[-+.\d])/i.test(text);
}

/** Reads an outline for a picture of this side. Throws an Error whose message is a sentence. */
export function ringsOf(text: string, name: string, side: number): Imported {
  const start = text.trimStart().slice(0, 1);
  const json = start === '[' || start === '{';
  const { rings, page } = json ? parseJson(text, name) : start === '<' ? svgRings(text, name) : { rings: pathRings(text, name), page: undefined };
  const placed = fitted(rings, side, page);
  const usable = json ? placed : thinned(placed, TOLERANCE * side, MOST);
  if (!usable.some((ring) => ring.length > 2)) throw new Error(tell('no_area', { name }));
  return { rings: usable, loose: () => paint(placed, side) };
}

/** `{"size": [w, h], "outer": [[x, y], ...], "holes": [...]}`, `{"rings": [...]}`, or a list of points or rings. */
function parseJson(text: string, name: string): { rings: Ring[]; page: number | undefined } {
  const wrong = (key: Parameters<typeof tell>[0], values = {}): Error => new Error(tell(key, { name, ...values }));
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch {
    throw wrong('no_json');
  }
  const lists = Array.isArray(content) ? content : ringsIn(content);
  const found: unknown[] = lists.some(isPoint) ? [lists] : lists;
  if (!found.length || !found.every((ring) => Array.isArray(ring))) throw wrong('no_rings');
  const rings = found.map((ring, at) =>
    (ring as unknown[]).map((point, index): Point => {
      if (!isPoint(point)) throw wrong('no_point', { k: index + 1, ring: at + 1 });
      return [point[0], point[1]];
    }),
  );
  const page = content instanceof Object && 'size' in content && isPoint(content.size) ? Math.max(...content.size) : undefined;
  return { rings: rings.map(plain), page };
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
