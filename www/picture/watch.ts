/**
 * The pace of a forming that a visitor watches. It goes by the clock, so that it takes the same time on fast and slow
 * machines. The clock decides only when things are made, never the result.
 */
import { isPlacedByStep, type Course } from '../module/stages';
import type { Engine } from '../state/engine';

/** Milliseconds for the packing, for the cells as polygons, and for the stones. */
const PACKING = 2100;
const STANDING = 350;
const STONES = 1000;

/** Milliseconds for all bodies where each step places some. */
const PLACED = 4000;

/** The assumed steps of a packing whose number of steps is unknown. */
const STEPS = 45;

/** The most milliseconds that one frame counts, so that a page that was hidden goes on where it was. */
const LONGEST = 300;

/** The share of the packing's time after which the subtitle calls it settling. */
const SETTLING = 0.62;

/** The phases of the subtitle, in their order. */
export const PHASES = ['push', 'settle', 'stone'] as const;
export type Phase = (typeof PHASES)[number];

export class Watch {
  /** The number of steps, if it is known. */
  expected: number | undefined;
  private last: number | undefined;
  private stage = '';
  private readonly course: Course;
  /** Milliseconds spent in the present stage. */
  private passed = 0;
  /** The fraction of a packing step that is due but not made yet. */
  private due = 0;

  /** `course` is the order of the stages. */
  constructor(course: Course) {
    this.course = course;
  }

  get phase(): Phase {
    const { stages, stepping, placing } = this.course;
    const at = stages.indexOf(this.stage);
    const steps = stages.indexOf(stepping);
    if (at < steps || (at === steps && this.passed < SETTLING * PACKING)) return 'push';
    return at < stages.indexOf(placing) ? 'settle' : 'stone';
  }

  /**
   * Does the work that is due in a frame that begins at `now`, within `budget` milliseconds; true if the picture may
   * have changed. `steps` limits the packing steps if the visitor asked for fewer.
   */
  tick(engine: Engine, now: number, budget: number, steps?: number): boolean {
    const before = this.follow(engine.stage(), now);
    if (this.stage === this.course.stepping) {
      if (steps !== undefined) return engine.tick(budget, steps);
      return isPlacedByStep(this.course) ? this.placed(engine, budget) : engine.tick(budget, this.steps(before));
    }
    return this.stage === this.course.placing ? this.stones(engine, budget) : engine.tick(budget, 0);
  }

  /** Adds to the time of the stage; returns the time before. */
  private follow(stage: string, now: number): number {
    if (stage !== this.stage) [this.stage, this.passed, this.due] = [stage, 0, 0];
    const before = this.passed;
    this.passed += Math.min(now - (this.last ?? now), LONGEST);
    this.last = now;
    return before;
  }

  /** The whole steps that are due. The rate is low at first, because each early step moves much. */
  private steps(before: number): number {
    const way = (at: number): number => 0.5 * at + 0.5 * Math.min(at, 1) * at;
    this.due += (this.expected ?? STEPS) * (way(this.passed / PACKING) - way(before / PACKING));
    const whole = Math.floor(this.due);
    this.due -= whole;
    return whole;
  }

  /** Makes steps until as many bodies as are due by now have their places. If their number is unknown, all are due. */
  private placed(engine: Engine, budget: number): boolean {
    const all = this.expected ?? 0;
    const due = (this.passed / PLACED) * all;
    const end = performance.now() + budget;
    let changed = false;
    while (engine.stage() === this.stage && performance.now() < end) {
      const { steps } = engine.status();
      // Once all bodies have their places, one more slice ends the stage.
      if (steps >= due && steps < all) break;
      changed = engine.tick(0, 1) || changed;
    }
    return changed;
  }

  /** Makes one stone after the other, as many as are due by now. */
  private stones(engine: Engine, budget: number): boolean {
    const share = (this.passed - STANDING) / STONES;
    const end = performance.now() + budget;
    let changed = false;
    while (engine.stage() === this.stage && performance.now() < end) {
      const { stones, cells } = engine.status();
      if (stones >= share * cells) break;
      changed = engine.tick(0, 0) || changed;
    }
    return changed;
  }
}
