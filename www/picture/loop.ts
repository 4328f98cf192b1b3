/**
 * The animation frames: each does a slice of the work, and none is requested when there is nothing to do or to see.
 *
 * A frame works for some milliseconds and draws. If both would take long, the next frame only draws. Large drawings
 * are prepared in pieces of some rows over several frames, while the work pauses; the pixels are the same as if drawn
 * at once. Scripts get the digest only when its picture is drawn.
 */
import { isEnd, isUpToSteps } from '../module/stages';
import { idle } from '../base/dom';
import { soon } from '../base/soon';
import type { Engine } from '../state/engine';
import type { Painter } from './frames/source';
import type { Until } from './until';
import type { Watch } from './watch';

/**
 * If drawing takes longer than DRAWN_ALWAYS milliseconds, only some frames draw, so that drawing takes this share of
 * the time.
 */
const DRAWN_ALWAYS = 8;
const DRAWING_SHARE = 0.25;

/** Milliseconds after which a page without cells shows the bare ground. */
const BARE = 250;

/** If work and drawing would take longer than this, a frame only works, and the next one only draws. */
const LONG = 32;

/**
 * Milliseconds between the frames of a usual screen, and the most of these frames whose steps one slow frame makes. So
 * the first packing takes the same time where frames are slow, and no frame makes many steps at once.
 */
const FRAME = 1000 / 60;
const MOST_FRAMES = 4;

/** Decides how the work advances in a frame, when two pictures form together. */
interface PairPacing {
  /** Works for about `budget` milliseconds and makes at most `steps` steps; true if the picture may have changed. */
  tick(engine: Engine, budget: number, steps: number): boolean;
}

/** The times of the slices of the work. */
interface Rhythm {
  /** Milliseconds of work in a slice. */
  readonly budget: number;
  /** Milliseconds of work in a slice until the first picture is finished, which nobody turns or changes yet. */
  readonly first: number;
  /** Milliseconds of work if the screen does not show each slice: before the first cells, and if a painter draws. */
  readonly unseen: number;
  /** Milliseconds of a slice for a drawing that is made in pieces. */
  readonly piece: number;
  /** Milliseconds of a slice for a painter. */
  readonly painted: number;
  /** The least time between two drawings of work in progress, in milliseconds. */
  readonly apart: number;
  /** Requests the next slice. */
  next(slice: (begin: number) => void): void;
  /** Requests the next slice at once, without a frame in between. */
  soon?(slice: (begin: number) => void): void;
}

/** A slice in each animation frame, whose other milliseconds are left to the browser. */
export const FRAMES: Rhythm = {
  budget: 12,
  first: 24,
  unseen: 40,
  piece: 16,
  painted: 32,
  apart: 0,
  next: (slice) => requestAnimationFrame(slice),
  soon: (slice) => soon(() => slice(performance.now())),
};

/** Slices in idle moments, for work other than the page's own picture. */
export const IDLE: Rhythm = { budget: 6, first: 6, unseen: 6, piece: 6, painted: 6, apart: 150, next: (slice) => void idle(50).then(() => slice(performance.now())) };

export class Loop {
  rhythm = FRAMES;
  /** Whether unfinished work may continue now. If it may not, `wake` must be called as soon as it may. */
  may: (() => boolean) | undefined;
  /** The most packing steps of a frame; below 1, several frames share one. */
  stepsPerFrame = 1;
  /** The pace while a visitor watches. */
  watch: Watch | undefined;
  /** The step at which the packing is to pause. An earlier pause or a change of the recipe clears it. */
  until: Until | undefined;
  /** Another picture that forms together with this one. */
  pair: PairPacing | undefined;
  /** Draws something else instead of the view, also in pieces. */
  painter: Painter | undefined;
  private readonly ending = new AbortController();
  private credit = 0;
  /** The time of the last frame that worked; 0 before the first one. */
  private worked = 0;
  private readonly engine: Engine;
  private readonly view: (stage: string) => string | undefined;
  private readonly drawn: (stage: string, changed: boolean) => void;
  private held = false;
  /** While held: the work may run up to the packing, or after a finished packing, but makes no packing step. */
  private settling = false;
  /** Whether a picture has been finished. */
  private finished = false;
  private dirty = false;
  private waiting = false;
  /**
   * Work in progress is not drawn again before this time. Requested drawings, the first cells and finished work are
   * drawn at once.
   */
  private nextDrawing = 0;
  /**
   * The expected time of the rest of a drawing after its pieces are made, from the last drawings; a guess for the
   * first one.
   */
  private drawing = LONG;
  /** The time of the pieces of the next drawing so far. */
  private pieces = 0;
  /** The next frame draws the result of this one, and does no work. */
  private owed = false;
  private spared = false;
  /**
   * Whether the next slice starts without waiting for a frame. It does if the last slice used up its time, and either
   * the slices are not seen or the visitor waits for the first picture.
   */
  private hasty = false;

  /** `view` returns the view to draw at a stage, if any; `drawn` is called in every frame in which something was done. */
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
    // A pause lets the work reach its first cells. With a painter, it also lets a step of many cells finish, which may
    // take several slices.
    const { generator } = this.engine;
    const stage = this.engine.stage();
    this.settling = isUpToSteps(generator, stage) || (this.painter !== undefined && stage === generator.stepping);
    // The step that a pause holds may not have been drawn yet.
    this.redraw();
  }

  /** Whether no work is left, except the work that a pause holds. */
  get stands(): boolean {
    return isEnd(this.engine.stage()) || (this.held && !this.settling);
  }

  /** Stops all frames. */
  end(): void {
    this.ending.abort();
  }

  /** Whether nothing is left to do or to draw, or the page is hidden. */
  get rests(): boolean {
    return !this.waiting;
  }

  /** Starts the work. The first drawing shows cells, unless they take long. */
  begin(): void {
    this.nextDrawing = performance.now() + BARE;
    this.settling = true;
    this.wake();
  }

  /** The recipe has changed: works and draws again, up to the step that a pause holds. */
  changed(): void {
    this.settling = true;
    this.redraw();
  }

  /** The view has changed, but not the recipe. */
  redraw(): void {
    this.painter?.changed();
    this.look();
  }

  /** Requests a frame that draws. */
  look(): void {
    this.dirty = true;
    this.wake();
  }

  /** Leaves the next frame to the browser, which has a new layout to compute. */
  spare(): void {
    this.spared = true;
  }

  /** Requests a slice, if none is requested yet. */
  wake(): void {
    if (this.waiting || document.hidden) return;
    this.waiting = true;
    const { rhythm, hasty } = this;
    const run = (begin: number): void => this.run(begin);
    this.hasty = false;
    if (hasty && rhythm.soon) rhythm.soon(run);
    else rhythm.next(run);
  }

  /**
   * Whole steps for a frame that began at `begin`; the remainder is kept for the next one. Until the first picture is
   * finished, a slow frame makes the steps of up to MOST_FRAMES usual frames.
   */
  private stepsNow(begin: number): number {
    const isFirst = !this.finished && !this.pair && !this.until;
    const frames = isFirst && this.worked && this.stepsPerFrame >= 1 ? Math.round((begin - this.worked) / FRAME) : 1;
    this.worked = begin;
    this.credit += this.stepsPerFrame * Math.min(Math.max(frames, 1), MOST_FRAMES);
    const steps = Math.floor(this.credit);
    this.credit -= steps;
    return steps;
  }

  /** Prepares the pieces of a drawing; true when they are ready. */
  private prepared(stage: string): boolean {
    const view = this.view(stage);
    if (view === undefined) return true;
    const { piece, painted } = this.rhythm;
    const begin = performance.now();
    const ready = this.painter ? this.painter.advance(painted) : this.engine.prepare(view, piece);
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
    const apart = spent > DRAWN_ALWAYS ? spent * (1 / (this.painter?.share ?? DRAWING_SHARE) - 1) : 0;
    this.nextDrawing = end + Math.max(apart, this.rhythm.apart);
  }

  /** `begin` is the time when the frame began. */
  private run(begin: number): void {
    this.waiting = false;
    if (document.hidden || this.ending.signal.aborted || !this.engine.alive) return;
    if (this.spared) {
      this.spared = false;
      return this.wake();
    }
    const { stepping } = this.engine.generator;
    const before = this.engine.stage();
    if (!isEnd(before) && this.may?.() === false) return;
    const working = !this.owed && !isEnd(before) && (!this.held || this.settling);
    const changed = working && this.work(begin);
    this.hold();
    const stage = this.engine.stage();
    if (changed || stage !== before) this.painter?.changed();
    // While held, the work ends when only packing steps are left. The packing's first cells may take a slice of their
    // own.
    if (isEnd(stage) || (working && this.held && stage === stepping && !changed)) {
      // Bodies that no longer change are painted in better quality.
      if (this.settling && this.painter) this.dirty = true;
      this.settling = false;
      this.finished ||= isEnd(stage);
    }
    const now = changed ? performance.now() : begin;
    const due = changed && now >= this.nextDrawing;
    const draw = this.owed || this.dirty || due || isEnd(stage) || (stage !== before && (this.held || stage === stepping));
    const isLong = working && now - begin + (this.painter ? this.rhythm.painted : this.drawing) > LONG;
    // A painter may request another frame, which comes next.
    if (this.painter) this.dirty = false;
    this.owed = draw && (isLong || !this.prepared(stage));
    if (this.owed) return this.wake();
    if (!this.painter) this.dirty = false;
    this.show(stage, draw);
    if (!isEnd(stage) && (!this.held || this.settling)) this.wake();
  }

  /** Pauses when the packing has reached the step of `until`. */
  private hold(): void {
    const { until } = this;
    if (until?.made === undefined) return;
    this.paused = true;
    until.held(until.made);
  }

  /** Does a slice of the work in a frame that began at `begin`; true if the picture may have changed. */
  private work(begin: number): boolean {
    const { engine, watch } = this;
    const { stages, stepping } = engine.generator;
    const isSeen = !this.painter && !this.until?.unseen && stages.indexOf(engine.stage()) >= stages.indexOf(stepping);
    const { rhythm } = this;
    const isFirst = !this.finished && !watch;
    const budget = isSeen ? (isFirst ? rhythm.first : rhythm.budget) : rhythm.unseen;
    const changed = this.workFor(budget, begin);
    this.hasty = (isFirst || !isSeen) && performance.now() - begin >= budget;
    return changed;
  }

  private workFor(budget: number, begin: number): boolean {
    const { engine, watch } = this;
    // The other picture uses the other half of the time.
    if (this.pair && !this.until) return this.pair.tick(engine, budget / 2, this.held ? 0 : this.stepsNow(begin));
    if (this.held) return engine.tick(budget, 0);
    if (this.until) return this.until.tick(engine, budget, this.stepsNow(begin));
    if (!watch) return engine.tick(budget, this.stepsNow(begin));
    // If the visitor asked for slow steps, they stay slow.
    return watch.tick(engine, begin, budget, this.stepsPerFrame < 1 ? this.stepsNow(begin) : undefined);
  }
}
