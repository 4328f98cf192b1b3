/** The files and codecs that a film may be made in, and which of them the browser at hand encodes. */

import type { Matrix } from './planes';

/** The shapes of a film, in pixels: even, as codecs have it. */
export const SHAPES = { square: { width: 1080, height: 1080 }, upright: { width: 1080, height: 1920 }, turn: { width: 720, height: 720 } };
export type Shape = keyof typeof SHAPES;

/** Those of the film of the forming. */
export type FormingShape = Exclude<Shape, 'turn'>;

/** Frames a second. */
export const RATE = 30;

/** Bits for each pixel of a frame, and frame. */
const BITS = 0.16;

/** A codec as browsers call it, and as its file does; levels fit the largest shape. */
export interface Codec {
  file: 'mp4' | 'webm';
  codec: string;
  track: 'avc' | 'vp9' | 'vp8' | 'av1';
  matrix: Matrix;
}

/** The best first: what phones and networks take. */
const CODECS: readonly Codec[] = [
  { file: 'mp4', codec: 'avc1.640028', track: 'avc', matrix: 'bt709' },
  { file: 'mp4', codec: 'avc1.4d0028', track: 'avc', matrix: 'bt709' },
  { file: 'mp4', codec: 'avc1.420028', track: 'avc', matrix: 'bt709' },
  { file: 'webm', codec: 'vp09.00.40.08', track: 'vp9', matrix: 'bt709' },
  { file: 'webm', codec: 'vp8', track: 'vp8', matrix: 'smpte170m' },
  { file: 'webm', codec: 'av01.0.08M.08', track: 'av1', matrix: 'bt709' },
];

/** The codecs of the best file that the browser encodes in this shape: two of them where time is to tell which; none where it encodes none. */
export async function codecsFor(shape: Shape): Promise<Codec[]> {
  if (!('VideoEncoder' in globalThis && 'OffscreenCanvas' in globalThis)) return [];
  const found: Codec[] = [];
  for (const codec of CODECS) {
    const known = await VideoEncoder.isConfigSupported(encoding(codec, shape)).catch(() => undefined);
    if (known?.supported) found.push(codec);
  }
  return found[0]?.file === 'webm' ? found.slice(0, 2) : found.slice(0, 1);
}

/** What an encoder is told. */
export function encoding({ file, codec }: Codec, shape: Shape): VideoEncoderConfig {
  const { width, height } = SHAPES[shape];
  const plain: VideoEncoderConfig = { codec, width, height, framerate: RATE, bitrate: Math.round(BITS * width * height * RATE) };
  return file === 'mp4' ? { ...plain, avc: { format: 'avc' } } : { ...plain, latencyMode: 'realtime' };
}
