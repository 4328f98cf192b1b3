/** The meshes of all cells and of the ground, for other programs. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { BUDGET } from '../../module/run';
import { png } from './png';
import { given } from './refusal';

/**
 * The order for a mesh file. `detail` is 'low', 'middle' or 'high'. Only GLB files may have images or, by the second
 * module, one mesh of all bodies.
 */
export interface MeshJob {
  file: 'glb' | 'obj';
  detail: string;
  images?: boolean;
  joined?: boolean;
}

const TYPES = { glb: 'model/gltf-binary', obj: 'model/obj' };

/** Throws a Refusal if it cannot be made. */
export async function meshFile(studio: Bubblestone, { file, detail, images, joined }: MeshJob): Promise<Blob> {
  const pictures: Blob[] = [];
  if (images) for (const word of ['albedo', 'normal-opengl', 'orm']) pictures.push(await png(given(studio.map(word))));
  const lengths = Uint32Array.from(pictures, ({ size }) => size);
  const parts: BlobPart[] = [];
  for (;;) {
    const slice = given(studio.meshFile(file, joined ? `${detail}+joined` : detail, lengths, BUDGET));
    parts.push(...slice.parts);
    if (slice.done) break;
  }
  // The file ends with the images, each padded to a multiple of four bytes.
  for (const picture of pictures) parts.push(picture, new Uint8Array(-picture.size & 3));
  return new Blob(parts, { type: TYPES[file] });
}
