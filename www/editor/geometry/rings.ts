/** Rings from elsewhere in the order and the sense that an outline has. */
import type { Ring } from '../../module/types';
import { area, within } from './plane';

/** The largest ring first, and each in its sense. */
export function arranged(rings: Ring[]): Ring[] {
  return turned(rings.filter((ring) => ring.length > 2).sort((a, b) => Math.abs(area(b)) - Math.abs(area(a))));
}

/** Rings that lie in an even number of others (rims) run one way, the rest (holes) the other. */
export function turned(rings: Ring[]): Ring[] {
  return rings.map((ring) => (area(ring) > 0 === (depth(ring, rings) % 2 === 0) ? ring : [...ring].reverse()));
}

/** In how many of the rings a ring lies: a hole in an odd number. */
export function depth(ring: Ring, all: Ring[]): number {
  return all.filter((other) => other !== ring && ring[0] && within(ring[0], other)).length;
}
