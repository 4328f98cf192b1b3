/** The files and codecs that a film may be made in, and which of them this browser can encode. */

import type { Matrix } from './planes';

/** The sizes of a film, in pixels. They are even because codecs require it. */
export const SHAPES = { square: { width: 1080, height: 1080 }, upright: { width: 1080, height: 1920 }, turn: { width: 720, height: 720 } };
export type Shape = keyof typeof SHAPES;

/** The shapes of the film of the forming. */
export type FormingShape = Exclude<Shape, 'turn'>;

/** Frames in a second. */
export const RATE = 30;

/** Bits for each pixel of each frame. */
const BITS = 0.16;

/**
 * A codec: its name for browsers, its name for the file, and its colour matrix. The levels in the names fit the
 * largest shape.
 */
export interface Codec {
  file: 'mp4' | 'webm';
  codec: string;
  track: 'avc' | 'vp9' | 'vp8' | 'av1';
  matrix: Matrix;
}

/** The best first: phones and networks accept these files. */
const CODECS: readonly Codec[] = [
  { file: 'mp4', codec: 'avc1.640028', track: 'avc', matrix: 'bt709' },
  { file: 'mp4', codec: 'avc1.4d0028', track: 'avc', matrix: 'bt709' },
  { file: 'mp4', codec: 'avc1.420028', track: 'avc', matrix: 'bt709' },
  { file: 'webm', codec: 'vp09.00.40.08', track: 'vp9', matrix: 'bt709' },
  { file: 'webm', codec: 'vp8', track: 'vp8', matrix: 'smpte170m' },
  { file: 'webm', codec: 'av01.0.08M.08', track: 'av1', matrix: 'bt709' },
];

/**
 * The codecs of the best file that the browser encodes in this shape; empty if it encodes no film. Two codecs are
 * returned if only a measurement can tell which is faster.
 */
export async function codecsFor(shape: Shape): Promise<Codec[]> {
  if (!('VideoEncoder' in globalThis && 'OffscreenCanvas' in globalThis)) return [];
  const found: Codec[] = [];
  for (const codec of CODECS) {
    const known = await VideoEncoder.isConfigSupported(encoding(codec, shape)).catch(() => undefined);
    if (known?.supported) found.push(codec);
  }
  return found[0]?.file === 'webm' ? found.slice(0, 2) : found.slice(0, 1);
}

/** The configuration of an encoder. */
export function encoding({ file, codec }: Codec, shape: Shape): VideoEncoderConfig {
  const { width, height } = SHAPES[shape];
  const plain: VideoEncoderConfig = { codec, width, height, framerate: RATE, bitrate: Math.round(BITS * width * height * RATE) };
  return file === 'mp4' ? { ...plain, avc: { format: 'avc' } } : { ...plain, latencyMode: 'realtime' };
}
