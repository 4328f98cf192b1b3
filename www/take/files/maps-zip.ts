/** All maps in one ZIP file. */
import { strToU8, Zip, ZipDeflate, ZipPassThrough } from 'fflate';
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import type { PixelMap } from '../../module/types';
import { bigger } from './bigger';
import { ExrWriter } from './exr';
import { FileParts, type RowWriter } from './parts';
import type { Progress } from './worked';
import { PngWriter } from './png';
import { mapsFor, maskOf } from './programs';
import { given } from './refusal';

/** `program` is one of PROGRAMS, or the word of the normal map; `scale` multiplies the picture's side. */
export interface MapsJob {
  file: 'maps';
  program: string;
  scale: number;
}

/** The share of the work before the ZIP file is assembled. */
const MADE = 0.85;

/** Throws a Refusal if there are no maps. */
export async function mapsZip(studio: Bubblestone, { program, scale }: MapsJob, progress: Progress): Promise<Blob> {
  const maps = mapsFor(program);
  const words = maps.map(([word]) => (word === 'mask' ? 'orm' : word));
  const writers: RowWriter[] = [];
  const take = async (made: PixelMap[]): Promise<void> => {
    for (const [k, { side, channels, bits, bytes }] of made.entries()) {
      const packs = maps[k]?.[0] === 'mask';
      const writer = (writers[k] ??= bits === 32 ? new ExrWriter(side) : new PngWriter(side, packs ? 4 : channels, bits));
      await writer.write(packs ? maskOf(bytes) : bytes);
    }
  };
  let report = studio.report();
  // The picture's own pixels exist already.
  if (scale === 1) await take(words.map((word) => given(studio.map(word))));
  else {
    const heights = await bigger(studio, scale, words, take, (done) => progress(MADE * done));
    report = JSON.stringify({ ...(JSON.parse(report) as object), scale, height_range: heights }, undefined, 2);
  }
  const zip = new ZipFile();
  for (const [k, writer] of writers.entries()) {
    progress(MADE + ((1 - MADE) * k) / writers.length);
    await zip.add(maps[k]?.[1] ?? '', await writer.finish());
  }
  await zip.add('report.json', new Blob([strToU8(report)]));
  return zip.finish();
}

/** A ZIP file of several files, none of which is in memory as a whole. */
class ZipFile {
  private readonly parts = new FileParts();
  private readonly zip = new Zip((error, part) => {
    if (error) throw error;
    this.parts.add(part);
  });

  async add(name: string, content: Blob): Promise<void> {
    // PNG files are compressed already.
    const file = name.endsWith('.exr') ? new ZipDeflate(name, { level: 1 }) : new ZipPassThrough(name);
    this.zip.add(file);
    const reader = content.stream().getReader();
    for (let piece = await reader.read(); !piece.done; piece = await reader.read()) file.push(piece.value);
    file.push(new Uint8Array(), true);
  }

  finish(): Blob {
    this.zip.end();
    return this.parts.file('application/zip');
  }
}
