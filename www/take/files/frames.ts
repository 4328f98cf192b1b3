/** The frames of the film of the forming: which pictures each of them shows, by steps of the packing. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { isPlacedByStep, isSettled, type Course } from '../../module/stages';
import type { Status } from '../../module/types';
import type { Look } from './look';
import { making } from '../../module/run';
import { contextOf } from './sheet';

type Canvas = OffscreenCanvas;

/** The number of frames of each part. */
const FRAMES = { opening: 8, start: 10, still: 6, cells: 9, standing: 6, stones: 40, light: 16, last: 66 };

/** Frames of the packing: a number for each step, within limits. */
const PACKING = { step: 2, least: 48, most: 96 };

/** Shows one picture, with `share` (0..1) of another one blended over it, for a number of frames. */
export type Show = (one: Canvas, other?: Canvas, share?: number, times?: number) => Promise<void>;

/** The number of frames in a film of `steps` steps. */
export function framesOf(steps: number): number {
  return Object.values(FRAMES).reduce((sum, count) => sum + count, paceOf(steps).length);
}

/**
 * Makes a picture again that was made before with this status. Shows the finished picture, its forming, and the
 * finished picture again.
 */
export async function showForming(studio: Bubblestone, course: Course, look: Look, finished: Canvas, { steps, stones }: Status, show: Show): Promise<void> {
  // If each step places bodies, the steps also get the frames of the cells and stones.
  const more = isPlacedByStep(course) ? FRAMES.cells + FRAMES.standing + FRAMES.stones : 0;
  await new Forming(studio, course, look, finished, paceOf(steps, more), steps, stones, show).run();
}

/**
 * The step that each frame of the packing shows. The first frames lie closer together in steps, because each early
 * step moves much.
 */
function paceOf(steps: number, more = 0): number[] {
  const frames = steps ? Math.min(PACKING.most, Math.max(PACKING.least, PACKING.step * steps)) + more : 0;
  return Array.from({ length: frames }, (_, frame) => {
    const at = frame / (frames - 1);
    return steps * (0.5 * at + 0.5 * at * at);
  });
}

class Forming {
  /** The previous picture and the current one. */
  private before: OffscreenCanvasRenderingContext2D;
  private now: OffscreenCanvasRenderingContext2D;
  private begun = false;
  /** The number of the next frame of the packing, from 0, and of the next frame of the stones, from 1. */
  private packed = 0;
  private placed = 1;
  private steps = -1;

  constructor(
    private readonly studio: Bubblestone,
    private readonly course: Course,
    private readonly seen: Look,
    private readonly finished: Canvas,
    private readonly pace: readonly number[],
    private readonly last: number,
    private readonly stones: number,
    private readonly show: Show,
  ) {
    this.before = contextOf(seen.side, seen.side);
    this.now = contextOf(seen.side, seen.side);
  }

  async run(): Promise<void> {
    this.studio.restart();
    const { stages, stepping, placing } = this.course;
    const first = stages.indexOf(stepping);
    const isPlaced = isPlacedByStep(this.course);
    let stood = false;
    for (const [stage, { steps, cells, stones }] of making(this.studio, 0, 1)) {
      const at = stages.indexOf(stage);
      // Up to the first step, the counts may be those of the run before. After the last one, bodies are seen once they are whole.
      const isHidden = isPlaced && (at <= first ? steps === this.last : !isSettled(this.course, stage));
      if (cells && steps > this.steps && !stood && !isHidden) await this.step(steps);
      const stonesCome = stage === placing && !isPlaced;
      if (stonesCome && !stood) {
        stood = true;
        await this.stand();
      }
      // The last stone ends its stage.
      if (stood && this.stones) await this.stone(stonesCome ? stones : this.stones);
    }
    // If no frame was drawn on the way, one is drawn now.
    if (!this.begun) await this.look();
    await this.dissolve(this.now.canvas, this.finished, FRAMES.light);
    await this.show(this.finished, this.finished, 0, FRAMES.last);
  }

  /** Draws the current picture. The first call begins the film. */
  private async look(): Promise<void> {
    [this.before, this.now] = [this.now, this.before];
    this.seen.draw(this.now);
    if (this.begun) return;
    this.begun = true;
    await this.show(this.finished, this.finished, 0, FRAMES.opening);
    await this.dissolve(this.finished, this.now.canvas, FRAMES.start);
    await this.show(this.now.canvas, this.now.canvas, 0, FRAMES.still);
  }

  /** To be called after a step of the packing: shows the frames up to that step. */
  private async step(steps: number): Promise<void> {
    const next = this.pace[this.packed] ?? Infinity;
    const last = this.steps;
    this.steps = steps;
    // Only steps next to a frame are drawn.
    if (next > steps + 1) return;
    await this.look();
    for (let at = this.pace[this.packed]; at !== undefined && at <= steps; at = this.pace[(this.packed += 1)]) {
      await this.show(this.before.canvas, this.now.canvas, last < 0 ? 1 : (at - last) / (steps - last));
    }
  }

  /** Shows that bubbles have become cells. */
  private async stand(): Promise<void> {
    await this.look();
    await this.dissolve(this.before.canvas, this.now.canvas, FRAMES.cells);
    await this.show(this.now.canvas, this.now.canvas, 0, FRAMES.standing);
  }

  /** Shows the frame that is due after a stone, if one is. */
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
