/** The finished picture at several times its side, written row after row as a PNG file. */
import type { Bubblestone, PictureSlice } from '../../../pkg/bubblestone.js';
import { BUDGET, type Progress } from './pavement';
import { PngWriter } from './png';
import { given } from './refusal';

/** Throws a Refusal where it cannot be made. */
export async function pictureFile(studio: Bubblestone, scale: number, progress: Progress): Promise<Blob> {
  let file: PngWriter | undefined;
  await eachSlice(studio, scale, progress, async ({ side, rows }) => {
    file ??= new PngWriter(side, 3, 8);
    await file.write(rows);
  });
  return new Blob(file ? [await file.finish()] : [], { type: 'image/png' });
}

/** Hands on the picture's rows as they come. Throws the same. */
export async function eachSlice(studio: Bubblestone, scale: number, progress: Progress, take: (slice: PictureSlice) => Promise<void> | void): Promise<void> {
  for (;;) {
    const slice = given(studio.pictureFile(scale, BUDGET));
    await take(slice);
    progress(slice.progress);
    if (slice.done) return;
  }
}
