/** Decides whether a paint is visible on white paper. */

/** White has at least this in each channel, out of 255. Autotracers paint paper with a white that is not exact. */
const WHITE = 250;

/** A white paint that is less opaque than this hides nothing. */
const COVERS = 0.5;

/** `ink` adds to the outline; `paper` removes the area under it; undefined has no effect. */
export type Paint = 'ink' | 'paper' | undefined;

export function paintOf(colour: string, opacity: number): Paint {
  const [red, green, blue, alpha] = channels(colour.toLowerCase());
  if (!(opacity * alpha > 0)) return undefined;
  return Math.min(red, green, blue) >= WHITE && opacity * alpha >= COVERS ? 'paper' : 'ink';
}

/**
 * Red, green and blue up to 255, and alpha up to 1. Only white must be exact: other names count as black, and `hsl`
 * gives a grey of its lightness.
 */
function channels(colour: string): [number, number, number, number] {
  if (colour === 'none' || colour === 'transparent') return [0, 0, 0, 0];
  if (colour === 'white') return [255, 255, 255, 1];
  const hex = /^#(?:([\da-f]{3,4})|([\da-f]{6}(?:[\da-f]{2})?))$/.exec(colour);
  if (hex) {
    const digits = hex[2] ?? (hex[1] ?? '').replace(/./g, '$&$&');
    const [red = 0, green = 0, blue = 0, alpha = 255] = (digits.match(/../g) ?? []).map((pair) => parseInt(pair, 16));
    return [red, green, blue, alpha / 255];
  }
  const [, model, list = ''] = /^(rgb|hsl)a?\(([^()]*)\)$/.exec(colour) ?? [];
  if (!model) return [0, 0, 0, 1];
  const [first = 0, second = 0, third = 0, alpha = 1] = list.split(/[\s,/]+/).filter(Boolean).map((part, k) => {
    const number = parseFloat(part);
    return part.endsWith('%') ? (number / 100) * (k < 3 && model === 'rgb' ? 255 : 1) : number;
  });
  return model === 'rgb' ? [first, second, third, alpha] : [third * 255, third * 255, third * 255, alpha];
}
