/** The turntable on the page. The store holds whether it is on, and its camera. */
import { t } from '../words/turn';
import { t as common } from '../words/words';
import { byId, make } from '../base/dom';
import { mark } from '../base/marks';
import { alertOf, clear } from '../base/messages';
import { isSettled } from '../module/stages';
import { firstCamera } from '../state/asked-view';
import { refinesBodies } from '../state/fine';
import type { Camera } from '../state/viewing';
import type { Work } from '../state/work';
import type { PictureHost } from '../picture/host';
import type { View } from '../picture/view';
import { flipOf } from './flips';
import { noteOf } from './told';
import type { Surroundings } from './turntable';
import { Turntables } from './turntables';

export class PageTurntable {
  private readonly work: Work;
  private readonly both: Turntables;
  /** Called after each frame that the engine at work has made. */
  framed: (() => void) | undefined;
  /** The last note, and the key that it belongs to. */
  private told: readonly [of: string, note: string] = ['', ''];
  /** The first camera of the slant, while the visitor has chosen no other. */
  private first: Camera | undefined;

  constructor(work: Work, host: PictureHost, view: View) {
    this.work = work;
    view.noted = (word) => this.note(word);
    const { store } = work;
    this.both = new Turntables(host, this.place(), { leave: () => store.update({ turn: false }) });
    store.on(['recipe', 'held', 'camera', 'cut', 'fine'], () => this.both.shown?.follow());
    store.on(['make'], ({ turn }) => this.show(turn));
    store.on(['preset'], ({ turn }) => this.face(turn));
    // Editing, comparing and repeating need the picture. The mode chosen last ends the other modes.
    store.on(['editing', 'compare', 'repeat'], ({ turn, editing, compare, repeat }) => {
      if (turn && !work.engine.offers('frames') && (editing !== undefined || compare || repeat > 1)) store.update({ turn: false });
    });
  }

  show(on: boolean): void {
    const button = byId('turn-button');
    const focused = this.both.shown?.focused;
    if (on) clear('part');
    else this.work.store.update({ body: undefined });
    this.face(on);
    const turntable = this.both.show(on);
    // A link that opens the turntable leaves the focus where it is.
    if (on && document.activeElement === button) turntable.focus();
    if (!on && focused) button.focus();
  }

  /**
   * Sets the first camera by the light of the picture: when the turntable opens, and with another preset. The camera
   * does not follow later changes of the light. A camera that the visitor chose stays.
   */
  private face(on: boolean): void {
    const { store, engine } = this.work;
    const { camera } = store.state;
    if (engine.offers('frames') || (camera && camera.join() !== this.first?.join())) return;
    this.first = on ? firstCamera(engine.generator, (key) => engine.get(key)) : undefined;
    store.update({ camera: this.first });
  }

  focus(): void {
    this.both.shown?.focus();
  }

  /** Zooms in (1), out (-1), or back to the first camera (0). */
  step(by: number): void {
    this.both.shown?.step(by);
  }

  /** The frame of the engine at work, to be painted on. */
  get surface(): Turntables['surface'] {
    return this.both.surface;
  }

  private place(): Omit<Surroundings, 'leave' | 'frames'> {
    const { store, engine } = this.work;
    return {
      generator: () => engine.generator,
      link: () => store.state.recipe,
      held: () => store.state.held,
      refines: () => refinesBodies(store),
      get: (key) => engine.get(key),
      camera: () => store.state.camera,
      take: (camera) => store.update({ camera }),
      cut: () => store.state.cut,
      slice: (cut) => store.update({ cut }),
      asked: () => {
        const { asked } = store.state;
        store.update({ asked: '' });
        return asked;
      },
      flip: (feature) => flipOf(this.work, feature),
      schema: () => engine.schema,
      only: (subject, camera) => store.update({ body: subject === '' ? undefined : { subject, camera } }),
      framed: (whole) => {
        if (engine.offers('frames')) this.seen(whole);
      },
      ended: (how, why) => this.ended(how, why),
    };
  }

  /** Marks the first frames of the engine at work. */
  private seen(whole: boolean): void {
    const { engine } = this.work;
    mark('frame');
    const isFinished = whole && isSettled(engine.generator, engine.stage());
    const { compare, editing, asked, paused } = this.work.store.state;
    if (isFinished) mark('picture');
    if (isFinished && !compare && editing === undefined && asked === '' && !paused) this.both.shown?.greet();
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
