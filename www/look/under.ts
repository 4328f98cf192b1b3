/** Another picture under the one that is shown, up to a divider; it is made in idle moments. */
import { isEnd } from '../module/stages';
import { t } from '../words/look';
import { byId, idle, make, say } from '../base/dom';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { View } from '../picture/view';
import { OtherFrames } from '../turn/others';

/** Milliseconds of work in one idle slice, and between two drawings of work in progress. */
const SLICE = 6;
const DRAWINGS = 150;

export class Under {
  private readonly work: Work;
  private readonly store: Store;
  private readonly view: View;
  private readonly progress: HTMLElement;
  private readonly sheet = byId('sheet');
  private readonly canvas = make('canvas', { class: 'other', 'aria-hidden': 'true' });
  private readonly line = make('div', { class: 'compare-line' });
  private readonly divider = make('input', { type: 'range', id: 'divider', min: '0', max: '100', step: '1', value: '50', 'aria-label': t('compare_divider') });
  private engine: Engine | undefined;
  /** Its frames, for generators that are seen by frames only. */
  private frames: OtherFrames | undefined;
  private waiting = false;
  /** A drawing is being made in pieces; the work pauses until it is ready. */
  private owed = false;
  private drawn = 0;

  constructor(work: Work, view: View, progress: HTMLElement) {
    this.work = work;
    this.store = work.store;
    this.view = view;
    this.progress = progress;
    byId('cells').before(this.canvas);
    this.sheet.append(this.line, this.divider);
    this.divider.addEventListener('input', () => this.slide());
    this.store.on(['view', 'overlays'], () => this.look());
    this.store.on(['stage', 'paused'], () => this.wake());
    document.addEventListener('visibilitychange', () => this.wake());
    this.slide();
  }

  show(on: boolean): void {
    for (const element of [this.canvas, this.line, this.divider]) element.hidden = !on;
    if (on) this.divider.focus({ preventScroll: true });
    else {
      this.engine = undefined;
      this.frames?.end();
      this.frames = undefined;
    }
  }

  /** Compares with the picture of this engine. */
  take(engine: Engine): void {
    this.engine = engine;
    this.drawn = 0;
    this.frames?.end();
    this.frames = engine.offers('frames') ? this.framesOf(engine) : undefined;
    this.canvas.hidden = engine.offers('frames');
    this.wake();
  }

  /** Lays its frames over those of the page. */
  private framesOf(engine: Engine): OtherFrames {
    const stands = (): boolean => isEnd(engine.stage());
    const beat = {
      look: () => this.wake(),
      get stands() {
        return stands();
      },
    };
    const frames = new OtherFrames(engine, this.store, beat);
    this.line.before(frames.canvas);
    return frames;
  }

  private look(): void {
    this.frames?.painter.changed();
    this.wake();
  }

  private slide(): void {
    const at = this.divider.valueAsNumber;
    this.sheet.style.setProperty('--divider', String(at / 100));
    this.divider.setAttribute('aria-valuetext', t('compare_said', { n: at }));
  }

  /** Continues in an idle moment. */
  private wake(): void {
    const { engine } = this;
    if (!engine) return;
    if (!isEnd(engine.stage())) say(this.progress, t('compare_working'));
    if (this.waiting) return;
    this.waiting = true;
    void idle(50).then(() => {
      this.waiting = false;
      this.goOn();
    });
  }

  /** Works while the page is visible and its own picture needs no work. A finished picture is drawn before it is announced. */
  private goOn(): void {
    const { engine } = this;
    if (!engine || document.hidden) return;
    const works = !isEnd(engine.stage());
    if (works && !this.resting()) return;
    if (works && !this.owed && engine.tick(SLICE, 100_000)) this.frames?.painter.changed();
    // The engine failed, which has been announced.
    if (this.engine !== engine) return;
    const ended = isEnd(engine.stage());
    const due = ended || performance.now() >= this.drawn;
    this.owed = due && !(this.frames ? this.frames.painter.advance(SLICE) : engine.prepare(this.view.words, SLICE));
    if (due && !this.owed) this.paint();
    if (ended && !this.owed) say(this.progress, engine.problem());
    else this.wake();
  }

  private resting(): boolean {
    return this.store.state.paused || isEnd(this.work.engine.stage());
  }

  private paint(): void {
    const { engine, canvas } = this;
    const context = engine && !engine.offers('frames') && canvas.getContext('2d');
    if (!context) return;
    const side = engine.side();
    if (canvas.width !== side) canvas.width = canvas.height = side;
    engine.draw(context, this.view.words);
    this.drawn = performance.now() + DRAWINGS;
  }
}
