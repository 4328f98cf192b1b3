/**
 * The triangle with the smallest angle, scaled so that its circle always has the same size: its shortest side, its
 * radius, its angle.
 */
import type { Plate, View } from '../figures/figure';
import { LARGEST, placeOf, smallestOf, worstOf, type JoinedCells, type Triangle } from '../figures/joined';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { middleOf, sectorPath } from './delaunay';
import { hatched } from './hatching';
import { isThin, tintOf } from './mesh';
import { at, circle, line, svg, symbol, text, unit, WIDTH } from './plate';

const MIDDLE: Place = [WIDTH / 2, 156];
const RADIUS = 128;

/** The lowest line of a letter. */
const LOWEST = 292;

/** The bar: its ends and its top. */
const [LEFT, RIGHT, TOP, TALL] = [40, WIDTH - 40, 336, 16];

/** An angle below this, in degrees, is bad. */
const BAD = 30;

export function inscribed(view: View, { packing, title }: Plate): string {
  const joined = view.traces[packing]?.joined(0);
  const worst = joined && worstOf(joined);
  if (!joined || !worst) return svg(SIDE, '', '');
  const [angle, s, radius] = [number(smallestOf(worst), 1), number(worst.shortest, 3), number(worst.radius, 3)];
  const said = view.language === 'ja' ? `最小角${angle}°の三角形。最も短い辺${s}、外接円の半径${radius}` : `The triangle with the smallest angle, ${angle}°. Shortest side ${s}, radius ${radius}`;
  const names = `${text(WIDTH / 2 - 12, 312, `${symbol('shortest', 's')} = ${s}`, 'key', 'end')}${text(WIDTH / 2 + 12, 312, `${symbol('R', 'R')} = ${radius}`, 'key', 'start')}`;
  return svg(SIDE, `${title ? `${title[view.language]}. ` : ''}${said}`, `${inCircle(joined, worst)}${names}${bar(smallestOf(worst))}`);
}

/** The corners as seen from the circle's centre. */
function cornersOf({ points }: JoinedCells, { ids, centre, radius }: Triangle): Place[] {
  return ids.map((id) => {
    const [x, y] = placeOf(points, id);
    return [MIDDLE[0] + ((x - centre[0]) / radius) * RADIUS, MIDDLE[1] + ((y - centre[1]) / radius) * RADIUS];
  });
}

function inCircle(joined: JoinedCells, worst: Triangle): string {
  const corners = cornersOf(joined, worst);
  const least = worst.angles.indexOf(smallestOf(worst));
  const [at0, one, other] = [0, 1, 2].map((k) => corners[(least + k) % 3] ?? MIDDLE) as [Place, Place, Place];
  const shape = `M${[at0, one, other].map(([x, y]) => `${at(x)} ${at(y)}`).join('L')}z`;
  const round = circle(MIDDLE, RADIUS, 'empty-circle');
  const side = `${line(one, other, 'shortest-side')}${beside([(one[0] + other[0]) / 2, (one[1] + other[1]) / 2], MIDDLE, symbol('shortest', 's'))}`;
  return `${round}<path class="triangle tint-${tintOf(smallestOf(worst))}" d="${shape}"/>${isThin(smallestOf(worst)) ? hatched([[at0, one, other]]) : ''}<path class="looked-at" d="${shape}"/>${radiusTo(smallestOf(worst) < BAD ? clearOf(at0, one, other) : one)}${side}${angleAt(at0, one, other, smallestOf(worst))}`;
}

/** A place on the circle that is away from a thin triangle: at a right angle to its long axis. */
function clearOf(corner: Place, one: Place, other: Place): Place {
  const far: Place = [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2];
  const [x, y] = unit(corner, far);
  const side = x * (MIDDLE[1] - corner[1]) - y * (MIDDLE[0] - corner[0]) < 0 ? -1 : 1;
  return [MIDDLE[0] - side * y * RADIUS, MIDDLE[1] + side * x * RADIUS];
}

/** The radius to a place on the circle, with its letter halfway. */
function radiusTo(end: Place): string {
  const [x, y] = unit(MIDDLE, end);
  const half: Place = [MIDDLE[0] + (x * RADIUS) / 2 - y * 13, MIDDLE[1] + (y * RADIUS) / 2 + x * 13 + 5];
  return `${line(MIDDLE, end, 'radius')}${circle(MIDDLE, 3.5, 'centre')}${text(half[0], half[1], symbol('R', 'R'), 'letter-of')}`;
}

/** A letter beside a place, on the side away from another. */
function beside(place: Place, from: Place, letter: string): string {
  const [x, y] = unit(from, place);
  return text(place[0] + 18 * x, place[1] + 18 * y + 5, letter, 'letter-of');
}

/** The smallest angle at its corner. */
function angleAt(corner: Place, one: Place, other: Place, angle: number): string {
  const [from, to] = [unit(corner, one), unit(corner, other)];
  const [x, y] = middleOf(from, to);
  const [left, down] = [corner[0] - 22 * x, Math.max(20, corner[1] - 22 * y + 5)];
  // The lowest corners have the numbers below them, so the letter stands beside these.
  const place = down < LOWEST ? [left, down] as const : [corner[0] + (x > 0 ? -18 : 18), LOWEST] as const;
  const name = text(...place, symbol('gamma', 'γ'), 'letter-of');
  return `<path class="sector gamma" d="${sectorPath(corner, from, to, angle < BAD ? 84 : 44)}"/>${name}`;
}

/** The smallest angle from 0 to its largest value, with a mark at 30 degrees. */
function bar(angle: number): string {
  const x = (value: number): number => LEFT + (value / LARGEST) * (RIGHT - LEFT);
  const marks = [0, BAD, LARGEST].map((value) => `${line([x(value), TOP - 4], [x(value), TOP + TALL + 5], value === BAD ? 'median' : 'tick')}${text(x(value), TOP + TALL + 19, `${value}°`, 'number')}`);
  const isLong = angle > 48;
  const value = text(x(angle) + (isLong ? -8 : 8), TOP + 13, `${symbol('gamma', 'γ')} = ${number(angle, 1)}°`, 'angle-value', isLong ? 'end' : 'start');
  const lines = isThin(angle) ? hatched([[[LEFT, TOP], [x(angle), TOP], [x(angle), TOP + TALL], [LEFT, TOP + TALL]]]) : '';
  return `<rect class="angle-rail" x="${LEFT}" y="${TOP}" width="${RIGHT - LEFT}" height="${TALL}"/><rect class="angle-bar tint-${tintOf(angle)}" x="${LEFT}" y="${TOP}" width="${at(x(angle) - LEFT)}" height="${TALL}"/>${lines}${marks.join('')}${value}`;
}
