/**
 * A figure at work: it reads the numbers of its packings in slices, plays, and shows a step. The picture is made from its state
 * alone, by the drawing that made the still picture.
 */
import { curveOf, gripAt, platesOf, stopsOf } from '../draw/picture';
import type { CurvePoint, View } from '../draw/plate';
import { Reading } from '../draw/reading';
import { zeroOf, type Bubbles } from '../draw/studio';
import type { Figure, Language, Seen, Trial } from '../figures/figure';
import { trialOf } from '../figures/rules';
import { opening, type State } from './address';
import { Asked } from './asked';
import { Handles, type Handled } from './handles';
import { Timeline, type Timed } from './timeline';
import type { Turns } from './turns';

/** Milliseconds of work in a frame. */
const SLICE = 6;

/** Milliseconds of a whole run at speed 1, and of a stop if runs go from stop to stop. */
const RUN = 9000;
const AT_STOP = 1400;

export class Live implements Handled, Timed {
  readonly figure: Figure;
  readonly language: Language;
  private readonly module: Bubbles;
  private readonly place: HTMLElement;
  private readonly turns: Turns;
  private readonly changed: (state: State) => void;
  private readonly ended = new AbortController();
  private readonly handles: Handles;
  private readonly timeline: Timeline;
  private readonly asked: Asked;
  private readonly curve: CurvePoint[];
  private readonly zero: number;
  private readings: Reading[] = [];
  private stops: ReturnType<typeof stopsOf> = [];
  private trials: Trial[] = [];
  private step: number;
  private mark: number | undefined;
  private isRead = false;
  private isPlaying = false;
  private isInSight = true;
  /** The time of the last frame that played, and the part of a step that is still to come. */
  private last = 0;
  private part = 0;
  private frame = 0;

  constructor(place: HTMLElement, figure: Figure, language: Language, module: Bubbles, state: State, turns: Turns, changed: (state: State) => void) {
    [this.place, this.figure, this.language, this.module, this.turns, this.changed] = [place, figure, language, module, turns, changed];
    [this.step, this.mark] = [state.step, state.mark];
    [this.curve, this.zero] = [curveOf(module), zeroOf(module)];
    this.asked = new Asked(figure, language);
    this.timeline = new Timeline(this, place, this.ended.signal);
    this.handles = new Handles(this, place, this.ended.signal);
    this.open(state.recipe);
  }

  get state(): State {
    return { recipe: this.readings[0]?.link ?? this.figure.recipe, step: this.step, mark: this.mark };
  }

  /** The hashes of all packings at the present step. */
  get hash(): string {
    return this.isRead ? this.readings.map((reading) => reading.hashAt(this.step)).join(' ') : '';
  }

  /** A recipe that is not of two bubbles is left for the figure's own. */
  private open(recipe: string): void {
    const { figure, module } = this;
    const made = (from: string): Reading[] => figure.packings.map((own) => new Reading(module, figure, from, own));
    this.free();
    this.readings = made(recipe);
    if (figure.steps === 'step' && !this.readings.every(({ isPair }) => isPair)) {
      this.free();
      this.readings = made(figure.recipe);
    }
    this.read();
  }

  private read(): void {
    this.isRead = false;
    this.wake();
  }

  value(key: string): string {
    if (key === 'mark') return String(this.mark ?? 0);
    if (key !== 'w') return this.readings[0]?.value(key) ?? '';
    return String((this.isRead ? this.readings[0]?.moments[this.step]?.w : undefined) ?? this.readings[0]?.distance ?? 0);
  }

  change(key: string, text: string, isOver: boolean): void {
    if (this.isPlaying && key !== 'mark') this.pause();
    if (key === 'mark') this.mark = Number(text);
    else {
      if (key === 'w') this.step = 0;
      for (const reading of this.readings) reading.change(key, text);
      this.read();
    }
    this.show(isOver);
  }

  gripAt(plate: number, key: string): readonly [number, number] {
    return gripAt(this.figure, plate, key, this.view());
  }

  again(): void {
    this.isPlaying = false;
    const state = opening(this.figure);
    [this.step, this.mark] = [state.step, state.mark];
    this.open(state.recipe);
    this.show(true);
  }

  play(): void {
    if (this.isPlaying) return this.pause();
    if (this.step >= this.figure.last) this.step = 0;
    [this.isPlaying, this.last, this.part] = [true, performance.now(), 0];
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
    this.step = Math.max(0, Math.min(this.figure.last, step));
    this.show(true);
  }

  /** Works and plays in sight only. */
  sight(isInSight: boolean): void {
    this.isInSight = isInSight;
    this.last = performance.now();
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
    if (!this.readings.map((reading) => reading.advance(slice)).every(Boolean)) return;
    this.isRead = true;
    this.stops = stopsOf(this.figure, this.readings);
    this.last = performance.now();
    this.show(!this.isPlaying);
  }

  /** Goes on by the time that has passed; with less motion, from stop to stop. */
  private advance(now: number): void {
    const { figure, timeline, stops } = this;
    const isStill = figure.steps === 'layer' || matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.part += (Math.min(100, now - this.last) * timeline.speed) / (isStill ? AT_STOP : RUN / figure.last);
    this.last = now;
    const whole = Math.floor(this.part);
    if (whole < 1) return;
    this.part -= whole;
    this.step = isStill ? (stops.find(({ step }) => step > this.step)?.step ?? figure.last) : Math.min(figure.last, this.step + whole);
    if (this.step >= figure.last) this.isPlaying = false;
    this.show(!this.isPlaying || isStill);
  }

  private view(): View {
    const { readings, step, figure, curve, zero, mark, language, stops } = this;
    return { traces: readings, step, last: figure.last, curve, zero, mark, isZeroShown: this.asked.showsZero, stops, language };
  }

  private seen(): Seen {
    return { traces: this.readings, step: this.step, trials: this.trials, mark: this.mark ?? 0, zero: this.zero };
  }

  /** Shows the state. At rest the text is spoken, and the address follows. */
  private show(isAtRest: boolean): void {
    if (!this.isRead) return this.handles.show();
    this.look();
    platesOf(this.figure, this.view()).forEach((plate, k) => {
      const place = this.place.querySelector(`.plate-box[data-plate="${k}"] .plate-svg`);
      if (place) place.innerHTML = plate;
    });
    this.timeline.show(this.step, this.isPlaying, this.stops);
    this.handles.show();
    this.tell(isAtRest);
    this.place.dataset.step = String(this.step);
    if (isAtRest) this.changed(this.state);
  }

  /** Keeps how a start without damping ended, and looks whether a question is answered. */
  private look(): void {
    const [reading] = this.readings;
    const trial = reading && trialOf(reading, this.step);
    if (trial && !this.trials.some(({ w }) => w === trial.w)) this.trials = [...this.trials, trial];
    this.asked.look(this.seen());
  }

  private tell(isAtRest: boolean): void {
    const place = this.place.querySelector('.figure-told') as HTMLElement;
    place.setAttribute('aria-live', isAtRest ? 'polite' : 'off');
    const words = this.figure.told(this.seen(), this.language);
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
