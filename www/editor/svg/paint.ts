/** Whether what is painted is seen on white paper. */

/** Of 255; autotracers paint paper with a white that is not quite one. */
const WHITE = 250;

/** What is less opaque than this hides nothing. */
const COVERS = 0.5;

/** `ink` adds to the outline, `paper` takes from it what lies under it; undefined where nothing is painted. */
export type Paint = 'ink' | 'paper' | undefined;

export function paintOf(colour: string, opacity: number): Paint {
  const [red, green, blue, alpha] = channels(colour.toLowerCase());
  if (!(opacity * alpha > 0)) return undefined;
  return Math.min(red, green, blue) >= WHITE && opacity * alpha >= COVERS ? 'paper' : 'ink';
}

/** Red, green and blue up to 255, and alpha up to 1; black for a colour that is none of white and clear. */
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
