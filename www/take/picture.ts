/** The finished picture at several times its side, written row after row as a PNG file. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { PictureSlice } from '../types';
import { BUDGET, type Progress } from './pavement';
import { PngWriter } from './png';

/** Throws a sentence where it cannot be made. */
export async function pictureFile(studio: Bubblestone, scale: number, progress: Progress): Promise<Blob> {
  let file: PngWriter | undefined;
  for (;;) {
    const slice = studio.pictureFile(scale, BUDGET) as PictureSlice | string;
    if (typeof slice === 'string') throw new Error(slice);
    file ??= new PngWriter(slice.side, 3, 8);
    await file.write(slice.rows);
    progress(slice.progress);
    if (slice.done) return new Blob([await file.finish()], { type: 'image/png' });
  }
}
