/**
 * Strokes, the field that they make, and squares on the way from one stroke to the other; the square in the middle
 * stands out.
 */
import type { Plate, Trace, View } from '../figures/figure';
import type { Place } from '../figures/place';
import { angleIn } from '../figures/which-way-handles';
import { SIDE } from './crowd';
import { line, svg, text } from './plate';
import { crosses, onto, standing, strokesOf } from './ways';

/** The number of squares on the way, and their side. */
const SQUARES = 5;
const TALL = 24;

/** How far a stroke's angle is written from its middle, across and down. */
const AWAY = 26;

/** The ends of both strokes. */
export function endsOf(trace: Trace): readonly (readonly [Place, Place])[] {
  const points = trace.points('strokes');
  return [0, 2].flatMap((k) => {
    const [from, to] = [points[k], points[k + 1]];
    return from && to ? [[from, to] as const] : [];
  });
}

export const middleOf = ([[ax, ay], [bx, by]]: readonly [Place, Place]): Place => [(ax + bx) / 2, (ay + by) / 2];

export function strokes(view: View, { packing }: Plate): string {
  const trace = view.traces[packing];
  if (!trace) return svg(SIDE, '', '');
  const both = endsOf(trace);
  const said = view.language === 'ja' ? '二本の線と、その間に並ぶ正方形' : 'Two strokes, and squares between them';
  return svg(SIDE, said, `${crosses(trace.directions.field, 5.5)}${between(trace, both)}${both.map((ends, k) => strokeOf(ends, k, trace)).join('')}`);
}

/** A stroke with its angle beside it, on the side that is farther from the other one. */
function strokeOf(ends: readonly [Place, Place], k: number, trace: Trace): string {
  const [from, to] = ends;
  const [x, y] = onto(middleOf(ends));
  const far = k ? -AWAY : AWAY;
  return `${line(onto(from), onto(to), 'stroke-back')}${line(onto(from), onto(to), `stroke stroke-${k}`)}${text(x - far, y + far + 5, `${angleIn(trace.points('strokes'), k)}°`, 'key marked halo')}`;
}

function between({ directions }: Trace, [one, other]: readonly (readonly [Place, Place])[]): string {
  if (!one || !other) return '';
  const [[ax, ay], [bx, by]] = [middleOf(one), middleOf(other)];
  const squares = Array.from({ length: SQUARES }, (_, k) => {
    const share = (k + 1.5) / (SQUARES + 2);
    const isHalfway = 2 * k + 1 === SQUARES;
    const { place, along, certainty } = directions.at([ax + share * (bx - ax), ay + share * (by - ay)]);
    const cross = isHalfway ? `<path class="axes" d="${strokesOf(onto(place), along, TALL * 1.1)}"/>` : '';
    return `${cross}${standing(onto(place), along, TALL, isHalfway ? 'tile halfway' : 'tile', 0.15 + 0.85 * certainty)}`;
  });
  return squares.join('');
}
