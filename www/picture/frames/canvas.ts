/** Frames of an engine on a plain canvas, as large as the screen shows it. */
import { cameraWords, homeOf, wholeBodies } from '../../state/asked-view';
import type { Engine } from '../../state/engine';
import type { Camera, Cut } from '../../state/viewing';
import { LocalFrames } from './local';
import type { Beat } from './source';

/** The camera counts as still after this many milliseconds. */
const STILL = 220;

/** The most pixels along a side. */
const MOST = 1200;

/** The view and its camera. */
interface Sight {
  /** The words of the view. */
  readonly view: () => string;
  /** The camera; undefined for the usual one. */
  readonly camera?: () => Camera | undefined;
  /** The plane beyond which bodies are cut away, if the generator offers that. */
  readonly cut?: () => Cut | undefined;
  /** Whether something is being dragged. */
  readonly held?: () => boolean;
}

export class FrameCanvas {
  readonly painter: LocalFrames;
  private readonly engine: Engine;
  private readonly context: CanvasRenderingContext2D;
  private readonly sight: Sight;
  private readonly size = new ResizeObserver(() => this.follow());
  private stopping = 0;

  /** `loop` is the loop of the engine. */
  constructor(engine: Engine, loop: Beat, context: CanvasRenderingContext2D, sight: Sight) {
    [this.engine, this.context, this.sight] = [engine, context, sight];
    const none = (): void => undefined;
    this.painter = new LocalFrames({ engine, loop, view: sight.view }, { frame: (frame) => this.show(frame), kept: none, working: none, refused: none, ended: none });
    this.size.observe(context.canvas);
  }

  /** Ends the frames. */
  end(): void {
    this.size.disconnect();
    clearTimeout(this.stopping);
    this.painter.end();
  }

  /** To be called when the camera has moved. */
  moved(): void {
    clearTimeout(this.stopping);
    this.stopping = window.setTimeout(() => {
      this.stopping = 0;
      this.follow();
    }, STILL);
    this.follow();
  }

  /** Requests frames after a change of recipe, camera or canvas. */
  follow(): void {
    const { context, engine, sight } = this;
    const { clientWidth, clientHeight } = context.canvas;
    if (!clientWidth || !clientHeight || !engine.offers('frames')) return;
    const fine = Math.min(devicePixelRatio, MOST / Math.max(clientWidth, clientHeight));
    const [width, height] = [clientWidth, clientHeight].map((side) => Math.round(side * fine)) as [number, number];
    const home = homeOf(engine.generator);
    this.painter.want({ link: engine.link(), subject: '', camera: cameraWords(sight.camera?.() ?? home, home), width, height, plane: 'light', cut: engine.offers('cut') ? wholeBodies(sight.cut?.()) : '', moving: sight.held?.() === true || this.stopping !== 0, refined: true });
  }

  private show(frame: ImageBitmap): void {
    const { context, engine } = this;
    const { canvas } = context;
    if (engine.offers('frames')) {
      [canvas.width, canvas.height] = [frame.width, frame.height];
      context.drawImage(frame, 0, 0);
    }
    frame.close();
  }
}
