/** A dial with arrows at angles, clockwise from the right, and the arc up to the last of them. */
import type { Hand, Plate, View } from '../figures/figure';
import type { Place } from '../figures/place';
import { number } from '../figures/words';
import { arrowTo, circle, line, path, svg, text, WIDTH } from './plate';

const [MIDDLE, CENTRE, RADIUS] = [WIDTH / 2, 178, 128];

/** The row of the sum's name. */
const BELOW = WIDTH - 20;

/** The cosine of the angle at which two names are in each other's way, and the shortest arrow. */
const [NEAR, LEAST] = [0.94, 0.02];

/** The cosine of the angle at which the names of two terms would lie on each other, and the height of a line. */
const [CLOSE, LINE] = [0.985, 18];

const place = (degrees: number, far: number): Place => {
  const angle = (degrees * Math.PI) / 180;
  return [MIDDLE + far * Math.cos(angle), CENTRE + far * Math.sin(angle)];
};

export function dial(view: View, { hands, title }: Plate): string {
  const all = hands?.(view, view.language) ?? [];
  const said = [title?.[view.language] ?? '', ...all.filter(({ kind }) => kind !== 'ghost').map(({ name, degrees }) => `${name} ${number(degrees, 0)}°`)].filter(Boolean).join(', ');
  const last = all.at(-1);
  return svg(WIDTH, said, `${face(all)}${last ? arc(last) : ''}${all.map((hand, k) => handOf(hand, all.slice(0, k))).join('')}${circle([MIDDLE, CENTRE], 4.5, 'hub')}`);
}

/** Degrees at the rim, unless the name of an arrow stands there. */
function face(all: readonly Hand[]): string {
  const ticks = Array.from({ length: 24 }, (_, k) => line(place(15 * k, RADIUS - (k % 6 ? 5 : 10)), place(15 * k, RADIUS), 'axis'));
  const named = all.filter(({ kind }) => kind === 'term').map(({ degrees }) => degrees);
  const names = [0, 90, 180, 270].filter((degrees) => named.every((other) => Math.cos(((other - degrees) * Math.PI) / 180) < NEAR)).map((degrees) => {
    const [x, y] = place(degrees, RADIUS + 20);
    return text(x, y + 4, `${degrees}°`, 'number');
  });
  return `${circle([MIDDLE, CENTRE], RADIUS, 'dial')}${ticks.join('')}${names.join('')}`;
}

/** The way of an arrow from 0, which may go round more than once. */
function arc({ degrees }: Hand): string {
  const count = Math.max(1, Math.round(Math.abs(degrees) / 3));
  const points = Array.from({ length: count + 1 }, (_, k) => place((degrees * k) / count, 40 + (12 * Math.abs((degrees * k) / count)) / 360));
  return path(points, 'arc');
}

/** An arrow with its name: that of a term stands outside, that of the sum below the dial. */
function handOf({ degrees, length, kind, name }: Hand, before: readonly Hand[]): string {
  if (length < LEAST) return kind === 'sum' ? text(MIDDLE, BELOW, name, 'key marked sum-said') : '';
  const [x, y] = place(degrees, RADIUS * length);
  const label = kind === 'sum' ? text(MIDDLE, BELOW, name, 'key marked sum-said') : termName(degrees, name, before);
  return `${arrowTo([MIDDLE, CENTRE], [x - MIDDLE, y - CENTRE], `hand ${kind}`)}${name && label}`;
}

/** The name of a term outside of the dial; it makes room for that of an earlier term which points nearly the same way. */
function termName(degrees: number, name: string, before: readonly Hand[]): string {
  const [x, y] = place(degrees, RADIUS + 14);
  const across = (x - MIDDLE) / (RADIUS + 14);
  const near = before.find((hand) => hand.kind === 'term' && Math.cos(((hand.degrees - degrees) * Math.PI) / 180) > CLOSE);
  const [, taken] = place(near?.degrees ?? 0, RADIUS + 14);
  const way = Math.abs(y - taken) > 1 ? Math.sign(y - taken) : y < CENTRE ? -1 : 1;
  return text(x, (near ? taken + way * LINE : y) + 5, name, 'key', across > 0.3 ? 'start' : across < -0.3 ? 'end' : 'middle');
}
