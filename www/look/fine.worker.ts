/** Runs a link and makes its picture with more pixels, in a worker that ends with the picture. So the page is never blocked. */
import { serve } from '../late/worker';
import { studioFor } from '../module/given';
import { loadModule } from '../module/load';
import { BUDGET, finish } from '../module/run';

/** The message to the worker: the recipe, and the number of fine pixels for one of its own, along a side. */
export type FineRequest = [link: string, scale: number];

/** The worker's answer; without a picture if the recipe gives none at this scale. */
export interface FineResult {
  picture?: ImageBitmap;
}

serve(
  async ([link, scale]: FineRequest): Promise<FineResult> => {
    const pixels = await painted(link, scale);
    return pixels ? { picture: await createImageBitmap(pixels) } : {};
  },
  ({ picture }) => (picture ? [picture] : []),
);

async function painted(link: string, scale: number): Promise<ImageData | undefined> {
  const module = await loadModule(link);
  const studio = await studioFor(module, link);
  finish(studio);
  const side = studio.side() * scale;
  const pixels = new ImageData(side, side);
  for (let at = 0; ; ) {
    const slice = studio.pictureFile(scale, '', BUDGET);
    if (!('maps' in slice)) return undefined;
    for (const { bytes } of slice.maps) at = put(bytes, pixels.data, at);
    if (slice.done) return pixels;
  }
}

/** Copies red, green and blue into RGBA pixels from `at` on; returns the next place. */
function put(rows: Uint8Array, pixels: Uint8ClampedArray, at: number): number {
  for (let k = 0; k < rows.length; k += 3, at += 4) {
    pixels[at] = rows[k] ?? 0;
    pixels[at + 1] = rows[k + 1] ?? 0;
    pixels[at + 2] = rows[k + 2] ?? 0;
    pixels[at + 3] = 255;
  }
  return at;
}
