/** A forming that somebody watches: its pace, the words about it, and for scripts the same recipe ahead of it. */
import { isEnd } from '../module/stages';
import type { Engine } from '../state/engine';
import { Ahead } from './ahead';
import type { Loop } from './loop';
import { Subtitle } from './subtitle';
import { Watch } from './watch';

export class Forming {
  /** The recipe at work, worked out unseen; only while what the page begins with forms for a newcomer. */
  ahead: Ahead | undefined;
  private readonly engine: Engine;
  private readonly loop: Loop;
  private readonly work: (tell: () => void) => Ahead;
  private readonly told: () => void;
  private readonly subtitle = new Subtitle();
  /** What the page begins with is for a newcomer, and not worked out ahead yet. */
  private newcomer = false;

  /** `work` begins to work a recipe out ahead; `told` is called whenever there is more to tell scripts of that. */
  constructor(engine: Engine, loop: Loop, work: (tell: () => void) => Ahead, told: () => void) {
    this.engine = engine;
    this.loop = loop;
    this.work = work;
    this.told = told;
  }

  /** From now on the work goes at the pace of who watches. */
  begin(newcomer = this.newcomer): void {
    if (!this.engine.generator.offers.includes('forming')) return;
    this.newcomer = newcomer;
    this.loop.watch = new Watch();
    if (isEnd(this.engine.stage())) this.loop.watch.expected = this.engine.status().steps;
    this.expect();
    this.subtitle.begin(this.engine.get('stone') === 'skin');
  }

  /** Nobody watches any more: the work goes on at its own pace. */
  leave(): void {
    this.newcomer = false;
    if (!this.loop.watch) return;
    this.loop.watch = undefined;
    this.subtitle.end(true);
  }

  /** What is worked out ahead is not what is asked for any more, or is there on the screen as well. */
  endAhead(): void {
    this.ahead?.end();
    this.ahead = undefined;
  }

  /** After a frame; `begun` tells that cells were shown. */
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

  /** Once it is known how many steps the packing takes, it is spread over those. */
  private expect(): void {
    if (this.ahead?.planes && this.loop.watch) this.loop.watch.expected = this.ahead.planes.status.steps;
  }
}
