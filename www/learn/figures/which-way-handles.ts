/** The handles of chapter 5, and the recipes of its figures. Angles are clockwise on screen. */
import { degreesOf, unitAt } from './directions';
import type { ChoiceHandle, Listed, NumberHandle, PointHandle } from './figure';
import type { Place } from './place';

const NONE = { en: '', ja: '' };
const DEGREES = { en: '°', ja: '°' };

const listed = (points: readonly Place[]): string => points.map((point) => point.map((value) => Number(value.toFixed(9))).join(',')).join(',');

export const ANGLE: NumberHandle = {
  kind: 'number', key: 'angle', symbol: '', name: { en: 'Angle', ja: '角度' }, unit: DEGREES,
  from: -90, to: 90, stride: 5, fine: 1, coarse: 45, digits: 0, plates: [0],
};

/** A road, five times as long as wide. */
const [ENDS, WALLS] = [[0.05, 0.95], [0.41, 0.59]] as const;
const RIGHT_CORNERS: readonly Place[] = [[ENDS[1], WALLS[1]], [ENDS[0], WALLS[1]]];

/** The road with its upper side cut into pieces of one length. */
export const roadOf = (pieces: number): string => listed([...Array.from({ length: pieces + 1 }, (_, k): Place => [ENDS[0] + ((ENDS[1] - ENDS[0]) * k) / pieces, WALLS[0]]), ...RIGHT_CORNERS]);

/** The upper side has all points of the road but two, so its pieces are three fewer than the points. */
const CUT: Listed = { list: 'poly', read: (points) => points.length - 3, write: (pieces) => ({ poly: roadOf(Math.round(pieces)) }) };

export const PIECES: NumberHandle = {
  kind: 'number', key: 'pieces', symbol: '', name: { en: 'Pieces', ja: '上の辺を切る数' }, unit: NONE,
  from: 1, to: 10, stride: 1, fine: 1, coarse: 3, digits: 0, listed: CUT,
};

export const POWER: NumberHandle = {
  kind: 'number', key: 'dp', symbol: '', name: { en: 'Our power of the distance', ja: '距離の指数（四倍角の和）' }, unit: NONE,
  from: 2, to: 4, stride: 1, fine: 1, coarse: 1, digits: 0,
};

export const IN_ROAD: PointHandle = {
  kind: 'point', key: 'at', name: { en: 'Point', ja: '点' }, unit: NONE,
  origin: [0, 0], scale: 1, from: 0, to: 1, stride: 0.015, fine: 0.005, coarse: 0.1, digits: 3, plates: [0, 1], area: [0.07, 0.43, 0.93, 0.57], line: 0.5,
};

/** A round place as a polygon, with a corner every five degrees. */
const [CORNERS, RADIUS, FIRST] = [72, 0.44, 2];

function roundOf(height: number): string {
  return listed(Array.from({ length: CORNERS }, (_, k) => unitAt(FIRST + (360 / CORNERS) * k)).map(([x, y]): Place => [0.5 + RADIUS * x, 0.5 + height * RADIUS * y]));
}

export const ROUND = roundOf(1);

/** The height of the round place in widths. A change of it also returns to the round place from another outline. */
const FLAT: Listed = {
  list: 'poly',
  read: (points) => {
    const wide = (axis: 0 | 1): number => Math.max(...points.map((point) => point[axis])) - Math.min(...points.map((point) => point[axis]));
    return Math.round((100 * wide(1)) / (wide(0) || 1)) / 100;
  },
  write: (height) => ({ outline: 'polygon', poly: roundOf(height) }),
};

export const HEIGHT: NumberHandle = {
  kind: 'number', key: 'height', symbol: '', name: { en: 'Height of the round place', ja: '円い広場の高さ' }, unit: { en: 'widths', ja: '（幅を1として）' },
  from: 0.6, to: 1, stride: 0.05, fine: 0.01, coarse: 0.2, digits: 2, listed: FLAT,
};

export const OUTLINE: ChoiceHandle = {
  kind: 'choice', key: 'outline', name: { en: 'Place', ja: '場所' },
  choices: [
    { word: 'polygon', name: { en: 'round', ja: '円板' } },
    { word: 'annulus', name: { en: 'ring', ja: '環' } },
    { word: 'square', name: { en: 'square', ja: '正方形' } },
  ],
};

export const CENTRE: PointHandle = {
  kind: 'point', key: 'at', name: { en: 'Middle', ja: '道筋の中心' }, unit: NONE,
  origin: [0, 0], scale: 1, from: 0.02, to: 0.98, stride: 0.02, fine: 0.005, coarse: 0.1, digits: 3, plates: [0],
};

export const WALK_RADIUS: NumberHandle = {
  kind: 'number', key: 'mark-2', symbol: '', name: { en: 'Radius', ja: '道筋の半径' }, unit: NONE,
  from: 0.04, to: 0.4, stride: 0.02, fine: 0.005, coarse: 0.1, digits: 3, plates: [0],
};

/** The middles of both strokes, and half of their length. */
const MIDDLES: readonly Place[] = [[0.3, 0.7], [0.7, 0.3]];
const HALF = 0.06;

function strokeAt(middle: Place, degrees: number): readonly Place[] {
  const [x, y] = unitAt(Math.round(degrees));
  return [-HALF, HALF].map((far): Place => [middle[0] + far * x, middle[1] + far * y]);
}

/** The words of two strokes at these angles. */
export const strokesAt = (...angles: readonly number[]): string => MIDDLES.map((middle, k) => listed(strokeAt(middle, angles[k] ?? 0))).join(';');

/** The angle of a stroke by its ends: a line has no sense. */
export function angleIn(points: readonly Place[], stroke: number): number {
  const [[ax, ay], [bx, by]] = [points[2 * stroke] ?? [0, 0], points[2 * stroke + 1] ?? [1, 0]];
  return (Math.round(degreesOf([bx - ax, by - ay])) + 360) % 180;
}

const strokeHandle = (stroke: 0 | 1, name: NumberHandle['name']): NumberHandle => ({
  kind: 'number', key: `stroke-${stroke + 1}`, symbol: '', name, unit: DEGREES,
  from: 0, to: 179, stride: 5, fine: 1, coarse: 45, digits: 0, plates: [0],
  listed: {
    list: 'strokes',
    read: (points) => angleIn(points, stroke),
    write: (value, points) => ({ strokes: strokesAt(...[0, 1].map((k) => (k === stroke ? value : angleIn(points, k)))) }),
  },
});

export const STROKES = [strokeHandle(0, { en: 'Lower stroke', ja: '下の線' }), strokeHandle(1, { en: 'Upper stroke', ja: '上の線' })] as const;
