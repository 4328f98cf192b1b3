/**
 * Two linked pictures that form in step. While both are packed they make equally many steps, at the pace of the slower
 * one. Before and after that, each goes on by itself.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';

export class Together {
  private readonly first: Engine;
  private readonly second: Engine;

  /** `first` is the picture whose frames advance both. */
  constructor(first: Engine, second: Engine) {
    this.first = first;
    this.second = second;
  }

  /**
   * Works on one of the two for about `budget` milliseconds and at most `steps` steps. True when the visible state may
   * have changed.
   */
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

  /** Makes the steps of both in turn. The picture that is behind comes first. */
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

  /** Makes the steps by which the first picture is ahead, even while both are paused. */
  private catchUp(budget: number): boolean {
    const { first, second } = this;
    const end = performance.now() + budget;
    // Before its packing, the first one may still report the steps of the previous packing.
    if (!isPast(first) && !isAtStep(first)) return false;
    let changed = false;
    while (performance.now() < end && isAtStep(second) && second.status().steps < first.status().steps) changed = second.tick(0, 1) || changed;
    return changed;
  }
}

/** Whether packing is over. */
function isPast(engine: Engine): boolean {
  const stage = engine.stage();
  return isEnd(stage) || !isUpToSteps(engine.generator, stage);
}

/** Whether a packing step is next. Does any work that is due before it. */
function isAtStep(engine: Engine): boolean {
  return engine.stage() === engine.generator.stepping && !engine.tick(0, 0);
}
