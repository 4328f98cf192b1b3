/**
 * The cells of a packing: those that are crowded, that go, that come. Below is a strip of all looks at the population.
 */
import { countOf, crowdAt } from '../figures/crowds';
import type { PackedCell, Plate, Trace, View } from '../figures/figure';
import { isCrowded, looksUpTo, marksAt, type Look, type Marks } from '../figures/population';
import { cellShape, outlineOf, SIDE } from './crowd';
import { at, circle, line, path, svg, symbol, text, WIDTH } from './plate';

/** The picture fills this share of the plate's width, so that there is room below it, also for cells that begin on the outline. */
const SHARE = 0.76;
export const BELOW = 0.805 * SIDE;

/** Room above for cells that stick out of the outline; below it the outline leaves enough. */
const TOP_ROOM = 8;

/** The strip: its left and right end, the top and floor of its curve, and the rows of the cells that came and went. */
const [LEFT, RIGHT, TOP, FLOOR] = [62, WIDTH - 24, BELOW + 36, BELOW + 78];
const [CAME, WENT] = [FLOOR + 18, FLOOR + 34];

export const HEIGHT = WENT + 10;

/** Half the arm of a sign, in units of the plate. */
const ARM = 6;

/** The width of a digit in the rows. */
const DIGIT = 9;

/** Between two lines of a hatching. */
const HATCH = 5;

export function population(view: View, { packing, title, isAhead = false, isAsked = false }: Plate): string {
  const trace = view.traces[packing];
  if (!trace) return svg(HEIGHT, '', '');
  const all = marksAt(trace, view.step);
  const marks = isAsked ? { ...all, leaving: new Set<number>(), empty: [] } : all;
  const said = [title?.[view.language] ?? '', spoken(view, marks, isAsked)].filter(Boolean).join('. ');
  return svg(HEIGHT, said, `${inOutline(trace, cellsOf(trace, marks))}${legend(view)}${strip(view, trace, isAhead)}`);
}

/** Drawings at the places of the picture, in its outline. */
export function inOutline(trace: Trace, content: string): string {
  return `<g transform="translate(${at((WIDTH - SHARE * SIDE) / 2)} ${TOP_ROOM}) scale(${SHARE})">${outlineOf(trace)}${content}</g>`;
}

function spoken({ language }: View, { cells, leaving, empty }: Marks, isAsked: boolean): string {
  if (isAsked) return language === 'ja' ? `輪郭の中の${cells.length}個のセル` : `${cells.length} cells in their outline`;
  return language === 'ja' ? `輪郭の中の${cells.length}個のセル。次の調査で${leaving.size}個が去り、${empty.length}個が増えます` : `${cells.length} cells in their outline; at the next look ${leaving.size} ${leaving.size === 1 ? 'goes' : 'go'} and ${empty.length} ${empty.length === 1 ? 'comes' : 'come'}`;
}

function cellsOf(trace: Trace, { cells, leaving, fresh, empty }: Marks): string {
  const size = cells[0]?.size ?? 0;
  const kind = (cell: PackedCell): string => `bubble${isCrowded(trace, cell) ? ' crowded' : ''}${fresh.has(cell.id) ? ' fresh' : ''}`;
  const drawn = cells.map((cell) => `${cellShape(cell, undefined, kind(cell))}${isCrowded(trace, cell) ? hatching(cell) : ''}`);
  const signs = cells.map((cell) => (leaving.has(cell.id) ? cross(cell.x * SIDE, cell.y * SIDE) : fresh.has(cell.id) ? plus(cell.x * SIDE, cell.y * SIDE) : ''));
  const places = empty.map(({ x, y }) => `${circle([x * SIDE, y * SIDE], (size / 2) * SIDE, 'empty')}${plus(x * SIDE, y * SIDE)}`);
  return `${drawn.join('')}${places.join('')}${signs.join('')}`;
}

/** Slanted lines in a circle. */
function chords(x: number, y: number, r: number): string {
  const count = Math.floor(r / HATCH);
  const chord = (off: number): string => {
    const half = Math.sqrt(r * r - off * off) / Math.SQRT2;
    const [cx, cy] = [x + off / Math.SQRT2, y + off / Math.SQRT2];
    return `M${at(cx - half)} ${at(cy + half)}L${at(cx + half)} ${at(cy - half)}`;
  };
  return `<path class="hatch" d="${Array.from({ length: 2 * count + 1 }, (_, k) => chord((k - count) * HATCH)).join('')}"/>`;
}

const hatching = ({ x, y, size }: PackedCell): string => chords(x * SIDE, y * SIDE, (size / 2) * SIDE);

/** The sign of a cell that goes. A wider one in the plate's colour below it parts it from the lines of crowded cells. */
export function cross(x: number, y: number, arm = ARM): string {
  const d = `M${at(x - arm)} ${at(y - arm)}l${2 * arm} ${2 * arm}m0 ${-2 * arm}l${-2 * arm} ${2 * arm}`;
  return `<path class="sign-back" d="${d}"/><path class="sign goes" d="${d}"/>`;
}

/** The sign of a cell that comes. */
export function plus(x: number, y: number, arm = ARM + 1, kind = ''): string {
  return `<path class="sign comes${kind}" d="M${at(x - arm)} ${at(y)}h${2 * arm}m${-arm} ${-arm}v${2 * arm}"/>`;
}

/** The key of the signs. */
function legend({ language }: View): string {
  const y = BELOW + 10;
  const dot = (x: number, kind: string): string => circle([x, y], 7, kind);
  const words = (x: number, en: string, ja: string): string => text(x, y + 4, language === 'ja' ? ja : en, 'number sign-name', 'start');
  const crowded = `${dot(14, 'bubble crowded')}${chords(14, y, 7)}${words(25, 'crowded', '過密')}`;
  const goes = `${cross(104, y, 5)}${words(114, 'goes next', '次に去る')}`;
  const comes = `${dot(199, 'empty small')}${plus(199, y, 3, ' small')}${words(210, 'comes next', '次に増える')}`;
  const came = `${dot(309, 'bubble fresh small')}${plus(309, y, 3, ' small')}${words(320, 'just came', '今増えた')}`;
  return `${crowded}${goes}${comes}${came}`;
}

/** The number of cells over the steps, and at each look how many came and went. */
function strip(view: View, trace: Trace, isAhead: boolean): string {
  const x = (step: number): number => LEFT + (step / Math.max(1, view.last)) * (RIGHT - LEFT);
  const most = Math.max(1, ...view.traces.flatMap(({ steps }) => steps.map(countOf)));
  const y = (count: number): number => FLOOR - (count / most) * (FLOOR - TOP);
  const points = stairs(trace, x, y);
  const seen = isAhead ? view.step : view.furthest;
  const past = points.slice(0, 2 * seen + 2);
  // Near the end, the number at the present step is enough.
  const end = x(trace.steps.length - 1) - x(seen) > 20 ? endOf(trace, x, y) : '';
  const ahead = isAhead && seen < view.last ? `${path(points.slice(2 * seen + 1), 'line ahead')}${end}` : '';
  const looks = changed(looksUpTo(trace, isAhead ? view.last : view.furthest), x, seen);
  const name = text(LEFT - 8, (TOP + FLOOR) / 2 + 4, `${view.language === 'ja' ? '個数' : 'cells'} ${symbol('n', 'n')}`, 'number', 'end');
  return `${line([LEFT, FLOOR], [RIGHT, FLOOR], 'axis')}${name}${rowNames(view)}${looks}${ahead}${path(past, 'line line-0')}${here(view, trace, isAhead, x, y)}`;
}

/** The curve of the number of cells, as stairs: the number changes at a step, not between two steps. */
function stairs({ steps }: Trace, x: (step: number) => number, y: (count: number) => number): (readonly [number, number])[] {
  return steps.flatMap((crowd, k) => [[x(crowd.step), y(countOf(steps[k - 1] ?? crowd))], [x(crowd.step), y(countOf(crowd))]] as const);
}

/** The number of cells at the end of a run. */
function endOf({ steps }: Trace, x: (step: number) => number, y: (count: number) => number): string {
  const last = steps.at(-1);
  return last ? text(x(last.step) + 3, y(countOf(last)) + 4, String(countOf(last)), 'number', 'start') : '';
}

/** The present step, and the number of cells there. */
function here(view: View, trace: Trace, isAhead: boolean, x: (step: number) => number, y: (count: number) => number): string {
  const now = crowdAt(trace, view.step);
  if (!now) return '';
  const count = countOf(now);
  // The number at the end of the later steps needs its room, too.
  const isLate = x(now.step) > Math.min(RIGHT, isAhead ? x(trace.steps.length - 1) : RIGHT) - 30;
  const words = text(x(now.step) + (isLate ? -8 : 8), y(count) - 5, String(count), 'key halo', isLate ? 'end' : 'start');
  return `${line([x(view.step), TOP - 6], [x(view.step), FLOOR], 'now')}${circle([x(now.step), y(count)], 4.5, 'here')}${words}`;
}

function rowNames({ language }: View): string {
  const names = language === 'ja' ? ['増えた', '去った'] : ['came', 'went'];
  return `${text(LEFT - 8, CAME, names[0] ?? '', 'number', 'end')}${text(LEFT - 8, WENT, names[1] ?? '', 'number', 'end')}`;
}

/** A tick at each look, with two rows of numbers below. */
function changed(looks: readonly Look[], x: (step: number) => number, seen: number): string {
  const ticks = looks.map(({ step }) => line([x(step), FLOOR], [x(step), FLOOR + 5], 'tick')).join('');
  const row = (y: number, sign: string, way: 'came' | 'went'): string => {
    const all = looks.filter((look) => look[way].length).map((look) => ({ words: `${sign}${look[way].length}`, x: x(look.step), isAhead: look.step > seen }));
    return apart(all).map((one) => text(one.x, y, one.words, `change ${way}${one.isAhead ? ' ahead' : ''}`)).join('');
  };
  return `${ticks}${row(CAME, '+', 'came')}${row(WENT, '−', 'went')}`;
}

/** Words in a row, each moved on until it is clear of the one before. */
function apart<T extends { readonly words: string; readonly x: number }>(row: readonly T[]): T[] {
  let free = -Infinity;
  return row.map((one) => {
    const half = (one.words.length * DIGIT) / 2;
    const x = Math.max(one.x, free + half);
    free = x + half + DIGIT / 2;
    return { ...one, x };
  });
}
