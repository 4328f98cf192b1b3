/** Works a recipe out anew, and a frame of its bodies: its hash is all that is asked for. */
import { serve } from '../late/worker';
import { studioFor } from '../module/given';
import { loadWhole } from '../module/load';
import { isEnd } from '../module/stages';

/** The recipe, and where it is seen from. */
export type Order = [link: string, camera: string];

export interface Answer {
  hash: string;
}

/** Milliseconds of work in one call, and more packing steps than fit into that. */
const BUDGET = 50;
const STEPS = 100_000;

serve(async ([link, camera]: Order): Promise<Answer> => {
  const module = await loadWhole();
  const studio = await studioFor(module, link);
  while (!isEnd(studio.stage())) studio.tick(BUDGET, STEPS);
  const problem = studio.problem();
  if (problem) return { hash: problem.text };
  const side = studio.side();
  for (;;) {
    const slice = studio.turn('', camera, side, side, 'still', BUDGET);
    if ('code' in slice) return { hash: slice.text };
    if (slice.done) return { hash: studio.frameHash() };
  }
});
