/**
 * Pixels in the format of films: the brightness of every pixel, and the two colour differences of every second pixel
 * in every second row (limited range). Browsers would convert them too, but not all with the same matrix.
 */

/**
 * The conversion matrices by the browsers' words. VP8 knows BT.601 only; newer codecs expect BT.709 for large films.
 */
export type Matrix = 'bt709' | 'smpte170m';

/** The shares of red, green and blue in the brightness. */
const SHARES: Record<Matrix, readonly [number, number, number]> = { bt709: [0.2126, 0.7152, 0.0722], smpte170m: [0.299, 0.587, 0.114] };

/** The factors from 0..255 to brightness, and to the differences of blue and red from it, in units of 2^-16. */
const UNIT = 2 ** 16;
type Row = readonly [red: number, green: number, blue: number];

function rowsOf(matrix: Matrix): [y: Row, u: Row, v: Row] {
  const [red, green, blue] = SHARES[matrix];
  const row = (range: number, ...parts: Row): Row => {
    const [r, g, b] = parts.map((part) => Math.round((part * UNIT * range) / 255));
    return [r ?? 0, g ?? 0, b ?? 0];
  };
  return [row(219, red, green, blue), row(112 / (1 - blue), -red, -green, 1 - blue), row(112 / (1 - red), 1 - red, -green, -blue)];
}

/** All three planes one after the other (I420); sides are even. */
export function planesOf(rgba: Uint8ClampedArray, width: number, height: number, matrix: Matrix): Uint8Array<ArrayBuffer> {
  const planes = new Uint8Array((width * height * 3) / 2);
  const [light, [ur, ug, ub], [vr, vg, vb]] = rowsOf(matrix);
  brightness(rgba, light, planes);
  const blue = width * height;
  const half = UNIT / 2;
  let to = blue;
  for (let y = 0; y < height; y += 2) {
    for (let x = 0; x < width; x += 2, to += 1) {
      const a = 4 * (y * width + x);
      const b = a + 4 * width;
      const sum = (channel: number): number => (rgba[a + channel] ?? 0) + (rgba[a + 4 + channel] ?? 0) + (rgba[b + channel] ?? 0) + (rgba[b + 4 + channel] ?? 0);
      const [red, green, last] = [sum(0), sum(1), sum(2)];
      planes[to] = 128 + ((ur * red + ug * green + ub * last + 4 * half) >> 18);
      planes[to + blue / 4] = 128 + ((vr * red + vg * green + vb * last + 4 * half) >> 18);
    }
  }
  return planes;
}

function brightness(rgba: Uint8ClampedArray, [red, green, blue]: Row, planes: Uint8Array): void {
  for (let from = 0, to = 0; from < rgba.length; from += 4, to += 1) {
    planes[to] = 16 + ((red * (rgba[from] ?? 0) + green * (rgba[from + 1] ?? 0) + blue * (rgba[from + 2] ?? 0) + UNIT / 2) >> 16);
  }
}
