/** The stages of the work for the page: whether all is done, and the progress. Each generator defines its own stages. */
import type { Generator, Status } from './types';

/** The stages of a generator, and their order. */
export type Course = Pick<Generator, 'stages' | 'begins' | 'stepping' | 'placing' | 'settled'>;

/** Whether there is no work left at this stage. */
export function isEnd(stage: string): boolean {
  return stage === 'done' || stage === 'error';
}

/**
 * Whether a stage is the one of single steps, or comes before it. If no stage has steps, this is true for all, and a
 * pause holds nothing.
 */
export function isUpToSteps({ stages, stepping }: Course, stage: string): boolean {
  const last = stages.indexOf(stepping);
  return last < 0 || stages.indexOf(stage) <= last;
}

/** Whether the bodies no longer change, so that the rest of the work is a picture of them. */
export function isSettled({ stages, settled }: Course, stage: string): boolean {
  const first = stages.indexOf(settled);
  return stage === 'done' || (first >= 0 && stages.indexOf(stage) >= first);
}

/** The number of steps is unknown, so every HALF steps count as half of the progress that is left in the stage. */
const HALF = 60;

/**
 * The approximate progress of the work on a picture, 0..1, which never decreases. Stages without a known beginning
 * have equal shares.
 */
export function progressOf({ stages, begins, stepping, placing }: Course, stage: string, { steps, stones, cells }: Status): number {
  const at = stages.indexOf(stage);
  if (at < 0) return 1;
  const beginOf = (place: number): number => (place < stages.length ? (begins[place] ?? place / stages.length) : 1);
  const [begin, end] = [beginOf(at), beginOf(at + 1)];
  const within = stage === stepping ? 1 - 2 ** (-steps / HALF) : stage === placing && cells ? Math.min(1, stones / cells) : 0;
  return begin + (end - begin) * within;
}

/** Whether each step places bodies, so that no stage after the steps does. */
export function isPlacedByStep({ stepping, placing }: Course): boolean {
  return stepping === placing && stepping !== '';
}

/** The things that a generator counts: cells, the bodies of a pile, or blocks that are laid one by one. */
export function countedBy(course: Course & { readonly offers: readonly string[] }): 'cells' | 'bodies' | 'blocks' {
  if (course.offers.includes('bodies')) return 'bodies';
  return isPlacedByStep(course) ? 'blocks' : 'cells';
}
