/**
 * Pieces of SVG as text. A plate is 400 units wide, and all plates have the distance w on the same horizontal axis, so that a
 * bubble, its place on a curve and its track stand above each other. Colours come from classes alone: the page's style sheet
 * has them for light, dark and paper.
 */
import type { Figure, Language, Moment, Plate, View, Words } from '../figures/figure';
import type { Place, Vector } from '../figures/place';

export const WIDTH = 400;

/** The place of w = 0, and the length of a stable distance. */
const ORIGIN = 72;
export const UNIT = 130;

/** The largest distance on the axis. */
export const WIDEST = (WIDTH - 16 - ORIGIN) / UNIT;

export const X = (w: number): number => ORIGIN + UNIT * w;

export const toW = (x: number): number => (x - ORIGIN) / UNIT;

/** The middles of the bands of push, pull and nothing, where their names stand. */
const NAMED = [0.5, 1.25, (1.5 + WIDEST) / 2];

/** A line down from a bubble into a drawing below, with a gap where the name of a band stands. */
export function guideDown(w: number, from: number, top: number, to: number): string {
  const isNamed = NAMED.some((middle) => Math.abs(w - middle) < 0.2);
  return isNamed ? `${line([X(w), from], [X(w), top - 20], 'guide')}${line([X(w), top - 2], [X(w), to], 'guide')}` : line([X(w), from], [X(w), to], 'guide');
}

/** A point of the curves: the distance, the force, the potential. */
export type CurvePoint = View['curve'][number];

/** A number for an attribute: hundredths are finer than a pixel of any screen. */
export const at = (value: number): string => String(Math.round(value * 100) / 100);

/** The unit vector from a place to another. */
export function unit([x, y]: Place, [u, v]: Place): Vector {
  const far = Math.hypot(u - x, v - y) || 1;
  return [(u - x) / far, (v - y) / far];
}

export function momentOf(view: View, packing: number): Moment | undefined {
  return view.traces[packing]?.moments[view.step];
}

/** The stiffness k0 of a packing: forces and energies are drawn as shares of it, so that the curves stay and their numbers change. */
export const stiffnessOf = (view: View, packing: number): number => Number(view.traces[packing]?.value('stiff')) || 1;

export function line(from: readonly [number, number], to: readonly [number, number], name: string): string {
  return `<path class="${name}" d="M${at(from[0])} ${at(from[1])}L${at(to[0])} ${at(to[1])}"/>`;
}

export function path(points: readonly (readonly [number, number])[], name: string): string {
  return points.length < 2 ? '' : `<path class="${name}" d="M${points.map(([x, y]) => `${at(x)} ${at(y)}`).join('L')}"/>`;
}

export function text(x: number, y: number, words: string, name = '', anchor = 'middle'): string {
  return `<text x="${at(x)}" y="${at(y)}" text-anchor="${anchor}"${name && ` class="${name}"`}>${words}</text>`;
}

export function circle([x, y]: Place, radius: number, name: string): string {
  return `<circle class="${name}" cx="${at(x)}" cy="${at(y)}" r="${at(radius)}"/>`;
}

/** A symbol, which the page marks together with the same one in equations. */
export function symbol(name: string, letters: string): string {
  return `<tspan class="letter" data-symbol="${name}">${letters}</tspan>`;
}

export const pick = (words: Words, language: Language): string => words[language];

export const PUSH: Words = { en: 'push', ja: '押す' };
export const PULL: Words = { en: 'pull', ja: '引く' };
export const NOTHING: Words = { en: 'nothing', ja: '力なし' };

/** An arrow from a point along the axis; its head is open if it pulls, so that colour is not needed. */
export function arrow(x: number, y: number, length: number, kind: string): string {
  const way = Math.sign(length);
  const end = x + length;
  const head = Math.min(13, Math.abs(length) * 0.7 + 5) * way;
  return `<g class="arrow ${kind}">${line([x, y], [end - head * 0.5, y], 'shaft')}<path class="head" d="M${at(end)} ${at(y)}l${at(-head)} -7v14z"/></g>`;
}

/** An arrow in any direction; its head is open if it pulls. */
export function arrowTo([x, y]: readonly [number, number], [dx, dy]: readonly [number, number], kind: string): string {
  const length = Math.hypot(dx, dy);
  const head = Math.min(9, length * 0.6 + 2);
  const [ux, uy] = [dx / length, dy / length];
  const [bx, by] = [x + dx - head * ux, y + dy - head * uy];
  const side = head * 0.5;
  const shaft = line([x, y], [x + dx - 0.6 * head * ux, y + dy - 0.6 * head * uy], 'shaft');
  return `<g class="arrow small ${kind}">${shaft}<path class="head" d="M${at(x + dx)} ${at(y + dy)}L${at(bx - side * uy)} ${at(by + side * ux)}L${at(bx + side * uy)} ${at(by - side * ux)}z"/></g>`;
}

/** The axis of w with its numbers, and the bands of push, pull and nothing above it, with lines at their borders down to it. */
export function axisOfW(y: number, top: number, bottom: number, language: Language): string {
  const marks = [0, 0.5, 1, 1.5, 2].map((w) => `${line([X(w), y - 3], [X(w), y + 3], 'tick')}${text(X(w), bottom + 16, String(w), 'number')}`);
  const names = [[0, 1, 'push', PUSH], [1, 1.5, 'pull', PULL], [1.5, WIDEST, 'none', NOTHING]] as const;
  const bands = names.map(([from, to, kind, words]) => {
    const middle = text(X((from + to) / 2), top - 6, pick(words, language), `band-name ${kind}`);
    return `<rect class="band ${kind}" x="${at(X(from))}" y="${at(top)}" width="${at(UNIT * (to - from))}" height="${at(bottom - top)}"/>${kind === 'none' ? '' : line([X(to), top], [X(to), y], 'border')}${middle}`;
  });
  return `${bands.join('')}${line([X(0), y], [X(WIDEST), y], 'axis')}${marks.join('')}${text(X(WIDEST) + 2, bottom + 16, symbol('w', 'w'), 'number', 'end')}`;
}

/** A way to draw a plate. Places on it are in units of its width of 400. */
export interface PlateDrawing {
  readonly height: number;
  readonly draw: (view: View, plate: Plate) => string;
  /** The place of a grip: `numbers` are those of its handle, two for a point. */
  readonly grip?: (view: View, plate: Plate, key: string, numbers: readonly number[]) => readonly [x: number, y: number];
  /** The numbers of a handle at a place. */
  readonly numbers?: (x: number, y: number, key: string, view: View) => readonly number[];
}

/** The figures of a chapter, and the ways to draw their plates by their words in the figures' data. */
export interface Drawings {
  readonly figures: readonly Figure[];
  readonly drawn: Readonly<Partial<Record<Plate['draw'], PlateDrawing>>>;
}

/** A plate that shows the picture as a whole. */
export const ofPlaces = (draw: PlateDrawing['draw']): PlateDrawing => ({ height: WIDTH, draw, grip: (_view, _plate, _key, [x = 0, y = 0]) => [x * WIDTH, y * WIDTH], numbers: (x, y) => [x / WIDTH, y / WIDTH] });

export function svg(height: number, said: string, content: string): string {
  return `<svg class="plate" viewBox="0 0 ${WIDTH} ${height}" width="${WIDTH}" height="${height}" role="img" aria-label="${said}">${content}</svg>`;
}
