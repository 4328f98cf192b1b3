/** The stages of the work as the page sees them: whether all is done, and how far it is. Each generator tells its own. */
import type { Generator, Status } from './types';

/** The stages of a generator, and how they go on. */
export type Course = Pick<Generator, 'stages' | 'begins' | 'stepping' | 'placing' | 'settled'>;

/** Whether there is no work left at this stage. */
export function isEnd(stage: string): boolean {
  return stage === 'done' || stage === 'error';
}

/** Whether a stage comes before the one that goes in steps, or is that one; where nothing does, a pause holds nothing. */
export function isUpToSteps({ stages, stepping }: Course, stage: string): boolean {
  const last = stages.indexOf(stepping);
  return last < 0 || stages.indexOf(stage) <= last;
}

/** Whether the bodies stay as they are: the rest of the work is a picture of them. */
export function isSettled({ stages, settled }: Course, stage: string): boolean {
  const first = stages.indexOf(settled);
  return stage === 'done' || (first >= 0 && stages.indexOf(stage) >= first);
}

/** After these packing steps the rest of the way is taken to be half as long, as nobody knows how many it takes. */
const HALF = 60;

/**
 * How far the work on a picture is, about: 0..1, and never less than before while a picture is made. Stages of which
 * nothing is known take even shares.
 */
export function progressOf({ stages, begins, stepping, placing }: Course, stage: string, { steps, stones, cells }: Status): number {
  const at = stages.indexOf(stage);
  if (at < 0) return 1;
  const beginOf = (place: number): number => (place < stages.length ? (begins[place] ?? place / stages.length) : 1);
  const [begin, end] = [beginOf(at), beginOf(at + 1)];
  const within = stage === stepping ? 1 - 2 ** (-steps / HALF) : stage === placing && cells ? Math.min(1, stones / cells) : 0;
  return begin + (end - begin) * within;
}
