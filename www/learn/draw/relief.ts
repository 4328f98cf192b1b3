/** The landscape as a relief in light: a card for each band, cut along its border, laid on those below it, and seen from above a corner. */
import type { Landscape, Plate, Trace, View } from '../figures/figure';
import { neighbourAt } from '../figures/neighbour';
import { FOOT, over, part, seenBands, STEP, UNIT } from './ground';
import { at, circle, path, svg, WIDTH } from './plate';

/** How much the view shortens depth, the thickness of a card, and how far the square is turned. */
const FLAT = 0.76;
const THICK = 3.4;
const TURN = 45;

/** The vertical place of the centre at an energy of 0. */
const MIDDLE = 186;

/** The radii of the round piece of ground, and the height of its edge. */
const [WIDE, DEEP, EDGE] = [194, 194 * FLAT, 26];

/** A rim is seen this far beside its card. */
const RIM = 0.7;

/** The height of an energy above 0, in cards; the hill is cut off one card high. */
const cardsUp = (energy: number): number => Math.min(energy / STEP, 1);

/** The place of a point of the ground on the plate; y up. */
function spot(x: number, y: number, energy: number): readonly [number, number] {
  const [aside, near] = [(x + y) * Math.SQRT1_2, (x - y) * Math.SQRT1_2];
  return [WIDTH / 2 + UNIT * aside, MIDDLE + FLAT * UNIT * near - THICK * cardsUp(energy)];
}

export function relief(view: View, { packing, ground = '' }: Plate): string {
  const trace = view.traces[packing];
  if (!trace?.landscape) return svg(WIDTH, '', '');
  const said = view.language === 'ja' ? '同じ地形を斜め上から見た模型。正方形の中心が玉になって転がる' : 'The same landscape as a model seen from above one corner; the centre of the square is a ball in it';
  const round = `<clipPath id="${ground}-round"><ellipse cx="${WIDTH / 2}" cy="${MIDDLE}" rx="${WIDE}" ry="${DEEP}"/></clipPath>`;
  const edge = `<path class="block" d="M${WIDTH / 2 - WIDE} ${MIDDLE}v${EDGE}a${WIDE} ${DEEP} 0 0 0 ${2 * WIDE} 0v${-EDGE}z"/>`;
  return `${svg(WIDTH, said, `${round}${edge}<g clip-path="url(#${ground}-round)">${cards(trace.landscape, ground)}</g>`)}${over(ball(trace, view.step))}`;
}

/** The cards from the lowest that is seen: each has a dark rim in front, a lit one behind, and its top. */
function cards(landscape: Landscape, ground: string): string {
  return seenBands(landscape).filter(([band]) => band <= FOOT).map(([band, level]) => card(ground, band, level)).join('');
}

function card(ground: string, band: number, level: number): string {
  const up = THICK * cardsUp(level);
  const laid = (kind: string, aside: number, down: number): string =>
    part(ground, String(band), kind, `translate(${at(WIDTH / 2 + aside)} ${at(MIDDLE - up + down)}) scale(1 ${FLAT}) rotate(${TURN})`);
  return `<g class="tier${band}">${laid('rim-dark', RIM, THICK)}${laid('rim-lit', -RIM, -RIM)}${laid('', 0, 0)}</g>`;
}

/** The centre of the second square as a ball, and its way. */
function ball(trace: Trace, step: number): string {
  const points = trace.steps.slice(0, step + 1).flatMap((_, k) => {
    const one = neighbourAt(trace, k);
    return one ? [spot(one.x, one.y, one.energy)] : [];
  });
  const [x, y] = points.at(-1) ?? [0, 0];
  return `${path(points, 'way-back')}${path(points, 'way')}<ellipse class="shadow" cx="${at(x + 2)}" cy="${at(y)}" rx="8" ry="4"/>${circle([x, y - 6], 7.5, 'ball')}${circle([x - 2.5, y - 8.5], 2.2, 'gleam')}`;
}
