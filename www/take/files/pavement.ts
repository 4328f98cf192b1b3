/** Makes a studio's picture from its start to its end. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { progressOf } from '../../module/stages';
import type { Status } from '../../module/types';
import { Refusal } from './refusal';

/** Milliseconds of work between two reports of progress. */
export const BUDGET = 50;

/** More packing steps than fit into that. */
const STEPS = 100_000;

/** Gets how much is done, 0..1. */
export type Progress = (done: number) => void;

/** Where somebody looks on, one step of the packing or one stone is made at a time. Throws a Refusal where there is no picture. */
export function pavement(studio: Bubblestone, stages: readonly string[], progress: Progress, looksOn?: (stage: string, status: Status) => void): void {
  for (;;) {
    const stage = studio.stage();
    const status = studio.status();
    const problem = studio.problem();
    if (problem) throw new Refusal(problem);
    if (stage === 'done') return;
    looksOn?.(stage, status);
    progress(progressOf(stages, stage, status));
    studio.tick(looksOn ? 0 : BUDGET, looksOn ? 1 : STEPS);
  }
}
