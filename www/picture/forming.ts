/** A forming that the visitor watches: its pace, its subtitle, and the same recipe computed ahead for scripts. */
import { isEnd } from '../module/stages';
import type { Engine } from '../state/engine';
import { Ahead } from './ahead';
import type { Loop } from './loop';
import { Subtitle } from './subtitle';
import { Watch } from './watch';

export class Forming {
  /** Computes the present recipe unseen, only while the page's first picture forms for a new visitor. */
  ahead: Ahead | undefined;
  private readonly engine: Engine;
  private readonly loop: Loop;
  private readonly work: (tell: () => void) => Ahead;
  private readonly told: () => void;
  private readonly subtitle = new Subtitle();
  /** A new visitor watches the page's first picture, which is not computed ahead yet. */
  private newcomer = false;

  /** `work` starts to compute a recipe ahead. `told` is called after each piece of that work. */
  constructor(engine: Engine, loop: Loop, work: (tell: () => void) => Ahead, told: () => void) {
    this.engine = engine;
    this.loop = loop;
    this.work = work;
    this.told = told;
  }

  /** Starts a forming at the pace of a viewer. */
  begin(newcomer = this.newcomer): void {
    if (!this.engine.offers('forming')) return;
    this.newcomer = newcomer;
    this.loop.watch = new Watch(this.engine.generator);
    if (isEnd(this.engine.stage())) this.loop.watch.expected = this.engine.status().steps;
    this.expect();
    this.subtitle.begin(this.engine);
  }

  /** Ends the pace of a viewer; the work goes on at its own pace. */
  leave(): void {
    this.newcomer = false;
    if (!this.loop.watch) return;
    this.loop.watch = undefined;
    this.subtitle.end(true);
  }

  /** Ends the computation ahead: its recipe is no longer the present one, or the screen shows the result as well. */
  endAhead(): void {
    this.ahead?.end();
    this.ahead = undefined;
  }

  /** Updates pace and subtitle after a frame. `begun` is true once the first cells are visible. */
  follow(stage: string, begun: boolean): void {
    const { loop } = this;
    if (isEnd(stage)) {
      loop.watch = undefined;
      this.subtitle.end(false);
      return this.endAhead();
    }
    if (!loop.watch || !begun) return;
    this.subtitle.show(loop.watch.phase);
    if (this.newcomer) {
      this.ahead = this.work(() => {
        this.expect();
        this.told();
      });
    }
    this.newcomer = false;
  }

  /** Spreads the watched time over the packing's steps, once their number is known. */
  private expect(): void {
    if (this.ahead?.planes && this.loop.watch) this.loop.watch.expected = this.ahead.planes.status.steps;
  }
}
