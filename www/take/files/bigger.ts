/** The finished picture, or its maps, with more pixels, as rows. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { PictureSlice, PixelMap } from '../../module/types';
import { BUDGET } from '../../module/run';
import type { Progress } from './worked';
import { given } from './refusal';

/**
 * Calls `take` with the rows of these maps as they are made, or with those of the picture if there are no words.
 * Returns the heights that are 0 and 65535 in the map of heights. Throws a Refusal if it cannot be made.
 */
export async function bigger(studio: Bubblestone, scale: number, words: string[], take: (maps: PixelMap[]) => Promise<void> | void, progress: Progress): Promise<PictureSlice['heights']> {
  for (;;) {
    const { maps, heights, done, progress: part } = given(studio.pictureFile(scale, words.join(' '), BUDGET));
    await take(maps);
    progress(part);
    if (done) return heights;
  }
}
