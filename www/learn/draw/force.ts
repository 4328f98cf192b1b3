/** The force of equation (2) below its two bubbles, with their place on it. */
import type { View } from '../figures/figure';
import { number, way } from '../figures/words';
import { axisOfW, circle, guideDown, line, momentOf, path, stiffnessOf, svg, symbol, text, X } from './plate';
import { BELOW, bubbles } from './bubbles';

const [TOP, BOTTOM] = [BELOW + 24, BELOW + 200];
export const HEIGHT = BOTTOM + 24;

const [LOWEST, HIGHEST] = [-0.28, 1.2];

const Y = (force: number): number => BOTTOM - ((force - LOWEST) / (HIGHEST - LOWEST)) * (BOTTOM - TOP);

/** The distance of the strongest pull, where the slope of eq. (2) is 0. */
const STRONGEST = 19 / 15;

export function force(view: View, packing: number): string {
  const curve = view.curve.map(([w, f]) => [X(w), Y(f)] as const);
  const content = `${axisOfW(Y(0), TOP, BOTTOM, view.language)}${path(curve, 'curve')}${name()}${here(view, packing)}${strongest(view, packing)}${bubbles(view, packing)}`;
  const said = view.language === 'ja' ? '二つのバブルと、力f(w)の曲線の上の位置' : 'Two bubbles, and their place on the curve of the force f(w)';
  return svg(HEIGHT, said, content);
}

function name(): string {
  return text(X(0) - 8, TOP + 12, `${symbol('f', 'f')}(${symbol('w', 'w')})`, 'curve-name', 'end');
}

/** Numbers of the curve stand this far beside their points. */
const BESIDE = 8;

/** The strongest push and the strongest pull, with their numbers. That of the pull keeps to the side where the pair is not. */
function strongest(view: View, packing: number): string {
  const stiffness = stiffnessOf(view, packing);
  const most = view.curve[0]?.[1] ?? 0;
  const least = Math.min(...view.curve.map(([, f]) => f));
  const side = (momentOf(view, packing)?.w ?? 0) > STRONGEST ? -1 : 1;
  const dot = (w: number, f: number): string => circle([X(w), Y(f)], 2.5, 'extreme');
  return `${dot(0, most)}${text(X(0) - BESIDE, Y(most) + 18, number(most * stiffness, 3), 'number', 'end')}${dot(STRONGEST, least)}${text(X(STRONGEST) + side * BESIDE, Y(least) + 15, number(least * stiffness, 3), 'number', side < 0 ? 'end' : 'start')}`;
}

/** The place of the pair on the curve, its force as a bar from the axis, and the line down from the bubble. */
function here(view: View, packing: number): string {
  const moment = momentOf(view, packing);
  if (!moment) return '';
  const [x, y, kind] = [X(moment.w), Y(moment.force / stiffnessOf(view, packing)), way(moment)];
  const guide = moment.left === 0 ? guideDown(moment.w, BELOW - 8, TOP, BOTTOM) : '';
  return `${guide}${line([x, Y(0)], [x, y], `bar ${kind}`)}${circle([x, y], 5.5, 'here')}`;
}
