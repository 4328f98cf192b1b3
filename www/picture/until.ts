/** A forming that runs up to one step of its packing, and is held there; where the packing ends before, at its end. */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';

export class Until {
  /** The steps that were made, once it is held. */
  made: number | undefined;
  private readonly step: number;
  /** Is called when it is held. */
  readonly held: (steps: number) => void;

  constructor(step: number, held: (steps: number) => void) {
    this.step = step;
    this.held = held;
  }

  /** Works for about `budget` milliseconds, and makes at most so many steps; true when what is shown may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean {
    const end = performance.now() + budget;
    const { stepping } = engine.generator;
    let changed = false;
    for (let left = steps; performance.now() < end; ) {
      if (this.isPast(engine)) break;
      // One slice of anything but a step: where there is none, a step is next, and what is counted is the packing at work.
      if (engine.tick(0, 0)) changed = true;
      else if (engine.stage() !== stepping || engine.status().steps >= this.step) {
        this.made = engine.status().steps;
        break;
      } else if (left >= 1) {
        left -= 1;
        changed = engine.tick(0, 1) || changed;
      } else break;
    }
    return changed;
  }

  /** Whether the packing is over. */
  private isPast(engine: Engine): boolean {
    const stage = engine.stage();
    if (!isEnd(stage) && isUpToSteps(engine.generator, stage)) return false;
    this.made = engine.status().steps;
    return true;
  }
}
