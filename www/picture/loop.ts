/**
 * The animation frames: a slice of work in each, none when there is nothing to do or to see.
 *
 * A frame works for some milliseconds and draws. Where both would take long, the next frame draws and does nothing
 * else. Drawings of many shapes are drawn some rows at a time over as many frames as that takes, while the work stands
 * still; drawn at once they are the same pixels. The digest is told to scripts only when its picture is drawn.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import type { Engine } from '../state/engine';
import type { Until } from './until';
import type { Watch } from './watch';

/** Milliseconds of work in a frame; the rest of it belongs to the browser. */
const BUDGET = 12;

/** Drawing that takes longer than this many milliseconds is done in some frames only: it may take this part of the time. */
const DRAWN_ALWAYS = 8;
const DRAWING_SHARE = 0.25;

/** Milliseconds after which a page that has no cells yet shows the bare ground. */
const BARE = 250;

/** A frame in which work and drawing would take longer than this only works, and the next one only draws. */
const LONG = 32;

/** Milliseconds of a frame for a drawing that is made in pieces, over as many frames as it takes. */
const PIECE = 16;

/** What decides how the work goes on in a frame, where two pictures go on together. */
interface Pair {
  /** Works for about `budget` milliseconds and makes at most so many steps; true when what is shown may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean;
}

/** What is seen instead of the view's drawing, while there is such a thing: it is made in pieces as well. */
export interface Painter {
  /** The part of the time that it may take while the work goes on. */
  readonly share: number;
  /** What is made may look otherwise now. */
  changed(): void;
  /** Works for about `budget` milliseconds; true when nothing is left to be done before the work goes on. */
  advance(budget: number): boolean;
}

export class Loop {
  /** Packing steps that a frame may take at most; below 1, several frames share one. */
  stepsPerFrame = 1;
  /** The pace while somebody watches. */
  watch: Watch | undefined;
  /** The step up to which the packing runs, to be held there; who pauses before that, or changes what is made, lets it be. */
  until: Until | undefined;
  /** Another picture that goes on together with this one. */
  pair: Pair | undefined;
  painter: Painter | undefined;
  private readonly ending = new AbortController();
  private credit = 0;
  private readonly engine: Engine;
  private readonly view: (stage: string) => string | undefined;
  private readonly drawn: (stage: string, changed: boolean) => void;
  private held = false;
  /** While held: run up to the packing and what follows a finished packing, but take no packing step. */
  private settling = false;
  private dirty = false;
  private frame = 0;
  /** Not before this time is work in progress drawn again; what was asked for, the first cells and what is done are drawn at once. */
  private nextDrawing = 0;
  /** What is left of a drawing takes so long when its pieces are made, as those of late took: nobody knows of the first one. */
  private drawing = LONG;
  /** What the pieces of the next drawing took so far. */
  private pieces = 0;
  /** The next frame draws what was done in this one, and does no work. */
  private owed = false;
  private spared = false;

  /** `view` is what is to be drawn at a stage, if anything; `drawn` is called in every frame in which something was done. */
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
    // Work without cells goes on to the first ones; a step of many cells may take several slices.
    const { generator } = this.engine;
    const stage = this.engine.stage();
    this.settling = isUpToSteps(generator, stage) || (this.painter !== undefined && stage === generator.stepping);
    // A pause shows the step that it holds, which may not have been drawn.
    this.redraw();
  }

  /** No work is left but what a pause holds. */
  get stands(): boolean {
    return isEnd(this.engine.stage()) || (this.held && !this.settling);
  }

  /** No frame comes any more. */
  end(): void {
    this.ending.abort();
    cancelAnimationFrame(this.frame);
  }

  /** Nothing is left to do or to draw, or nobody sees it. */
  get rests(): boolean {
    return this.frame === 0;
  }

  /** The first work: cells are the first thing to be drawn, unless they take long. */
  begin(): void {
    this.nextDrawing = performance.now() + BARE;
    this.settling = true;
    this.wake();
  }

  /** Something was changed: work and draw again, up to where a pause holds the packing. */
  changed(): void {
    this.settling = true;
    this.redraw();
  }

  /** What is to be seen was changed, but not what it is made of. */
  redraw(): void {
    this.painter?.changed();
    this.look();
  }

  /** There is more to be painted. */
  look(): void {
    this.dirty = true;
    this.wake();
  }

  /** The next frame is left to the browser, which has something new to lay out. */
  spare(): void {
    this.spared = true;
  }

  private wake(): void {
    if (!this.frame && !document.hidden) this.frame = requestAnimationFrame((begin) => this.run(begin));
  }

  /** Whole steps for this frame; what is left over goes to the next one. */
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

  /** `begin` is when the frame began. */
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
    // Held, work ends where only packing steps are left: the packing's first cells may take a slice of their own.
    if (isEnd(stage) || (working && this.held && stage === stepping && !changed)) {
      // What stands from now on is painted better.
      if (this.settling && this.painter) this.dirty = true;
      this.settling = false;
    }
    const now = changed ? performance.now() : begin;
    const due = changed && now >= this.nextDrawing;
    const draw = this.owed || this.dirty || due || isEnd(stage) || (stage !== before && (this.held || stage === stepping));
    const isLong = working && now - begin + (this.painter ? PIECE : this.drawing) > LONG;
    // A painter may ask for more, which comes next.
    if (this.painter) this.dirty = false;
    this.owed = draw && (isLong || !this.prepared(stage));
    if (this.owed) return this.wake();
    if (!this.painter) this.dirty = false;
    this.show(stage, draw);
    if (!isEnd(stage) && (!this.held || this.settling)) this.wake();
  }

  /** Pauses where the packing came to the step that it was to run to. */
  private hold(): void {
    const { until } = this;
    if (until?.made === undefined) return;
    this.paused = true;
    until.held(until.made);
  }

  /** A slice of the work in a frame that began then; true when what is shown may have changed. */
  private work(begin: number): boolean {
    const { engine, watch } = this;
    // The other one has the other half of the time.
    if (this.pair && !this.until) return this.pair.tick(engine, BUDGET / 2, this.held ? 0 : this.stepsNow());
    if (this.held) return engine.tick(BUDGET, 0);
    if (this.until) return this.until.tick(engine, BUDGET, this.stepsNow());
    if (!watch) return engine.tick(BUDGET, this.stepsNow());
    // Who asked for slow steps gets them.
    return watch.tick(engine, begin, BUDGET, this.stepsPerFrame < 1 ? this.stepsNow() : undefined);
  }
}
