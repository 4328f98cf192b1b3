/** The surface of all cells, for other programs. */
import type { Bubblestone } from '../../pkg/bubblestone.js';
import type { MeshSlice } from '../types';
import { BUDGET } from './pavement';

const TYPES = { glb: 'model/gltf-binary', obj: 'model/obj' };

/** Throws a sentence where it cannot be made. */
export function meshFile(studio: Bubblestone, ending: keyof typeof TYPES): Blob {
  const parts: BlobPart[] = [];
  for (;;) {
    const slice = studio.meshFile(ending, BUDGET) as MeshSlice | string;
    if (typeof slice === 'string') throw new Error(slice);
    parts.push(...slice.parts);
    if (slice.done) return new Blob(parts, { type: TYPES[ending] });
  }
}
