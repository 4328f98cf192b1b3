/** The quality of frames. The first frame of a new view is coarse; the next one is refined, sample by sample. */
import type { Quality, Wished } from './source';

/**
 * The least and most pixels of a full frame for one pixel of a moving frame, along a side. A frame slower than `slow`
 * milliseconds makes the next ones coarser, a frame faster than `quick` makes them finer.
 */
const COARSE = { least: 2, most: 5, slow: 140, quick: 45 };

/** The frames of a view at rest, in their order. Planes of depth, normals and numbers have one sample. */
export function ladderOf({ plane, refined }: Pick<Wished, 'plane' | 'refined'>): readonly Quality[] {
  return ['moving', refined && (plane === 'light' || plane === 'alpha') ? 'fine' : 'still'];
}

/** A key of the view: requests with the same key need the same frames. */
export function viewOf({ link, subject, camera, width, height, plane, cut, refined }: Wished): string {
  return [link, subject, camera, width, height, plane, cut, refined].join(' ');
}

/** Adapts the number of pixels of moving frames to their times. */
export class Coarse {
  /** Pixels of the full frame for one of a moving frame, along a side. */
  part = COARSE.least;

  /** Adapts the size to the milliseconds that the last moving frame took. */
  suit(time: number): void {
    const { least, most, slow, quick } = COARSE;
    if (time > slow) this.part = Math.min(most, this.part + 1);
    else if (time < quick) this.part = Math.max(least, this.part - 1);
  }
}
