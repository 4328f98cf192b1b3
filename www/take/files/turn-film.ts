/** The film of the turntable. The camera goes round once, and the film loops. */
import { RATE, SHAPES, type Codec } from './codecs';
import { FilmEncoder, quickest } from './encoder';
import { gif, type Frame } from './gif';
import type { Progress } from './worked';
import { frameOf, studioOf, WORKED, type Seen } from './turn';

/** The order for the film; an animation (GIF) if no codec is given. */
export interface TurnFilmJob extends Seen {
  file: 'turn-film';
  codecs: Codec[];
}

/** Seconds of a turn. The animation (GIF) has few pixels and frames, because each of them makes its file large. */
const LENGTH = 6;
const ANIMATION = { side: 360, frames: 60 };

/** How much the turn slows down at its beginning and end, where the eye rests. */
const EASE = 0.5;

/** Throws a Refusal if there is nothing to see. */
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

/** Eases 0..1: slow at both ends, which join without a jerk. */
function eased(part: number): number {
  return part - (EASE * Math.sin(2 * Math.PI * part)) / (2 * Math.PI);
}

function clamped(pixels: Uint8Array<ArrayBuffer>): Uint8ClampedArray {
  return new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length);
}
