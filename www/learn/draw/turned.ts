/** A square that is held and turned, in its landscape, with its arrow, and the place where the arrow was before. */
import { unitAt } from '../figures/directions';
import type { Landscape, Plate, Trace, View } from '../figures/figure';
import { number } from '../figures/words';
import { SIDE } from './crowd';
import { definitions, FOOT, over, part, seenBands, UNIT } from './ground';
import { arrowTo, at, circle, path, svg, text } from './plate';
import { bubblesOf, square } from './squares';

const MIDDLE = SIDE / 2;

/** The length of the arrow, and the radius of the arc of its angle, in units of the plate. */
export const ARROW = 132;
const ARC = 76;

/** The ground farther away has no potential. This plain hides the edges of the turned ground. */
const FAR = 186;
const PLAIN = `<path class="tier${FOOT - 1} plain" d="M0 0h${SIDE}v${SIDE}h${-SIDE}zM${MIDDLE - FAR} ${MIDDLE}a${FAR} ${FAR} 0 1 0 ${2 * FAR} 0a${FAR} ${FAR} 0 1 0 ${-2 * FAR} 0z"/>`;

export function turned(view: View, { packing, ground = '' }: Plate): string {
  const trace = view.traces[packing];
  const land = trace?.landscape;
  if (!trace || !land) return svg(SIDE, '', '');
  const degrees = Number(trace.value('angle'));
  const said = view.language === 'ja' ? `${number(degrees, 0)}° 回した正方形と、四つの井戸` : `A square turned by ${number(degrees, 0)}°, and its four wells`;
  // The ground is drawn once, and turned.
  return `${svg(SIDE, said, definitions(land, ground))}${over(`<g transform="rotate(${at(degrees)} ${MIDDLE} ${MIDDLE})">${bands(land, ground)}${wells(land)}${squareOf(trace)}</g>${PLAIN}${arrows(degrees)}`)}`;
}

function bands(landscape: Landscape, ground: string): string {
  const centre = `translate(${MIDDLE} ${MIDDLE})`;
  return `${seenBands(landscape).map(([band]) => part(ground, String(band), `tier${band}`, centre)).join('')}${part(ground, 'lines', 'level-line', centre)}`;
}

/** The wells; the first one is followed. */
function wells({ well }: Landscape): string {
  const far = well.w * UNIT;
  const at2 = (x: number, y: number): string => `<path class="well" d="M${at(MIDDLE + x)} ${at(MIDDLE + y)}m-5 0h10m-5 -5v10"/>`;
  return `${at2(far, 0)}${at2(-far, 0)}${at2(0, far)}${at2(0, -far)}${circle([MIDDLE + far, MIDDLE], 11, 'followed')}`;
}

function squareOf(trace: Trace): string {
  const held = { id: 0, x: 0.5, y: 0.5, size: Number(trace.value('cs')) / trace.side, isHeld: true, speed: [0, 0], force: [0, 0], energy: 0, least: 0 } as const;
  return `${square(held, 'outlined held')}${bubblesOf(held, trace)}`;
}

/** The arrow now and at 0, and the arc between them. */
function arrows(degrees: number): string {
  const [x, y] = unitAt(Math.round(degrees));
  const arc = Array.from({ length: Math.abs(Math.round(degrees / 3)) + 1 }, (_, k) => unitAt(Math.sign(degrees) * 3 * k)).map(([u, v]) => [MIDDLE + ARC * u, MIDDLE + ARC * v] as const);
  const [nx, ny] = unitAt(Math.round(degrees / 2));
  const name = Math.abs(degrees) < 20 ? '' : text(MIDDLE + (ARC + 18) * nx, MIDDLE + (ARC + 18) * ny + 5, `${number(degrees, 0)}°`, 'key marked halo');
  const ghost = degrees === 0 ? '' : arrowTo([MIDDLE, MIDDLE], [ARROW, 0], 'hand ghost');
  return `${path([...arc, [MIDDLE + ARC * x, MIDDLE + ARC * y]], 'arc')}${ghost}${arrowTo([MIDDLE, MIDDLE], [ARROW * x, ARROW * y], 'hand term')}${name}`;
}
