/** A walk in an outline: the field as crosses, and the cross that was carried along the way, with one of its arms marked. */
import { degreesOf, STEPS, type Turned } from '../figures/directions';
import type { Plate, Trace, View } from '../figures/figure';
import { number } from '../figures/words';
import { outlineOf, SIDE } from './crowd';
import { over } from './ground';
import { arrowTo, at, circle, path, svg, text } from './plate';
import { cornersOf, crosses, inOutline, onto, strokesOf } from './ways';

/** Half the size of a cross in the field, of a past one on the walk, and of the present one. */
const [SMALL, PAST, LARGE] = [7, 9, 18];

/** The least distance of crosses on the way, and the numbers of steps between two of them. */
const APART = 34;
const EVERY = [3, 6, 9, 12, 18];

export function walk(view: View, { packing, ground: name = '', after }: Plate): string {
  const trace = view.traces[packing];
  if (!trace) return svg(SIDE, '', '');
  const said = view.language === 'ja' ? '輪郭の中の向きの場と、一周する道筋' : 'The directions in an outline, and a walk';
  const ground = `${inOutline(trace, name, crosses(trace.directions.field, SMALL))}${outlineOf(trace)}${cornersOf(trace)}`;
  const points = after === undefined || view.answered.has(after) ? singular(trace, view) : '';
  return `${svg(SIDE, said, ground)}${over(`${points}${walked(view, trace)}`)}`;
}

/** The circle of the walk, and the part that has been walked, with its crosses. */
function walked(view: View, trace: Trace): string {
  const [x = 0, y = 0, radius = 0] = view.at;
  const way = trace.directions.walk(view.at);
  const now = way[view.step];
  const ring = circle([x * SIDE, y * SIDE], radius * SIDE, `round${now ? '' : ' broken'}`);
  if (!now) return ring;
  const gone = way.slice(0, view.step + 1);
  const stride = (2 * Math.PI * radius * SIDE) / STEPS;
  const every = EVERY.find((steps) => steps * stride >= APART) ?? STEPS;
  const marks = gone.filter((_, k) => k % every === 0 && k < view.step).map((one) => carried(one, way, PAST, 'past'));
  return `${ring}${path(gone.map(({ place }) => onto(place)), 'gone')}${marks.join('')}${onward(now, [x, y])}${carried(now, way, LARGE, 'present')}`;
}

/** An arrow in the direction of the walk, at its present place. */
function onward({ place }: Turned, [x, y]: readonly [number, number]): string {
  const [dx, dy] = [place[0] - x, place[1] - y];
  const length = Math.hypot(dx, dy) || 1;
  return arrowTo(onto(place), [(-dy / length) * 34, (dx / length) * 34], 'onward');
}

/** A cross with the arm that began along the first direction. */
function carried({ place, along, quarters }: Turned, [first]: readonly Turned[], half: number, kind: string): string {
  const [x, y] = onto(place);
  const angle = ((degreesOf(first?.along ?? along) + 90 * quarters) * Math.PI) / 180;
  const [u, v] = [half * Math.cos(angle), half * Math.sin(angle)];
  return `<g class="carried ${kind}">${kind === 'present' ? `<path class="back" d="${strokesOf([x, y], along, half)}"/>` : ''}<path class="arms" d="${strokesOf([x, y], along, half)}"/><path class="arm" d="M${at(x)} ${at(y)}l${at(u)} ${at(v)}"/>${circle([x + u, y + v], kind === 'present' ? 4.5 : 2.5, 'tip')}</g>`;
}

/**
 * The singular points. After a whole walk those inside show their quarter turns, if the sum of these is the walk's
 * count.
 */
function singular({ directions }: Trace, { at: [x = 0, y = 0, radius = 0], step, last }: View): string {
  const all = directions.singular();
  const inside = all.filter(({ place }) => Math.hypot(place[0] - x, place[1] - y) < radius);
  const count = directions.walk([x, y, radius]).at(-1)?.quarters;
  const isTold = step === last && count === inside.reduce((sum, { quarters }) => sum + quarters, 0);
  return all
    .map((one) => {
      const [px, py] = onto(one.place);
      const name = isTold && inside.includes(one) ? text(...beside([px, py], inside.map(({ place }) => onto(place)), x * SIDE), number(one.quarters, 0), 'quarters halo') : '';
      return `<path class="singular" d="M${at(px)} ${at(py - 6)}l6 6l-6 6l-6 -6z"/>${name}`;
    })
    .join('');
}

/**
 * The place of a point's name: on the side away from the mean of all points, or beside a single one, away from the grip of the
 * walk's centre. Above a centre it stands on the left, as the radius has its grip on the right.
 */
function beside([x, y]: readonly [number, number], all: readonly (readonly [number, number])[], centre: number): [number, number] {
  const middle = (axis: 0 | 1): number => all.reduce((sum, place) => sum + place[axis], 0) / all.length;
  const [dx, dy] = [x - middle(0), y - middle(1)];
  const length = Math.hypot(dx, dy);
  const [u, v] = length < 1 ? [x > centre + 4 ? 1 : -1, 0] : [dx / length, dy / length];
  return [x + 17 * u, y + 17 * v + 5];
}
