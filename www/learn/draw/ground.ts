/**
 * The ground of a landscape as bands of equal potential: each band is one path, of a quarter and its three mirror
 * images. An element for each image would cost a browser more, whenever the landscape changes, than the longer paths do.
 */
import type { Landscape } from '../figures/figure';
import type { Place } from '../figures/place';
import { inside, simplified, tracing, type Heights } from './contours';
import { WIDTH } from './plate';

/** Grid points for one stable distance, and along half the landscape's side. */
export const FINE = 32;
export const HALF = 2 * FINE;

/** The length of a stable distance on a map. */
export const UNIT = WIDTH / 4;

/** Bands below 0 every 0.005 k0, and a few above it, where the hill is steep. */
export const STEP = 0.005;
const BELOW = 24;
const ABOVE = [0.02, 0.06, 0.15, 0.3, 0.45];
const LEVELS = [...Array.from({ length: BELOW }, (_, k) => (k - BELOW) * STEP), ...ABOVE];

/** The number of the first band above 0. */
export const FOOT = BELOW;

/** Whether the border of a band is drawn as a line: below 0 only every second one is. */
const isDrawn = (band: number): boolean => band >= BELOW || band % 2 === 0;

/** How far a line may be from its place, in units of the grid. */
const TOLERANCE = 0.04;

/** Bands reach this far over the quarter's edges, and each a little farther than the band below it: so edges do not show. */
const OVER = -1;
const FARTHER = 0.05;

/** A small round top reaches over by this share of its radius: else the corners of its quarters would stick out. */
const MOST = 0.2;

/** The signs of both coordinates, in a quarter and in its mirror images. */
const MIRRORS = [[1, 1], [-1, 1], [1, -1], [-1, -1]] as const;

/** The paths of the bands and of the lines, in parts. */
export function* drawing(heights: Heights): Generator<undefined, Landscape['ground']> {
  const all = yield* tracing(heights, [OVER, HALF], LEVELS);
  const [bands, lines]: [string[], string[]] = [[], []];
  for (const [band, borders] of all.entries()) {
    bands.push(borders.map((border) => closed(border, band)).join(''));
    if (isDrawn(band)) lines.push(...borders.flatMap((border) => inside(border, [0, HALF])).map((line) => pathOf(line)));
    yield;
  }
  return { bands, lines: lines.join('') };
}

/** The lowest band that is seen, and those above it: their numbers with their levels. */
export function seenBands({ well, pass }: Landscape): (readonly [band: number, level: number])[] {
  const lowest = Math.min(well.energy, pass.energy);
  return LEVELS.map((level, band) => [band, level] as const).filter(([, level]) => level > lowest - STEP);
}

/** The bands and the lines by a name. */
export function definitions(landscape: Landscape, name: string): string {
  const { bands, lines } = landscape.ground;
  const all = seenBands(landscape).map(([band]) => whole(`${name}-${band}`, bands[band] ?? ''));
  return `<defs>${all.join('')}${whole(`${name}-lines`, lines)}</defs>`;
}

function whole(id: string, path: string): string {
  return `<path class="card" id="${id}" d="${path}"/>`;
}

/** Uses a band or the lines of the ground of this name. */
export function part(name: string, of: string, kind: string, transform: string): string {
  return `<use${kind && ` class="${kind}"`} href="#${name}-${of}" transform="${transform}"/>`;
}

/** A layer over a ground, for moving parts. */
export function over(content: string): string {
  return `<svg class="plate over" viewBox="0 0 ${WIDTH} ${WIDTH}" width="${WIDTH}" height="${WIDTH}" aria-hidden="true">${content}</svg>`;
}

/**
 * The path of a line and of its mirror images; `end` ends each. All images of a ring go round in the same sense, so that
 * the strips where they overlap are filled.
 */
function pathOf(line: readonly Place[], end = ''): string {
  const points = simplified(line, TOLERANCE).map((point) => point.map((value) => Math.round((10 * value * UNIT) / FINE)));
  const images = MIRRORS.map(([a, b]) => {
    const image = points.map(([x = 0, y = 0]) => [a * x, b * y] as const);
    return stepwise(a === b ? image : image.reverse()) + end;
  });
  return images.join('');
}

/** The path through places in tenths: its first place, then steps, which take less room than places. */
function stepwise(places: readonly Place[]): string {
  const steps = places.map(([x, y], k) => {
    const [u, v] = places[k - 1] ?? [0, 0];
    return `${(x - u) / 10} ${(y - v) / 10}`;
  });
  return `M${steps[0] ?? ''}l${steps.slice(1).join(' ')}`;
}

function closed(border: readonly Place[], band: number): string {
  const far = Math.min(band * FARTHER - OVER, MOST * Math.max(...border.flat()));
  const out = (value: number): number => (value <= OVER + 0.01 ? -far : value);
  return pathOf(border.map(([x, y]) => [out(x), out(y)]), 'z');
}
