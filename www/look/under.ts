/** Another picture under the shown one, up to a divider; it is made in idle moments. */
import { isEnd } from '../module/stages';
import { t } from '../words/look';
import { byId, make, say } from '../base/dom';
import { PACE } from '../state/viewing';
import type { Work } from '../state/work';
import type { PictureHost } from '../picture/host';
import { IDLE } from '../picture/loop';
import type { Way } from './way';

export class Under implements Way {
  private readonly work: Work;
  private readonly progress: HTMLElement;
  private readonly sheet = byId('sheet');
  private readonly canvas: HTMLCanvasElement;
  private readonly line = make('div', { class: 'compare-line' });
  private readonly divider = make('input', { type: 'range', id: 'divider', min: '0', max: '100', step: '1', value: '50', 'aria-label': t('compare_divider') });
  private host: PictureHost | undefined;

  constructor(work: Work, canvas: HTMLCanvasElement, progress: HTMLElement) {
    this.work = work;
    this.canvas = canvas;
    this.progress = progress;
    byId('cells').before(canvas);
    this.sheet.append(this.line, this.divider);
    this.sheet.toggleAttribute('data-divided', true);
    this.divider.addEventListener('input', () => this.slide());
    work.store.on(['stage', 'paused'], () => this.host?.loop.wake());
    this.slide();
  }

  show(on: boolean): void {
    for (const element of [this.line, this.divider]) element.hidden = !on;
    if (on) this.divider.focus({ preventScroll: true });
    else this.host = undefined;
  }

  take(host: PictureHost): void {
    const { canvas, line } = this;
    const { engine, loop } = (this.host = host);
    canvas.setAttribute('aria-hidden', 'true');
    for (const name of ['role', 'aria-labelledby']) canvas.removeAttribute(name);
    // Frames lie over the page's frames. A picture is put into the layer of the page's picture, which is zoomed as a
    // whole.
    if (engine.offers('frames')) line.before(canvas);
    else byId('cells').before(canvas);
    loop.rhythm = IDLE;
    // The page's own picture comes first.
    loop.may = () => this.work.store.state.paused || isEnd(this.work.engine.stage());
    host.still = false;
    host.drive({ paused: false, pace: PACE.still });
    if (!isEnd(engine.stage())) say(this.progress, t('compare_working'));
  }

  worked(stage: string): void {
    say(this.progress, isEnd(stage) ? (this.host?.engine.problem() ?? '') : t('compare_working'));
  }

  private slide(): void {
    const at = this.divider.valueAsNumber;
    this.sheet.style.setProperty('--divider', String(at / 100));
    this.divider.setAttribute('aria-valuetext', t('compare_said', { n: at }));
  }
}
