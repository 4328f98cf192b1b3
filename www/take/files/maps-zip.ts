/** All maps in one zip file. */
import { strToU8, Zip, ZipPassThrough } from 'fflate';
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { Progress } from './pavement';
import { png } from './png';
import { given } from './refusal';

/** `normals` is the word of the normal map. Throws a Refusal where there are no maps. */
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
    add(`${word}.png`, await png(given(studio.map(word))));
    progress((index + 1) / words.length);
  }
  add('report.json', strToU8(studio.report()));
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}
