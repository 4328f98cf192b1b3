/**
 * Pixels in the format of films (YUV 4:2:0, limited range): luma for every pixel, and the two colour differences for
 * every second pixel of every second row. Browsers can convert too, but not all with the same matrix.
 */

/**
 * The matrix of the conversion, as browsers name it. VP8 supports BT.601 only; for newer codecs players assume that
 * large films are BT.709.
 */
export type Matrix = 'bt709' | 'smpte170m';

/** Weights of red, green and blue in the luma. */
const SHARES: Record<Matrix, readonly [number, number, number]> = { bt709: [0.2126, 0.7152, 0.0722], smpte170m: [0.299, 0.587, 0.114] };

/** Fixed-point unit of the conversion: coefficients are multiples of 2^-16. */
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
