/** Reads one outline. Nothing here blocks the page: it is a worker, which ends with the file. */
import { serve } from '../../late/worker';
import { Refusal, type Count, type Told } from '../svg/refusal';
import { outlines, type Try } from './read';

/** What the worker gets. */
export type Order = [text: string, side: number];

/** What it answers: the outlines, or what is wrong with the file. */
export type Answer = { tries: Try[] } | { refused: Told; left: Count };

serve(([text, side]: Order, progress): Answer => {
  try {
    return { tries: outlines(text, side, progress) };
  } catch (error) {
    if (error instanceof Refusal) return { refused: error.told, left: error.left };
    throw error;
  }
});
