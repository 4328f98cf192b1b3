/** Frames of another engine on a canvas of its own, with the camera of the page's turntable, for comparison. */
import { make } from '../base/dom';
import type { Engine } from '../state/engine';
import { cameraWords, homeOf } from '../state/asked-view';
import type { Store } from '../state/store';
import { LocalFrames, type Beat } from './local';

/** The camera counts as still after this many milliseconds. */
const STILL = 220;

/** The most pixels along a side. */
const MOST = 1200;

export class OtherFrames {
  readonly canvas = make('canvas', { class: 'other', 'aria-hidden': 'true' });
  readonly painter: LocalFrames;
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly size = new ResizeObserver(() => this.follow());
  private stopping = 0;
  private ended = false;

  /** `loop` is the loop of the other engine. */
  constructor(engine: Engine, store: Store, loop: Beat) {
    this.engine = engine;
    this.store = store;
    this.painter = new LocalFrames(
      { engine, loop, view: () => store.state.view },
      {
        frame: (frame) => {
          const { canvas } = this;
          [canvas.width, canvas.height] = [frame.width, frame.height];
          canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(frame);
        },
        working: () => undefined,
        refused: () => undefined,
        ended: () => undefined,
      },
    );
    store.on(['camera', 'recipe', 'held'], () => this.moved());
    this.size.observe(this.canvas);
  }

  /** Ends the frames and removes the canvas. */
  end(): void {
    this.ended = true;
    this.size.disconnect();
    clearTimeout(this.stopping);
    this.painter.end();
    this.canvas.remove();
  }

  private moved(): void {
    clearTimeout(this.stopping);
    this.stopping = window.setTimeout(() => {
      this.stopping = 0;
      this.follow();
    }, STILL);
    this.follow();
  }

  private follow(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (this.ended || !clientWidth || !clientHeight || !this.engine.alive) return;
    const fine = Math.min(devicePixelRatio, MOST / Math.max(clientWidth, clientHeight));
    const [width, height] = [clientWidth, clientHeight].map((side) => Math.round(side * fine)) as [number, number];
    const { camera, held } = this.store.state;
    const home = homeOf(this.engine.generator);
    this.painter.want({ link: this.engine.link(), subject: '', camera: cameraWords(camera ?? home, home), width, height, plane: 'light', moving: held || this.stopping !== 0 });
  }
}
