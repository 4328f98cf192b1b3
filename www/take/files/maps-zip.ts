/** All maps in one zip file. */
import { strToU8, Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { exr } from './exr';
import type { Progress } from './pavement';
import { png } from './png';
import { mapsFor, maskOf } from './programs';
import { given } from './refusal';

/** `program` is one of PROGRAMS, or the word of the normal map. Throws a Refusal where there are no maps. */
export async function mapsZip(studio: Bubblestone, program: string, progress: Progress): Promise<Blob> {
  const parts: BlobPart[] = [];
  const zip = new Zip((error, part) => {
    if (error) throw error;
    parts.push(part);
  });
  const add = (file: ZipPassThrough | ZipDeflate, bytes: Uint8Array): void => {
    zip.add(file);
    file.push(bytes, true);
  };
  const maps = mapsFor(program);
  for (const [index, [word, name]] of maps.entries()) {
    const map = given(studio.map(word === 'mask' ? 'orm' : word));
    // PNG files are packed already.
    if (map.bits === 32) add(new ZipDeflate(name), exr(map));
    else add(new ZipPassThrough(name), await png(word === 'mask' ? maskOf(map) : map));
    progress((index + 1) / maps.length);
  }
  add(new ZipPassThrough('report.json'), strToU8(studio.report()));
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}
