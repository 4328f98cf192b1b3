/** All maps in one zip file. Loaded when it is asked for. */
import { strToU8, zipSync } from 'fflate';
import type { Engine } from './engine';
import { png } from './png';

/** `normals` is the word of the normal map. Throws a sentence where there are no maps. */
export async function mapsZip(engine: Engine, normals: string): Promise<Blob> {
  const files: Record<string, Uint8Array> = {};
  for (const word of ['height', normals, 'albedo', 'roughness', 'ao', 'id']) {
    const map = engine.map(word);
    if (typeof map === 'string') throw new Error(map);
    files[`${word}.png`] = await png(map);
  }
  files['report.json'] = strToU8(engine.report());
  // PNG files are packed already.
  const zip = zipSync(files, { level: 0 });
  return new Blob([zip], { type: 'application/zip' });
}
