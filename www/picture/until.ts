/**
 * A forming that runs up to one step of its packing and is held there, or at the end of the packing if that comes
 * first.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';

export class Until {
  /** The steps made, once it is held. */
  made: number | undefined;
  private readonly step: number;
  /** Called when it is held. */
  readonly held: (steps: number) => void;

  constructor(step: number, held: (steps: number) => void) {
    this.step = step;
    this.held = held;
  }

  /** Works for about `budget` milliseconds and makes at most `steps` steps; true if the display may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean {
    const end = performance.now() + budget;
    const { stepping } = engine.generator;
    let changed = false;
    for (let left = steps; performance.now() < end; ) {
      if (this.isPast(engine)) break;
      // Do one slice without a step. If there was none to do, a step is next, and the count is that of the current
      // packing.
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
