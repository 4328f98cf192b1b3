/** The turntable on the page. The store holds whether it is on, and its camera. */
import { t } from '../words/turn';
import { t as common } from '../words/words';
import { byId, make } from '../base/dom';
import { mark } from '../base/marks';
import { alertOf, clear } from '../base/messages';
import { isSettled } from '../module/stages';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import type { View } from '../picture/view';
import { LocalFrames } from './local';
import { noteOf } from './told';
import { Turntable, type Place } from './turntable';

export class PageTurntable {
  private readonly work: Work;
  private readonly loop: Loop;
  /** The turntable of a picture's bodies, and that of generators seen by frames only. */
  private slant: Turntable | undefined;
  private own: Turntable | undefined;
  private frames: LocalFrames | undefined;
  /** Called after each frame that the engine at work has made. */
  framed: (() => void) | undefined;
  /** The last note, and the key that it belongs to. */
  private told: readonly [of: string, note: string] = ['', ''];
  /** The turntable that is shown, or was shown last. */
  private shown: Turntable | undefined;

  constructor(work: Work, loop: Loop, view: View) {
    this.work = work;
    view.noted = (word) => this.note(word);
    this.loop = loop;
    const { store } = work;
    store.on(['recipe', 'held', 'camera'], () => this.shown?.follow());
    store.on(['make'], ({ turn }) => this.show(turn));
    // Editing, comparing and repeating need the picture. The mode chosen last ends the others.
    store.on(['editing', 'compare', 'repeat'], ({ turn, editing, compare, repeat }) => {
      if (turn && !work.engine.offers('frames') && (editing !== undefined || compare || repeat > 1)) store.update({ turn: false });
    });
  }

  show(on: boolean): void {
    const button = byId('turn-button');
    const isFramed = this.work.engine.offers('frames');
    const turntable = isFramed ? (this.own ??= this.ofFrames()) : (this.slant ??= this.onSlant());
    const focused = this.shown?.focused;
    if (on) clear('part');
    else this.work.store.update({ body: undefined });
    if (this.shown !== turntable) this.shown?.toggle(false);
    this.loop.painter = isFramed ? this.frames : undefined;
    this.shown = turntable;
    turntable.toggle(on);
    // A link that opens the turntable leaves the focus where it is.
    if (on && document.activeElement === button) turntable.focus();
    if (!on && focused) button.focus();
  }

  focus(): void {
    this.shown?.focus();
  }

  /** Zooms in (1), out (-1), or back to the first camera (0). */
  step(by: number): void {
    this.shown?.step(by);
  }

  /** The frame of the engine at work, to be painted on, and the mapping between its places and places on the model. */
  get surface() {
    this.own ??= this.ofFrames();
    return {
      host: this.own.host,
      placeAt: (spot: readonly [number, number]) => this.frames?.placeAt(spot),
      spotOf: (place: readonly [number, number, number]) => this.frames?.spotOf(place),
    };
  }

  /** The parts that both turntables share. */
  private place(): Omit<Place, 'leave' | 'frames'> {
    const { store, engine } = this.work;
    return {
      generator: () => engine.generator,
      link: () => store.state.recipe,
      held: () => store.state.held,
      get: (key) => engine.get(key),
      camera: () => store.state.camera,
      take: (camera) => store.update({ camera }),
      only: (subject, camera) => store.update({ body: subject === '' ? undefined : { subject, camera } }),
      ended: (how, why) => this.ended(how, why),
    };
  }

  private onSlant(): Turntable {
    return new Turntable({ ...this.place(), leave: () => this.work.store.update({ turn: false }) });
  }

  /** The engine at work makes the frames, between the slices of its work. */
  private ofFrames(): Turntable {
    const { loop } = this;
    const { store, engine } = this.work;
    return new Turntable({
      ...this.place(),
      framed: (whole) => this.seen(whole),
      frames: (heard) => (this.frames = new LocalFrames({ engine, loop, view: () => store.state.view }, heard)),
    });
  }

  /** Marks the first frames of the engine at work. */
  private seen(whole: boolean): void {
    const { engine } = this.work;
    mark('frame');
    if (whole && isSettled(engine.generator, engine.stage())) mark('picture');
    this.framed?.();
  }

  /**
   * The note of a view. It is cached, because singular points should be counted only once for each stage of the work.
   */
  private note(view: string): string {
    const { store, engine } = this.work;
    const of = [store.state.recipe, engine.stage(), view].join(' ');
    if (of !== this.told[0]) this.told = [of, noteOf(engine, view)];
    return this.told[1];
  }

  private ended(how: 'lost' | 'broken', why: string): void {
    const { store } = this.work;
    store.update({ turn: false });
    const again = make('button', { type: 'button' }, t('lost'));
    again.addEventListener('click', () => store.update({ turn: true }));
    alertOf('part', how === 'lost' ? common('lost_module') : t('broken', { reason: why }), again);
  }
}
