/**
 * The pace of a forming that somebody watches. It goes by the clock, so that it lasts as long on a fast machine as on a
 * slow one; the clock tells only when things are made, never what is made.
 */
import type { Course } from '../module/stages';
import type { Engine } from '../state/engine';

/** Milliseconds in which cells are packed, then stand as polygons, then get their stones. */
const PACKING = 2100;
const STANDING = 350;
const STONES = 1000;

/** Steps of a packing of which nothing is known yet. */
const STEPS = 45;

/** Milliseconds that a frame may take off the time: a page that was hidden goes on where it was. */
const LONGEST = 300;

/** This part of the packing goes by before what is seen is called settling. */
const SETTLING = 0.62;

/** What is seen, in the order in which it comes. */
export const PHASES = ['push', 'settle', 'stone'] as const;
export type Phase = (typeof PHASES)[number];

export class Watch {
  /** Steps that the packing takes, as far as known. */
  expected = STEPS;
  private last: number | undefined;
  private stage = '';
  private readonly course: Course;
  /** Milliseconds of the stage at work. */
  private passed = 0;
  /** The fraction of a packing step that is due but not made yet. */
  private due = 0;

  /** How the stages go on in what is watched. */
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
   * Does what is due in a frame that begins now, within `budget` milliseconds; true when what is shown may have changed.
   * `steps` are those of the packing where the visitor asked for fewer than would fit in.
   */
  tick(engine: Engine, now: number, budget: number, steps?: number): boolean {
    const before = this.follow(engine.stage(), now);
    if (this.stage === this.course.stepping) return engine.tick(budget, steps ?? this.steps(before));
    return this.stage === this.course.placing ? this.stones(engine, budget) : engine.tick(budget, 0);
  }

  /** Counts the time of the stage; answers what it was before. */
  private follow(stage: string, now: number): number {
    if (stage !== this.stage) [this.stage, this.passed, this.due] = [stage, 0, 0];
    const before = this.passed;
    this.passed += Math.min(now - (this.last ?? now), LONGEST);
    this.last = now;
    return before;
  }

  /** Few at first, when each of them moves much. */
  private steps(before: number): number {
    const way = (at: number): number => 0.5 * at + 0.5 * Math.min(at, 1) * at;
    this.due += this.expected * (way(this.passed / PACKING) - way(before / PACKING));
    const whole = Math.floor(this.due);
    this.due -= whole;
    return whole;
  }

  /** One after the other, as many as there should be by now. */
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
