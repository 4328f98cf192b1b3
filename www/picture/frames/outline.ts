/** The outline of a body in a frame: a light line on a dark rim, seen on any background. */
import type { PixelMap } from '../../module/types';

/** Half the widths of the line and of its rim, in pixels of the page, and their greys. */
const LINE = { half: 1, grey: 255 };
const RIM = { half: 2.25, grey: 20 };

/**
 * The outline of a body's visible parts in the map of numbers, transparent beside it; undefined if none is visible.
 * `fine` is the number of the map's pixels for one of the page, along a side.
 */
export function outlineIn({ side: width, bytes }: PixelMap, id: number, fine: number): ImageData | undefined {
  const height = bytes.length / 3 / width;
  // The module's colour for a body: the number times an odd factor, so that no two bodies share one.
  const colour = Math.imul(id, 0x9e3779) & 0xffffff;
  const isBody = (at: number): boolean => (((bytes[3 * at] ?? 0) << 16) | ((bytes[3 * at + 1] ?? 0) << 8) | (bytes[3 * at + 2] ?? 0)) === colour;
  const away = new Float32Array(width * height).fill(Infinity);
  const reach = Math.ceil(RIM.half * fine);
  let isSeen = false;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const at = y * width + x;
      if (!isBody(at)) continue;
      isSeen = true;
      const isBorder = (x > 0 && !isBody(at - 1)) || (x < width - 1 && !isBody(at + 1)) || (y > 0 && !isBody(at - width)) || (y < height - 1 && !isBody(at + width));
      if (!isBorder) continue;
      for (let v = Math.max(0, y - reach); v <= Math.min(height - 1, y + reach); v += 1) {
        for (let u = Math.max(0, x - reach); u <= Math.min(width - 1, x + reach); u += 1) {
          away[v * width + u] = Math.min(away[v * width + u] ?? 0, Math.hypot(u - x, v - y));
        }
      }
    }
  }
  return isSeen ? inked(away, width, height, fine) : undefined;
}

/** The pixels of a line, by their distances from its middle. */
function inked(away: Float32Array, width: number, height: number, fine: number): ImageData {
  const image = new ImageData(width, height);
  const cover = (half: number, far: number): number => Math.min(1, Math.max(0, half * fine + 0.5 - far));
  away.forEach((far, at) => {
    const rim = cover(RIM.half, far);
    if (!rim) return;
    const line = cover(LINE.half, far);
    image.data.fill(RIM.grey + (LINE.grey - RIM.grey) * line, 4 * at, 4 * at + 3);
    image.data[4 * at + 3] = 255 * rim;
  });
  return image;
}
