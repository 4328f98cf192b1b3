/** Pieces of drawings of directions: crosses all over a field, strokes of one cross, and the outline with its square corners. */
import { degreesOf, type Direction } from '../figures/directions';
import type { Trace } from '../figures/figure';
import type { Place } from '../figures/place';
import { ringPath, SIDE } from './crowd';
import { at, symbol, text, unit } from './plate';

/** The point of the plate that a place of the picture has. */
export type Onto = (place: Place) => Place;

export const onto: Onto = ([x, y]) => [x * SIDE, y * SIDE];

/** Certainty is shown in this many tones. */
const TONES = 6;

/** The two strokes of a cross: the first stroke lies along the direction. */
export function strokesOf([x, y]: Place, [u, v]: Place, half: number): string {
  const stroke = (dx: number, dy: number): string => `M${tenth(x - dx)} ${tenth(y - dy)}l${tenth(2 * dx)} ${tenth(2 * dy)}`;
  return `${stroke(half * u, half * v)}${stroke(-half * v, half * u)}`;
}

const tenth = (value: number): string => String(Math.round(value * 10) / 10);

/** The crosses of a field, fainter where they are less certain. */
export function crosses(field: readonly Direction[], half: number, to: Onto = onto): string {
  const tone = ({ certainty }: Direction): number => Math.min(TONES - 1, Math.floor(certainty * TONES));
  const rows = Array.from({ length: TONES }, (_, k) => field.filter((one) => tone(one) === k).map(({ place, along }) => strokesOf(to(place), along, half)));
  return rows.map((row, k) => (row.length ? `<path class="cross tone${k}" d="${row.join('')}"/>` : '')).join('');
}

/** A drawing that is clipped at the outline. */
export function inOutline({ outline }: Trace, name: string, content: string): string {
  return `<clipPath id="${name}-inside"><path clip-rule="evenodd" d="${outline.map(ringPath).join('')}"/></clipPath><g clip-path="url(#${name}-inside)">${content}</g>`;
}

/** A square that stands in a direction, fainter where that is less certain. */
export function standing([x, y]: Place, along: Place, side: number, kind: string, opacity = 1): string {
  const rest = opacity < 1 ? ` opacity="${at(opacity)}"` : '';
  return `<rect class="${kind}" x="${at(-side / 2)}" y="${at(-side / 2)}" width="${at(side)}" height="${at(side)}" transform="translate(${at(x)} ${at(y)}) rotate(${at(degreesOf(along))})"${rest}/>`;
}

/** A corner is square if the sine of its angle is at least this. */
const SQUARE = 0.95;

/** The square corners of an outline, as small angles inside them. */
export function cornersOf({ outline }: Trace): string {
  return outline.flatMap((ring) => Array.from({ length: ring.length / 2 }, (_, k) => cornerAt(ring, k))).join('');
}

function cornerAt(ring: readonly number[], k: number): string {
  const point = (n: number): Place => [ring[(2 * n + ring.length) % ring.length] ?? 0, ring[(2 * n + 1 + ring.length) % ring.length] ?? 0];
  const [before, here, after] = [point(k - 1), point(k), point(k + 1)];
  const [a, b] = [unit(here, before), unit(here, after)];
  if (Math.abs(a[0] * b[1] - a[1] * b[0]) < SQUARE) return '';
  const [x, y] = onto(here);
  const [far, size] = [10, 10];
  return `<path class="corner" data-symbol="corners" d="M${at(x + far * a[0])} ${at(y + far * a[1])}l${at(size * b[0])} ${at(size * b[1])}l${at(-size * a[0])} ${at(-size * a[1])}"/>`;
}

/** A symbol with a subscript. */
export function lettered(x: number, y: number, name: string, letters: string, low: string, kind = 'side-name', anchor = 'middle'): string {
  return text(x, y, `${symbol(name, letters)}<tspan class="low" dy="3">${low}</tspan>`, kind, anchor);
}
