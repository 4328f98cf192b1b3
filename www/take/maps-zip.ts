/** All maps in one zip file. */
import { strToU8, Zip, ZipPassThrough } from 'fflate';
import type { Engine } from '../engine';
import { png } from './png';
import { breath, type Task } from './working';

/** `normals` is the word of the normal map. Throws a sentence where there are no maps. */
export async function mapsZip(engine: Engine, normals: string, task: Task): Promise<Blob> {
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
    task.progress(index / words.length);
    await breath();
    task.signal.throwIfAborted();
    const map = engine.map(word);
    if (typeof map === 'string') throw new Error(map);
    add(`${word}.png`, await png(map));
  }
  add('report.json', strToU8(engine.report()));
  zip.end();
  return new Blob(parts, { type: 'application/zip' });
}
