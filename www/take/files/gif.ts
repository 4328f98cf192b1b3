/**
 * Frames of a film as a GIF. All frames share one palette; each frame stores only the pixels that differ from the one
 * before.
 */
import { applyPalette, GIFEncoder, quantize } from 'gifenc';

export interface Frame {
  /** Red, green, blue, alpha. */
  pixels: Uint8Array;
  /** The time for which it is shown, in milliseconds. */
  shown: number;
}

/** Colours of the palette; one more entry means "as before". */
const COLOURS = 255;

/** The number of pixels that decide the palette. Half of them come from the last frame, which is shown longest. */
const SAMPLE = 60_000;

/** `progress` gets 0..1. */
export function gif(frames: readonly Frame[], side: number, progress: (done: number) => void): Uint8Array<ArrayBuffer> {
  const palette = quantize(sample(frames), COLOURS);
  const same = palette.length;
  const encoder = GIFEncoder();
  let before: Uint8Array | undefined;
  frames.forEach(({ pixels, shown }, index) => {
    const now = applyPalette(pixels, palette);
    const changes = now.map((colour, at) => (before?.[at] === colour ? same : colour));
    const table = index === 0 ? { palette: [...palette, [0, 0, 0]], repeat: 0 } : {};
    encoder.writeFrame(changes, side, side, { ...table, delay: shown, transparent: index > 0, transparentIndex: same, dispose: 1 });
    before = now;
    progress((index + 1) / frames.length);
  });
  encoder.finish();
  return encoder.bytes();
}

function sample(frames: readonly Frame[]): Uint8Array {
  const last = frames.at(-1);
  const others = frames.filter((_, index) => index % Math.ceil(frames.length / 6) === 0);
  const taken = [...(last ? [every(last.pixels, SAMPLE / 2)] : []), ...others.map(({ pixels }) => every(pixels, SAMPLE / 2 / others.length))];
  const whole = new Uint32Array(taken.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of taken) {
    whole.set(part, at);
    at += part.length;
  }
  return new Uint8Array(whole.buffer);
}

/** About `count` pixels, spread over the picture. */
function every(rgba: Uint8Array, count: number): Uint32Array {
  const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, rgba.length / 4);
  // Odd steps do not sample the same columns in each row.
  const step = Math.max(1, Math.floor(pixels.length / count)) | 1;
  return Uint32Array.from({ length: Math.floor((pixels.length - 1) / step) + 1 }, (_, k) => pixels[k * step] ?? 0);
}

/** A square picture made smaller: each pixel is the mean of the area that it covers. */
export function smaller(rgba: Uint8ClampedArray, from: number, to: number): Uint8Array {
  const out = new Uint8Array(to * to * 4);
  const row = new Float32Array(from * 4);
  const spans = Array.from({ length: to }, (_, place) => covered(place, from / to, from));
  for (let y = 0; y < to; y += 1) {
    row.fill(0);
    for (const { at, share } of spans[y] ?? []) {
      for (let k = 0, source = 4 * at * from; k < row.length; k += 1, source += 1) row[k] = (row[k] ?? 0) + share * (rgba[source] ?? 0);
    }
    for (let x = 0, place = 4 * y * to; x < to; x += 1, place += 4) {
      // The 0.5 rounds the sums.
      let [red, green, blue] = [0.5, 0.5, 0.5];
      for (const { at, share } of spans[x] ?? []) {
        red += share * (row[4 * at] ?? 0);
        green += share * (row[4 * at + 1] ?? 0);
        blue += share * (row[4 * at + 2] ?? 0);
      }
      out[place] = red;
      out[place + 1] = green;
      out[place + 2] = blue;
      out[place + 3] = 255;
    }
  }
  return out;
}

/** The old pixels that a new pixel covers along one axis, with their shares of it. */
function covered(place: number, scale: number, from: number): { at: number; share: number }[] {
  const [begin, end] = [place * scale, Math.min(from, (place + 1) * scale)];
  const places = [];
  for (let at = Math.floor(begin); at < end; at += 1) places.push({ at, share: (Math.min(at + 1, end) - Math.max(at, begin)) / scale });
  return places;
}
