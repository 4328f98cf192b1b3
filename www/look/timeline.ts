/**
 * The timeline under the picture: a slider through the steps of the forming, on and back.
 *
 * An engine only works forwards. To go back, it begins the steps again and runs unseen up to the step that is asked
 * for; the stages before the steps keep their results. Some engines store states on the first such run, and start from
 * the nearest state later. Those of piles and of masonry take each body from the last finished run. The number of steps
 * is known once the forming has come to its end.
 */
import { t } from '../words/look';
import { byId, make, say } from '../base/dom';
import { RETOLD } from '../base/language';
import { countedBy, isEnd, isUpToSteps } from '../module/stages';
import type { Status } from '../module/types';
import { Until } from '../picture/until';
import type { PictureHost } from '../picture/host';
import type { Work } from '../state/work';

import '../styles/late/timeline.css';

/** The assumed number of steps, until a forming has come to its end. */
const GUESS = 45;

export class Timeline {
  private readonly work: Work;
  private readonly host: PictureHost;
  private readonly leave: () => void;
  private readonly slider = make('input', { type: 'range', id: 'moment', min: '0', step: '1', value: '0' });
  private readonly back = make('button', { type: 'button', id: 'step-back', class: 'key', 'aria-keyshortcuts': ',' }, '‹');
  private readonly said = make('output', { for: 'moment' });
  /** The number of steps of a whole forming: that of the last one, or a guess until one has come to its end. */
  private all = 0;
  private isKnown = false;
  /** The step that is asked for, until it is reached. */
  private asked: number | undefined;
  /** Whether the engine keeps states of the present recipe's steps. */
  private isKept = false;

  /** `leave` ends the slow pace of a watched forming, and the pause that a link asked for. */
  constructor(work: Work, host: PictureHost, leave: () => void) {
    [this.work, this.host, this.leave] = [work, host, leave];
    this.slider.addEventListener('input', () => this.seek(Number(this.slider.value)));
    this.back.addEventListener('click', () => this.goBack());
    byId('timeline').replaceChildren(this.back, this.slider, this.said);
    const { store } = work;
    store.on(['make'], () => ([this.all, this.isKnown] = [0, false]));
    store.on(['recipe'], () => this.forget());
    store.on(['paused'], ({ paused }) => {
      // A pause on the way to a step gives that step up: work will go on from where it is now.
      if (!paused || this.asked === undefined) return;
      this.forget();
      this.show();
    });
    store.on(['compare', 'make'], () => this.show());
    addEventListener(RETOLD, () => {
      this.name();
      this.show();
    });
    this.name();
    this.follow(work.engine.stage(), work.engine.status());
  }

  /** Shows how far the forming has come. */
  follow(stage: string, { steps }: Status): void {
    const { generator } = this.host.engine;
    if (this.isFormed(stage)) [this.all, this.isKnown] = [steps, true];
    else if (stage === generator.stepping) this.all = Math.max(this.all, steps, this.isKnown ? 0 : GUESS);
    this.show();
  }

  /** Whether all steps are made at this stage. */
  private isFormed(stage: string): boolean {
    return stage === 'done' || (stage !== 'error' && !isUpToSteps(this.host.engine.generator, stage));
  }

  /** The present step; 0 before the forming has begun, and if the recipe gives no picture. */
  private now(): number {
    if (this.asked !== undefined) return this.asked;
    const { engine } = this.host;
    if (engine.stage() === 'error') return 0;
    const { stages, stepping } = engine.generator;
    const stage = engine.stage();
    return !isEnd(stage) && stages.indexOf(stage) < stages.indexOf(stepping) ? 0 : engine.status().steps;
  }

  /**
   * One step back, if there is one. The last step may count for several, so a run to `now - 1` may end at `now` again.
   * Then a second run goes to where that step began.
   */
  goBack(): void {
    if (this.back.disabled) return;
    const now = this.now();
    this.seek(now - 1, ({ made, before }) => made !== undefined && made >= now && this.seek(before));
  }

  /** Drops the asked step and the stored states, as another recipe has other steps. */
  private forget(): void {
    this.asked = undefined;
    if (this.isKept) this.host.engine.hold();
    this.isKept = false;
  }

  /** Goes to a step and pauses there, then calls `then`. The last step leads on to the finished picture. */
  private seek(asked: number, then?: (until: Until) => void): void {
    const { work, host } = this;
    const { engine, loop } = host;
    const step = Math.max(0, Math.min(asked, this.all));
    const isFormed = this.isFormed(engine.stage());
    const isLast = step === this.all;
    if (isLast && isFormed) return;
    const isBack = isFormed || step < engine.status().steps;
    const rewinds = !isLast && engine.offers('rewind') && (isBack || this.isKept);
    if (isBack) work.restart();
    if (rewinds) {
      engine.hold(step);
      this.isKept = true;
    }
    this.asked = step;
    this.leave();
    work.store.update({ paused: false });
    const until = new Until(
      isLast ? Infinity : step,
      () => {
        this.reached();
        then?.(until);
      },
      rewinds ? 'rewound' : 'unseen',
    );
    loop.until = until;
    loop.changed();
    this.show();
  }

  /** The step is reached: pauses, or goes on with the finished picture. */
  private reached(): void {
    const { engine, loop } = this.host;
    const { store } = this.work;
    const isLast = engine.stage() === 'error' || this.isFormed(engine.stage());
    this.asked = undefined;
    loop.paused = !isLast;
    store.update({ paused: !isLast });
  }

  private name(): void {
    this.slider.ariaLabel = t('timeline');
    this.back.title = t('step_back');
    this.back.ariaLabel = t('step_back');
  }

  private show(): void {
    const { store } = this.work;
    const isIdle = this.all === 0 || store.state.compare || this.host.engine.stage() === 'error';
    const now = this.now();
    this.slider.disabled = isIdle;
    this.back.disabled = isIdle || now === 0;
    this.slider.max = String(Math.max(this.all, 1));
    this.slider.value = String(now);
    this.slider.style.setProperty('--place', String(this.all ? now / this.all : 0));
    const key = countedBy(this.host.engine.generator);
    const text = isIdle ? '' : t(`at_${key}`, { n: this.isKnown ? t('at_of', { n: now, all: this.all }) : now });
    say(this.said, text);
    this.slider.setAttribute('aria-valuetext', text);
  }
}
