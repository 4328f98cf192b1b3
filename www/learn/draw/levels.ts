/** Numbers as levels in the order in which they were found, as valleys of different depth; the marked one is named. */
import type { Bar, Plate, View } from '../figures/figure';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { at, circle, line, svg, text, WIDTH } from './plate';
import { digitsOf, marksOf } from './plot';

const [LEFT, RIGHT, TOP, BOTTOM] = [64, WIDTH - 24, 44, SIDE - 44];

/** The room of a level, and the most levels. */
const ROOM = 52;
const MOST = Math.floor((RIGHT - LEFT) / ROOM);

/** The levels that have room beside an unknown one: the first, the marked one, and those that were found last. */
function shownOf(all: readonly Bar[]): readonly Bar[] {
  if (all.length < MOST) return all;
  const kept = all.filter(({ isMarked }, k) => k === 0 || isMarked);
  const others = all.filter((bar) => !kept.includes(bar)).slice(kept.length + 1 - MOST);
  return all.filter((bar) => kept.includes(bar) || others.includes(bar));
}

/** The least height of the axis, so that small differences stay small. */
const LEAST = 0.2;

export function levels(view: View, { bars, digits = 2, title }: Plate): string {
  const all = bars?.(view, view.language) ?? [];
  const shown = shownOf(all);
  const values = shown.map(({ value }) => value);
  const middle = values.length ? (Math.min(...values) + Math.max(...values)) / 2 : 0;
  const half = Math.max(LEAST, ...values.map((value) => Math.abs(value - middle) + LEAST / 4));
  const marks = marksOf(middle - half, middle + half);
  const [low = 0, high = 1] = [marks[0], marks.at(-1)];
  const y = (value: number): number => BOTTOM - ((value - low) / (high - low)) * (BOTTOM - TOP);
  const scale = marks.map((value) => `${line([LEFT, y(value)], [RIGHT, y(value)], 'grid')}${text(LEFT - 8, y(value) + 4, number(value, digitsOf(marks)), 'number', 'end')}`);
  const said = [title?.[view.language] ?? '', ...all.map(({ value }) => number(value, digits))].filter(Boolean).join(', ');
  const name = text(LEFT, BOTTOM + 32, view.language === 'ja' ? '試した順に' : 'in the order of trials', 'number', 'start');
  const place = (k: number): number => LEFT + (k + 0.5) * ROOM;
  return svg(SIDE, said, `${scale.join('')}${shown.map((bar, k) => level(bar, place(k), y, digits)).join('')}${next(place(shown.length), y(middle))}${name}`);
}

/** The level of the next trial, which is not known yet. */
function next(x: number, y: number): string {
  return `${basin(x, y, 'unknown')}${text(x, y - 24, '?', 'key')}`;
}

function basin(x: number, y: number, kind: string): string {
  const half = ROOM * 0.38;
  return `<path class="basin ${kind}" d="M${at(x - half)} ${at(y - 16)}C${at(x - half * 0.5)} ${at(y + 5)} ${at(x + half * 0.5)} ${at(y + 5)} ${at(x + half)} ${at(y - 16)}"/>`;
}

/** A level as a valley with a ball in it; the marked one has its number. */
function level({ name, value, isMarked = false }: Bar, x: number, y: (value: number) => number, digits: number): string {
  const here = y(value);
  const ball = circle([x, here - 6], isMarked ? 5.5 : 4, isMarked ? 'here' : 'extreme');
  const shown = isMarked ? text(x, here - 24, number(value, digits), 'key marked') : '';
  return `${basin(x, here, isMarked ? 'marked' : '')}${ball}${shown}${text(x, BOTTOM + 15, name, 'number')}`;
}
