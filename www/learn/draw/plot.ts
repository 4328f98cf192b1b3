/** Numbers over the steps of a run: lines that differ by dash and name, and the present step. */
import { crowdAt } from '../figures/crowds';
import type { Line, Plate, View } from '../figures/figure';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { circle, line, path, pick, svg, symbol, text, WIDTH } from './plate';

const [LEFT, RIGHT, BOTTOM] = [56, WIDTH - 16, SIDE - 44];

/** The height of a row of the key. */
const ROW_OF_KEY = 18;

/** The most intervals between marks of the vertical axis. */
const MARKS = 6;

interface Axes {
  readonly top: number;
  readonly x: (step: number) => number;
  readonly y: (value: number) => number;
  readonly marks: readonly number[];
}

export function plot(view: View, { lines = [], axis, digits = 2, title }: Plate): string {
  const values = lines.map((own) => valuesOf(view, own));
  const axes = axesOf(view, values.flat(), 28 + ROW_OF_KEY * lines.length);
  const drawn = values.map((row, k) => path(row.map((value, step) => [axes.x(step), axes.y(value)] as const), `line line-${k}`));
  const shown = axis ? text(LEFT - 44, axes.top - 10, pick(axis, view.language), 'number', 'start') : '';
  const said = [title?.[view.language] ?? '', ...lines.map(({ name }) => name[view.language])].filter(Boolean).join(', ');
  return svg(SIDE, said, `${scale(view, axes)}${shown}${drawn.join('')}${view.furthest === 0 ? toCome(view, axes) : ''}${now(view, lines, axes)}${key(view, lines, digits)}`);
}

/** A word where lines will come: no step has been seen yet. */
function toCome({ language }: View, { top }: Axes): string {
  return text((LEFT + RIGHT) / 2, (top + BOTTOM) / 2, language === 'ja' ? '再生すると、ここに線が伸びます' : 'Press play: the lines are drawn here', 'to-come halo');
}

/** The numbers of a line up to the furthest step that was seen; later ones would tell how the run goes on. */
function valuesOf({ traces, furthest }: View, { packing, of }: Line): number[] {
  return (traces[packing]?.steps ?? []).slice(0, furthest + 1).map(of);
}

function axesOf({ last }: View, values: readonly number[], top: number): Axes {
  const marks = marksOf(Math.min(0, ...values), Math.max(0, ...values));
  const [low = 0, high = 1] = [marks[0], marks.at(-1)];
  return {
    top,
    x: (step) => LEFT + (step / Math.max(1, last)) * (RIGHT - LEFT),
    y: (value) => BOTTOM - ((value - low) / (high - low)) * (BOTTOM - top),
    marks,
  };
}

/** Round numbers at equal intervals that cover a range. */
export function marksOf(low: number, high: number): number[] {
  const wide = Math.max(high - low, 1e-3) / MARKS;
  const power = 10 ** Math.floor(Math.log10(wide));
  const stride = ([1, 2, 5].find((factor) => factor * power >= wide) ?? 10) * power;
  const first = Math.floor(low / stride + 1e-9);
  const count = Math.max(1, Math.ceil(high / stride - 1e-9) - first);
  return Array.from({ length: count + 1 }, (_, k) => (first + k) * stride);
}

/** The digits that tell marks apart. */
export function digitsOf([first = 0, second = 1]: readonly number[]): number {
  return Math.max(0, -Math.floor(Math.log10(second - first) + 1e-9));
}

function scale({ last, language }: View, { x, y, marks }: Axes): string {
  const digits = digitsOf(marks);
  const rows = marks.map((value) => `${line([LEFT, y(value)], [RIGHT, y(value)], value === 0 ? 'axis' : 'grid')}${text(LEFT - 6, y(value) + 4, number(value, digits), 'number', 'end')}`);
  const steps = [0, Math.round(last / 2), last].map((step) => text(x(step), BOTTOM + 18, String(step), 'number'));
  const name = text((LEFT + RIGHT) / 2, BOTTOM + 34, language === 'ja' ? 'ステップ' : 'step', 'number');
  return `${rows.join('')}${steps.join('')}${name}`;
}

/** The present step, with a dot on each line. */
function now(view: View, lines: readonly Line[], { top, x, y }: Axes): string {
  const pole = line([x(view.step), top], [x(view.step), BOTTOM], 'now');
  const dots = lines.map(({ packing, of }, k) => {
    const trace = view.traces[packing];
    const crowd = trace && crowdAt(trace, view.step);
    return crowd ? circle([x(crowd.step), y(of(crowd))], 4.5, `here here-${k}`) : '';
  });
  return `${pole}${dots.join('')}`;
}

/** The names of the lines with a piece of each, and their numbers at the present step. */
function key({ traces, step, language }: View, lines: readonly Line[], digits: number): string {
  return lines
    .map(({ name, symbol: letters, packing, of }, k) => {
      const y = 20 + ROW_OF_KEY * k;
      const trace = traces[packing];
      const crowd = trace && crowdAt(trace, step);
      const value = crowd ? text(RIGHT, y, number(of(crowd), digits), `key key-${k}`, 'end') : '';
      return `${line([LEFT - 40, y - 4], [LEFT - 8, y - 4], `line line-${k}`)}${text(LEFT, y, `${pick(name, language)}${letters ? ` ${symbol(letters, letters)}` : ''}`, 'key', 'start')}${value}`;
    })
    .join('');
}
