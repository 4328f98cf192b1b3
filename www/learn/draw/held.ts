/** The cells of a packing in their outline. Bars below compare the number of cells with other numbers. */
import type { Bar, Plate, View } from '../figures/figure';
import { marksAt } from '../figures/population';
import { number } from '../figures/words';
import { cellShape } from './crowd';
import { at, svg, text, WIDTH } from './plate';
import { BELOW, inOutline } from './population';

const [NAMES, RIGHT, TOP, TALL] = [112, WIDTH - 56, BELOW + 8, 26];

/** As tall as the two bars of a plate. */
export const HEIGHT = TOP + 2 * TALL + 12;

export function held(view: View, { packing, bars, digits = 1, title }: Plate): string {
  const trace = view.traces[packing];
  if (!trace) return svg(HEIGHT, '', '');
  const cells = marksAt(trace, view.step).cells.map((cell) => cellShape(cell, undefined, 'bubble')).join('');
  const all = bars?.(view, view.language) ?? [];
  const said = [title?.[view.language] ?? '', ...all.map(({ name, value }) => `${name} ${number(value, digits)}`)].filter(Boolean).join(', ');
  const most = mostOf(view, all);
  return svg(HEIGHT, said, `${inOutline(trace, cells)}${all.map((bar, k) => row(bar, TOP + k * TALL, most, digits)).join('')}`);
}

/** The longest bar of all plates, which have one scale. */
function mostOf({ traces, step }: View, all: readonly Bar[]): number {
  return Math.max(...all.map(({ value }) => value), ...traces.map((trace) => marksAt(trace, step).cells.length));
}

function row({ name, value, isMarked = false }: Bar, y: number, most: number, digits: number): string {
  const bar = `<rect class="bar-of${isMarked ? ' marked' : ' formula'}" x="${NAMES}" y="${at(y + 4)}" width="${at((value / most) * (RIGHT - NAMES))}" height="${TALL - 8}"/>`;
  return `${bar}${text(NAMES - 8, y + TALL / 2 + 4, name, 'key', 'end')}${text(NAMES + (value / most) * (RIGHT - NAMES) + 8, y + TALL / 2 + 4, number(value, Number.isInteger(value) ? 0 : digits), 'key', 'start')}`;
}
