/** How far a direction has turned over a walk, in quarter turns. */
import { STEPS } from '../figures/directions';
import type { Plate, View } from '../figures/figure';
import { inQuarters, number } from '../figures/words';
import { SIDE } from './crowd';
import { circle, line, path, svg, symbol, text, WIDTH } from './plate';

const [LEFT, RIGHT, TOP, BOTTOM] = [56, WIDTH - 24, 40, SIDE - 52];

/** The axis goes at least from the first number to the second. */
const [LOWEST, HIGHEST] = [-2, 4];

const X = (step: number): number => LEFT + (step / STEPS) * (RIGHT - LEFT);

export function turns(view: View, { packing, title }: Plate): string {
  const way = view.traces[packing]?.directions.walk(view.at) ?? [];
  const values = way.map(({ quarters }) => quarters);
  const [low, high] = [Math.floor(Math.min(LOWEST, ...values)), Math.ceil(Math.max(HIGHEST, ...values))];
  const y = (value: number): number => BOTTOM - ((value - low) / (high - low)) * (BOTTOM - TOP);
  const rows = Array.from({ length: high - low + 1 }, (_, k) => low + k).map((value) => `${line([LEFT, y(value)], [RIGHT, y(value)], value ? 'grid' : 'axis')}${text(LEFT - 8, y(value) + 4, number(value, 0), 'number', 'end')}`);
  const marks = [0, 90, 180, 270, 360].map((degrees) => `${line([X(degrees / 5), BOTTOM], [X(degrees / 5), BOTTOM + 4], 'tick')}${text(X(degrees / 5), BOTTOM + 18, `${degrees}°`, 'number')}`);
  const isJapanese = view.language === 'ja';
  const names = `${text(LEFT - 40, TOP - 18, `${symbol('turns', 'q')}<tspan dx="6">${isJapanese ? '90°回転の数' : 'quarter turns'}</tspan>`, 'number', 'start')}${text((LEFT + RIGHT) / 2, BOTTOM + 38, isJapanese ? '道筋' : 'along the walk', 'number')}`;
  return svg(SIDE, title?.[view.language] ?? '', `${rows.join('')}${marks.join('')}${names}${way.length ? drawn(view, values, y) : nothing(isJapanese, y(1))}`);
}

/** The curve goes on, dotted, to the furthest step that was seen; the present number stands beside its dot. */
function drawn({ step, furthest }: View, values: readonly number[], y: (value: number) => number): string {
  const upTo = (last: number): (readonly [number, number])[] => values.slice(0, last + 1).map((value, k) => [X(k), y(value)] as const);
  const now = values[step] ?? 0;
  const isLate = step > STEPS - 12;
  const place = [X(step), y(now)] as const;
  const name = text(place[0] + (isLate ? -12 : 12), place[1] - 10, inQuarters(now), 'key marked halo', isLate ? 'end' : 'start');
  return `${path(upTo(furthest), 'line later')}${path(upTo(step), 'line line-0')}${line([place[0], y(0)], place, 'now')}${circle(place, 5.5, 'here')}${name}`;
}

function nothing(isJapanese: boolean, y: number): string {
  return text((LEFT + RIGHT) / 2, y, isJapanese ? '道筋が輪郭の外に出るので、数えません。' : 'The walk leaves the outline: no count.', 'key');
}
