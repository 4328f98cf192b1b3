/** SVG path data as rings of points; its curves become short pieces. */
import type { Point, Ring } from '../types';

/** Pieces of a curve. */
const PIECES = 24;

/** Numbers that a command takes. */
const TAKES: Record<string, number> = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0 };

/** Every subpath as a ring, closed or not; what comes after a mistake is left out, as browsers do. */
export function parsePath(text: string): Ring[] {
  const rings: Ring[] = [];
  let ring: Ring = [];
  let start: Point = [0, 0];
  let at: Point = [0, 0];
  // The last control point, which smooth curves mirror, and what kind of curve it belongs to.
  let control: { point: Point; of: string } | undefined;
  for (const { letter, numbers } of commands(text)) {
    const kind = letter.toLowerCase();
    const from = at;
    const [ox, oy] = letter === kind ? from : [0, 0];
    const pair = (k: number): Point => [(numbers[k] ?? 0) + ox, (numbers[k + 1] ?? 0) + oy];
    const mirrored = (of: string): Point => (control && control.of === of ? [2 * from[0] - control.point[0], 2 * from[1] - control.point[1]] : from);
    let next: typeof control;
    if (kind === 'z') {
      at = start;
    } else if (kind === 'm') {
      at = start = pair(0);
      ring = [at];
      rings.push(ring);
    } else {
      // After a closing, a new subpath begins where that one did.
      if (!ring.length) rings.push((ring = [at]));
      if (kind === 'l') at = pair(0);
      else if (kind === 'h') at = [(numbers[0] ?? 0) + ox, from[1]];
      else if (kind === 'v') at = [from[0], (numbers[0] ?? 0) + oy];
      else if (kind === 'a') {
        at = pair(5);
        ring.push(...arc(from, numbers, at));
      } else {
        const cubic = kind === 'c' || kind === 's';
        const whole = kind === 'c' || kind === 'q';
        at = pair(numbers.length - 2);
        const second = cubic ? pair(whole ? 2 : 0) : whole ? pair(0) : mirrored('q');
        const first = cubic ? (whole ? pair(0) : mirrored('c')) : second;
        ring.push(...bezier(cubic ? [from, first, second, at] : [from, second, at]));
        next = { point: second, of: cubic ? 'c' : 'q' };
      }
      ring.push(at);
    }
    if (kind === 'z') ring = [];
    control = next;
  }
  return rings.map(plain);
}

interface Command {
  letter: string;
  numbers: number[];
}

/** The commands with as many numbers as each takes; a list of numbers repeats the command, lines after a move. */
function commands(text: string): Command[] {
  const found: Command[] = [];
  for (const [whole, letter = ''] of text.matchAll(/([a-z])[^a-df-z]*/gi)) {
    const takes = TAKES[letter.toLowerCase()];
    if (takes === undefined) return found;
    const numbers = letter.toLowerCase() === 'a' ? arcNumbers(whole) : (whole.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);
    // A number too large for any number is a mistake, too.
    if (!numbers.every(Number.isFinite)) return found;
    if (takes === 0) {
      found.push({ letter, numbers: [] });
      continue;
    }
    for (let k = 0; k + takes <= numbers.length; k += takes) {
      const line = letter === 'm' ? 'l' : 'L';
      found.push({ letter: k > 0 && letter.toLowerCase() === 'm' ? line : letter, numbers: numbers.slice(k, k + takes) });
    }
    if (numbers.length === 0 || numbers.length % takes) return found;
  }
  return found;
}

/** The two flags of an arc may stand without a space after them. */
function arcNumbers(text: string): number[] {
  const number = '[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[-+]?\\d+)?';
  const gap = '[\\s,]*';
  const whole = new RegExp([number, number, number, '[01]', '[01]', number, number].map((part) => `(${part})`).join(gap), 'gi');
  return [...text.slice(1).matchAll(whole)].flatMap((match) => match.slice(1).map(Number));
}

/** Places on a curve between its ends. */
function bezier(points: Point[]): Point[] {
  return Array.from({ length: PIECES - 1 }, (_, k) => {
    const t = (k + 1) / PIECES;
    let left = points;
    while (left.length > 1) left = left.slice(1).map((to, n): Point => mix(left[n] ?? to, to, t));
    return left[0] ?? [0, 0];
  });
}

function mix(from: Point, to: Point, t: number): Point {
  return [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t];
}

/** Places on an arc between its ends, which the browser knows. */
function arc(from: Point, [rx, ry, turn, large, sweep]: number[], to: Point): Point[] {
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', `M${from.join(' ')}A${[rx, ry, turn, large, sweep, ...to].join(' ')}`);
  const length = path.getTotalLength();
  return Array.from({ length: PIECES * 2 - 1 }, (_, k): Point => {
    const { x, y } = path.getPointAtLength((length * (k + 1)) / (PIECES * 2));
    return [x, y];
  });
}

/** Without points that repeat the one before. */
export function plain(ring: Ring): Ring {
  return ring.filter(([x, y], k) => {
    const [u, v] = ring[(k || ring.length) - 1] ?? [x, y];
    return ring.length < 2 || Math.abs(x - u) + Math.abs(y - v) > 1e-9;
  });
}
