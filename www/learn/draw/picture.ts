/** The plates of a figure at a step. The build makes the still picture with it, and the page every later one. */
import type { Figure, Trace, View } from '../figures/figure';
import { WIDEST, WIDTH, type CurvePoint, type Drawings, type PlateDrawing } from './plate';
import type { Bubbles } from './studio';

/** A figure with the ways to draw its plates. */
export interface Shown {
  readonly figure: Figure;
  readonly drawn: Drawings['drawn'];
}

/** A figure among the drawings of its chapter. */
export function shownIn({ figures, drawn }: Drawings, name: string): Shown | undefined {
  const figure = figures.find((one) => one.name === name);
  return figure && { figure, drawn };
}

/** The step of w from one point of a curve to the next. */
const FINE = 0.02;

/** The curves of the force and of the potential, by the module. */
export function curveOf(module: Bubbles): CurvePoint[] {
  return Array.from({ length: Math.floor(WIDEST / FINE) + 1 }, (_, k) => {
    const [force = 0, potential = 0] = module.bubbleCurve(k * FINE);
    return [k * FINE, force, potential];
  });
}

function drawnAt({ figure, drawn }: Shown, plate: number): PlateDrawing | undefined {
  const own = figure.plates[plate];
  return own && drawn[own.draw];
}

export function platesOf(shown: Shown, view: View): string[] {
  return shown.figure.plates.map((plate, k) => drawnAt(shown, k)?.draw(view, plate) ?? '');
}

/** The text of the state. No line ends between a letter and its number. */
export function toldOf({ told }: Figure, view: View): string {
  return told(view, view.language).replace(/(\w) = (?=[\d−])/g, '$1\u00a0=\u00a0');
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

/** The key of the stop at the last step, which is always on offer. */
export const LAST = 'end';

/** The one stop that is marked at a step: the one on offer that falls on it, or the last step. */
export function markedAt(stops: readonly { readonly key: string; readonly step: number }[], step: number, last: number): string | undefined {
  return stops.find((stop) => stop.step === step)?.key ?? (step === last ? LAST : undefined);
}

/** The last step of the longest run. */
export function lastStepOf(figure: Figure, traces: readonly Trace[]): number {
  return figure.steps !== 'step' ? figure.last : Math.max(0, ...traces.map(({ steps }) => steps.length - 1));
}

/** The place of a handle's grip on a plate, in shares of the plate's width and height. */
export function gripAt(shown: Shown, plate: number, key: string, numbers: readonly number[], view: View): readonly [number, number] {
  const [own, drawn] = [shown.figure.plates[plate], drawnAt(shown, plate)];
  const [x, y] = (own && drawn?.grip?.(view, own, key, numbers)) ?? [0, 0];
  return [x / WIDTH, y / (drawn?.height ?? 1)];
}

/** The numbers of a handle at a place of a plate, in shares of its width and height. */
export function numbersAt(shown: Shown, plate: number, key: string, [x, y]: readonly [number, number], view: View): readonly number[] {
  const drawn = drawnAt(shown, plate);
  return drawn?.numbers?.(x * WIDTH, y * drawn.height, key, view) ?? [];
}
