/** The figures of chapter 1 with their drawings. */
import type { Plate, View } from '../figures/figure';
import { TWO_BUBBLES } from '../figures/two-bubbles';
import { MIDDLE } from './bubbles';
import { force, HEIGHT } from './force';
import { pavement } from './pavement';
import { stiffnessOf, toW, WIDTH, X, type Drawings, type PlateDrawing } from './plate';
import { track } from './track';
import { BOTTOM, POLE, valley, Y } from './valley';

/** Plates whose horizontal axis is the distance of a pair. */
const ofPair = (draw: (view: View, packing: number, title: string) => string, y: (view: View, plate: Plate, key: string) => number): PlateDrawing => ({
  height: HEIGHT,
  draw: (view, { packing, title }) => draw(view, packing, title?.[view.language] ?? ''),
  grip: (view, plate, key, [w = 0]) => {
    const left = draw === valley || key === 'mark' ? 0 : (view.traces[plate.packing]?.moments[view.step]?.left ?? 0);
    return [Math.min(X(left + w), WIDTH - 8), y(view, plate, key)];
  },
  numbers: (x) => [toW(x)],
});

const ballAt = (view: View, { packing }: Plate, key: string): number => (key === 'mark' ? BOTTOM - POLE + 7 : Y((view.traces[packing]?.moments[view.step]?.energy ?? 0) / stiffnessOf(view, packing)));

export const drawings: Drawings = {
  figures: TWO_BUBBLES,
  drawn: {
    force: ofPair(force, () => MIDDLE),
    track: ofPair(track, () => MIDDLE),
    valley: ofPair(valley, ballAt),
    pavement: { height: WIDTH, draw: (view, { packing }) => pavement(view, packing) },
  },
};
