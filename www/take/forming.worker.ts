/** Makes a recipe once more from its start to its end, and takes frames on the way. Never blocks the page: it is a worker. */
import { Bubblestone } from '../../pkg/bubblestone.js';
import { loadModule } from '../module';
import { progressOf } from '../progress';
import type { Status } from '../types';
import { gif, smaller, type Frame } from './film';
import type { Said } from './forming';

/** Sides in pixels; smaller pictures keep their own. */
const SIDE = 480;

/** Frames of the packing at most; there are half as many at least, where there are as many steps. */
const PACKING = 48;

/** Frames of the stones as they come. */
const STONES = 10;

/** Milliseconds. */
const SHOWN = { first: 500, step: 70, stones: 80, last: 2500 };

/** Making frames is this part of the work. */
const MAKING = 0.7;

const say = (said: Said): void => postMessage(said, 'file' in said ? { transfer: [said.file.buffer] } : {});

addEventListener('message', ({ data }: MessageEvent<string>) => {
  film(data).then(
    (file) => say({ file }),
    (error: unknown) => say({ trouble: error instanceof Error ? error.message : String(error) }),
  );
});

async function film(link: string): Promise<Uint8Array<ArrayBuffer>> {
  await loadModule();
  const studio = new Bubblestone(link);
  const side = Math.min(SIDE, studio.side());
  const picture = new Picture(side);
  const frame = (shown: number): Frame => {
    studio.draw(picture as unknown as CanvasRenderingContext2D, 'auto');
    return { pixels: picture.pixels, shown };
  };
  const packing: Frame[] = [];
  const later: Frame[] = [];
  let [stride, packed, placed] = [1, -1, 0];
  for (;;) {
    const stage = studio.stage();
    const status = studio.status() as Status;
    if (stage === 'error') throw new Error(studio.problem());
    if (stage === 'done') break;
    if (stage === 'packing' && status.cells && status.steps > packed && status.steps % stride === 0) {
      packed = status.steps;
      packing.push(frame(SHOWN.step));
      if (packing.length > PACKING) {
        // Twice as many steps from frame to frame.
        stride *= 2;
        packing.splice(0, packing.length, ...packing.filter((_, index) => index % 2 === 0));
      }
    } else if (stage === 'solids' && status.stones >= placed && status.stones) {
      later.push(frame(SHOWN.stones));
      placed += status.cells / STONES;
    }
    say({ progress: MAKING * progressOf(stage, status) });
    // As little at once as there is: one step of the packing, one stone.
    studio.tick(0, 1);
  }
  const frames = [...packing, ...later, frame(SHOWN.last)];
  studio.free();
  const [first] = frames;
  if (first && frames.length > 1) first.shown = SHOWN.first;
  return gif(frames, side, (done) => say({ progress: MAKING + (1 - MAKING) * done }));
}

/** What the studio needs of a canvas. */
class Picture {
  pixels: Uint8Array = new Uint8Array();

  constructor(private readonly side: number) {}

  putImageData({ data, width }: ImageData): void {
    // The studio hands over a view of its own memory, which does not stay.
    this.pixels = width === this.side ? new Uint8Array(data) : smaller(data, width, this.side);
  }
}
