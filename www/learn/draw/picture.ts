/** The plates of a figure at a step. The build makes the still picture with it, and the page every later one. */
import type { Figure, Plate, Trace, View } from '../figures/figure';
import { MIDDLE } from './bubbles';
import { crowd, SIDE } from './crowd';
import { force, HEIGHT } from './force';
import { held, HEIGHT as HELD } from './held';
import { lens } from './lens';
import { levels } from './levels';
import { map } from './map';
import { pavement } from './pavement';
import { toW, WIDEST, WIDTH, X, type CurvePoint, type Drawn } from './plate';
import { plot } from './plot';
import { population, HEIGHT as POPULATION } from './population';
import { relief, HEIGHT as RELIEF } from './relief';
import { section } from './section';
import { squares } from './squares';
import type { Bubbles } from './studio';
import { gripOf, numbersOf, thresholds } from './thresholds';
import { track } from './track';
import { BOTTOM, POLE, valley, Y } from './valley';

/** The steps between two points of a curve. */
const FINE = 0.02;

/** The curves of the force and of the potential, by the module. */
export function curveOf(module: Bubbles): CurvePoint[] {
  return Array.from({ length: Math.floor(WIDEST / FINE) + 1 }, (_, k) => {
    const [force = 0, potential = 0] = module.bubbleCurve(k * FINE);
    return [k * FINE, force, potential];
  });
}

/** Plates whose horizontal axis is the distance of a pair. */
const ofPair = (draw: (view: View, packing: number, title: string) => string, y: (view: View, plate: Plate, key: string) => number): Drawn => ({
  height: HEIGHT,
  draw: (view, { packing, title }) => draw(view, packing, title?.[view.language] ?? ''),
  grip: (view, plate, key, [w = 0]) => {
    const left = draw === valley || key === 'mark' ? 0 : (view.traces[plate.packing]?.moments[view.step]?.left ?? 0);
    return [Math.min(X(left + w), WIDTH - 8), y(view, plate, key)];
  },
  numbers: (x) => [toW(x)],
});

const ballAt = (view: View, { packing }: Plate, key: string): number => (key === 'mark' ? BOTTOM - POLE + 7 : Y(view.traces[packing]?.moments[view.step]?.energy ?? 0));

/** Plates that show the picture as a whole. */
const ofPlaces = (draw: Drawn['draw']): Drawn => ({ height: SIDE, draw, grip: (_view, _plate, _key, [x = 0, y = 0]) => [x * SIDE, y * SIDE], numbers: (x, y) => [x / SIDE, y / SIDE] });

/** The ways to draw a plate, by their words in the data of figures. */
const DRAWN: Readonly<Record<Plate['draw'], Drawn>> = {
  force: ofPair(force, () => MIDDLE),
  track: ofPair(track, () => MIDDLE),
  valley: ofPair(valley, ballAt),
  pavement: { height: WIDTH, draw: (view, { packing }) => pavement(view, packing) },
  crowd: ofPlaces(crowd),
  plot: { height: SIDE, draw: plot },
  lens: { height: WIDTH, draw: lens },
  levels: { height: SIDE, draw: levels },
  population: { height: POPULATION, draw: population },
  thresholds: { height: POPULATION, draw: thresholds, grip: (_view, _plate, key, [value = 0]) => gripOf(key, value), numbers: numbersOf },
  held: { height: HELD, draw: held },
  squares: ofPlaces(squares),
  landscape: ofPlaces(map),
  relief: { height: RELIEF, draw: relief },
  section: { height: HEIGHT, draw: section },
};

export function platesOf(figure: Figure, view: View): string[] {
  return figure.plates.map((plate) => DRAWN[plate.draw].draw(view, plate));
}

/** The notes beside the plates' titles; `undefined` where there is none. */
export function notesOf(figure: Figure, view: View): (string | undefined)[] {
  return figure.plates.map(({ note }) => note?.(view, view.language));
}

/** The stops that these packings have, in the order of their steps; of two at one step, the first. */
export function stopsOf(figure: Figure, traces: readonly Trace[]): { key: string; name: Figure['stops'][number]['name']; step: number }[] {
  const found = figure.stops.flatMap(({ key, name, find }) => {
    const step = find(traces);
    return step === undefined ? [] : [{ key, name, step }];
  });
  return found.filter(({ step }, k) => found.findIndex((other) => other.step === step) === k).sort((a, b) => a.step - b.step);
}

/** The last step of the longest run. */
export function lastStepOf(figure: Figure, traces: readonly Trace[]): number {
  return figure.steps === 'layer' ? figure.last : Math.max(0, ...traces.map(({ steps }) => steps.length - 1));
}

/** The place of a handle's grip on a plate, in shares of the plate's width and height. */
export function gripAt(figure: Figure, plate: number, key: string, numbers: readonly number[], view: View): readonly [number, number] {
  const own = figure.plates[plate];
  const drawn = own && DRAWN[own.draw];
  const [x, y] = (own && drawn?.grip?.(view, own, key, numbers)) ?? [0, 0];
  return [x / WIDTH, y / (drawn?.height ?? 1)];
}

/** The numbers of a handle at a place of a plate, in shares of its width and height. */
export function numbersAt(figure: Figure, plate: number, [x, y]: readonly [number, number]): readonly number[] {
  const drawn = DRAWN[figure.plates[plate]?.draw ?? 'crowd'];
  return drawn.numbers?.(x * WIDTH, y * drawn.height) ?? [];
}
