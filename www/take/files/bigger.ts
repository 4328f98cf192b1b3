/** The finished picture, or its maps, at several times its side, as rows. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { PictureSlice, PixelMap } from '../../module/types';
import { BUDGET } from '../../module/run';
import type { Progress } from './worked';
import { given } from './refusal';

/**
 * Has the rows of these maps taken as they are made, of the picture where there are no words; answers the heights that
 * are 0 and 65535 in the map of heights. Throws a Refusal where it cannot be made.
 */
export async function bigger(studio: Bubblestone, scale: number, words: string[], take: (maps: PixelMap[]) => Promise<void> | void, progress: Progress): Promise<PictureSlice['heights']> {
  for (;;) {
    const { maps, heights, done, progress: part } = given(studio.pictureFile(scale, words.join(' '), BUDGET));
    await take(maps);
    progress(part);
    if (done) return heights;
  }
}
