/**
 * Frames of the engine at work, made between the slices of its work, so that bodies can be seen from any side while
 * they are being made. The work pauses while a frame is made; otherwise no frame would ever be finished.
 */
import type { SceneStudio } from '../../module/scene';
import { countedBy, isSettled } from '../../module/stages';
import type { Notice } from '../../module/types';
import type { Engine } from '../../state/engine';
import { FrameMaker, type Made } from './maker';
import { sortOf } from './sort';
import type { Beat, FramePlace, FrameSource, Heard, Painter, BodyInfo, PlacedLabel, Wished } from './source';

/** The answer if there is nothing to see yet. */
const NOT_YET: Notice = { code: 'not_yet', args: {}, text: '' };

/** The source of the frames' content. */
interface FrameContent {
  readonly engine: Engine;
  readonly loop: Beat;
  /** The words of the view. Only the first one counts, because no overlays are drawn on frames. */
  view(): string;
}

export class LocalFrames implements FrameSource, Painter {
  readonly share = 0.3;
  private readonly place: FrameContent;
  private readonly heard: Heard;
  private readonly maker: FrameMaker;
  private wish: Wished | undefined;
  private stage = '';
  /** Numbers of the last frame that was passed on, and of the last one that was shown. */
  private handed = 0;
  private shown = 0;
  /** The last request that a frame was made for, or that needed none; and the end of that frame's way to the page. */
  private met: Wished | undefined;
  private showing = Promise.resolve();

  constructor(place: FrameContent, heard: Heard) {
    this.place = place;
    this.heard = heard;
    this.maker = new FrameMaker(
      {
        turn: (...order) => this.ask((studio) => studio.turn(...order)) ?? NOT_YET,
        frameMap: (word) => this.ask((studio) => studio.frameMap(word)) ?? NOT_YET,
      },
      () => this.view,
    );
  }

  want(wish: Wished): boolean {
    const { wish: last } = this;
    if (last && (Object.keys(wish) as (keyof Wished)[]).every((key) => wish[key] === last[key])) return false;
    this.wish = wish;
    this.place.loop.look();
    return true;
  }

  bodyAt(x: number, y: number): Promise<BodyInfo | undefined> {
    const { sides } = this.maker;
    const body = sides && this.ask((studio) => studio.bodyAt(Math.floor(x * sides[0]), Math.floor(y * sides[1])));
    return Promise.resolve(body && { id: body.id, figures: body.figures, words: body.words, steps: this.ask((studio) => studio.making(body.id)) ?? [] });
  }

  bodyOf(id: number): Promise<BodyInfo | undefined> {
    return Promise.resolve({ id, figures: {}, words: {}, steps: this.ask((studio) => studio.making(id)) ?? [] });
  }

  outlineOf(id: number, fine: number): Promise<ImageData | undefined> {
    return Promise.resolve(this.maker.outlineOf(id, fine));
  }

  labels(): Promise<readonly PlacedLabel[]> {
    const { sides } = this.maker;
    const labels = sides ? (this.ask((studio) => studio.labels()) ?? []) : [];
    return Promise.resolve(labels.map(({ text, x, y }) => ({ text, at: [x / (sides?.[0] ?? 1), y / (sides?.[1] ?? 1)] })));
  }

  /** The place on the model at a place of the last frame, in fractions of its sides; undefined beside the model. */
  placeAt([u, v]: FramePlace): [x: number, y: number, z: number] | undefined {
    const { sides } = this.maker;
    const place = sides && this.ask((studio) => studio.placeAt(Math.floor(u * sides[0]), Math.floor(v * sides[1])));
    return place && [place[0] ?? 0, place[1] ?? 0, place[2] ?? 0];
  }

  /** The place in the last frame of a place on the model; undefined if it is hidden. */
  spotOf([x, y, z]: readonly [x: number, y: number, z: number]): FramePlace | undefined {
    const { sides } = this.maker;
    const pixel = sides && this.ask((studio) => studio.pixelOf(x, y, z));
    return pixel && [(pixel[0] ?? 0) / sides[0], (pixel[1] ?? 0) / sides[1]];
  }

  end(): void {
    this.wish = undefined;
    this.maker.drop();
  }

  changed(): void {
    const stage = this.place.engine.stage();
    // If the bodies do not change any more, the current frame stays until better ones come.
    if (!this.isSettled(stage) || !this.isSettled(this.stage)) this.maker.changed();
    this.stage = stage;
  }

  advance(budget: number): boolean {
    const { wish, heard, maker, stands } = this;
    if (!wish) return true;
    const piece = maker.advance(wish, budget, stands);
    if (!piece) {
      if (this.met !== wish) void this.keep(wish);
      return true;
    }
    if ('working' in piece) heard.working(piece.working);
    else if ('refused' in piece) heard.refused(piece.refused);
    else {
      this.met = piece.made.wish;
      this.showing = this.show(piece.made);
      // The next level of quality, or a newer request, is due.
      if (maker.due(wish, stands)) this.place.loop.look();
    }
    return !('working' in piece);
  }

  /** Tells that the shown frame stays, if it is the requested one. */
  private async keep(wish: Wished): Promise<void> {
    this.met = wish;
    await this.showing;
    const kept = this.maker.kept(wish);
    if (kept && wish === this.wish) this.heard.kept(kept);
  }

  private ask<T>(call: (studio: SceneStudio) => T): T | undefined {
    return this.place.engine.askWhole<T | undefined>(call, undefined);
  }

  private get view(): string {
    return this.place.view().split('+', 1)[0] ?? 'auto';
  }

  private get stands(): boolean {
    return this.place.loop.stands || this.isSettled(this.stage);
  }

  private isSettled(stage: string): boolean {
    return isSettled(this.place.engine.generator, stage);
  }

  private async show({ wish, quality, width, height, pixels }: Made<Wished>): Promise<void> {
    const { view } = this;
    const { engine } = this.place;
    const number = (this.handed += 1);
    const { cells, stones } = engine.status();
    const { stages, seen } = engine.generator;
    const what = view === 'auto' ? seen[stages.indexOf(engine.stage())] : view === 'picture' ? undefined : view;
    const bodies = { count: what ? cells : stones, sort: sortOf(engine.get('stone'), what, countedBy(engine.generator) === 'blocks'), what };
    const frame = await createImageBitmap(new ImageData(pixels, width, height));
    // Browsers may finish a later bitmap earlier.
    if (number < this.shown || !this.wish) { frame.close(); return; }
    this.shown = number;
    this.heard.frame(frame, quality, bodies, wish === this.wish && number === this.handed);
  }
}
