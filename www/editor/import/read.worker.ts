/** A worker that reads one outline, so that the page stays responsive. It ends with the file. */
import { serve } from '../../late/worker';
import { Refusal, type Count, type RefusalReason } from '../svg/refusal';
import { outlines, type Try } from './read';

/** The worker's input. */
export type ReadRequest = [text: string, side: number];

/** The worker's answer: the outlines, or the reason why the file was refused. */
export type ReadResult = { tries: Try[] } | { refused: RefusalReason; left: Count };

serve(([text, side]: ReadRequest, progress): ReadResult => {
  try {
    return { tries: outlines(text, side, progress) };
  } catch (error) {
    if (error instanceof Refusal) return { refused: error.told, left: error.left };
    throw error;
  }
});
