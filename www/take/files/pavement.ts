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
  for (const [stage, status] of making(studio, looksOn ? 0 : BUDGET, looksOn ? 1 : STEPS)) {
    looksOn?.(stage, status);
    progress(progressOf(stages, stage, status));
  }
}

/** How far a picture is before each slice of its work: of so many milliseconds, and steps of the packing. Throws the same. */
export function* making(studio: Bubblestone, budget: number, steps: number): Generator<[stage: string, status: Status]> {
  for (;;) {
    const [stage, status] = [studio.stage(), studio.status()];
    const problem = studio.problem();
    if (problem) throw new Refusal(problem);
    if (stage === 'done') return;
    yield [stage, status];
    studio.tick(budget, steps);
  }
}
