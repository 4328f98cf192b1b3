/** Reads one outline. Nothing here blocks the page: it is a worker, which ends with the file. */
import { Refusal, type Count, type Told } from '../svg/refusal';
import { outlines, type Try } from './read';

/** What the worker gets. */
export type Order = [text: string, side: number];

/** What it says: how far it is, then the outlines; or what is wrong with the file; or what went wrong here. */
export type Said = { progress: number } | { tries: Try[] } | { refused: Told; left: Count } | { trouble: string };

/** The least step of the progress that is told. */
const STEP = 0.01;

const say = (said: Said): void => postMessage(said);

addEventListener('message', ({ data: [text, side] }: MessageEvent<Order>) => {
  let told = 0;
  const progress = (done: number): void => {
    if (done >= told + STEP) say({ progress: (told = done) });
  };
  try {
    say({ tries: outlines(text, side, progress) });
  } catch (error) {
    if (error instanceof Refusal) say({ refused: error.told, left: error.left });
    else say({ trouble: error instanceof Error ? error.message : String(error) });
  }
});
