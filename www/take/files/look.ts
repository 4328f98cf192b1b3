/**
 * The picture that films show while the work goes on: the picture in its plane, or frames of the bodies seen by the
 * camera.
 */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { SceneStudio } from '../../module/scene';
import type { Generator } from '../../module/types';
import { BUDGET } from '../../module/run';
import { given } from './refusal';
import type { Seen } from './turn';

/** Draws the current state, with `side` pixels along a side. */
export interface Look {
  readonly side: number;
  draw(context: Pick<CanvasRenderingContext2D, 'putImageData'>): void;
}

/** `side` is used for frames, which have no size of their own. */
export function lookOf(studio: Bubblestone, { offers }: Generator, seen: Seen, side: number): Look {
  if (!offers.includes('frames')) return { side: studio.side(), draw: (context) => studio.draw(context as CanvasRenderingContext2D, 'auto') };
  return { side, draw: (context) => context.putImageData(frame(studio as SceneStudio, seen, side, 'still'), 0, 0) };
}

/** A frame; an empty one while there is nothing to see. */
export function frame(studio: SceneStudio, { camera }: Seen, side: number, how: string): ImageData {
  for (;;) {
    const slice = studio.turn('', camera, side, side, `${how}+floor+auto`, BUDGET);
    if ('code' in slice && slice.code === 'not_yet') return new ImageData(side, side);
    const { done, pixels } = given(slice);
    if (done && pixels) return new ImageData(new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length), side, side);
  }
}
