/** The fate of two bubbles, found in the engine's numbers. */
import type { Moment, Trace, Trial } from './figure';

/** How near to the stable distance, and how slow, a pair at rest is. */
const NEAR = 0.01;

/** Beyond this many stable distances there is no force (eq. (2)). */
export const REACH = 1.5;

export const start = (): number => 0;

/** Whether a recipe has two given bubbles and no others. */
export const isPair = ({ points, value }: Trace): boolean => points('given').length === 2 && value('pop') === 'off';

/** The first step past the stable distance, where the two circles touch. */
export function touch(moments: readonly Moment[]): number | undefined {
  const from = moments[0]?.w ?? 1;
  return stepOf(moments, ({ w }) => (from < 1 ? w >= 1 : w <= 1), Math.abs(from - 1) > NEAR);
}

/** The first step at which the distance begins to change the other way. */
export function turn(moments: readonly Moment[]): number | undefined {
  const way = Math.sign(moments.find(({ speed }) => Math.abs(speed) > 1e-9)?.speed ?? 0);
  return stepOf(moments, ({ speed }) => speed * way < 0, way !== 0);
}

/** The first step after which the distance stays the same. */
export function rest(moments: readonly Moment[]): number | undefined {
  const end = moments.at(-1);
  if (!end || Math.abs(end.speed) > NEAR) return undefined;
  const last = moments.findLastIndex(({ w, speed }) => Math.abs(w - end.w) > NEAR || Math.abs(speed) > NEAR);
  return moments[last + 1]?.step;
}

/** The first step after which the two never meet again. */
export function parting(moments: readonly Moment[]): number | undefined {
  return stepOf(moments, ({ w, speed }) => w > REACH && speed > 0, true);
}

/** The longest time step with which Runge-Kutta keeps the energy of a start near the border to a thousandth of the valley's depth. */
const EXACT = 0.2;

/** How a start without damping ended as far as this step: parted for good, or come back. Runs that lose or gain energy do not count. */
export function trialOf({ moments, value }: Trace, step: number): Trial | undefined {
  if (Number(value('damp')) > 0 || value('move') !== 'rk4' || Number(value('dt')) > EXACT) return undefined;
  const [first] = moments;
  const [away, back] = [parting(moments), turn(moments)];
  if (!first || first.w >= 1) return undefined;
  if (away !== undefined && away <= step) return { ...kept(first.w), parted: true };
  return back !== undefined && back <= step && away === undefined ? { ...kept(first.w), parted: false } : undefined;
}

const kept = (w: number): Trial => ({ start: String(w), value: w });

/** The largest start that parted, and the smallest that came back; `undefined` where there was none. */
export function nearest(trials: readonly Trial[]): readonly [parted: number | undefined, kept: number | undefined] {
  const values = (isParted: boolean): number[] => trials.filter(({ parted }) => parted === isParted).map(({ value }) => value).sort((a, b) => a - b);
  return [values(true).at(-1), values(false)[0]];
}

/** The nearest pair of trials that ended differently, if they are less than `apart` from each other. */
export function between(trials: readonly Trial[], apart: number): readonly [parted: number, kept: number] | undefined {
  const [parted, kept] = nearest(trials);
  return parted !== undefined && kept !== undefined && kept > parted && kept - parted < apart ? [parted, kept] : undefined;
}

function stepOf(moments: readonly Moment[], is: (moment: Moment) => boolean, can: boolean): number | undefined {
  return can ? moments.find((moment) => moment.step > 0 && is(moment))?.step : undefined;
}
