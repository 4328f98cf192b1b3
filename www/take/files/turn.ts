/** Pictures of the turntable: a frame of its bodies, or a data plane of that frame. */
import { studioFor } from '../../module/given';
import { loadWhole } from '../../module/load';
import { BUDGET, generatorOf } from '../../module/run';
import type { SceneStudio } from '../../module/scene';
import { workedOut, type Progress } from './worked';
import { png } from './png';
import { given } from './refusal';

/**
 * The shown subject, camera and view. `subject` is '' for all bodies, or `ID:STEP` for a step in the making of one.
 * `view` matters for generators that are seen by frames only.
 */
export interface Seen {
  subject: string;
  camera: string;
  view: string;
}

/** The background behind the bodies. */
export type Backdrop = 'floor' | 'sky' | 'nothing';

/** The order for a square frame, or for one of its planes; `scale` multiplies the usual side. */
export interface TurnJob extends Seen {
  file: 'turn';
  plane: 'depth' | 'normal' | 'id' | undefined;
  side: number;
  scale: number;
  backdrop: Backdrop;
  /** The diameter of the lens, as a share of the distance in focus; 0 blurs nothing. */
  aperture: number;
}

/** The samples of a picture with blur by depth: fewer show as copies beside each other. */
const BLURRED = 48;

/** The progress at which the first frame begins. */
export const WORKED = 0.15;

/** Throws a Refusal if there is nothing to see. */
export async function turnFile(link: string, { plane, side, backdrop, aperture, ...seen }: TurnJob, progress: Progress): Promise<Blob> {
  const studio = await studioOf(link, progress);
  const rest = (done: number): void => progress(WORKED + (1 - WORKED) * done);
  // Planes have one sample.
  const how = plane ? 'still' : aperture ? `samples=${BLURRED}+aperture=${aperture}` : 'fine';
  const pixels = frameOf(studio, seen, side, `${how}+${backdrop}`, rest);
  if (plane) return png(given(studio.frameMap(plane)));
  return png(backdrop === 'nothing' ? { side, channels: 4, bits: 8, bytes: pixels } : { side, channels: 3, bits: 8, bytes: opaque(pixels) });
}

/** A studio with a finished recipe and its scene. Throws a Refusal if there is no picture. */
export async function studioOf(link: string, progress: Progress): Promise<SceneStudio> {
  const module = await loadWhole();
  const studio = await studioFor(module, link);
  workedOut(studio, generatorOf(module, studio), (done) => progress(WORKED * done));
  return studio;
}

/** The pixels of a square frame. Throws a Refusal if there is nothing to see. */
export function frameOf(studio: SceneStudio, { subject, camera, view }: Seen, side: number, how: string, progress: Progress): Uint8Array<ArrayBuffer> {
  for (;;) {
    const slice = given(studio.turn(subject, camera, side, side, `${how}+${view}`, BUDGET));
    progress(slice.progress);
    if (slice.done) return slice.pixels ?? new Uint8Array(4 * side * side);
  }
}

/** The RGB values of opaque pixels. */
function opaque(pixels: Uint8Array): Uint8Array<ArrayBuffer> {
  const out = new Uint8Array((pixels.length / 4) * 3);
  for (let from = 0, to = 0; from < pixels.length; from += 4) {
    out[to++] = pixels[from] ?? 0;
    out[to++] = pixels[from + 1] ?? 0;
    out[to++] = pixels[from + 2] ?? 0;
  }
  return out;
}
