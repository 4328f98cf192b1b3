/**
 * Frames of the engine at work, made between the slices of its work in the page's own frames: the bodies are seen
 * from any side while they are being made. While one frame is made the work waits, or no frame would ever be finished.
 *
 * What moves, or is being made, gets coarse frames of few pixels; what stands gets one of all pixels, then a smooth one.
 */
import { isSettled } from '../module/stages';
import type { Loop, Painter } from '../picture/loop';
import type { Engine } from '../state/engine';
import { Coarse, ladderOf, viewOf } from './ladder';
import { coverage, pixelsOf } from './pixels';
import type { FrameSource, Heard, Wished } from './frames';
import type { Quality, Told } from './turn.worker';

/** A frame in the making. */
interface Order {
  readonly wish: Wished;
  readonly quality: Quality;
  readonly width: number;
  readonly height: number;
}

/** A place of a frame, in parts of its sides. */
type Part = readonly [u: number, v: number];

/** What goes on from frame to frame. */
export type Beat = Pick<Loop, 'look' | 'stands'>;

/** What the frames are of. */
interface Place {
  readonly engine: Engine;
  readonly loop: Beat;
  /** The word of the view. */
  view(): string;
}

export class LocalFrames implements FrameSource, Painter {
  readonly share = 0.6;
  private readonly place: Place;
  private readonly heard: Heard;
  private readonly coarse = new Coarse();
  private wish: Wished | undefined;
  private order: Order | undefined;
  /** How long its pieces took so far, in milliseconds. */
  private spent = 0;
  /** What is made looks otherwise than the last frame. */
  private stale = true;
  private stage = '';
  /** What the last frame is of, how many of the ladder's rungs it has, and its sides. */
  private made = { view: '', rungs: 0, subject: '', width: 0, height: 0 };
  /** Counts the frames that are handed over, and the last one that was shown. */
  private handed = 0;
  private shown = 0;

  constructor(place: Place, heard: Heard) {
    this.place = place;
    this.heard = heard;
  }

  want(wish: Wished): boolean {
    const { wish: last } = this;
    if (last && (Object.keys(wish) as (keyof Wished)[]).every((key) => wish[key] === last[key])) return false;
    this.wish = wish;
    this.place.loop.look();
    return true;
  }

  bodyAt(x: number, y: number): Promise<Told | undefined> {
    const { width, height, subject } = this.made;
    const { engine } = this.place;
    const body = width && subject === '' ? engine.bodyAt(Math.floor(x * width), Math.floor(y * height)) : undefined;
    return Promise.resolve(body && { id: body.id, probe: undefined, steps: engine.making(body.id) });
  }

  /** The place of the model at a place of the last frame, in parts of its sides; undefined beside it. */
  placeAt([u, v]: Part): [x: number, y: number, z: number] | undefined {
    const { width, height, subject } = this.made;
    if (!width || subject !== '') return undefined;
    const place = this.place.engine.askWhole((studio) => studio.placeAt(Math.floor(u * width), Math.floor(v * height)), undefined);
    return place && [place[0] ?? 0, place[1] ?? 0, place[2] ?? 0];
  }

  /** Where a place of the model is in that frame; undefined where it is not seen. */
  spotOf([x, y, z]: readonly [x: number, y: number, z: number]): Part | undefined {
    const { width, height, subject } = this.made;
    if (!width || subject !== '') return undefined;
    const pixel = this.place.engine.askWhole((studio) => studio.pixelOf(x, y, z), undefined);
    return pixel && [(pixel[0] ?? 0) / width, (pixel[1] ?? 0) / height];
  }

  end(): void {
    this.wish = this.order = undefined;
    this.stale = true;
  }

  changed(): void {
    const stage = this.place.engine.stage();
    // The picture of bodies that stay as they are waits for better frames.
    if (!this.isSettled(stage) || !this.isSettled(this.stage)) this.stale = true;
    this.stage = stage;
  }

  advance(budget: number): boolean {
    const { wish } = this;
    if (!wish) return true;
    // A coarse frame is finished, else none ever would be while one turns it.
    if (this.order && this.order.wish !== wish && this.order.quality !== 'moving') this.order = undefined;
    const order = (this.order ??= this.begun(wish));
    return !order || this.goOn(order, budget);
  }

  /** How good the next frame is to be; undefined where none is due. */
  private due(wish: Wished): Quality | undefined {
    const isSame = !this.stale && this.seen(wish) === this.made.view;
    const rung = isSame ? this.made.rungs : 0;
    const stands = this.place.loop.stands || this.isSettled(this.stage);
    return rung > 0 && (wish.moving || !stands) ? undefined : ladderOf(wish)[rung];
  }

  private isSettled(stage: string): boolean {
    return isSettled(this.place.engine.generator, stage);
  }

  private seen(wish: Wished): string {
    return `${viewOf(wish)} ${this.place.view()}`;
  }

  private begun(wish: Wished): Order | undefined {
    const quality = this.due(wish);
    if (!quality) return undefined;
    [this.stale, this.spent] = [false, 0];
    const part = quality === 'moving' ? this.coarse.part : 1;
    const [width, height] = [wish.width, wish.height].map((side) => Math.max(1, Math.round(side / part))) as [number, number];
    return { wish, quality, width, height };
  }

  /** Works on a frame; true where it is done, or cannot be. */
  private goOn(order: Order, budget: number): boolean {
    const { wish, quality, width, height } = order;
    const { engine } = this.place;
    const begin = performance.now();
    const how = [quality, wish.plane === 'alpha' ? 'nothing' : 'floor', this.place.view()].join('+');
    const slice = engine.turn(wish.subject, wish.camera, [width, height], how, budget);
    this.spent += performance.now() - begin;
    if ('code' in slice) {
      this.order = undefined;
      if (slice.code !== 'not_yet') this.heard.refused(slice);
      return true;
    }
    if (!slice.done) {
      this.heard.working(slice.progress);
      return false;
    }
    this.order = undefined;
    if (quality === 'moving') this.coarse.suit(this.spent);
    this.made = { view: this.seen(wish), rungs: ladderOf(wish).indexOf(quality) + 1, subject: wish.subject, width, height };
    void this.show(order, slice.pixels ?? new Uint8Array(4 * width * height));
    // The next rung, or what was wished for meanwhile.
    if (this.due(this.wish ?? wish)) this.place.loop.look();
    return true;
  }

  private async show({ wish, quality, width, height }: Order, pixels: Uint8Array<ArrayBuffer>): Promise<void> {
    const { engine } = this.place;
    const number = (this.handed += 1);
    const plane = wish.plane === 'light' || wish.plane === 'alpha' ? undefined : engine.frameMap(wish.plane);
    const plain = new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length);
    const seen = wish.plane === 'alpha' ? coverage(pixels) : plane && 'bytes' in plane ? pixelsOf(plane) : plain;
    const { cells, stones } = engine.status();
    const view = this.place.view();
    const { stages, seen: views } = engine.generator;
    const what = view === 'auto' ? views[stages.indexOf(engine.stage())] : view === 'picture' ? undefined : view;
    const bodies = { count: what ? cells : stones, skin: engine.get('stone') === 'skin', what };
    const frame = await createImageBitmap(new ImageData(seen, width, height));
    // Browsers may be done with a later one earlier.
    if (number < this.shown || !this.wish) { frame.close(); return; }
    this.shown = number;
    this.heard.frame(frame, quality, bodies, wish === this.wish && number === this.handed);
  }
}
