/**
 * The looping animation of the forming.
 *
 * One step or one stone is made at a time, so frames do not depend on a clock.
 */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { Generator } from '../../module/types';
import { gif, smaller, type Frame } from './gif';
import { lookOf } from './look';
import { workedOut, type Progress } from './worked';
import type { Seen } from './turn';

/** The order for the animation. */
export interface GifJob extends Seen {
  file: 'gif';
}

/** The side in pixels; smaller pictures keep their own. */
const SIDE = 480;

/** The most frames of the packing. There are at least half as many if there are enough steps. */
const PACKING = 48;

/** Frames that show stones being placed. */
const STONES = 10;

/** Durations of frames in milliseconds. */
const SHOWN = { first: 500, step: 70, stones: 80, last: 2500 };

/** The share of the work that making frames takes; the rest is encoding. */
const MAKING = 0.7;

/** Throws a Refusal if there is no picture. */
export function formingGif(studio: Bubblestone, generator: Generator, job: GifJob, progress: Progress): Blob {
  const { stepping, placing } = generator;
  const look = lookOf(studio, generator, job, SIDE);
  const side = Math.min(SIDE, look.side);
  const picture = new Picture(side);
  const frame = (shown: number): Frame => {
    look.draw(picture);
    return { pixels: picture.pixels, shown };
  };
  const packing: Frame[] = [];
  const later: Frame[] = [];
  let [stride, packed, placed] = [1, -1, 0];
  workedOut(studio, generator, (done) => progress(MAKING * done), (stage, { cells, steps, stones }) => {
    if (stage === stepping && cells && steps > packed && steps % stride === 0) {
      packed = steps;
      packing.push(frame(SHOWN.step));
      if (packing.length > PACKING) {
        // From here on, twice as many steps lie between frames.
        stride *= 2;
        packing.splice(0, packing.length, ...packing.filter((_, index) => index % 2 === 0));
      }
    } else if (stage === placing && stones >= placed && stones) {
      later.push(frame(SHOWN.stones));
      placed += cells / STONES;
    }
  });
  const frames = [...packing, ...later, frame(SHOWN.last)];
  const [first] = frames;
  if (first && frames.length > 1) first.shown = SHOWN.first;
  return new Blob([gif(frames, side, (done) => progress(MAKING + (1 - MAKING) * done))], { type: 'image/gif' });
}

/** The part of a canvas' context that the studio draws to. */
class Picture {
  pixels: Uint8Array = new Uint8Array();

  constructor(private readonly side: number) {}

  putImageData({ data, width }: ImageData): void {
    // The studio passes a view of its own memory, which does not stay valid.
    this.pixels = width === this.side ? new Uint8Array(data) : smaller(data, width, this.side);
  }
}
