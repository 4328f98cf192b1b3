/**
 * The animation frames: a slice of work in each; no frames when there is nothing to do or to show.
 *
 * A frame works for some milliseconds and then draws. If both would take long, the next frame only draws. Drawings
 * of many shapes are made some rows at a time over several frames while the work stands still; the pixels are the
 * same as if drawn at once. Scripts get the digest only when its picture is drawn.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';
import type { Until } from './until';
import type { Watch } from './watch';

/** Milliseconds of work in a frame; the rest of the frame belongs to the browser. */
const BUDGET = 12;

/**
 * A drawing that takes more milliseconds than the first number is made in some frames only: it may take this share
 * of the time.
 */
const DRAWN_ALWAYS = 8;
const DRAWING_SHARE = 0.25;

/** Milliseconds after which a page without cells shows the bare ground. */
const BARE = 250;

/** If work and drawing would take more milliseconds than this, a frame only works, and the next one only draws. */
const LONG = 32;

/** Milliseconds of a frame for a piece of a drawing. */
const PIECE = 16;

/** Runs the work of two pictures that advance together. */
interface Pair {
  /** Works for about `budget` milliseconds and makes at most `steps` steps; true if the display may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean;
}

/** Draws instead of the view, if there is one; it works in pieces as well. */
export interface Painter {
  /** The share of the time that it may take while the work goes on. */
  readonly share: number;
  /** Notes that its subject may look different now. */
  changed(): void;
  /** Works for about `budget` milliseconds; true if nothing is left to do before the work goes on. */
  advance(budget: number): boolean;
}

export class Loop {
  /** The most packing steps in a frame; below 1, several frames share one step. */
  stepsPerFrame = 1;
  /** The pace while somebody watches the forming. */
  watch: Watch | undefined;
  /**
   * The step up to which the packing runs, to be held there. A pause before that, or a change of the recipe, drops
   * it.
   */
  until: Until | undefined;
  /** Another picture that advances together with this one. */
  pair: Pair | undefined;
  painter: Painter | undefined;
  private readonly ending = new AbortController();
  private credit = 0;
  private readonly engine: Engine;
  private readonly view: (stage: string) => string | undefined;
  private readonly drawn: (stage: string, changed: boolean) => void;
  private held = false;
  /** While held: run up to the packing, or on from a finished packing, but take no packing step. */
  private settling = false;
  private dirty = false;
  private frame = 0;
  /**
   * Drawings of work in progress wait until this time. Requested drawings, the first cells and results are drawn at
   * once.
   */
  private nextDrawing = 0;
  /**
   * An estimate of how long the rest of a drawing takes once its pieces are made, from the last ones. The first one
   * is unknown.
   */
  private drawing = LONG;
  /** How long the pieces of the next drawing have taken so far. */
  private pieces = 0;
  /** The next frame draws the results of this one, and does no work. */
  private owed = false;
  private spared = false;

  /** `view` gives the view to draw at a stage, if any. `drawn` is called in every frame in which something was done. */
  constructor(engine: Engine, view: (stage: string) => string | undefined, drawn: (stage: string, changed: boolean) => void) {
    this.engine = engine;
    this.view = view;
    this.drawn = drawn;
    document.addEventListener('visibilitychange', () => this.wake(), this.ending);
  }

  get paused(): boolean {
    return this.held;
  }

  set paused(paused: boolean) {
    this.held = paused;
    this.until = undefined;
    // Without cells, the work goes on to the first ones; a step of many cells may take several slices.
    const { generator } = this.engine;
    const stage = this.engine.stage();
    this.settling = isUpToSteps(generator, stage) || (this.painter !== undefined && stage === generator.stepping);
    // A pause shows the step that it holds, which may not be drawn yet.
    this.redraw();
  }

  /** Whether no work is left, apart from what a pause holds. */
  get stands(): boolean {
    return isEnd(this.engine.stage()) || (this.held && !this.settling);
  }

  /** Stops all frames. */
  end(): void {
    this.ending.abort();
    cancelAnimationFrame(this.frame);
  }

  /** Whether nothing is left to do or to draw, or the page is hidden. */
  get rests(): boolean {
    return this.frame === 0;
  }

  /** Starts the work. Cells are the first thing to be drawn, unless they take long. */
  begin(): void {
    this.nextDrawing = performance.now() + BARE;
    this.settling = true;
    this.wake();
  }

  /** After a change of the recipe: works and draws again, up to where a pause holds the packing. */
  changed(): void {
    this.settling = true;
    this.redraw();
  }

  /** After a change of the display: draws again, without new work. */
  redraw(): void {
    this.painter?.changed();
    this.look();
  }

  /** Asks for another frame to draw. */
  look(): void {
    this.dirty = true;
    this.wake();
  }

  /** Leaves the next frame to the browser, which has new elements to lay out. */
  spare(): void {
    this.spared = true;
  }

  private wake(): void {
    if (!this.frame && !document.hidden) this.frame = requestAnimationFrame((begin) => this.run(begin));
  }

  /** Whole steps for this frame; the fraction goes to the next one. */
  private stepsNow(): number {
    this.credit += this.stepsPerFrame;
    const steps = Math.floor(this.credit);
    this.credit -= steps;
    return steps;
  }

  /** Works on the pieces of a drawing; true when they are made. */
  private prepared(stage: string): boolean {
    const view = this.view(stage);
    if (view === undefined) return true;
    const begin = performance.now();
    const ready = this.painter ? this.painter.advance(PIECE) : this.engine.prepare(view, PIECE);
    this.pieces += performance.now() - begin;
    return ready;
  }

  private show(stage: string, draw: boolean): void {
    const begin = performance.now();
    this.drawn(stage, draw);
    if (!draw) return;
    const end = performance.now();
    this.drawing = Math.max(end - begin, 0.8 * this.drawing);
    const spent = end - begin + this.pieces;
    this.pieces = 0;
    this.nextDrawing = spent > DRAWN_ALWAYS ? end + spent * (1 / (this.painter?.share ?? DRAWING_SHARE) - 1) : end;
  }

  /** A frame that began at `begin`. */
  private run(begin: number): void {
    this.frame = 0;
    if (document.hidden || !this.engine.alive) return;
    if (this.spared) {
      this.spared = false;
      return this.wake();
    }
    const { stepping } = this.engine.generator;
    const before = this.engine.stage();
    const working = !this.owed && !isEnd(before) && (!this.held || this.settling);
    const changed = working && this.work(begin);
    this.hold();
    const stage = this.engine.stage();
    if (changed || stage !== before) this.painter?.changed();
    // While held, work ends where only packing steps are left. The packing's first cells may take a slice of their
    // own.
    if (isEnd(stage) || (working && this.held && stage === stepping && !changed)) {
      // The state is final now and can be drawn better.
      if (this.settling && this.painter) this.dirty = true;
      this.settling = false;
    }
    const now = changed ? performance.now() : begin;
    const due = changed && now >= this.nextDrawing;
    const draw = this.owed || this.dirty || due || isEnd(stage) || (stage !== before && (this.held || stage === stepping));
    const isLong = working && now - begin + (this.painter ? PIECE : this.drawing) > LONG;
    // A painter may ask for another frame.
    if (this.painter) this.dirty = false;
    this.owed = draw && (isLong || !this.prepared(stage));
    if (this.owed) return this.wake();
    if (!this.painter) this.dirty = false;
    this.show(stage, draw);
    if (!isEnd(stage) && (!this.held || this.settling)) this.wake();
  }

  /** Pauses once the packing has reached the step to hold at. */
  private hold(): void {
    const { until } = this;
    if (until?.made === undefined) return;
    this.paused = true;
    until.held(until.made);
  }

  /** Does a slice of work in a frame that began at `begin`; true if the display may have changed. */
  private work(begin: number): boolean {
    const { engine, watch } = this;
    // The other picture gets the other half of the time.
    if (this.pair && !this.until) return this.pair.tick(engine, BUDGET / 2, this.held ? 0 : this.stepsNow());
    if (this.held) return engine.tick(BUDGET, 0);
    if (this.until) return this.until.tick(engine, BUDGET, this.stepsNow());
    if (!watch) return engine.tick(BUDGET, this.stepsNow());
    // If slow steps are wanted, take them as they are.
    return watch.tick(engine, begin, BUDGET, this.stepsPerFrame < 1 ? this.stepsNow() : undefined);
  }
}
