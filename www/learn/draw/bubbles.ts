/** Two bubbles with their forces as arrows and the distance between their centres. */
import { number, way } from '../figures/words';
import type { Trace, View } from '../figures/figure';
import { arrow, at, circle, line, momentOf, pick, PULL, PUSH, stiffnessOf, symbol, text, UNIT, WIDTH, X } from './plate';

/** The height of the centres. */
export const MIDDLE = 96;

/** Below the bubbles, where the next drawing begins. */
export const BELOW = 194;

/** The length of an arrow for a force as large as the stiffness k0. */
const FORCE = 64;

/** Arrows begin beside the sign of the centre. */
const CLEAR = 9;

/** The least force that is drawn, as a share of the stiffness. */
const LEAST = 0.01;

export function bubbles(view: View, packing: number): string {
  const moment = momentOf(view, packing);
  const trace = view.traces[packing];
  if (!moment || !trace) return '';
  const [left, right] = [X(moment.left), X(moment.left + moment.w)];
  const kind = way(moment);
  const force = moment.force / stiffnessOf(view, packing);
  const length = force * FORCE;
  const clear = CLEAR * Math.sign(length);
  const arrows = Math.abs(force) < LEAST ? '' : `${arrow(left - clear, MIDDLE, -length, kind)}${arrow(right + clear, MIDDLE, length, kind)}`;
  return `${bubble(left, isHeld(trace))}${bubble(right, false)}${centre(left, isHeld(trace))}${centre(right, false)}${arrows}${forceName(view, packing)}${distance(left, right, moment.w)}${beyond(right, moment.w)}`;
}

const isHeld = (trace: Trace): boolean => trace.value('held') === '1';

function bubble(x: number, held: boolean): string {
  return circle([x, MIDDLE], UNIT / 2, `bubble${held ? ' held' : ''}`);
}

/** A held bubble has a nail, a free one a ring. */
function centre(x: number, held: boolean): string {
  if (!held) return circle([x, MIDDLE], 4, 'centre');
  return `<path class="nail" d="M${at(x - 5)} ${MIDDLE - 5}l10 10m0 -10l-10 10"/>`;
}

function forceName(view: View, packing: number): string {
  const moment = momentOf(view, packing);
  if (!moment) return '';
  const kind = way(moment);
  const none = view.language === 'ja' ? '力 0' : 'no force';
  const words = kind === 'none' ? none : `${pick(kind === 'push' ? PUSH : PULL, view.language)} ${number(Math.abs(moment.force), 3)}`;
  return text(WIDTH / 2, 20, words, `force-name ${kind}`);
}

function distance(left: number, right: number, w: number): string {
  const y = MIDDLE + UNIT / 2 + 12;
  const ends = [left, right].map((x) => line([x, y - 4], [x, y + 4], 'measure')).join('');
  return `${line([left, y], [right, y], 'measure')}${ends}${text((Math.max(left, 20) + Math.min(right, WIDTH - 20)) / 2, y + 15, `${symbol('w', 'w')} = ${number(w, 3)}`, 'measured')}`;
}

/** A sign that the right bubble has left the plate, beside its grip at the border. */
function beyond(right: number, w: number): string {
  return right < WIDTH ? '' : text(WIDTH - 24, MIDDLE + 5, `${symbol('w', 'w')} = ${number(w, 2)} »`, 'measured', 'end');
}
