/**
 * Pixels as films have them: brightness of every pixel, and the two differences of colour of every second one of every
 * second row (ITU-R BT.709, limited range). Browsers would do the same, but not all by the same matrix.
 */

/** Thousandths of red, green and blue in the brightness. */
const [RED, GREEN, BLUE] = [0.2126, 0.7152, 0.0722] as const;

/** From 0..255 to brightness, and to differences of blue and red from it, in parts of 2^16. */
const UNIT = 2 ** 16;
const Y = [RED, GREEN, BLUE].map((part) => Math.round((part * UNIT * 219) / 255));
const U = [-RED, -GREEN, 1 - BLUE].map((part) => Math.round((part * UNIT * 224) / 255 / (2 - 2 * BLUE)));
const V = [1 - RED, -GREEN, -BLUE].map((part) => Math.round((part * UNIT * 224) / 255 / (2 - 2 * RED)));

/** All three after each other (I420); sides are even. */
export function planesOf(rgba: Uint8ClampedArray, width: number, height: number): Uint8Array<ArrayBuffer> {
  const planes = new Uint8Array((width * height * 3) / 2);
  brightness(rgba, planes);
  const blue = width * height;
  const half = UNIT / 2;
  const [[ur = 0, ug = 0, ub = 0], [vr = 0, vg = 0, vb = 0]] = [U, V];
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

function brightness(rgba: Uint8ClampedArray, planes: Uint8Array): void {
  const [red = 0, green = 0, blue = 0] = Y;
  for (let from = 0, to = 0; from < rgba.length; from += 4, to += 1) {
    planes[to] = 16 + ((red * (rgba[from] ?? 0) + green * (rgba[from + 1] ?? 0) + blue * (rgba[from + 2] ?? 0) + UNIT / 2) >> 16);
  }
}
