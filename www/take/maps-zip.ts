/** All maps in one zip file. */
import { strToU8, Zip, ZipPassThrough } from 'fflate';
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { PixelMap } from '../types';
import type { Progress } from './pavement';
import { png } from './png';

/** `normals` is the word of the normal map. Throws a sentence where there are no maps. */
export async function mapsZip(studio: Bubblestone, normals: string, progress: Progress): Promise<Blob> {
  const parts: BlobPart[] = [];
  const zip = new Zip((error, part) => {
    if (error) throw error;
    parts.push(part);
  });
  // PNG files are packed already.
  const add = (name: string, bytes: Uint8Array): void => {
    const file = new ZipPassThrough(name);
    zip.add(file);
    file.push(bytes, true);
  };
  const words = ['height', normals, 'albedo', 'roughness', 'ao', 'id'];
  for (const [index, word] of words.entries()) {
    const map = studio.map(word) as PixelMap | string;
    if (typeof map === 'string') throw new Error(map);
    add(`${word}.png`, await png(map));
    progress((index + 1) / words.length);
  }
  add('report.json', strToU8(studio.report()));
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}
