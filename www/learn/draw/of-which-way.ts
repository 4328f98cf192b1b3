/** The figures of chapter 5 with their drawings. */
import { degreesOf } from '../figures/directions';
import type { Plate, View } from '../figures/figure';
import { WHICH_WAY } from '../figures/which-way';
import { SIDE } from './crowd';
import { dial } from './dial';
import { WIDTH, type Drawings, type PlateDrawing } from './plate';
import { HEIGHT, sidesOf, toPicture, toPlate } from './sides';
import { endsOf, middleOf, strokes } from './strokes';
import { ARROW, turned } from './turned';
import { turns } from './turns';
import { walk } from './walk';
import { onto } from './ways';

const MIDDLE = WIDTH / 2;

/** A point among the sides of an outline; below them a tap changes nothing. */
const ofSides = (draw: PlateDrawing['draw']): PlateDrawing => ({
  height: HEIGHT,
  draw,
  grip: (_view, _plate, _key, [x = 0, y = 0]) => toPlate([x, y]),
  numbers: (x, y, _key, { at }) => toPicture(x, y) ?? at,
});

/** The end of an arrow from a point, at an angle in degrees and with the length `far`. */
const end = ([x, y]: readonly [number, number], degrees: number, far: number): readonly [number, number] => [x + far * Math.cos((degrees * Math.PI) / 180), y + far * Math.sin((degrees * Math.PI) / 180)];

/** The walk's middle has one grip, and its radius another one on the circle. */
const ofWalk: PlateDrawing = {
  height: SIDE,
  draw: walk,
  grip: ({ at: [x = 0, y = 0, radius = 0] }, _plate, key, numbers) => (key === 'at' ? onto([numbers[0] ?? 0, numbers[1] ?? 0]) : end(onto([x, y]), -45, radius * SIDE)),
  numbers: (x, y, key, { at }) => (key === 'at' ? [x / SIDE, y / SIDE] : [Math.hypot(x / SIDE - (at[0] ?? 0), y / SIDE - (at[1] ?? 0))]),
};

/** The middle of the stroke that a handle turns, and half of its length with room for a grip. */
function strokeOf(view: View, { packing }: Plate, key: string): readonly [readonly [number, number], number] {
  const trace = view.traces[packing];
  const ends = (trace ? endsOf(trace) : [])[key === 'stroke-1' ? 0 : 1] ?? [[0, 0], [0, 0]];
  const [from, to] = ends.map(onto);
  return [onto(middleOf(ends)), Math.hypot((to?.[0] ?? 0) - (from?.[0] ?? 0), (to?.[1] ?? 0) - (from?.[1] ?? 0)) / 2 + 16];
}

const PLATE: Plate = { draw: 'strokes', packing: 0 };

const ofStrokes: PlateDrawing = {
  height: SIDE,
  draw: strokes,
  grip: (view, plate, key, [degrees = 0]) => end(...withDegrees(strokeOf(view, plate, key), degrees)),
  numbers: (x, y, key, view) => {
    const [[cx, cy]] = strokeOf(view, PLATE, key);
    return [(Math.round(degreesOf([x - cx, y - cy])) + 360) % 180];
  },
};

const withDegrees = ([middle, half]: readonly [readonly [number, number], number], degrees: number): readonly [readonly [number, number], number, number] => [middle, degrees, half];

export const drawings: Drawings = {
  figures: WHICH_WAY,
  drawn: {
    turned: { height: WIDTH, draw: turned, grip: (_view, _plate, _key, [degrees = 0]) => end([MIDDLE, MIDDLE], degrees, ARROW + 12), numbers: (x, y) => [degreesOf([x - MIDDLE, y - MIDDLE])] },
    dial: { height: WIDTH, draw: dial },
    arrows: ofSides(sidesOf('printed')),
    'four-fold': ofSides(sidesOf('turned')),
    walk: ofWalk,
    turns: { height: SIDE, draw: turns },
    strokes: ofStrokes,
  },
};
