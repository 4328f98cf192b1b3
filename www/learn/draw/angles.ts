/** Triangles counted by their smallest angle, in rows above one axis: bars, the median as a line, and the reader's mark as a flag. */
import type { AngleRow, Plate, View } from '../figures/figure';
import { LARGEST, type JoinedCells } from '../figures/joined';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { hatched } from './hatching';
import { isThin, tintOf } from './mesh';
import { at, circle, line, svg, symbol, text, WIDTH } from './plate';

const [LEFT, RIGHT, TOP, ROW, TALL] = [80, WIDTH - 18, 16, 61, 38];

/** The height of the flag above its row's floor. */
const POLE = 51;

const X = (angle: number): number => LEFT + (angle / LARGEST) * (RIGHT - LEFT);

export const angleAt = (x: number): number => ((x - LEFT) / (RIGHT - LEFT)) * LARGEST;

/** The number of a median stands left of it if the reader's mark is nearer than this on the right. */
const NAMED = 56;

/** The floor of a row. */
const floorOf = (row: number): number => TOP + ROW * (row + 1) - 8;

/** The place of a mark's flag. */
export const flagAt = (row: number, angle: number): readonly [x: number, y: number] => [X(angle), floorOf(row) - POLE + 9];

/** As tall as three rows and the axis. */
export const HEIGHT = floorOf(2) + 40;

export function angles(view: View, { angles: rows = [], title }: Plate): string {
  const found = rows.map(({ packing, always }) => view.traces[packing]?.joined(always ?? view.step));
  const most = Math.max(1, ...found.flatMap((joined) => joined?.counts ?? []));
  const drawn = rows.map((row, k) => (found[k] ? rowOf(view, row, k, found[k], most) : ''));
  const medians = rows.map(({ name }, k) => `${name[view.language]} ${number(found[k]?.median ?? 0, 1)}°`);
  return svg(HEIGHT, [title?.[view.language] ?? '', ...medians].filter(Boolean).join(', '), `${axis(view, rows.length)}${drawn.join('')}`);
}

function axis({ language }: View, rows: number): string {
  const bottom = floorOf(rows - 1);
  const marks = [0, 15, 30, 45, 60].map((angle) => `${line([X(angle), TOP - 8], [X(angle), bottom], 'grid')}${text(X(angle), bottom + 16, `${angle}°`, 'number')}`);
  const name = text((LEFT + RIGHT) / 2, bottom + 33, language === 'ja' ? `三角形の最小角 ${symbol('gamma', 'γ')}` : `smallest angle of a triangle ${symbol('gamma', 'γ')}`, 'number');
  return `${marks.join('')}${name}`;
}

function rowOf(view: View, { name, letter }: AngleRow, row: number, { counts, median, faces }: JoinedCells, most: number): string {
  const floor = floorOf(row);
  const wide = (RIGHT - LEFT) / counts.length;
  const bars = counts.map((count, k) => {
    const [angle, left, tall] = [k * (LARGEST / counts.length), LEFT + k * wide + 0.5, (count / most) * TALL];
    return count ? bar(angle, left, floor - tall, wide - 1, tall) : '';
  });
  const of = view.language === 'ja' ? `${faces.length}個` : `of ${faces.length}`;
  const names = `${text(LEFT - 10, floor - 18, name[view.language], 'key', 'end')}${text(LEFT - 10, floor - 3, of, 'number', 'end')}`;
  const beyond = X(view.at[row] ?? 0) - X(median);
  const isLeft = median > 50 || (beyond > -8 && beyond < NAMED);
  const middle = `${line([X(median), floor], [X(median), floor - POLE + 2], 'median')}${text(X(median) + (isLeft ? -5 : 5), floor - POLE + 9, `${number(median, 1)}°`, 'median-name', isLeft ? 'end' : 'start')}`;
  return `${line([LEFT, floor], [RIGHT, floor], 'axis')}${bars.join('')}${names}${middle}${mark(letter, row, view.at[row] ?? 0)}`;
}

/** A bar with the tint of its angle, and its lines if triangles of this angle are thin. */
function bar(angle: number, x: number, y: number, wide: number, tall: number): string {
  const corners: readonly Place[] = [[x, y], [x + wide, y], [x + wide, y + tall], [x, y + tall]];
  return `<rect class="angle-bar tint-${tintOf(angle)}" x="${at(x)}" y="${at(y)}" width="${at(wide)}" height="${at(tall)}"/>${isThin(angle) ? hatched([corners]) : ''}`;
}

/** The reader's mark; one that was not set stands at 0. */
function mark(letter: string, row: number, angle: number): string {
  const [x, y] = flagAt(row, angle);
  return `<g class="mark">${line([x, floorOf(row)], [x, y], 'pole')}${circle([x, y], 8, 'flag')}${text(x, y + 4, letter, 'flag-letter')}</g>`;
}
