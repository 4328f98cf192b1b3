/** The potential of equation (3) as a valley, with the pair as a ball in it and its energy as a level. */
import type { Moment, View } from '../figures/figure';
import { number } from '../figures/words';
import { at, axisOfW, circle, line, momentOf, path, stiffnessOf, svg, symbol, text, WIDEST, WIDTH, X, type CurvePoint } from './plate';
import { HEIGHT } from './force';

export const [TOP, BOTTOM] = [34, HEIGHT - 24];

/** From this distance on the words of a mark stand on its left. */
const LEFT_OF_NAME = 1;

/** The height of a mark's pole. */
export const POLE = 44;

/** The wall on the left is twelve times as high as the valley is deep: the plate shows its foot. */
const [LOWEST, HIGHEST] = [-0.062, 0.15];

export const Y = (energy: number): number => Math.max(TOP, BOTTOM - ((energy - LOWEST) / (HIGHEST - LOWEST)) * (BOTTOM - TOP));

export function valley(view: View, packing: number): string {
  const moment = momentOf(view, packing);
  const points = shown(view).map(([w, , psi]) => [X(w), Y(psi)] as const);
  const ground = `<path class="ground" d="M${at(X(0))} ${TOP}L${points.map(([x, y]) => `${at(x)} ${at(y)}`).join('L')}L${at(X(WIDEST))} ${BOTTOM}L${at(X(0))} ${BOTTOM}z"/>`;
  const said = view.language === 'ja' ? 'ポテンシャルΨ(w)の谷と、その中のバブルの位置' : 'The valley of the potential Ψ(w), and the place of the pair in it';
  return svg(HEIGHT, said, `${axisOfW(Y(0), TOP, BOTTOM, view.language)}${ground}${path(points, 'curve')}${name()}${zero(view)}${mark(view)}${moment ? ball(moment, stiffnessOf(view, packing), view) : ''}`);
}

/** The part of the curve below the plate's top, which it crosses between two of its points. */
function shown({ curve }: View): CurvePoint[] {
  const first = curve.findIndex(([, , psi]) => psi <= HIGHEST);
  const [[w, , psi] = [0, 0, 0], [above, , higher] = [0, 0, 0]] = [curve[first], curve[first - 1]];
  const share = (HIGHEST - psi) / (higher - psi);
  return [[w + share * (above - w), 0, HIGHEST], ...curve.slice(first)];
}

function name(): string {
  return `${text(X(0) - 8, TOP + 12, `${symbol('psi', 'Ψ')}(${symbol('w', 'w')})`, 'curve-name', 'end')}${text(X(0) - 8, Y(0) + 4, '0', 'number', 'end')}`;
}

/**
 * The ball, and its whole energy as a line at the height where it would turn back. A sign stands for a ball above the
 * plate.
 */
function ball({ w, energy, motion }: Moment, stiffness: number, { language }: View): string {
  const level = energy + motion;
  const y = Y(level / stiffness);
  const words = language === 'ja' ? 'エネルギー' : 'energy';
  const high = level / stiffness > HIGHEST ? '' : `${line([X(0), y], [X(WIDEST), y], 'level')}${text(X(WIDEST), y - 6, `${words} ${number(level, 3)}`, 'level-name', 'end')}`;
  const up = energy / stiffness > HIGHEST ? text(Math.min(X(w), WIDTH - 20) + 12, TOP + 16, `▲ ${number(energy, 3)}`, 'number', 'start') : '';
  return `${high}${up}${circle([Math.min(X(w), WIDTH - 6), Y(energy / stiffness)], 7, 'here')}`;
}

/** The reader's mark: a flag on the axis. One that was not set stands at 0, and asks to be set. */
function mark({ at: [place], language }: View): string {
  if (place === undefined) return '';
  const x = X(place);
  // On the right the level has its name.
  const isFar = place > LEFT_OF_NAME;
  const words = place === 0 ? (language === 'ja' ? '印を付ける' : 'set your mark') : `${language === 'ja' ? '印' : 'mark'} ${number(place, 3)}`;
  return `<g class="mark">${line([x, BOTTOM], [x, BOTTOM - POLE], 'pole')}<path class="flag" d="M${at(x)} ${BOTTOM - POLE}h26l-6 7l6 7h-26z"/>${text(x + (isFar ? -4 : 4), BOTTOM - POLE - 6, words, 'number halo', isFar ? 'end' : 'start')}</g>`;
}

/** The distance at which the potential is 0, once that is found. */
function zero({ zero: place, isZeroShown }: View): string {
  if (!isZeroShown) return '';
  const x = X(place);
  return `<g class="zero">${line([x, Y(0) - 30], [x, Y(0) + 6], 'pole')}${circle([x, Y(0)], 4, 'extreme')}${text(x + 6, Y(0) - 24, `${symbol('psi', 'Ψ')} = 0: ${number(place, 3)}`, 'number', 'start')}</g>`;
}
