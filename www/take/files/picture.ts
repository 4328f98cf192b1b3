/** The finished picture at several times its side, written row after row as a PNG file. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { BUDGET, type Progress } from './pavement';
import { PngWriter } from './png';
import { given } from './refusal';

/** Throws a Refusal where it cannot be made. */
export async function pictureFile(studio: Bubblestone, scale: number, progress: Progress): Promise<Blob> {
  let file: PngWriter | undefined;
  for (;;) {
    const slice = given(studio.pictureFile(scale, BUDGET));
    file ??= new PngWriter(slice.side, 3, 8);
    await file.write(slice.rows);
    progress(slice.progress);
    if (slice.done) return new Blob([await file.finish()], { type: 'image/png' });
  }
}
