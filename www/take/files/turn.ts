/** Files of the turntable: a frame of its bodies, a plane of it, and a film of one turn, which loops. */
import { loadWhole } from '../../module/load';
import type { SceneStudio } from '../../module/scene';
import { RATE, SHAPES, type Codec } from './codecs';
import { FilmEncoder, quickest } from './encoder';
import { gif, type Frame } from './gif';
import { BUDGET, pavement, type Progress } from './pavement';
import { png } from './png';
import { given } from './refusal';

/** What is to be seen, all of it ('') or a step in the making of a body (`ID:STEP`), and the words of where from. */
export interface Seen {
  subject: string;
  camera: string;
}

/** What is behind the bodies. */
export type Backdrop = 'floor' | 'sky' | 'nothing';

/** A square frame, or one of its planes; `scale` is times the usual side. */
export interface TurnJob extends Seen {
  file: 'turn';
  plane: 'depth' | 'normal' | 'id' | undefined;
  side: number;
  scale: number;
  backdrop: Backdrop;
}

/** A film, or where there is no codec an animation. */
export interface TurnFilmJob extends Seen {
  file: 'turn-film';
  codecs: Codec[];
}

/** The share of the work before the first frame. */
const WORKED = 0.15;

/** Seconds of a turn; of an animation, pixels along a side and frames, which are large in its file. */
const LENGTH = 6;
const ANIMATION = { side: 360, frames: 60 };

/** How much slower than evenly the turn begins and ends: there the eye comes to rest. */
const EASE = 0.5;

/** Throws a Refusal where there is nothing to be seen. */
export async function turnFile(link: string, { plane, side, backdrop, subject, camera }: TurnJob, progress: Progress): Promise<Blob> {
  const studio = await studioOf(link, progress);
  const rest = (done: number): void => progress(WORKED + (1 - WORKED) * done);
  // Planes have no smooth edges.
  const pixels = frameOf(studio, { subject, camera }, side, `${plane ? 'still' : 'fine'}+${backdrop}`, rest);
  if (plane) return png(given(studio.frameMap(plane)));
  return png(backdrop === 'nothing' ? { side, channels: 4, bits: 8, bytes: pixels } : { side, channels: 3, bits: 8, bytes: opaque(pixels) });
}

/** One turn of the viewer. Throws a Refusal where there is nothing to be seen. */
export async function turnFilm(link: string, { codecs, subject, camera }: TurnFilmJob, progress: Progress): Promise<Blob> {
  const studio = await studioOf(link, progress);
  const [side, count] = codecs.length ? [SHAPES.turn.width, LENGTH * RATE] : [ANIMATION.side, ANIMATION.frames];
  const [angle = '', ...others] = camera.split(',');
  const frame = (k: number): Uint8Array<ArrayBuffer> => {
    const at = (Number(angle) + 360 * eased(k / count)) % 360;
    const part = (done: number): void => progress(WORKED + ((1 - WORKED) * (k + done)) / count);
    return frameOf(studio, { subject, camera: [at.toFixed(3), ...others].join() }, side, 'still', part);
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

async function studioOf(link: string, progress: Progress): Promise<SceneStudio> {
  const module = await loadWhole();
  const studio = new module.Bubblestone(link);
  const { stages = [] } = module.generators().find(({ word }) => word === studio.generator()) ?? {};
  pavement(studio, stages, (done) => progress(WORKED * done));
  return studio;
}

function frameOf(studio: SceneStudio, { subject, camera }: Seen, side: number, how: string, progress: Progress): Uint8Array<ArrayBuffer> {
  for (;;) {
    const slice = given(studio.turn(subject, camera, side, side, how, BUDGET));
    progress(slice.progress);
    if (slice.done) return slice.pixels ?? new Uint8Array(4 * side * side);
  }
}

/** From 0 to 1, slow at both ends, which meet without a jerk. */
function eased(part: number): number {
  return part - (EASE * Math.sin(2 * Math.PI * part)) / (2 * Math.PI);
}

function clamped(pixels: Uint8Array<ArrayBuffer>): Uint8ClampedArray {
  return new Uint8ClampedArray(pixels.buffer, pixels.byteOffset, pixels.length);
}

/** Red, green, blue of pixels that hide all. */
function opaque(pixels: Uint8Array): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array((pixels.length / 4) * 3);
  for (let from = 0, to = 0; from < pixels.length; from += 4) {
    out[to++] = pixels[from] ?? 0;
    out[to++] = pixels[from + 1] ?? 0;
    out[to++] = pixels[from + 2] ?? 0;
  }
  return out;
}
