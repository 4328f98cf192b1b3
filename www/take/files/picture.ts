/** The finished picture at several times its side, written row by row as a PNG file. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { bigger } from './bigger';
import type { Progress } from './worked';
import { PngWriter } from './png';

/** Throws a Refusal if it cannot be made. */
export async function pictureFile(studio: Bubblestone, scale: number, progress: Progress): Promise<Blob> {
  const file = new PngWriter(studio.side() * scale, 3, 8);
  await bigger(studio, scale, [], async ([rows]) => rows && file.write(rows.bytes), progress);
  return file.finish();
}
