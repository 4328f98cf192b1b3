/** The surface of all cells, for other programs. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { BUDGET } from './pavement';
import { given } from './refusal';

const TYPES = { glb: 'model/gltf-binary', obj: 'model/obj' };

/** Throws a Refusal where it cannot be made. */
export function meshFile(studio: Bubblestone, ending: keyof typeof TYPES): Blob {
  const parts: BlobPart[] = [];
  for (;;) {
    const slice = given(studio.meshFile(ending, BUDGET));
    parts.push(...slice.parts);
    if (slice.done) return new Blob(parts, { type: TYPES[ending] });
  }
}
