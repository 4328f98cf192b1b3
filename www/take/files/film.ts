/**
 * The film of the forming: the finished picture, then how it came about, to the finished picture again, so that it loops.
 *
 * The picture is made twice. The first time tells how many steps it takes, and what it ends with; the second time goes from
 * frame to frame. So every film has about the same length, and frames depend on steps, never on a clock.
 */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { Codec, Shape } from './codecs';
import { FilmEncoder } from './encoder';
import { making, pavement, type Progress } from './pavement';
import { eachSlice } from './picture';
import { contextOf, Sheet, type Words } from './sheet';

export interface FilmJob {
  file: 'film';
  codec: Codec;
  shape: Shape;
  words: Words;
}

/** Frames of the parts. */
const FRAMES = { opening: 8, start: 10, still: 6, cells: 9, standing: 6, stones: 40, light: 16, last: 66 };

/** Frames of the packing: so many for each step, within limits. */
const PACKING = { step: 2, least: 48, most: 96 };

/** The parts of the work: the picture, the picture larger, the frames. */
const FIRST = 0.12;
const SECOND = 0.2;

/** The most that a picture file is enlarged. */
const MOST = 4;

type Canvas = OffscreenCanvas;

/** Throws a Refusal where there is no picture. */
export async function formingFilm(studio: Bubblestone, stages: readonly string[], { codec, shape, words }: FilmJob, progress: Progress): Promise<Blob> {
  const sheet = new Sheet(shape, words);
  pavement(studio, stages, (done) => progress(FIRST * done));
  const { steps, stones } = studio.status();
  const finished = await largePicture(studio, sheet.side, (done) => progress(FIRST + (SECOND - FIRST) * done));
  sheet.lay(finished);
  const encoder = await FilmEncoder.of(codec, shape);
  const pace = paceOf(steps);
  const whole = Object.values(FRAMES).reduce((sum, count) => sum + count, pace.length);
  let made = 0;
  const show: Show = async (one, other = one, share = 0, times = 1) => {
    await encoder.add(sheet.frame(one, other, share), times);
    made += times;
    progress(SECOND + (1 - SECOND) * (made / whole));
  };
  await new Forming(studio, finished, pace, stones, show).run();
  return encoder.finish();
}

/** One picture, and so much of another over it, 0..1, for so many frames. */
type Show = (one: Canvas, other?: Canvas, share?: number, times?: number) => Promise<void>;

/** At which step each frame of the packing is: few steps at first, when each of them moves much. */
export function paceOf(steps: number): number[] {
  const frames = steps ? Math.min(PACKING.most, Math.max(PACKING.least, PACKING.step * steps)) : 0;
  return Array.from({ length: frames }, (_, frame) => {
    const at = frame / (frames - 1);
    return steps * (0.5 * at + 0.5 * at * at);
  });
}

class Forming {
  /** What was seen last, and what is seen now. */
  private before: OffscreenCanvasRenderingContext2D;
  private now: OffscreenCanvasRenderingContext2D;
  private begun = false;
  /** The next frames of the packing and of the stones. */
  private packed = 0;
  private placed = 1;
  private steps = -1;

  constructor(
    private readonly studio: Bubblestone,
    private readonly finished: Canvas,
    private readonly pace: readonly number[],
    private readonly stones: number,
    private readonly show: Show,
  ) {
    this.before = contextOf(studio.side(), studio.side());
    this.now = contextOf(studio.side(), studio.side());
  }

  async run(): Promise<void> {
    this.studio.restart();
    let stood = false;
    for (const [stage, { steps, cells, stones }] of making(this.studio, 0, 1)) {
      if (cells && steps > this.steps && !stood) await this.step(steps);
      if (stage === 'planes' && !stood) {
        stood = true;
        await this.stand();
      }
      if (stage === 'planes' && stones) await this.stone(stones);
    }
    // Where nothing was seen on the way, this is seen.
    if (!this.begun) await this.look();
    await this.dissolve(this.now.canvas, this.finished, FRAMES.light);
    await this.show(this.finished, this.finished, 0, FRAMES.last);
  }

  /** Draws what there is now; the first time the film begins. */
  private async look(): Promise<void> {
    [this.before, this.now] = [this.now, this.before];
    this.studio.draw(this.now as unknown as CanvasRenderingContext2D, 'auto');
    if (this.begun) return;
    this.begun = true;
    await this.show(this.finished, this.finished, 0, FRAMES.opening);
    await this.dissolve(this.finished, this.now.canvas, FRAMES.start);
    await this.show(this.now.canvas, this.now.canvas, 0, FRAMES.still);
  }

  /** After a step of the packing: the frames up to it. */
  private async step(steps: number): Promise<void> {
    const next = this.pace[this.packed] ?? Infinity;
    const last = this.steps;
    this.steps = steps;
    // Only what lies beside a frame is drawn.
    if (next > steps + 1) return;
    await this.look();
    for (let at = this.pace[this.packed]; at !== undefined && at <= steps; at = this.pace[(this.packed += 1)]) {
      await this.show(this.before.canvas, this.now.canvas, last < 0 ? 1 : at - last);
    }
  }

  /** Bubbles have become cells. */
  private async stand(): Promise<void> {
    await this.look();
    await this.dissolve(this.before.canvas, this.now.canvas, FRAMES.cells);
    await this.show(this.now.canvas, this.now.canvas, 0, FRAMES.standing);
  }

  /** After a stone: the frame that is due. */
  private async stone(stones: number): Promise<void> {
    if (stones < (this.placed / FRAMES.stones) * this.stones) return;
    await this.look();
    for (; stones >= (this.placed / FRAMES.stones) * this.stones && this.placed <= FRAMES.stones; this.placed += 1) await this.show(this.now.canvas);
  }

  private async dissolve(one: Canvas, other: Canvas, frames: number): Promise<void> {
    for (let frame = 1; frame <= frames; frame += 1) {
      const at = frame / (frames + 1);
      await this.show(one, other, at * at * (3 - 2 * at));
    }
  }
}

/** The finished picture, with as many pixels as the sheet has for it where that can be. */
async function largePicture(studio: Bubblestone, side: number, progress: Progress): Promise<Canvas> {
  const scale = Math.min(MOST, Math.ceil(side / studio.side()));
  const context = contextOf(scale * studio.side(), scale * studio.side());
  let row = 0;
  await eachSlice(studio, scale, progress, ({ rows, side }) => {
    const count = rows.length / 3 / side;
    if (!count) return;
    const image = context.createImageData(side, count);
    const { data } = image;
    for (let from = 0, to = 0; to < data.length; to += 1) data[to] = (to & 3) === 3 ? 255 : (rows[from++] ?? 0);
    context.putImageData(image, 0, row);
    row += count;
  });
  studio.stopFile();
  return context.canvas;
}
