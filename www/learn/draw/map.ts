/** The landscape around a held square from above, with a second square and the way that it has slid. */
import { crowdAt, packedOf } from '../figures/crowds';
import type { Landscape, PackedCell, Plate, Trace, View } from '../figures/figure';
import { SIDE } from './crowd';
import { definitions, over, part, seenBands, UNIT } from './ground';
import { arrowTo, at, circle, path, svg } from './plate';
import { bubblesOf, square } from './squares';

const CENTRE = `translate(${SIDE / 2} ${SIDE / 2})`;

/** The length of an arrow for a force of 1, and the longest arrow. */
const FORCE = 260;
const LONGEST = 80;

/** Arrows that are shorter are not drawn. */
const LEAST = 4;

export function map(view: View, { packing, ground = '' }: Plate): string {
  const trace = view.traces[packing];
  const now = trace && crowdAt(trace, view.step);
  const [held, free] = now ? packedOf(now, trace.side) : [];
  if (!trace || !held || !free) return svg(SIDE, '', '');
  const said = view.language === 'ja' ? '留めた正方形のまわりの地形を上から見た図と、滑る正方形' : 'The landscape around a held square from above, and a square that slides';
  const land = trace.landscape ? `${definitions(trace.landscape, ground)}${bands(trace.landscape, ground)}${marks(trace.landscape)}` : '';
  const first = `${square(held, 'outlined held')}${bubblesOf(held, trace)}${nail(held)}`;
  return `${svg(SIDE, said, `${land}${first}`)}${over(`${wayOf(trace, view.step)}${square(free, 'outlined')}${bubblesOf(free, trace)}${forceOn(free)}`)}`;
}

function bands(landscape: Landscape, ground: string): string {
  const seen = seenBands(landscape);
  const all = seen.map(([band]) => part(ground, String(band), `tier${band}`, CENTRE));
  return `<rect class="tier${seen[0]?.[0] ?? 0}" width="${SIDE}" height="${SIDE}"/>${all.join('')}${part(ground, 'lines', 'level-line', CENTRE)}`;
}

/** The wells and the passes between them; a ring if all of them are equally deep. */
function marks({ well, pass }: Landscape): string {
  if (pass.energy - well.energy < LOW) return circle([SIDE / 2, SIDE / 2], well.w * UNIT, 'ring');
  const [far, near] = [well.w * UNIT, pass.w * UNIT * Math.SQRT1_2];
  const wells = [[far, 0], [-far, 0], [0, far], [0, -far]] as const;
  const passes = [[near, near], [-near, near], [near, -near], [-near, -near]] as const;
  const at2 = ([x, y]: readonly [number, number], d: string, kind: string): string => `<path class="${kind}" d="M${at(SIDE / 2 + x)} ${at(SIDE / 2 + y)}${d}"/>`;
  return `${wells.map((place) => at2(place, 'm-5 0h10m-5 -5v10', 'well')).join('')}${passes.map((place) => at2(place, 'm-4 -4l8 8m0 -8l-8 8', 'pass')).join('')}`;
}

/** If the pass is lower than this above the well, all wells and passes form one ring. */
const LOW = 1e-6;

const nail = ({ x, y }: PackedCell): string => `<path class="nail" d="M${at(x * SIDE - 5)} ${at(y * SIDE - 5)}l10 10m0 -10l-10 10"/>`;

/** The centres of the second square up to a step. */
function wayOf(trace: Trace, step: number): string {
  const points = trace.steps.slice(0, step + 1).flatMap((crowd) => packedOf(crowd, trace.side).slice(1, 2).map(({ x, y }) => [x * SIDE, y * SIDE] as const));
  const [first] = points;
  return `${path(points, 'way-back')}${path(points, 'way')}${first ? circle(first, 4, 'start') : ''}`;
}

function forceOn({ x, y, force }: PackedCell): string {
  const length = Math.hypot(...force);
  const drawn = Math.min(LONGEST, length * FORCE);
  const [fx, fy] = force;
  const arrow = drawn < LEAST ? '' : arrowTo([x * SIDE, y * SIDE], [(fx / length) * drawn, (fy / length) * drawn], 'sum');
  return `${arrow}${circle([x * SIDE, y * SIDE], 6, 'here')}`;
}
