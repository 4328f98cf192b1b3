/** How good frames are: the first one of what is new is coarse, and with time they become smooth. */
import type { Quality, Wish } from './turn.worker';

/** Pixels for one of a moving frame, along a side, and the milliseconds that such a frame may take. */
const COARSE = { least: 2, most: 5, slow: 140, quick: 45 };

export const LADDER: readonly Quality[] = ['moving', 'still', 'fine'];

/** Planes of depth, normals and numbers are of one sample. */
export function ladderOf({ plane }: Pick<Wish, 'plane'>): readonly Quality[] {
  return plane === 'light' || plane === 'alpha' ? LADDER : LADDER.slice(0, 2);
}

/** Two wishes of one view ask for the same frames. */
export function viewOf({ link, subject, camera, width, height, plane }: Omit<Wish, 'n'>): string {
  return [link, subject, camera, width, height, plane].join(' ');
}

/** Moving frames have as many pixels as there is time for. */
export class Coarse {
  /** Pixels of the whole frame for one of a moving one, along a side. */
  part = COARSE.least;

  /** After a moving frame that took so many milliseconds. */
  suit(time: number): void {
    const { least, most, slow, quick } = COARSE;
    if (time > slow) this.part = Math.min(most, this.part + 1);
    else if (time < quick) this.part = Math.max(least, this.part - 1);
  }
}
