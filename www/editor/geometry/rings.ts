/** Puts rings from elsewhere into the order and the orientation of an outline. */
import type { Ring } from '../../module/types';
import { area, within } from './plane';

/** The rings in the right orientation, the largest first. */
export function arranged(rings: Ring[]): Ring[] {
  return turned(rings.filter((ring) => ring.length > 2).sort((a, b) => Math.abs(area(b)) - Math.abs(area(a))));
}

/**
 * The rings in the right orientation: clockwise on the screen if a ring lies in an even number of others, else
 * reversed.
 */
export function turned(rings: Ring[]): Ring[] {
  return rings.map((ring) => (area(ring) > 0 === (depth(ring, rings) % 2 === 0) ? ring : [...ring].reverse()));
}

/** The number of rings that a ring lies in: odd for a hole. */
export function depth(ring: Ring, all: Ring[]): number {
  return all.filter((other) => other !== ring && ring[0] && within(ring[0], other)).length;
}
