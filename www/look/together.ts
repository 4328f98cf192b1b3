/**
 * Two pictures that form in step: while both are packed they have made as many steps, whichever of them is the slower one.
 * Before and after that each goes on by itself.
 */
import { isEnd, isUpToSteps, STEPPING } from '../module/stages';
import type { Engine } from '../state/engine';

export class Together {
  private readonly first: Engine;
  private readonly second: Engine;

  /** The first one leads: its frames make the steps of both. */
  constructor(first: Engine, second: Engine) {
    this.first = first;
    this.second = second;
  }

  /** Works on one of both for about `budget` milliseconds, and makes at most so many steps; true when what is shown may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean {
    const { first, second } = this;
    const other = engine === first ? second : first;
    if (isPast(engine)) return engine.tick(budget, 0);
    if (engine.tick(budget, 0)) return true;
    if (!isAtStep(engine)) return false;
    if (engine === second && this.catchUp(budget)) return true;
    if (isPast(other)) return steps > 0 && engine.tick(budget, steps);
    return engine === first && this.lead(budget, steps);
  }

  /** The steps of both, one after the other; where one is behind, it comes first. */
  private lead(budget: number, steps: number): boolean {
    const { first, second } = this;
    const end = performance.now() + budget;
    let changed = false;
    for (let left = steps; performance.now() < end && isAtStep(first) && isAtStep(second); ) {
      const ahead = first.status().steps - second.status().steps;
      if (ahead === 0 && left < 1) break;
      if (ahead <= 0) first.tick(0, 1);
      if (ahead === 0) left -= 1;
      if (ahead >= 0) second.tick(0, 1);
      changed = true;
    }
    return changed;
  }

  /** Makes the steps that the first one has ahead: also while a pause holds both. */
  private catchUp(budget: number): boolean {
    const { first, second } = this;
    const end = performance.now() + budget;
    // Before its packing, the first one may tell the steps of the one before.
    if (!isPast(first) && !isAtStep(first)) return false;
    let changed = false;
    while (performance.now() < end && isAtStep(second) && second.status().steps < first.status().steps) changed = second.tick(0, 1) || changed;
    return changed;
  }
}

/** Whether the packing is over. */
function isPast(engine: Engine): boolean {
  const stage = engine.stage();
  return isEnd(stage) || !isUpToSteps(engine.generator.stages, stage);
}

/** Whether a step is next; whatever else is to be done before it is begun. */
function isAtStep(engine: Engine): boolean {
  return engine.stage() === STEPPING && !engine.tick(0, 0);
}
