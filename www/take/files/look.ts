/** What films show of the work as it goes on: the picture of a plane, or bodies in space from where they are seen. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { SceneStudio } from '../../module/scene';
import { BUDGET } from './pavement';
import { given } from './refusal';
import type { Seen } from './turn';

/** Draws what there is now, with so many pixels along a side. */
export interface Look {
  readonly side: number;
  draw(context: Pick<CanvasRenderingContext2D, 'putImageData'>): void;
}

/** `side` is for what stands in space, which has no size of its own. */
export function lookOf(studio: Bubblestone, isSpace: boolean, seen: Seen, side: number): Look {
  if (!isSpace) return { side: studio.side(), draw: (context) => studio.draw(context as CanvasRenderingContext2D, 'auto') };
  return { side, draw: (context) => context.putImageData(frame(studio as SceneStudio, seen, side, 'still'), 0, 0) };
}

/** A frame; before there is anything to be seen, an empty one. */
export function frame(studio: SceneStudio, { camera }: Seen, side: number, how: string): ImageData {
  for (;;) {
    const slice = studio.turn('', camera, side, side, `${how}+floor+auto`, BUDGET);
    if ('code' in slice && slice.code === 'not_yet') return new ImageData(side, side);
    const { done, pixels } = given(slice);
    if (done && pixels) return new ImageData(new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length), side, side);
  }
}
