/**
 * The one host of an engine: it works on a recipe, draws the view into a canvas, and frees all at the end. The page, an
 * embedded picture, a compared one and a dialog's preview are built on it. It needs no other part of the page:
 *
 *     await load(link); // state/arrivals.ts: the module of the link
 *     const host = new PictureHost(link, { canvas, view: () => 'mesh', camera: () => undefined, worked, crashed });
 *     host.drive({ paused: false, pace: 0.5 });
 *     host.changed();
 *
 * This shows how the mesh of a recipe forms, one step in two frames. `host.step()` takes one step, `host.open(link)`
 * shows another recipe, `host.engine.problem()` returns the reason if there is no picture, and `host.free()` frees
 * everything. Style sheets set the size of the canvas on the screen.
 */
import { wantsStill } from '../base/dom';
import { isEnd } from '../module/stages';
import { Engine } from '../state/engine';
import type { Camera, Cut } from '../state/viewing';
import type { FrameCanvas } from './frames/canvas';
import { Loop } from './loop';

/** The canvas, the view, and the functions to call. */
interface Showing {
  readonly canvas: HTMLCanvasElement;
  /** The words of the view, joined by '+'. */
  readonly view: () => string;
  /**
   * The camera of frames, undefined for the usual one. If this function is given, the frames of generators that have
   * `frames` are drawn into the canvas; else another part of the page shows them.
   */
  readonly camera?: () => Camera | undefined;
  /** The plane beyond which bodies are cut away. */
  readonly cut?: () => Cut | undefined;
  /** Whether something is being dragged; then frames are fast rather than fine. */
  readonly held?: () => boolean;
  /** Called after work up to this stage. `changed` is true if the picture may have changed, `drawn` if it was drawn. */
  readonly worked: (stage: string, changed: boolean, drawn: boolean) => void;
  /** Called when the program has failed at this link; no work follows. The call may come before the host exists. */
  readonly crashed: (error: unknown, link: string) => void;
}

export class PictureHost {
  readonly engine: Engine;
  readonly loop: Loop;
  /** Whether only finished and paused pictures are drawn, for visitors who prefer less motion. */
  still = wantsStill();
  private readonly showing: Showing;
  private readonly context: CanvasRenderingContext2D;
  private frames: FrameCanvas | undefined;

  /** The link's module must be loaded. The work starts with the first call of `changed`. */
  constructor(link: string, showing: Showing) {
    const context = showing.canvas.getContext('2d');
    if (!context) throw new Error('This browser gives no canvas to draw on.');
    this.context = context;
    this.showing = showing;
    this.engine = new Engine(link, showing.crashed);
    this.loop = new Loop(this.engine, (stage) => (this.isShown(stage) ? showing.view() : undefined), (stage, changed) => this.worked(stage, changed));
    void this.bringFrames();
  }

  /** The words of the view. */
  view(): string {
    return this.showing.view();
  }

  /** Opens another link, whose module must be loaded. Returns the notices about corrections. */
  open(link: string): string[] {
    const sentences = this.engine.open(link);
    void this.bringFrames();
    this.changed();
    return sentences;
  }

  /** To be called after a change of the recipe: works and draws again. */
  changed(): void {
    this.loop.changed();
    this.frames?.follow();
  }

  /** To be called when the camera of frames has moved, or when something is dragged or released. */
  moved(): void {
    this.frames?.moved();
  }

  /** Pauses or continues, with `pace` steps in each frame. */
  drive({ paused, pace }: { paused: boolean; pace: number }): void {
    if (this.loop.paused !== paused) this.loop.paused = paused;
    this.loop.stepsPerFrame = pace;
  }

  /** Takes one step. */
  step(): void {
    this.engine.step();
    this.loop.redraw();
  }

  /** Makes the steps again, and all stages after them. */
  restart(): void {
    this.engine.restart();
    this.loop.changed();
  }

  free(): void {
    this.loop.end();
    this.frames?.end();
    this.engine.free();
  }

  private isShown(stage: string): boolean {
    return !this.loop.until?.unseen && (!this.still || isEnd(stage) || this.loop.paused);
  }

  private worked(stage: string, changed: boolean): void {
    if (!this.engine.alive) return;
    const draws = changed && this.isShown(stage) && !this.engine.offers('frames');
    if (draws) this.draw();
    this.showing.worked(stage, changed, draws);
  }

  private draw(): void {
    const { canvas } = this.context;
    const side = this.engine.side();
    if (canvas.width !== side || canvas.height !== side) canvas.width = canvas.height = side;
    this.engine.draw(this.context, this.showing.view());
  }

  /** Loads the maker of frames, if the generator has frames. */
  private async bringFrames(): Promise<void> {
    const { engine, loop, context, showing } = this;
    if (!showing.camera) return;
    loop.painter = undefined;
    if (!engine.offers('frames')) return;
    try {
      const part = await import('./frames/canvas');
      if (engine.alive) this.frames ??= new part.FrameCanvas(engine, loop, context, showing);
    } catch (error) {
      showing.crashed(error, engine.link());
    }
    if (engine.offers('frames')) loop.painter = this.frames?.painter;
    this.changed();
  }
}
