/**
 * The view in a link: words that stand beside those of the recipe, as `view=mesh+forces&pace=0.25&step=12&zoom=2.5,0.31,0.62`
 * (docs/parameters.md). The page takes them out before the engine sees the link; recipes, history and files have none.
 * What they mean is read by asked-view.ts, which comes with the first link that has some.
 */

/** How much closer, and what is in the middle of the frame, in sides of the picture. */
export interface Zoomed {
  readonly scale: number;
  readonly x: number;
  readonly y: number;
}

/** Where the bodies of a picture are seen from: degrees clockwise and above the ground, sides of the picture, the lens in degrees, the target. */
export type Camera = readonly [angle: number, height: number, distance: number, lens: number, x: number, y: number, z: number];

/** How a link shows its picture; what it does not name is left as it is. */
export interface Viewing {
  view?: string | undefined;
  overlays?: readonly string[] | undefined;
  /** Packing steps a frame. */
  pace?: number | undefined;
  /** The packing step that is held. */
  step?: number | undefined;
  zoom?: Zoomed | undefined;
  /** The picture is seen from a slant. */
  camera?: Camera | undefined;
}

/** All of the picture. */
export const WHOLE: Zoomed = { scale: 1, x: 0.5, y: 0.5 };

/** The page's own speed, and that of visitors who ask for less motion. */
export const PACE = { usual: 3, still: 100_000 } as const;

const KEYS = ['view', 'pace', 'step', 'zoom', 'camera'];

/** The recipe of a fragment, and its words of the view. With such words there is always a recipe: the default one is said. */
export function parted(fragment: string): { recipe: string; words: string } {
  const pieces = fragment.split('&');
  const words = pieces.filter((piece) => KEYS.includes(keyOf(piece)));
  if (!words.length) return { recipe: fragment, words: '' };
  return { recipe: pieces.filter((piece) => piece !== '' && !words.includes(piece)).join('&') || 'v=1', words: words.join('&') };
}

/** The fragment of both. */
export function joined(recipe: string, words: string): string {
  return words === '' ? recipe : `${recipe || 'v=1'}&${words}`;
}

function keyOf(piece: string): string {
  const [key = ''] = piece.split('=', 1);
  try {
    return decodeURIComponent(key).trim().toLowerCase();
  } catch {
    return key;
  }
}
