/** The plates of a figure at a step. The build makes the still picture with it, and the page every later one. */
import type { Figure, Trace } from '../figures/figure';
import { MIDDLE } from './bubbles';
import { force, HEIGHT } from './force';
import { pavement } from './pavement';
import { WIDEST, WIDTH, X, type CurvePoint, type View } from './plate';
import type { Bubbles } from './studio';
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

export function platesOf(figure: Figure, view: View): string[] {
  const drawn = { force, valley, pavement, track };
  return figure.plates.map(({ draw, packing, title }) => drawn[draw](view, packing, title?.[view.language] ?? ''));
}

/** The stops that these moments have, in the order of their steps; of two at one step, the first. */
export function stopsOf(figure: Figure, traces: readonly Trace[]): { key: string; name: Figure['stops'][number]['name']; step: number }[] {
  const moments = traces[0]?.moments ?? [];
  const found = figure.stops.flatMap(({ key, name, find }) => {
    const step = find(moments);
    return step === undefined ? [] : [{ key, name, step }];
  });
  return found.filter(({ step }, k) => found.findIndex((other) => other.step === step) === k).sort((a, b) => a.step - b.step);
}


/** The place of a handle's grip on a plate, in shares of the plate's width and height. */
export function gripAt(figure: Figure, plate: number, key: string, view: View): readonly [number, number] {
  const { draw = 'force', packing = 0 } = figure.plates[plate] ?? {};
  const moment = view.traces[packing]?.moments[view.step];
  if (!moment) return [0, 0];
  const x = X(key === 'mark' ? (view.mark ?? 0) : draw === 'valley' ? moment.w : moment.left + moment.w);
  const y = draw !== 'valley' ? MIDDLE : key === 'mark' ? BOTTOM - POLE + 7 : Y(moment.energy);
  return [Math.min(x, WIDTH - 8) / WIDTH, y / HEIGHT];
}
