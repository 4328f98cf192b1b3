/** Planes of a frame as RGBA pixels. */
import type { PixelMap } from '../../module/types';

/** The opaque pixels of a map. 16 bit greys are shown by their high byte. */
export function pixelsOf({ channels, bits, bytes }: PixelMap): Uint8ClampedArray<ArrayBuffer> {
  const each = (channels * bits) / 8;
  const pixels = new Uint8ClampedArray((4 * bytes.length) / each).fill(255);
  for (let from = 0, to = 0; from < bytes.length; from += each, to += 4) {
    for (let k = 0; k < 3; k += 1) pixels[to + k] = bytes[from + (channels === 3 ? k : 0)] ?? 0;
  }
  return pixels;
}

/** The coverage of each pixel from black to white, in a frame without a background. */
export function coverage(pixels: Uint8Array): Uint8ClampedArray<ArrayBuffer> {
  const grey = new Uint8ClampedArray(pixels.length).fill(255);
  for (let at = 0; at < pixels.length; at += 4) grey.fill(pixels[at + 3] ?? 0, at, at + 3);
  return grey;
}
