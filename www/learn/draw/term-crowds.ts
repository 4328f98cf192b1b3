/** The small pictures of the terms of crowds, squares and populations, by the module's numbers. Places are units of 120 x 80. */
import type { Landscape } from '../figures/figure';
import type { Place } from '../figures/place';
import { inside, regions, simplified } from './contours';
import { FINE, HALF } from './ground';
import { Survey } from './landscape';
import { arrowTo, at, circle, line, path } from './plate';
import { cross, plus } from './population';
import { asked, bubble, dot, HEIGHT, MIDDLE, square, WIDTH, type Draw } from './small';
import type { Bubbles, Studio } from './studio';

/** The numbers of a cell in `packedCells`. */
const ROW = 11;

/** The papers' weight and radius of the corner bubbles. */
const PAPERS = String(Math.SQRT2 - 1);

/** Six places around the middle, at a distance. */
const around = (far: number): Place[] => Array.from({ length: 6 }, (_, k) => [MIDDLE[0] + far * Math.cos((k * Math.PI) / 3), MIDDLE[1] + far * Math.sin((k * Math.PI) / 3)]);

const CROWD = 'outline=square&size=256&kind=circle&cs=40&seed=3&damp=1';

/** Cells of a start at random, drawn small. */
const start: Draw = (module) =>
  asked(module, `${CROWD}&start=random&count=12&pop=off`, 1, (studio) => {
    const [cells, scale] = [studio.packedCells(), HEIGHT / studio.side()];
    const places = Array.from({ length: cells.length / ROW }, (_, k): Place => [20 + (cells[k * ROW + 1] ?? 0) * scale, (cells[k * ROW + 2] ?? 0) * scale]);
    return places.map((place) => `${bubble(place, 20 * scale)}${dot(place, 'centre', 1.5)}`).join('');
  }).join('');

/** The curve of a number over the steps; its height goes from `low` to `high`. */
const overSteps = (recipe: string, steps: number, [low, high]: Place, of: (studio: Studio) => number): Draw => (module) => {
  const points = asked(module, recipe, steps, of).map((value, step): Place => [8 + (step * (WIDTH - 16)) / (steps - 1), HEIGHT - 12 - ((HEIGHT - 22) * (value - low)) / (high - low)]);
  return `${line([8, HEIGHT - 10], [WIDTH - 6, HEIGHT - 10], 'axis')}${path(points, 'curve')}`;
};

const sum = (studio: Studio): number => studio.energyParts().reduce((whole, part) => whole + part, 0);
const count = (studio: Studio): number => studio.packedCells().length / ROW;
const RUN = `${CROWD}&start=random&count=12`;

/** The forces of two neighbours on a bubble, and their sum. */
const netForce: Draw = (module) => {
  const recipe = 'outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&given=0.5,0.5,0;0.66,0.45,1;0.42,0.31,1';
  return asked(module, recipe, 1, (studio) => {
    const [cells, scale, longest] = [studio.packedCells(), 0.5, 90];
    const places = [0, 1, 2].map((k): Place => [MIDDLE[0] + ((cells[k * ROW + 1] ?? 0) - 128) * scale, MIDDLE[1] + 4 + ((cells[k * ROW + 2] ?? 0) - 128) * scale]);
    const [own = MIDDLE] = places;
    const near = studio.neighbours(cells[0] ?? 0);
    const arrows = [2, 6].map((k) => arrowTo(own, [(near[k] ?? 0) * longest, (near[k + 1] ?? 0) * longest], (near[k - 1] ?? 0) < 1 ? 'push' : 'pull'));
    const whole = arrowTo(own, [(cells[7] ?? 0) * longest, (cells[8] ?? 0) * longest], 'sum');
    return `${places.map((place) => bubble(place, 32 * scale)).join('')}${arrows.join('')}${whole}`;
  }).join('');
};

/** Two valleys along a line: the potential of a bubble between held ones, of which two stand at its right. */
const valleys: Draw = ({ bubbleCurve }) => {
  const psi = (w: number): number => bubbleCurve(w)[1] ?? 0;
  const energy = (x: number): number => psi(x) + psi(2.75 - x) + psi(Math.hypot(x - 1.75, 1));
  const place = (x: number): Place => [8 + (x - 0.7) * 80, 22 - energy(x) * 480];
  const points = Array.from({ length: 68 }, (_, k) => place(0.73 + k * 0.02)).filter(([, y]) => y > 4);
  const [x, y] = place(1.05);
  return `${path(points, 'curve')}${dot([x, y - 4], 'here', 4)}`;
};

const neighbours: Draw = () => `${around(24).map((place) => bubble(place, 12)).join('')}${circle(MIDDLE, 12, 'bubble own')}${dot(MIDDLE)}`;
const wall: Draw = () => `${line([34, 4], [34, HEIGHT - 4], 'outline')}${bubble([48, 40], 20)}${dot([48, 40])}${arrowTo([48, 40], [44, 0], 'wall')}`;
const round: Draw = () => `${bubble([30, 40], 16)}${bubble([90, 40], 16)}<path class="curve" d="M34 18Q60 0 84 18M86 62Q60 80 36 62"/>${arrowTo([78, 13], [8, 6], 'sum')}${arrowTo([42, 67], [-8, -6], 'sum')}`;

/** Half a side of the square in pictures of corner bubbles. */
const HALF_SIDE = 20;
const corners = (radius: number): string => [-1, 1].flatMap((x) => [-1, 1].map((y) => circle([MIDDLE[0] + x * HALF_SIDE, MIDDLE[1] + y * HALF_SIDE], radius, 'bubble own'))).join('');
const cornered: Draw = () => `${square(MIDDLE, HALF_SIDE)}${corners((Math.SQRT2 - 1) * HALF_SIDE)}${dot(MIDDLE)}`;
const cornerRadius: Draw = () => {
  const [half, x, y] = [26, 72, 24];
  const radius = (Math.SQRT2 - 1) * half;
  return `${square([x - half, y + half], half)}${circle([x, y], radius, 'bubble own')}${line([x, y], [x + radius, y], 'now')}${dot([x, y])}${dot([x - half, y + half])}`;
};
const rows: Draw = () => [-1, 0, 1].flatMap((x) => [-1, 0, 1].map((y) => square([MIDDLE[0] + x * 24, MIDDLE[1] + y * 24], 12))).join('');

function landscapeOf(module: Bubbles, weight = PAPERS): Landscape | undefined {
  const survey = new Survey(module);
  while (!survey.advance(weight, PAPERS, 1000));
  const found = survey.of(weight, PAPERS);
  survey.free();
  return found;
}

/** Lines of equal potential around a square. */
const contours: Draw = (module) => {
  const landscape = landscapeOf(module);
  if (!landscape) return '';
  const scale = 22 / FINE;
  const lines = regions((column, row) => landscape.at(column, row), [-HALF, HALF], [-0.07, -0.06, -0.045, -0.03, -0.015]).flat();
  const drawn = lines.flatMap((border) => inside(border, [-HALF, HALF])).map((border) => path(simplified(border, 0.2).map(([x, y]): Place => [MIDDLE[0] + x * scale, MIDDLE[1] + y * scale]), 'level-line'));
  return `${square(MIDDLE, 11)}${drawn.join('')}`;
};

/** The height at a place in stable distances, between the points of the grid. */
function heightAt(landscape: Landscape, [x, y]: Place): number {
  const [column, row] = [Math.floor(x * FINE), Math.floor(y * FINE)];
  const [right, down] = [x * FINE - column, y * FINE - row];
  const along = (at: number): number => landscape.at(column, at) * (1 - right) + landscape.at(column + 1, at) * right;
  return along(row) * (1 - down) + along(row + 1) * down;
}

/** The heights on a walk, drawn from the left to the right. */
const section = (landscape: Landscape, walk: readonly Place[]): Place[] =>
  walk.map((place, k): Place => [8 + (k * (WIDTH - 16)) / (walk.length - 1), 14 - heightAt(landscape, place) * 720]).filter(([, y]) => y > 3);

/** Walks: outwards through the middle of an edge; and from the well there over the pass to the next well, and on. */
const OUT = Array.from({ length: 80 }, (_, k): Place => [0.8 + k * 0.014, 0]);
const ROUND = Array.from({ length: 121 }, (_, k): Place => {
  const turn = (k - 10) / 100 * (Math.PI / 2);
  const far = 1 + 0.226 * Math.sin(2 * turn) ** 2;
  return [Math.abs(far * Math.cos(turn)), Math.abs(far * Math.sin(turn))];
});

const SEA = line([8, 14], [WIDTH - 6, 14], 'axis');

/** The heights on a walk with each of these weights; the last one is drawn strongest. */
const heights = (walk: readonly Place[], weights: readonly string[], over = ''): Draw => (module) => {
  const all = weights.map((weight) => landscapeOf(module, weight));
  return `${SEA}${all.map((one, k) => (one ? path(section(one, walk), k === all.length - 1 ? 'curve' : 'guide') : '')).join('')}${over}`;
};

const crowded: Draw = () => `${circle([48, 40], 22, 'bubble crowded')}${bubble([72, 40], 22)}${dot([48, 40])}${dot([72, 40])}${cross(48, 40, 6)}`;
const empty: Draw = () => `${around(24).map((place) => bubble(place, 12)).join('')}${circle(MIDDLE, 12, 'empty')}${plus(...MIDDLE, 5)}`;
const nearest: Draw = () => {
  const others: Place[] = [[30, 22], [88, 24], [82, 66]];
  return `${others.map((place) => bubble(place, 13)).join('')}${circle(MIDDLE, 13, 'bubble own')}${others.map((place) => line(MIDDLE, place, 'link')).join('')}${line(MIDDLE, others[0] ?? MIDDLE, 'measure')}${dot(MIDDLE)}`;
};
const threshold: Draw = () => `${line([8, 52], [112, 52], 'axis')}${line([50, 20], [50, 62], 'measure')}${[20, 36, 64, 76, 84, 96].map((x) => dot([x, 52], x < 50 ? 'bubble crowded' : 'bubble', 5)).join('')}`;

/** A square cut into four, and so on where an arc crosses it. */
function quarters([x, y]: Place, side: number, depth: number): string {
  const far = [0, side].flatMap((i) => [0, side].map((j) => Math.hypot(x + i - 22, y + j - 78)));
  if (depth === 0 || Math.min(...far) > 50 || Math.max(...far) < 50) return square([x + side / 2, y + side / 2], side / 2, 'cell');
  const half = side / 2;
  return [0, half].flatMap((i) => [0, half].map((j) => quarters([x + i, y + j], half, depth - 1))).join('');
}
const honeycomb: Draw = () => `${around(24).map((place) => bubble(place, 12)).join('')}${bubble(MIDDLE, 12)}<path class="curve" d="M${around(13.9).map(([x, y]) => `${at(MIDDLE[0] + (y - MIDDLE[1]))} ${at(MIDDLE[1] + (x - MIDDLE[0]))}`).join('L')}z"/>`;

export const CROWD_TERMS: Readonly<Record<string, Draw>> = {
  neighbour: neighbours,
  'net-force': netForce,
  wall,
  'first-places': start,
  energy: overSteps(RUN, 40, [-4, 1], sum),
  'local-minimum': valleys,
  iteration: round,
  'square-cell': () => `${square(MIDDLE, 26)}${dot(MIDDLE)}${line([60, 40], [86, 40], 'guide')}`,
  alignment: rows,
  contour: contours,
  well: heights(OUT, [PAPERS]),
  superposition: heights(OUT, ['0', PAPERS]),
  'corner-bubble': cornered,
  'corner-weight': heights(ROUND, ['0', '0.1', PAPERS]),
  'corner-radius': cornerRadius,
  barrier: heights(ROUND, [PAPERS], line([60, 37], [60, 68], 'measure')),
  crowded,
  'empty-place': empty,
  'smallest-w': nearest,
  threshold,
  population: overSteps(RUN, 60, [0, 40], count),
  quadtree: () => quarters([22, 2], 76, 3),
  honeycomb,
};
