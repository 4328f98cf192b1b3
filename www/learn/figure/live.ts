/**
 * A figure at work: it reads the numbers of its packings in slices, plays, and shows a step. The picture is made from its state
 * alone, by the drawing that made the still picture.
 */
import { curveOf, gripAt, lastStepOf, notesOf, numbersAt, platesOf, stopsOf, toldOf, type Shown } from '../draw/picture';
import type { CurvePoint } from '../draw/plate';
import { Reading, shownPoints, shownValue } from '../draw/reading';
import { zeroOf, type Bubbles } from '../draw/studio';
import type { Figure, Language, PointHandle, View } from '../figures/figure';
import { markAt } from '../figures/marks';
import { opening, type State } from './address';
import type { Past } from './past';
import { Questions } from './questions';
import { Handles, type Handled } from './handles';
import { Layers } from './layers';
import { Timeline, type Timed } from './timeline';
import type { Turns } from './turns';

/** Milliseconds of work in a frame. */
const SLICE = 6;

/** Milliseconds of a whole run at speed 1, and of a stop if runs go from stop to stop. */
const RUN = 9000;
const AT_STOP = 1400;

export class Live implements Handled, Timed {
  readonly figure: Figure;
  private readonly shown: Shown;
  readonly language: Language;
  private readonly module: Bubbles;
  private readonly place: HTMLElement;
  private readonly turns: Turns;
  private readonly changed: (state: State) => void;
  private readonly ended = new AbortController();
  private readonly handles: Handles;
  private readonly timeline: Timeline;
  private readonly questions: Questions;
  private readonly layers = new Layers();
  private readonly curve: CurvePoint[];
  private readonly zero: number;
  private readings: Reading[] = [];
  private stops: ReturnType<typeof stopsOf> = [];
  private readonly past: Past;
  /** The step asked for, and the last one that there is. */
  private asked = 0;
  private last = 0;
  private at: readonly number[];
  private isRead = false;
  /** Whether the reader has changed the recipe: the picture then follows while the numbers are being read. */
  private isInHand = false;
  private isPlaying = false;
  private isInSight = true;
  /** The time of the last frame that played, and the fraction of a step that is due. */
  private played = 0;
  private part = 0;
  private frame = 0;

  constructor(place: HTMLElement, shown: Shown, language: Language, module: Bubbles, state: State, past: Past, turns: Turns, changed: (state: State) => void) {
    const { figure } = shown;
    [this.shown, this.place, this.figure, this.language, this.module, this.past, this.turns, this.changed] = [shown, place, figure, language, module, past, turns, changed];
    [this.asked, this.at, this.last] = [state.step, state.at, figure.last];
    [this.curve, this.zero] = [curveOf(module), zeroOf(module)];
    this.questions = new Questions(figure, language, past.answered);
    this.timeline = new Timeline(this, place, this.ended.signal);
    const { furthest } = past;
    this.open(state.recipe);
    past.furthest = furthest;
    this.handles = new Handles(this, place, this.ended.signal);
  }

  get state(): State {
    return { recipe: this.readings[0]?.link ?? this.figure.recipe, step: this.step, at: this.at };
  }

  /** The step that is shown: a run that ended earlier stays at its end. */
  private get step(): number {
    return Math.min(this.asked, this.last);
  }

  /** The hashes of all packings at the present step. */
  get hash(): string {
    return this.isRead ? this.readings.map((reading) => reading.hashAt(this.step)).join(' ') : '';
  }

  /** Opens a recipe. One that does not fit the figure is replaced by the figure's own. */
  private open(recipe: string): void {
    const { figure, module } = this;
    const made = (from: string): Reading[] => figure.packings.map((own) => new Reading(module, figure, from, own));
    this.free();
    this.isInHand = false;
    this.readings = made(recipe);
    if (!this.readings.every((reading) => figure.fits(reading))) {
      this.free();
      this.readings = made(figure.recipe);
    }
    this.read();
  }

  /** Reads all numbers anew, because the recipe has changed: only the step that is shown has been seen. */
  private read(): void {
    this.isRead = false;
    this.past.furthest = 0;
    this.wake();
  }

  value(key: string): string {
    return shownValue(this.readings, this.isRead ? this.step : Infinity, this.at, key);
  }

  points(handle: PointHandle): readonly (readonly [number, number])[] {
    return shownPoints(this.readings, this.step, this.at, handle);
  }

  change(key: string, text: string, isOver: boolean): void {
    const mark = markAt(key);
    if (mark !== undefined) return this.look(this.at.map((value, k) => (k === mark ? Number(text) : value)), isOver);
    if (key === 'w') this.asked = 0;
    this.alter((reading) => reading.change(key, text), isOver);
  }

  move(handle: PointHandle, row: number, to: readonly [number, number], isOver: boolean): void {
    const { key } = handle;
    if (key === 'at') return this.look([...to, ...this.at.slice(2)], isOver);
    const { step } = this;
    if (key === 'given') this.asked = 0;
    this.alter((reading) => reading.move(key, row, to, step), isOver);
  }

  private look(at: readonly number[], isOver: boolean): void {
    this.at = at;
    this.show(isOver);
  }

  private alter(act: (reading: Reading) => void, isOver: boolean): void {
    if (this.isPlaying) this.pause();
    this.readings.forEach(act);
    this.isInHand = true;
    this.read();
    this.show(isOver);
  }

  gripAt(plate: number, key: string, numbers: readonly number[]): readonly [number, number] {
    return gripAt(this.shown, plate, key, numbers, this.view());
  }

  numbersAt(plate: number, key: string, place: readonly [number, number]): readonly number[] {
    return numbersAt(this.shown, plate, key, place, this.view());
  }

  again(): void {
    this.isPlaying = false;
    const state = opening(this.figure);
    [this.asked, this.at] = [state.step, state.at];
    this.open(state.recipe);
    this.show(true);
  }

  play(): void {
    if (this.isPlaying) return this.pause();
    if (this.step >= this.last) this.asked = 0;
    [this.isPlaying, this.played, this.part] = [true, performance.now(), 0];
    this.show(false);
    this.wake();
  }

  pause(): void {
    this.isPlaying = false;
    this.show(true);
  }

  by(steps: number): void {
    this.seek(this.step + steps);
  }

  seek(step: number): void {
    this.isPlaying = false;
    this.go(step);
    this.show(true);
  }

  /** Asks for a step. The last step stands for the end, also after a change that makes the run longer. */
  private go(step: number): void {
    this.asked = step >= this.last ? this.figure.last : Math.max(0, step);
  }

  /** To be called when the figure comes into sight or leaves it. It works and plays in sight only. */
  sight(isInSight: boolean): void {
    this.isInSight = isInSight;
    this.played = performance.now();
    if (isInSight) this.wake();
    else this.turns.leave(this);
  }

  private wake(): void {
    if (!this.frame && this.isInSight && (!this.isRead || this.isPlaying)) this.frame = requestAnimationFrame((now) => this.run(now));
  }

  private run(now: number): void {
    this.frame = 0;
    if (!this.isInSight || this.ended.signal.aborted) return;
    if (this.turns.take(this, this.isPlaying)) {
      if (!this.isRead) this.work();
      else if (this.isPlaying) this.advance(now);
    }
    if (this.isRead && !this.isPlaying) this.turns.leave(this);
    this.wake();
  }

  private work(): void {
    const slice = SLICE / this.readings.length;
    if (!this.readings.map((reading) => reading.advance(slice)).every(Boolean)) return this.preview();
    this.isRead = true;
    this.stops = stopsOf(this.figure, this.readings);
    this.last = lastStepOf(this.figure, this.readings);
    this.go(this.asked);
    this.played = performance.now();
    this.show(!this.isPlaying);
  }

  /** Shows a crowd while its numbers are still being read, so that its outline follows a drag. */
  private preview(): void {
    const isBegun = this.readings.every(({ isBegun, moments, landscape }) => isBegun && (landscape !== undefined || !moments.length));
    if (!isBegun || !this.isInHand) return;
    this.draw();
    this.handles.show();
  }

  /** Goes on by the time that has passed; with less motion, from stop to stop. */
  private advance(now: number): void {
    const { figure, timeline, stops, last } = this;
    const isStill = figure.steps === 'layer' || matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.part += (Math.min(100, now - this.played) * timeline.speed) / (isStill ? AT_STOP : RUN / figure.last);
    this.played = now;
    const whole = Math.floor(this.part);
    if (whole < 1) return;
    this.part -= whole;
    this.go(isStill ? (stops.find(({ step }) => step > this.step)?.step ?? last) : this.step + whole);
    if (this.step >= last) this.isPlaying = false;
    this.show(!this.isPlaying || isStill);
  }

  private view(): View {
    const { readings, step, last, past: { furthest, trials }, curve, zero, at, language, stops } = this;
    return { traces: readings, step, last, furthest, trials, curve, zero, at, isStill: !this.isPlaying, isZeroShown: this.questions.showsZero, answered: this.questions.answered, stops, language };
  }

  /** Shows the state. At rest the text is spoken, and the address follows. */
  private show(isAtRest: boolean): void {
    if (!this.isRead) return this.handles.show();
    this.past.furthest = Math.max(this.past.furthest, this.step);
    this.ask();
    this.draw();
    this.timeline.show(this.step, this.last, this.isPlaying, this.offered());
    this.handles.show();
    this.tell(isAtRest);
    this.place.dataset.step = String(this.step);
    if (isAtRest) this.changed(this.state);
  }

  private draw(): void {
    const view = this.view();
    platesOf(this.shown, view).forEach((plate, k) => {
      const place = this.place.querySelector(`.plate-box[data-plate="${k}"] .plate-svg`);
      if (place) this.layers.put(place, plate);
    });
    notesOf(this.figure, view).forEach((note, k) => {
      const place = this.place.querySelector(`.plate-note[data-plate="${k}"]`);
      if (place && note !== undefined) place.textContent = note;
    });
  }

  /**
   * The stops on offer. If there is something to predict, only those up to the furthest step that the reader has seen.
   */
  private offered(): typeof this.stops {
    const { steps, asks } = this.figure;
    return steps === 'layer' || !asks.length ? this.stops : this.stops.filter(({ step }) => step <= this.past.furthest);
  }

  /** Keeps how a start ended, and looks whether a question is answered. */
  private ask(): void {
    const { past, readings: [reading] } = this;
    const trial = reading && this.figure.trial?.(reading, this.step);
    if (trial && !past.trials.some(({ start }) => start === trial.start)) past.trials = [...past.trials, trial];
    this.questions.look(this.view());
  }

  private tell(isAtRest: boolean): void {
    const place = this.place.querySelector('.figure-told') as HTMLElement;
    place.setAttribute('aria-live', isAtRest ? 'polite' : 'off');
    const words = toldOf(this.figure, this.view());
    if (place.textContent !== words) place.textContent = words;
  }

  private free(): void {
    for (const reading of this.readings) reading.free();
    this.readings = [];
  }

  end(): void {
    this.ended.abort();
    cancelAnimationFrame(this.frame);
    this.turns.leave(this);
    this.free();
  }
}
