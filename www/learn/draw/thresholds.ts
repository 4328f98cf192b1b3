/** The smallest w of each cell on one axis, and the thresholds from which a cell goes or brings another one. */
import { crowdAt, packedOf } from '../figures/crowds';
import type { Plate, Trace, View } from '../figures/figure';
import { isCrowded, isLonely } from '../figures/population';
import { number } from '../figures/words';
import { at, circle, line, svg, symbol, text, WIDTH } from './plate';
import { HEIGHT } from './population';

const [LEFT, RIGHT, TOP, FLOOR] = [24, WIDTH - 24, 112, HEIGHT - 64];

/** The ends of the axis. */
const [LOWEST, HIGHEST] = [0.6, 1.25];

/** Cells whose w is in one bin stand on each other. */
const BIN = 0.02;

/** The heights of both flags, so that their words have room beside each other. */
const FLAGS: Readonly<Record<string, number>> = { crowd: 34, room: 66 };

const X = (w: number): number => LEFT + ((Math.max(LOWEST, Math.min(HIGHEST, w)) - LOWEST) / (HIGHEST - LOWEST)) * (RIGHT - LEFT);

const toW = (x: number): number => LOWEST + ((x - LEFT) / (RIGHT - LEFT)) * (HIGHEST - LOWEST);

/** The places of the grips, and the number at a place. */
export const gripOf = (key: string, value: number): readonly [number, number] => [X(value), FLAGS[key] ?? TOP];
export const numbersOf = (x: number): readonly number[] => [toW(x)];

export function thresholds(view: View, { packing, title }: Plate): string {
  const trace = view.traces[packing];
  const now = trace && crowdAt(trace, view.step);
  if (!trace || !now) return svg(HEIGHT, '', '');
  const [crowd, room] = [Number(trace.value('crowd')), Number(trace.value('room'))];
  const words = view.language === 'ja' ? '各セルのwの最小値と、二つのしきい値' : 'The smallest w of each cell, and both thresholds';
  const said = title ? `${title[view.language]}. ${words}` : words;
  return svg(HEIGHT, said, `${bands(view, crowd, room)}${axis(view)}${dots(trace, view)}${flag(view, 'crowd', crowd)}${flag(view, 'room', room, crowd)}${sums(trace, view)}`);
}

/** The bands of w in which cells go, and in which they bring another one; where these overlap, both patterns show. */
function bands({ language }: View, crowd: number, room: number): string {
  const band = (from: number, to: number, kind: string): string => `<rect class="band ${kind}" x="${at(X(from))}" y="${TOP}" width="${at(Math.max(0, X(to) - X(from)))}" height="${FLOOR - TOP}"/>`;
  const both = room < crowd ? `${slant(room, crowd)}${text((X(room) + X(crowd)) / 2, TOP + 16, language === 'ja' ? '両方' : 'both', 'both')}` : '';
  return `${band(LOWEST, crowd, 'push')}${band(room, HIGHEST, 'pull')}${both}`;
}

/** Slanted lines where a cell goes and brings another one. */
function slant(from: number, to: number): string {
  const [left, right] = [X(from), X(to)];
  const rows = Array.from({ length: Math.floor((FLOOR - TOP) / 9) }, (_, k) => TOP + 9 * (k + 1));
  return `<path class="hatch" d="${rows.map((y) => `M${at(left)} ${at(y)}L${at(right)} ${at(y - Math.min(9, right - left))}`).join('')}"/>`;
}

function axis({ language }: View): string {
  const marks = [0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2].map((w) => `${line([X(w), FLOOR], [X(w), FLOOR + 4], 'tick')}${text(X(w), FLOOR + 17, w > LOWEST ? number(w, 1) : `≤ ${number(w, 1)}`, 'number')}`);
  const name = `${language === 'ja' ? '最も近い隣までの' : 'nearest neighbour at'} ${symbol('w', 'w')}`;
  return `${line([LEFT, FLOOR], [RIGHT, FLOOR], 'axis')}${marks.join('')}${text(WIDTH / 2, FLOOR + 34, name, 'number')}`;
}

/**
 * A dot for each cell. One with a cross goes, one with a plus brings another cell, and one with both signs does both.
 */
function dots(trace: Trace, { step }: View): string {
  const now = crowdAt(trace, step);
  const heights = new Map<number, number>();
  const cells = now ? packedOf(now, trace.side) : [];
  const r = ((RIGHT - LEFT) / (HIGHEST - LOWEST)) * BIN * 0.46;
  return cells
    .map((cell) => {
      const bin = Math.round((Math.max(LOWEST, Math.min(HIGHEST, cell.least || HIGHEST))) / BIN);
      const height = heights.get(bin) ?? 0;
      heights.set(bin, height + 1);
      const [x, y] = [X(bin * BIN), FLOOR - r - 2 - height * 2 * r];
      const kind = `${isCrowded(trace, cell) ? ' crowded' : ''}${isLonely(trace, cell) ? ' lonely' : ''}`;
      return `${circle([x, y], r, `cell-dot${kind}`)}${kind ? sign(x, y, r * 0.6, kind) : ''}`;
    })
    .join('');
}

function sign(x: number, y: number, arm: number, kind: string): string {
  const slanted = kind.includes('crowded') ? `M${at(x - arm)} ${at(y - arm)}l${at(2 * arm)} ${at(2 * arm)}m0 ${at(-2 * arm)}l${at(-2 * arm)} ${at(2 * arm)}` : '';
  const upright = kind.includes('lonely') ? `M${at(x - arm)} ${at(y)}h${at(2 * arm)}M${at(x)} ${at(y - arm)}v${at(2 * arm)}` : '';
  return `<path class="sign" d="${slanted}${upright}"/>`;
}

/** The room that the words of a flag take in one line, and in two. */
const ROOM = { en: [152, 88], ja: [116, 72] } as const;

/** The free room between words and the other pole. */
const APART = 10;

/** Where words can stand: the side to which they run, where they begin, and how long they may be. */
interface Free {
  readonly side: number;
  readonly from: number;
  readonly room: number;
}

/** The places for the words of a flag: near it, before and behind, and those beyond the pole that passes them. */
function freeBeside(x: number, way: number, pole: number | undefined): readonly [near: Free[], beyond: Free[]] {
  const [near, beyond]: [Free[], Free[]] = [[], []];
  for (const side of [way, -way]) {
    const from = x + side * (side === way ? 36 : 14);
    const end = side < 0 ? 0 : WIDTH;
    const isDivided = pole !== undefined && (pole - x) * side > 0;
    near.push({ side, from, room: isDivided ? (pole - from) * side - APART : (end - from) * side });
    if (!isDivided) continue;
    const after = side * Math.max(side * from, side * pole + APART);
    beyond.push({ side, from: after, room: (end - after) * side });
  }
  return [near, beyond];
}

/**
 * A threshold as a pole with a flag to the side on which it works. Its words stand where there is room for them. The pole
 * of "goes below" begins higher and passes the words of "comes from", which keep away from it, in two lines if need be.
 */
function flag({ language }: View, key: 'crowd' | 'room', value: number, passing?: number): string {
  const [x, y] = gripOf(key, value);
  const way = key === 'crowd' ? -1 : 1;
  const words = key === 'crowd' ? (language === 'ja' ? '去る' : 'goes below') : language === 'ja' ? '増える' : 'comes from';
  const [inOne, inTwo] = ROOM[language];
  const free = freeBeside(x, way, passing === undefined ? undefined : X(passing)).flatMap((places) => [inOne, inTwo].map((least) => places.find((place) => place.room >= least)));
  const { side, from, room } = free.find((place) => place !== undefined) ?? { side: way, from: x, room: 0 };
  const anchor = side < 0 ? 'end' : 'start';
  const named = `${symbol(key, key === 'crowd' ? 'a' : 'b')} = ${number(value, 2)}`;
  const label = room >= inOne ? text(from, y + 5, `${words} ${named}`, 'key halo', anchor) : `${text(from, y - 3, words, 'key halo', anchor)}${text(from, y + 13, named, 'key halo', anchor)}`;
  return `<g class="threshold ${key}" data-symbol="${key}">${line([x, y], [x, FLOOR], 'pole')}<path class="flag" d="M${at(x)} ${y - 8}h${22 * way}l${6 * way} 8l${-6 * way} 8h${-22 * way}z"/>${label}</g>`;
}

function sums(trace: Trace, { step, language }: View): string {
  const now = crowdAt(trace, step);
  const cells = now ? packedOf(now, trace.side) : [];
  const [goes, brings] = [cells.filter((cell) => isCrowded(trace, cell)).length, cells.filter((cell) => isLonely(trace, cell)).length];
  const words = language === 'ja' ? `${cells.length}個のうち、過密${goes}個、孤立${brings}個` : `of ${cells.length} cells, ${goes} crowded, ${brings} lonely`;
  return text(WIDTH / 2, HEIGHT - 8, words, 'key');
}
