/** The two angles that face an edge, side by side in half a turn; below, the lengths of the edge and of the other diagonal. */
import type { Plate, View } from '../figures/figure';
import { acrossOf, lengthOf, nearestEdge, sumOf, type InnerEdge, type JoinedCells } from '../figures/joined';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { sectorPath } from './delaunay';
import { at, line, svg, symbol, text, WIDTH } from './plate';

/** The middle of the half circle and its radius. */
const MIDDLE: Place = [WIDTH / 2, 190];
const RADIUS = 150;

/** Bars: their beginning, their first row, their distance, and the length of a picture's side. */
const [LEFT, FIRST, APART, SCALE] = [148, 278, 34, 420];

/** The unit vector at an angle in degrees, counter-clockwise from the right. */
const toward = (angle: number): Place => [Math.cos((angle * Math.PI) / 180), -Math.sin((angle * Math.PI) / 180)];

const letter = (name: 'alpha' | 'beta'): string => symbol(name, name === 'alpha' ? 'α' : 'β');

export function facing(view: View, { packing, title }: Plate): string {
  const trace = view.traces[packing];
  const joined = trace?.joined(0);
  const edge = joined && nearestEdge(joined, [view.at[0] ?? 0.5, view.at[1] ?? 0.5]);
  if (!joined || !edge) return svg(SIDE, '', '');
  const sum = number(sumOf(edge), 1);
  const said = view.language === 'ja' ? `向かい合う角の和は${sum}°` : `The facing angles make ${sum}°`;
  const [x, y] = MIDDLE;
  const total = text(x, y + 44, `${letter('alpha')} + ${letter('beta')} = ${sum}°`, 'angle-sum');
  const half = `<path class="half-turn" d="M${x - RADIUS} ${y}A${RADIUS} ${RADIUS} 0 0 1 ${x + RADIUS} ${y}"/>${line([x - RADIUS - 14, y], [x + RADIUS + 14, y], 'axis')}${text(x - RADIUS - 6, y + 18, '180°', 'number')}${text(x + RADIUS + 6, y + 18, '0°', 'number')}`;
  return svg(SIDE, `${title ? `${title[view.language]}. ` : ''}${said}`, `${sectors(edge)}${half}${total}${bars(view, joined, edge)}${last(view, packing)}`);
}

function sectors({ facing: [one, other] }: InnerEdge): string {
  const [first, second] = [one.angle, one.angle + other.angle];
  const name = (angle: number, of: 'alpha' | 'beta', value: number): string => {
    const [dx, dy] = toward(angle);
    return text(MIDDLE[0] + dx * 100, MIDDLE[1] + dy * 100 + 5, `${letter(of)} ${number(value, 1)}°`, 'angle-name');
  };
  const drawn = `<path class="sector alpha" d="${wide(0, first)}"/><path class="sector beta" d="${wide(first, second)}"/>`;
  return `${drawn}${name(first / 2, 'alpha', one.angle)}${name((first + second) / 2, 'beta', other.angle)}`;
}

const wide = (from: number, to: number): string => sectorPath(MIDDLE, toward(from), toward(to), RADIUS);

function bars({ language }: View, { points }: JoinedCells, edge: InnerEdge): string {
  const rows = [
    { name: language === 'ja' ? 'この辺' : 'this edge', value: lengthOf(points, edge.ends), kind: 'marked' },
    { name: language === 'ja' ? 'もう一方の対角線' : 'other diagonal', value: lengthOf(points, acrossOf(edge)), kind: 'formula' },
  ];
  return rows.map(({ name, value, kind }, k) => {
    const y = FIRST + k * APART;
    const long = Math.min(value * SCALE, WIDTH - LEFT - 60);
    return `${text(LEFT - 10, y + 4, name, 'key', 'end')}<rect class="bar-of ${kind}" x="${LEFT}" y="${y - 8}" width="${at(long)}" height="16"/>${text(LEFT + long + 8, y + 4, number(value, 3), 'key', 'start')}`;
  }).join('');
}

/** The last flip, until points are moved again. */
function last({ traces, language }: View, packing: number): string {
  const flip = traces[packing]?.flip;
  if (!flip) return '';
  const sum = number(flip.sum, 1);
  return text(WIDTH / 2, FIRST + 2 * APART + 16, language === 'ja' ? `入れ替わった瞬間：和は${sum}°` : `it flipped at a sum of ${sum}°`, 'key marked');
}
