/**
 * Outlines from JSON files: `{"size": [w, h], "outer": [[x, y], ...], "holes": [[[x, y], ...], ...]}`, or with a list of
 * "rings" in any order instead: what is a hole and what an island they tell themselves.
 */
import type { Point, Ring } from './types';

/** Bytes; an outline of a thousand points has some twenty thousand. */
const LARGEST = 1_000_000;

/** Reads an outline and scales it to a picture of this side. Throws an Error whose message is a sentence. */
export async function readOutline(file: File, side: number): Promise<Ring[]> {
  if (file.size > LARGEST) throw new Error(`“${file.name}” is larger than 1 MB, which no outline needs; the outline stays as it was.`);
  return parseOutline(await file.text(), file.name, side);
}

export function parseOutline(text: string, name: string, side: number): Ring[] {
  const wrong = (what: string): Error => new Error(`“${name}” ${what}; the outline stays as it was.`);
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch {
    throw wrong('is not a JSON file');
  }
  if (typeof content !== 'object' || content === null) throw wrong('has no ring “outer”, a list of points [x, y]');
  const list = (value: unknown, which: string): unknown[] => {
    if (!Array.isArray(value)) throw wrong(`has “${which}” that are not a list of rings`);
    return value;
  };
  const holes = 'holes' in content ? list(content.holes, 'holes') : [];
  const others = 'rings' in content ? list(content.rings, 'rings') : [];
  if (!('outer' in content) && others.length === 0) {
    throw wrong('has no ring “outer”, a list of points [x, y], and no list of “rings”');
  }
  const scale = side / extent('size' in content ? content.size : undefined, side);
  const ring = (points: unknown, which: string): Ring => {
    if (!Array.isArray(points)) throw wrong(`has ${which} that is not a list of points`);
    return points.map((point: unknown, index): Point => {
      if (!isPoint(point)) throw wrong(`has a point ${index + 1} in ${which} that is not two numbers [x, y]`);
      return [point[0] * scale, point[1] * scale];
    });
  };
  return [
    ...('outer' in content ? [ring(content.outer, 'an outer ring')] : []),
    ...holes.map((hole, index) => ring(hole, `a hole ${index + 1}`)),
    ...others.map((points, index) => ring(points, `a ring ${index + 1}`)),
  ];
}

function isPoint(point: unknown): point is Point {
  return Array.isArray(point) && point.length === 2 && point.every((number) => typeof number === 'number' && Number.isFinite(number));
}

/** The side of the square that the file's numbers refer to. */
function extent(size: unknown, otherwise: number): number {
  if (!isPoint(size)) return otherwise;
  const side = Math.max(...size);
  return side > 0 ? side : otherwise;
}
