/** The small pictures of the terms of directions, by the module's sums. Places are units of 120 x 80. */
import type { Place } from '../figures/place';
import { arrowTo, line, path } from './plate';
import { ask, closed, dot, listed, MIDDLE, placed, ring, shared, type Draw } from './small';
import type { Studio } from './studio';

const CELLS = 'size=256&kind=square&cs=32&edge=open&pop=off';

/** A recipe whose outline has these corners. */
const within = (corners: readonly Place[]): string => `outline=polygon&poly=${listed(corners).join(',')}&${CELLS}`;

const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const from = ([x, y]: Place, far: number, degrees: number): Place => [x + far * Math.cos(radians(degrees)), y + far * Math.sin(radians(degrees))];
const around = (count: number, far: number): Place[] => Array.from({ length: count }, (_, k) => from(MIDDLE, far, (360 * k) / count));

const crossed = (place: Place, arm: number, degrees: number, kind = 'cell'): string => [0, 90].map((quarter) => line(from(place, arm, degrees + quarter), from(place, -arm, degrees + quarter), kind)).join('');
const tilted = (place: Place, half: number, degrees: number): string => closed([45, 135, 225, 315].map((corner) => from(place, half * Math.SQRT2, degrees + corner)), 'bubble');

/** The direction at a place of the picture, as an angle. */
function directionAt(studio: Studio, place: Place): number {
  const [x, y] = shared(place);
  const [along = 1, across = 0] = studio.directionAt(x * studio.side(), y * studio.side());
  return (Math.atan2(across, along) * 180) / Math.PI;
}

/** A square with its arrow, and the arrow at four times the angle. */
const fourFold: Draw = () => {
  const [left, right, angle]: [Place, Place, number] = [[36, 44], [80, 58], -20];
  const arrow = (place: Place, far: number, degrees: number): string => arrowTo(place, from([0, 0], far, degrees), 'sum');
  const base = (place: Place, far: number): string => line(place, from(place, far, 0), 'guide');
  const swept = (place: Place, radius: number, degrees: number): string => path(Array.from({ length: 13 }, (_, k) => from(place, radius, (degrees * k) / 12)), 'now');
  return `${tilted(left, 17, angle)}${base(left, 34)}${swept(left, 27, angle)}${arrow(left, 34, angle)}${base(right, 34)}${swept(right, 16, 4 * angle)}${arrow(right, 42, 4 * angle)}`;
};

/** A winding road: its middle line, and its width to both sides. */
const bend = (x: number, off: number): Place => [x, 40 + 14 * Math.sin((x - 4) / 18) + off];
const ROAD: readonly Place[] = [...Array.from({ length: 24 }, (_, k) => bend(3 + k * 5, -22)), ...Array.from({ length: 24 }, (_, k) => bend(118 - k * 5, 22))];

const field: Draw = (module) =>
  ask(module, within(ROAD), (studio) => {
    const places = Array.from({ length: 9 }, (_, k) => [-14, 0, 14].map((off) => bend(10 + k * 12.5, off))).flat();
    return `${closed(ROAD, 'outline')}${places.map((place) => crossed(place, 4.5, directionAt(studio, place))).join('')}`;
  });

/** A quadrilateral whose sides do not agree. */
const SIDES: readonly Place[] = [[20, 14], [104, 8], [96, 70], [28, 62]];

const segment: Draw = () =>
  SIDES.map(([x, y], k) => {
    const [toX, toY] = SIDES[(k + 1) % SIDES.length] ?? MIDDLE;
    return arrowTo([x, y], [toX - x, toY - y], k === 0 ? 'push' : 'sum');
  }).join('');

/** The length of terms that add up to 1. */
const SCALE = 130;

/** The terms at a place, one behind the other, and the arrow of their sum. */
const certainty: Draw = (module) =>
  ask(module, within([[108, 70], [14, 70], [60, 4]]), (studio) => {
    const [x, y] = shared([68, 55]);
    const numbers = studio.segmentTerms(x * studio.side(), y * studio.side()).subarray(3);
    const terms = Array.from({ length: numbers.length / 9 }, (_, k): Place => [(numbers[9 * k + 7] ?? 0) * SCALE, (numbers[9 * k + 8] ?? 0) * SCALE]);
    const start: Place = [10, 58];
    let end = start;
    const chain = terms.map((term) => {
      const piece = arrowTo(end, term, 'wall');
      end = [end[0] + term[0], end[1] + term[1]];
      return piece;
    });
    return `${chain.join('')}${arrowTo(start, [end[0] - start[0], end[1] - start[1]], 'sum')}`;
  });

const DISC = within(around(48, 39));

/** Three bent sides with square corners. */
const BULGED: readonly Place[] = [0, 120, 240].flatMap((corner) => {
  const [centre, radius] = [from(MIDDLE, 103.8, corner + 240), 127.1];
  return Array.from({ length: 9 }, (_, k) => from(centre, radius, corner + 45 + (30 * k) / 9));
});

/** The distance from a place to the outline. */
function marginAt(studio: Studio, place: Place): number {
  const [x, y] = shared(place);
  const numbers = studio.segmentTerms(x * studio.side(), y * studio.side());
  return numbers.reduce((least, number, k) => (k % 9 === 7 ? Math.min(least, number) : least), studio.side());
}

/** A line that follows the cross from a place to the outline, beginning in the direction nearest to `heading`. */
function followed(studio: Studio, place: Place, heading: number): Place[] {
  const points = [place];
  let [end, way] = [place, heading];
  while (points.length < 60 && marginAt(studio, end) > 4) {
    const angle = directionAt(studio, end);
    way = angle + 90 * Math.round((way - angle) / 90);
    end = from(end, 1.5, way);
    points.push(end);
  }
  return points;
}

/** Lines along the cross between three sides. */
const singular: Draw = (module) =>
  ask(module, within(BULGED), (studio) => {
    const [x = 0, y = 0] = studio.singularPoints();
    const point = placed([x / studio.side(), y / studio.side()]);
    const rays = [60, 180, 300].flatMap((ray) => [5, 12].flatMap((far) => [-90, 90].map((quarter) => followed(studio, from(point, far, ray), ray + quarter))));
    return `${closed(BULGED, 'outline')}${rays.map((points) => path(points, 'cell')).join('')}${dot(point, 'here', 4)}`;
  });

/** A walk around the middle of a disc, and crosses on it with one arm that is followed. */
const index: Draw = (module) =>
  ask(module, DISC, (studio) => {
    const walk = around(12, 26);
    const numbers = studio.directionsAlong(Float64Array.from(walk.flatMap((place) => shared(place).map((part) => part * studio.side()))));
    const first = (Math.atan2(numbers[1] ?? 0, numbers[0] ?? 1) * 180) / Math.PI;
    const crosses = walk.map((place, k) => {
      const angle = first + 360 * (numbers[4 * k + 3] ?? 0);
      return `${crossed(place, 6, angle)}${line(place, from(place, 8, angle), 'now')}`;
    });
    return `${ring(MIDDLE, 39, 'outline')}${ring(MIDDLE, 26, 'guide')}${crosses.join('')}`;
  });

const STROKE: readonly Place[] = Array.from({ length: 12 }, (_, k): Place => [7 + k * 9.6, 52 - 26 * Math.sin(k / 3.8)]);

const stroke: Draw = (module) =>
  ask(module, `outline=square&${CELLS}&dir=strokes&reach=1&strokes=${listed(STROKE).join(',')}`, (studio) => {
    const places = STROKE.flatMap(([x, y], k) => (k % 2 && k < 11 ? [[x, y - 14], [x, y + 14]] : []) as Place[]);
    return `${places.map((place) => tilted(place, 6.5, directionAt(studio, place))).join('')}${path(STROKE, 'outline')}`;
  });

export const WAY_TERMS: Readonly<Record<string, Draw>> = {
  'four-fold': fourFold,
  'direction-field': field,
  segment,
  certainty,
  'singular-point': singular,
  index,
  stroke,
};
