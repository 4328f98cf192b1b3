/**
 * Runs a forming up to one step of its packing and pauses it there, or at the packing's end if that comes earlier. It may
 * rewind first, to the step that the engine holds.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';

export class Until {
  /** The steps made, once the forming is paused; undefined before. */
  made: number | undefined;
  /** The number of steps before the last one, which may count for several. */
  before = 0;
  private readonly step: number;
  /** Called when the forming is paused. */
  readonly held: (steps: number) => void;
  /** Whether nothing is drawn on the way, which then takes as little time as it can. */
  readonly unseen: boolean;
  private rewinds: boolean;

  constructor(step: number, held: (steps: number) => void, how?: 'unseen' | 'rewound') {
    this.step = step;
    this.held = held;
    this.unseen = how !== undefined;
    this.rewinds = how === 'rewound';
  }

  /** Works for about `budget` milliseconds and makes at most `steps` steps; true if the picture may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean {
    const end = performance.now() + budget;
    const { stepping } = engine.generator;
    let changed = false;
    if (this.rewinds) {
      if (!engine.reach(budget)) return false;
      this.rewinds = false;
      engine.restart();
    }
    for (let left = this.unseen ? Infinity : steps; performance.now() < end; ) {
      if (this.isPast(engine)) break;
      // Runs one slice of anything but a packing step. If there is none, a packing step is next, and the count of
      // steps is that of this packing.
      if (engine.tick(0, 0)) {
        changed = true;
        continue;
      }
      const { steps: now } = engine.status();
      if (engine.stage() !== stepping || now >= this.step) {
        this.made = now;
        break;
      } else if (left >= 1) {
        left -= 1;
        this.before = now;
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
