/**
 * Makes frames of a studio's bodies, for the engine of the page or in a worker. A new view gets a coarse frame first,
 * then one with all pixels, which is refined: it is the mean of more and more samples, and each mean is shown. A newer
 * request ends the refinement at once. While something moves there are coarse frames only. Each of them is finished
 * even if a newer request comes; otherwise no frame would ever be finished.
 */
import type { SceneStudio } from '../../module/scene';
import type { Notice } from '../../module/types';
import { Coarse, ladderOf, viewOf } from './ladder';
import { outlineIn } from './outline';
import { coverage, pixelsOf } from './pixels';
import type { Quality, Wished } from './source';

/** The part of a studio that makes frames. */
type Studio = Pick<SceneStudio, 'turn' | 'frameMap'>;

interface FrameOrder<W> {
  readonly wish: W;
  readonly quality: Quality;
  readonly width: number;
  readonly height: number;
}

/** A finished frame, or one that has reached the quality `still` and is refined further. */
export interface Made<W> extends FrameOrder<W> {
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** The result of a piece of work. */
type WorkResult<W> = { made: Made<W> } | { working: number } | { refused: Notice };

/** `W` is the caller's type of request. */
export class FrameMaker<W extends Wished = Wished> {
  private readonly studio: Studio;
  private readonly view: () => string;
  private readonly coarse = new Coarse();
  private order: FrameOrder<W> | undefined;
  /** The milliseconds that the pieces of the order took so far. */
  private spent = 0;
  /** The bodies may differ from the last frame. */
  private stale = true;
  /** The bodies have changed since the last frame was made. */
  private lapsed = true;
  /** The last frame: its view, its quality, the number of finished frames of its ladder, its subject, and its sides. */
  private last = { view: '', quality: 'moving' as Quality, rungs: 0, subject: '', width: 0, height: 0 };

  /** `view` gives the word of the view. */
  constructor(studio: Studio, view: () => string = () => 'auto') {
    this.studio = studio;
    this.view = view;
  }

  /** Notes that the bodies may look different now. */
  changed(): void {
    this.stale = this.lapsed = true;
  }

  /** Abandons the frame in the making. */
  drop(): void {
    this.order = undefined;
    this.stale = this.lapsed = true;
  }

  /** The sides of the last frame, if it shows all bodies. */
  get sides(): readonly [width: number, height: number] | undefined {
    const { width, height, subject } = this.last;
    return width && subject === '' ? [width, height] : undefined;
  }

  /** The outline of a body in the last frame; undefined if the body is not visible. */
  outlineOf(id: number, fine: number): ImageData | undefined {
    const map = this.sides && this.studio.frameMap('id');
    return map && 'bytes' in map ? outlineIn(map, id, fine) : undefined;
  }

  /** The quality of the next frame; undefined if none is due. Bodies that still change get coarse frames only. */
  due(wish: Wished, stands = true): Quality | undefined {
    const rung = !this.stale && this.seen(wish) === this.last.view ? this.last.rungs : 0;
    return rung > 0 && (wish.moving || !stands) ? undefined : ladderOf(wish)[rung];
  }

  /** The quality of the last frame, if it shows what is requested; undefined if another frame has to come. */
  kept(wish: Wished): Quality | undefined {
    return this.lapsed || this.seen(wish) !== this.last.view ? undefined : this.last.quality;
  }

  /** Works for about `budget` milliseconds on the frame that is due. Undefined if none is due or there is nothing to see yet. */
  advance(wish: W, budget: number, stands = true): WorkResult<W> | undefined {
    if (this.order && this.order.wish !== wish && this.order.quality !== 'moving') this.order = undefined;
    const order = (this.order ??= this.begun(wish, stands));
    return order && this.goOn(order, budget);
  }

  private seen(wish: Wished): string {
    return `${viewOf(wish)} ${this.view()}`;
  }

  private begun(wish: W, stands: boolean): FrameOrder<W> | undefined {
    const quality = this.due(wish, stands);
    if (!quality) return undefined;
    [this.stale, this.spent] = [false, 0];
    const part = quality === 'moving' ? this.coarse.part : 1;
    const [width, height] = [wish.width, wish.height].map((side) => Math.max(1, Math.round(side / part))) as [number, number];
    return { wish, quality, width, height };
  }

  private goOn(order: FrameOrder<W>, budget: number): WorkResult<W> | undefined {
    const { wish, quality, width, height } = order;
    const begin = performance.now();
    const how = [quality, wish.plane === 'alpha' ? 'nothing' : 'floor', this.view(), ...(wish.cut ? [wish.cut] : [])].join('+');
    const slice = this.studio.turn(wish.subject, wish.camera, width, height, how, budget);
    this.spent += performance.now() - begin;
    if ('code' in slice) {
      this.order = undefined;
      return slice.code === 'not_yet' ? undefined : { refused: slice };
    }
    if (!slice.pixels) return { working: slice.progress };
    if (slice.done) this.order = undefined;
    if (quality === 'moving') this.coarse.suit(this.spent);
    const rungs = ladderOf(wish).indexOf(quality) + (slice.done ? 1 : 0);
    const reached = slice.done ? quality : 'still';
    this.lapsed = false;
    this.last = { view: this.seen(wish), quality: reached, rungs, subject: wish.subject, width, height };
    return { made: { ...order, quality: reached, pixels: this.pixels(order, slice.pixels) } };
  }

  private pixels({ wish: { plane } }: FrameOrder<W>, pixels: Uint8Array<ArrayBuffer>): Uint8ClampedArray<ArrayBuffer> {
    if (plane === 'alpha') return coverage(pixels);
    const map = plane === 'light' ? undefined : this.studio.frameMap(plane);
    return map && 'bytes' in map ? pixelsOf(map) : new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length);
  }
}
