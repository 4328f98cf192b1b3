/** Runs a recipe from its start to its end, in slices. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { Module } from './load';
import { isEnd } from './stages';
import type { Generator as Made, Status } from './types';

/** Milliseconds of work in one slice, and more steps than this time ever allows. */
export const BUDGET = 50;
const STEPS = 100_000;

/** Something that works on a recipe: a studio, or an engine of the page. */
type Worker = Pick<Bubblestone, 'stage' | 'status' | 'tick'>;

/**
 * Yields stage and status before each slice, which is limited by milliseconds and steps. It ends when no work is
 * left.
 */
export function* making(worker: Worker, budget = BUDGET, steps = STEPS): Generator<[stage: string, status: Status], undefined> {
  for (let stage = worker.stage(); !isEnd(stage); stage = worker.stage()) {
    yield [stage, worker.status()];
    worker.tick(budget, steps);
  }
}

/** Works on a recipe until no work is left. */
export function finish(worker: Worker): void {
  for (const work = making(worker); !work.next().done; );
}

/** The present generator of a studio. */
export function generatorOf({ generators }: Pick<Module, 'generators'>, studio: Bubblestone): Made {
  const word = studio.generator();
  const found = generators().find((one) => one.word === word);
  if (!found) throw new Error(`This module has no generator of the word “${word}”.`);
  return found;
}
