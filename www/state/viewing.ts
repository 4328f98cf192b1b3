/**
 * The words of the view in a link, beside those of the recipe: `view=mesh+forces&pace=0.25&step=12&zoom=2.5,0.31,0.62`
 * (docs/parameters.md). The page removes them before the engine sees the link; recipes, history and files have none.
 * asked-view.ts parses them. It is loaded with the first link that has some.
 */

/** The zoom, and the place in the middle of the frame, in sides of the picture. */
export interface Zoomed {
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

/**
 * The camera: degrees clockwise and above the ground, the distance in sides of the picture, the lens in degrees, and
 * the target.
 */
export type Camera = readonly [angle: number, height: number, distance: number, lens: number, x: number, y: number, z: number];

/** A plane beyond which bodies are cut away: its normal, pointing there, and its distance from the middle, in sides. */
export type Cut = readonly [x: number, y: number, z: number, at: number];

/** The view of a link's picture. Values that it does not name stay as they are. */
export interface Viewing {
  view?: string | undefined;
  overlays?: readonly string[] | undefined;
  /** Packing steps per frame. */
  pace?: number | undefined;
  /** The packing step to pause at. */
  step?: number | undefined;
  zoom?: Zoomed | undefined;
  /** The camera that shows the picture's bodies. */
  camera?: Camera | undefined;
  cut?: Cut | undefined;
  /** The step in the making of one body: its number and the index of the step, as `ID:STEP`. */
  body?: string | undefined;
}

/** The zoom that shows the whole picture. */
export const WHOLE: Zoomed = { scale: 1, x: 0.5, y: 0.5 };

/** Packing steps per frame: the usual number, and that for visitors who prefer reduced motion. */
export const PACE = { usual: 3, still: 100_000 } as const;

const KEYS = ['view', 'pace', 'step', 'zoom', 'camera', 'cut', 'body'];

/**
 * Splits a fragment into the recipe and the words of the view. Where there are such words, a default recipe is
 * written as `v=1`.
 */
export function parted(fragment: string): { recipe: string; words: string } {
  const pieces = fragment.split('&');
  const words = pieces.filter((piece) => KEYS.includes(keyOf(piece)));
  if (!words.length) return { recipe: fragment, words: '' };
  return { recipe: pieces.filter((piece) => piece !== '' && !words.includes(piece)).join('&') || 'v=1', words: words.join('&') };
}

/** Joins a recipe and words of the view. Never empty, as a bare address opens the first picture of a visit. */
export function joined(recipe: string, words: string): string {
  return [recipe || 'v=1', words].filter((piece) => piece !== '').join('&');
}

function keyOf(piece: string): string {
  const [key = ''] = piece.split('=', 1);
  try {
    return decodeURIComponent(key).trim().toLowerCase();
  } catch {
    return key;
  }
}
