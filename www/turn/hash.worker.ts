/** Works a recipe out anew, and a frame of its bodies: its hash is all that is asked for. */
import { serve } from '../late/worker';
import { loadWhole } from '../module/load';

/** The recipe, and where it is seen from. */
export type Order = [link: string, camera: string];

export interface Answer {
  hash: string;
}

serve(async ([link, camera]: Order): Promise<Answer> => {
  const module = await loadWhole();
  return { hash: module.frame_of_link(link, camera) };
});
