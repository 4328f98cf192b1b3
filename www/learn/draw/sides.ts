/**
 * The sides of an outline at a point. Below are the terms of the sides with their sum: as printed, or at four times the
 * angle. The terms of a side that is cut follow each other head to tail. All lengths are shares of the total length of
 * all terms.
 */
import { degreesOf, type SegmentTerm, type SegmentTerms } from '../figures/directions';
import type { Plate, Trace, View } from '../figures/figure';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { ringPath, SIDE } from './crowd';
import { arrowTo, circle, line, svg, symbol, text, WIDTH } from './plate';
import { crosses, lettered, strokesOf, type Onto } from './ways';

export const HEIGHT = 300;

/** The row of the picture's middle. */
const MIDDLE = 62;

/** The first row of terms, the height of a row, where their arrows begin, and the length of all together. */
const [FIRST, ROW, ORIGIN, WHOLE] = [138, 28, 198, 132];

/** The share of a distance at which its name stands. */
const BEYOND = 0.7;

/** Where the angle of a side stands. */
const ANGLE = 82;

/** Shorter arrows have no head. */
const SHORT = 4;

/** A point nearer than this to the name of an upright side is in its way. */
const ASIDE = 26;

/** The length that stands for all terms in the picture, where their sum is drawn at the point. */
const AT_POINT = 84;

type Kind = 'printed' | 'turned';

export const toPlate: Onto = ([x, y]) => [x * SIDE, (y - 0.5) * SIDE + MIDDLE];

/** The place of the picture at a point of the plate; `undefined` among the terms. */
export function toPicture(x: number, y: number): Place | undefined {
  return y > FIRST - ROW ? undefined : [x / SIDE, (y - MIDDLE) / SIDE + 0.5];
}

export const sidesOf = (kind: Kind) => (view: View, { packing, title }: Plate): string => {
  const trace = view.traces[packing];
  if (!trace) return svg(HEIGHT, '', '');
  const terms = trace.directions.terms(view.at);
  const groups = groupsOf(terms.list);
  const said = [title?.[view.language] ?? '', ...groups.map((group) => `${nameOf(group)} ${number(lengthOf(sumOf(group, kind)), 3)}`)].join(', ');
  return svg(HEIGHT, said, `${kind === 'printed' ? arrowsIn(trace, terms, groups, view) : crossIn(trace, view)}${rowsOf(groups, kind)}${total(terms, kind)}`);
};

/** Segments in a line with their numbers. */
interface Straight {
  readonly first: number;
  readonly terms: readonly SegmentTerm[];
}

/** Two vectors have one direction if the sine of the angle between them is less than this. */
const ALIKE = 1e-3;

function groupsOf(list: readonly SegmentTerm[]): Straight[] {
  const groups: { first: number; terms: SegmentTerm[] }[] = [];
  for (const [k, term] of list.entries()) {
    const last = groups.at(-1);
    const before = last?.terms.at(-1);
    if (last && before && isStraight(before, term)) last.terms.push(term);
    else groups.push({ first: k, terms: [term] });
  }
  return groups;
}

function isStraight(a: SegmentTerm, b: SegmentTerm): boolean {
  const [[u, v], [p, q]] = [vectorOf(a), vectorOf(b)];
  return Math.abs(u * q - v * p) < ALIKE * Math.hypot(u, v) * Math.hypot(p, q) && u * p + v * q > 0;
}

const vectorOf = ({ from, to }: SegmentTerm): Place => [to[0] - from[0], to[1] - from[1]];
const lengthOf = ([x, y]: Place): number => Math.hypot(x, y);

function sumOf({ terms }: Straight, kind: Kind): Place {
  return terms.reduce<Place>(([x, y], term) => [x + term[kind][0], y + term[kind][1]], [0, 0]);
}

const numbersOf = ({ first, terms }: Straight): string => (terms.length > 1 ? `${first + 1}–${first + terms.length}` : String(first + 1));
const nameOf = (group: Straight): string => `s ${numbersOf(group)}`;

/** The outline as its arrows, the nearest place of each, and the sum at the point. */
function arrowsIn({ outline }: Trace, { list, printed }: SegmentTerms, groups: readonly Straight[], { at: looked }: View): string {
  const point = toPlate([looked[0] ?? 0, looked[1] ?? 0]);
  const ground = outline.map((ring) => `<path class="floor" d="${ringPath(ring)}"/>`).join('');
  const ends = list.map(({ from, to }) => nearest(toPlate(from), toPlate(to), point));
  const near = `<g data-symbol="distance">${ends.map((end) => line(point, end, 'reach')).join('')}</g>${distanceTo(point, ends)}`;
  const arrows = list.map(({ from, to }) => arrowTo(toPlate(from), minus(toPlate(to), toPlate(from)), 'side')).join('');
  return `<g transform="translate(0 ${MIDDLE - SIDE / 2})">${ground}</g>${near}${arrows}${groups.map((group) => named(group, point, printed)).join('')}${sumAt(point, printed)}`;
}

/** The name of the longest distance, which has the most room: on its side towards the middle, beyond the arrow of the sum. */
function distanceTo(point: Place, ends: readonly Place[]): string {
  const lengths = ends.map((end) => lengthOf(minus(end, point)));
  const longest = lengths.indexOf(Math.max(...lengths));
  const [x, y] = ends[longest] ?? point;
  const [dx, dy] = [BEYOND * (x - point[0]), BEYOND * (y - point[1])];
  const isUpright = Math.abs(dy) > Math.abs(dx);
  const [right, down] = isUpright ? [14, 2] : [0, point[1] < MIDDLE ? 15 : -9];
  return lettered(point[0] + dx + right, point[1] + dy + down, 'distance', 'd', String(longest + 1));
}

function sumAt([x, y]: Place, [u, v]: Place): string {
  const isSeen = Math.hypot(u, v) * AT_POINT > 1.5;
  return `${isSeen ? arrowTo([x, y], [u * AT_POINT, v * AT_POINT], 'total') : ''}${circle([x, y], 4, 'looked')}`;
}

const minus = ([x, y]: Place, [u, v]: Place): Place => [x - u, y - v];

/** The place of a segment that is nearest to a point. */
function nearest([ax, ay]: Place, [bx, by]: Place, [x, y]: Place): Place {
  const [dx, dy] = [bx - ax, by - ay];
  const share = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
  return [ax + share * dx, ay + share * dy];
}

/**
 * The name of a side beside its middle: above or below it, and inside of an upright one, which has no room outside. There it
 * makes room for the point and the arrow of the sum.
 */
function named(group: Straight, point: Place, [, down]: Place): string {
  const [first, last] = [group.terms[0], group.terms.at(-1)];
  if (!first || !last) return '';
  const [from, to] = [toPlate(first.from), toPlate(last.to)];
  const [dx, dy] = minus(to, from);
  const length = Math.hypot(dx, dy) || 1;
  const isUpright = Math.abs(dy) > Math.abs(dx);
  const [x, y] = [(from[0] + to[0]) / 2 - (18 * dy) / length, (from[1] + to[1]) / 2 - (14 * dx) / length];
  const isBelow = Math.abs(point[1] - y) > 12 ? point[1] < y : down < 0;
  const inside = Math.abs(point[0] - x) > ASIDE ? y - 8 : y + (isBelow ? 24 : -20);
  return lettered(x, isUpright ? inside : y + 4, 'segment', 's', numbersOf(group));
}

/** The cross of the direction at the point, and the crosses all over the outline. */
function crossIn({ outline, directions }: Trace, { at: looked }: View): string {
  const { place, along } = directions.at(looked);
  const [x, y] = toPlate(place);
  const ground = outline.map((ring) => `<path class="outline" d="${ringPath(ring)}"/>`).join('');
  const marked = strokesOf([x, y], along, 17);
  return `${crosses(directions.field, 6, toPlate)}<g transform="translate(0 ${MIDDLE - SIDE / 2})">${ground}</g><g class="carried present"><path class="back" d="${marked}"/><path class="arms" d="${marked}"/></g>`;
}

/** A row for each side: its terms head to tail, and their length; with four-fold angles also the side's angle. */
function rowsOf(groups: readonly Straight[], kind: Kind): string {
  return groups
    .map((group, row) => {
      const y = FIRST + row * ROW;
      const name = lettered(16, y + 4, 'segment', 's', numbersOf(group), 'side-name', 'start');
      const length = number(lengthOf(sumOf(group, kind)), 3);
      const [angle, shown] = kind === 'turned' ? [angleOf(group, y + 4), `<tspan data-symbol="weight">${length}</tspan>`] : ['', length];
      return `${name}${angle}${chained(group, kind, y)}${text(WIDTH - 14, y + 4, shown, 'number', 'end')}`;
    })
    .join('');
}

/** The angle of a side, from 0 to 360 degrees. */
function angleOf({ terms: [first] }: Straight, y: number): string {
  const degrees = first ? (Math.round(degreesOf(vectorOf(first))) + 360) % 360 : 0;
  return text(ANGLE, y, `${symbol('theta', 'θ')} = ${degrees}°`, 'number', 'start');
}

function chained(group: Straight, kind: Kind, y: number): string {
  const [, down] = sumOf(group, kind);
  let [x, here] = [ORIGIN, y - (down * WHOLE) / 2];
  const arrows = group.terms.map((term) => {
    const [dx, dy] = [term[kind][0] * WHOLE, term[kind][1] * WHOLE];
    const arrow = Math.hypot(dx, dy) < SHORT ? line([x, here], [x + dx, here + dy], 'bit') : arrowTo([x, here], [dx, dy], 'term');
    [x, here] = [x + dx, here + dy];
    return arrow;
  });
  return `${circle([ORIGIN, y - (down * WHOLE) / 2], 2, 'origin')}${arrows.join('')}`;
}

/** The sum of all rows. */
function total({ list, printed }: SegmentTerms, kind: Kind): string {
  const y = HEIGHT - 26;
  const [u, v] = kind === 'printed' ? printed : sumOf({ first: 0, terms: list }, 'turned');
  const length = Math.hypot(u, v);
  const name = kind === 'printed' ? symbol('v', 'v') : `${symbol('v4', 'v')}<tspan class="low" dy="3">4</tspan>`;
  const arrow = length * WHOLE < 1 ? '' : arrowTo([ORIGIN, y - (v * WHOLE) / 2], [u * WHOLE, v * WHOLE], 'total');
  return `${line([14, y - 22], [WIDTH - 14, y - 22], 'axis')}${text(16, y + 4, name, 'side-name sum-name', 'start')}${circle([ORIGIN, y - (v * WHOLE) / 2], 3.5, 'looked')}${arrow}${text(WIDTH - 14, y + 5, number(length, 3), 'key marked', 'end')}`;
}
