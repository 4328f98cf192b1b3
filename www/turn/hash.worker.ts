/** Runs a recipe and makes one frame of its bodies, only for its hash. */
import { serve } from '../late/worker';
import { studioFor } from '../module/given';
import { loadWhole } from '../module/load';
import { BUDGET, finish } from '../module/run';

/** The recipe, and the camera. */
export type HashRequest = [link: string, camera: string];

export interface HashResult {
  hash: string;
}

serve(async ([link, camera]: HashRequest): Promise<HashResult> => {
  const module = await loadWhole();
  const studio = await studioFor(module, link);
  finish(studio);
  const problem = studio.problem();
  if (problem) return { hash: problem.text };
  const side = studio.side();
  for (;;) {
    const slice = studio.turn('', camera, side, side, 'still', BUDGET);
    if ('code' in slice) return { hash: slice.text };
    if (slice.done) return { hash: studio.frameHash() };
  }
});
