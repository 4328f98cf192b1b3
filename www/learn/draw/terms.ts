/** The small pictures of the glossary: pairs, curves and tracks by the same numbers as the figures. */
import { way } from '../figures/words';
import type { Moment } from '../figures/figure';
import { arrow, circle, line, path } from './plate';
import { shownOf } from './chapters';
import { curveOf } from './picture';
import { Reading } from './reading';
import type { Draw } from './small';
import type { Bubbles } from './studio';
import { CROWD_TERMS } from './term-crowds';
import { MESH_TERMS } from './term-mesh';
import { WAY_TERMS } from './term-ways';

const [WIDTH, HEIGHT, MIDDLE] = [120, 80, 40];

/** The length of a stable distance beside bubbles, and along a curve. */
const [UNIT, ALONG] = [36, 48];

/** The force and the potential as curves: their column, the height of 1, and that of the axis. */
const CURVES = { force: [1, 40, 52], potential: [2, 90, 58] } as const;

const bubble = (x: number, radius = UNIT / 2): string => circle([x, MIDDLE], radius, 'bubble');
const centre = (x: number, radius = 3): string => circle([x, MIDDLE], radius, 'centre');

/** Two bubbles at a distance, with what is drawn over them. */
const pair = (w: number, over: (left: number, right: number, module: Bubbles) => string): Draw => (module) => {
  const [left, right] = [-1, 1].map((side) => WIDTH / 2 + (side * w * UNIT) / 2) as [number, number];
  return `${bubble(left)}${bubble(right)}${centre(left)}${centre(right)}${over(left, right, module)}`;
};

function measure(left: number, right: number): string {
  const y = MIDDLE + UNIT / 2 + 10;
  return `${line([left, y], [right, y], 'measure')}${[left, right].map((x) => line([x, y - 4], [x, y + 4], 'measure')).join('')}`;
}

/** The forces at this distance; the pull is drawn longer than to scale, as it is an eighth of the push. */
const forces = (w: number, scale: number) => (left: number, right: number, module: Bubbles): string => {
  const force = module.bubbleCurve(w)[0] ?? 0;
  const kind = way({ step: 0, left: 0, w, speed: 0, force, energy: 0, motion: 0 });
  return `${arrow(left, MIDDLE, -force * scale, kind)}${arrow(right, MIDDLE, force * scale, kind)}`;
};

const curve = (which: keyof typeof CURVES, over: (x: (w: number) => number, y: (value: number) => number) => string = () => ''): Draw => (module) => {
  const [column, high, axis] = CURVES[which];
  const [x, y] = [(w: number): number => 12 + ALONG * w, (value: number): number => axis - high * value];
  const points = curveOf(module).map((point) => [x(point[0]), y(point[column])] as const);
  return `${line([x(0), axis], [WIDTH - 6, axis], 'axis')}${path(points.filter(([place]) => place < WIDTH - 6), 'curve')}${over(x, y)}`;
};

/** The distance of a pair over time, with a dot for each step if there are few. */
const track = (figure: string, values: Readonly<Record<string, string>>, steps: number): Draw => (module) => {
  const { figure: own } = shownOf(figure);
  const reading = new Reading(module, { ...own, last: steps }, own.recipe, values);
  while (!reading.advance(1000));
  const points = reading.moments.map(placed(steps));
  reading.free();
  const dots = steps > 20 ? '' : points.map((point) => circle(point, 2, 'centre')).join('');
  return `${line([8, MIDDLE], [WIDTH - 6, MIDDLE], 'axis')}${path(points, 'curve')}${dots}`;
};

const placed = (steps: number) => ({ step, w }: Moment): readonly [number, number] => [8 + (step * (WIDTH - 14)) / steps, Math.max(4, Math.min(HEIGHT - 4, MIDDLE - (w - 1) * 110))];

const moved: Draw = () => `${bubble(44)}${centre(44)}${arrow(44, MIDDLE, 56, 'push')}`;
const heavy: Draw = () => `${bubble(WIDTH / 2, 28)}${centre(WIDTH / 2, 11)}`;
const alone: Draw = () => `${bubble(WIDTH / 2, 28)}${centre(WIDTH / 2)}`;

const DRAWN: Readonly<Record<string, Draw>> = {
  bubble: alone,
  force: curve('force'),
  potential: curve('potential'),
  damping: track('let-go', { damp: '0.3', given: '0.25,0.5,1;0.45,0.5,0' }, 200),
  'stable-distance': pair(1, measure),
  ratio: pair(1.6, measure),
  repulsion: pair(0.7, forces(0.7, 60)),
  attraction: pair(19 / 15, forces(19 / 15, 110)),
  stiffness: curve('force', (x, y) => line([x(0.5), y(0.5)], [x(1.5), y(-0.5)], 'guide')),
  'equation-of-motion': moved,
  mass: heavy,
  rest: track('let-go', { damp: '1.5', given: '0.25,0.5,1;0.45,0.5,0' }, 120),
  'time-step': track('let-go', { damp: '1', dt: '0.5', given: '0.25,0.5,1;0.45,0.5,0' }, 12),
  euler: track('not-so', { dt: '1', move: 'euler' }, 18),
  'runge-kutta': track('not-so', { dt: '1', move: 'rk4' }, 18),
};

/** The picture of a term. The module must be initialised. */
export function termOf(module: Bubbles, term: string): string {
  const draw = DRAWN[term] ?? CROWD_TERMS[term] ?? MESH_TERMS[term] ?? WAY_TERMS[term];
  if (!draw) throw new Error(`The term ${term} has no picture.`);
  return `<svg class="plate small" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" aria-hidden="true">${draw(module)}</svg>`;
}
