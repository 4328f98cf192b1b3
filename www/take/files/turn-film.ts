/** The film of the turntable: the camera goes round once, and the film loops. */
import { RATE, SHAPES, type Codec } from './codecs';
import { FilmEncoder, quickest } from './encoder';
import { gif, type Frame } from './gif';
import type { Progress } from './worked';
import { frameOf, studioOf, WORKED, type Seen } from './turn';

/** A film or, without codecs, an animation. */
export interface TurnFilmJob extends Seen {
  file: 'turn-film';
  codecs: Codec[];
}

/** The seconds of a turn; and the pixels along a side and the frames of an animation, which make its file large. */
const LENGTH = 6;
const ANIMATION = { side: 360, frames: 60 };

/** How much slower the turn is at its start and end, where the eye rests. */
const EASE = 0.5;

/** Throws a Refusal if there is nothing to show. */
export async function turnFilm(link: string, { codecs, subject, camera, view }: TurnFilmJob, progress: Progress): Promise<Blob> {
  const studio = await studioOf(link, progress);
  const [side, count] = codecs.length ? [SHAPES.turn.width, LENGTH * RATE] : [ANIMATION.side, ANIMATION.frames];
  const [angle = '', ...others] = camera.split(',');
  const frame = (k: number): Uint8Array<ArrayBuffer> => {
    const at = (Number(angle) + 360 * eased(k / count)) % 360;
    const part = (done: number): void => progress(WORKED + ((1 - WORKED) * (k + done)) / count);
    return frameOf(studio, { subject, camera: [at.toFixed(3), ...others].join(), view }, side, 'still', part);
  };
  if (!codecs.length) {
    const frames = Array.from({ length: count }, (_, k): Frame => ({ pixels: frame(k), shown: (1000 * LENGTH) / count }));
    return new Blob([gif(frames, side, () => undefined)], { type: 'image/gif' });
  }
  const codec = await quickest(codecs, 'turn', clamped(frame(0)));
  const encoder = await FilmEncoder.of(codec, 'turn');
  for (let k = 0; k < count; k += 1) await encoder.add(clamped(frame(k)));
  return encoder.finish();
}

/** Maps 0..1 to 0..1, slowly at both ends, which join without a jerk. */
function eased(part: number): number {
  return part - (EASE * Math.sin(2 * Math.PI * part)) / (2 * Math.PI);
}

function clamped(pixels: Uint8Array<ArrayBuffer>): Uint8ClampedArray {
  return new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length);
}
