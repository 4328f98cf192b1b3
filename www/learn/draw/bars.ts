/** Bars with their names and numbers, one below the other. */
import type { Bar, Plate, View } from '../figures/figure';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { at, line, svg, text, WIDTH } from './plate';

const [NAMES, RIGHT, TOP] = [120, WIDTH - 60, 24];

/** The largest height of a row. */
const TALL = 40;

export function bars(view: View, { bars: of, digits = 2, title }: Plate): string {
  const all = of?.(view, view.language) ?? [];
  const tall = Math.min(TALL, (SIDE - TOP - 16) / Math.max(1, all.length));
  const [low, high] = [Math.min(0, ...all.map(({ value }) => value)), Math.max(0, ...all.map(({ value }) => value))];
  const x = (value: number): number => NAMES + ((value - low) / (high - low || 1)) * (RIGHT - NAMES);
  const drawn = all.map((bar, k) => one(bar, TOP + k * tall, tall, x, digits)).join('');
  const said = [title?.[view.language] ?? '', ...all.map(({ name, value }) => `${name} ${number(value, digits)}`)].filter(Boolean).join(', ');
  return svg(SIDE, said, `${drawn}${line([x(0), TOP - 6], [x(0), TOP + all.length * tall + 6], 'axis')}`);
}

function one({ name, value, isMarked = false }: Bar, y: number, tall: number, x: (value: number) => number, digits: number): string {
  const [from, to] = [Math.min(x(0), x(value)), Math.max(x(0), x(value))];
  const bar = `<rect class="bar-of${isMarked ? ' marked' : ''}" x="${at(from)}" y="${at(y + 0.15 * tall)}" width="${at(to - from)}" height="${at(0.7 * tall)}"/>`;
  return `${bar}${text(NAMES - 8, y + tall / 2 + 4, name, 'key', 'end')}${text(RIGHT + 8, y + tall / 2 + 4, number(value, digits), isMarked ? 'key marked' : 'key', 'start')}`;
}
