/** The finished picture, or its maps, at several times its side, delivered as rows. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { PictureSlice, PixelMap } from '../../module/types';
import { BUDGET } from '../../module/run';
import type { Progress } from './worked';
import { given } from './refusal';

/**
 * Passes the rows of these maps to `take` as they are made; without words, the rows of the picture. Answers the
 * heights that are 0 and 65535 in the map of heights. Throws a Refusal if it cannot be made.
 */
export async function bigger(studio: Bubblestone, scale: number, words: string[], take: (maps: PixelMap[]) => Promise<void> | void, progress: Progress): Promise<PictureSlice['heights']> {
  for (;;) {
    const { maps, heights, done, progress: part } = given(studio.pictureFile(scale, words.join(' '), BUDGET));
    await take(maps);
    progress(part);
    if (done) return heights;
  }
}
