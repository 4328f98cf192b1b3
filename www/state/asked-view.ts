/** Reads the words of the view in a link (viewing.ts), checks them, and writes the words for the present view. */
import type { Camera, Cut, Viewing, Zoomed } from './viewing';

/** The views and the camera that a generator offers. */
export interface Sights {
  readonly bases: readonly string[];
  readonly overlays: readonly string[];
  /** Only an offered forming has steps. A camera needs frames, or bodies that can be turned. */
  readonly offers: readonly string[];
  /** The first camera as numbers with commas between, and the least height of a camera in degrees. */
  readonly home: string;
  readonly lowest: number;
}

/** A word of a link that cannot be used as it is. */
export interface Fault {
  readonly what: 'view' | 'layer' | 'pace' | 'step' | 'zoom' | 'camera' | 'cut' | 'body';
  readonly given: string;
  /** The value used instead; without it the word is left out. */
  readonly kept?: string;
}

/** Minimum and maximum. */
export const LIMITS = { pace: [0.01, 100_000], step: [0, 100_000], zoom: [1, 16] } as const;

/** Minimum and maximum for each number of a camera; angles wrap around. */
export const CAMERA = [[0, 360], [5, 90], [0.05, 20], [5, 100], [-2, 2], [-2, 2], [-2, 2]] as const;

/** The first camera for a plane. Other generators replace its first numbers. */
const HOME: Camera = [330, 40, 2.95, 28, 0, 0, 0];

/** The farthest plane that cuts, in sides of the picture. */
const FARTHEST = 2;

/** A body and a step in its making. */
const BODY = /^[1-9]\d{0,6}:\d{1,3}$/;

/** Decimals of each number of a camera in a link. */
const DIGITS = [1, 1, 3, 1, 4, 4, 4];

/** The camera of links without one. */
export function homeOf({ home }: Pick<Sights, 'home'>): Camera {
  const numbers = home.split(',').map(numberIn);
  return HOME.map((value, k) => numbers[k] ?? value) as unknown as Camera;
}

/** Degrees from the lamp to the first camera of a slant. The light then comes from the side, which shows heights best. */
const ASIDE = 195;

/** The first camera for a recipe's bodies. That of a picture in a plane follows the light. */
export function firstCamera(generator: Pick<Sights, 'home' | 'offers'>, get: (key: string) => string): Camera {
  const [angle, ...rest] = homeOf(generator);
  if (generator.offers.includes('frames')) return [angle, ...rest];
  const number = (key: string): number => Number(get(key));
  const lamp = get('light') === 'point' ? (Math.atan2(number('ly') - 0.5, number('lx') - 0.5) * 180) / Math.PI : number('az');
  return [Number(((lamp + ASIDE + 360) % 360).toFixed(DIGITS[0])), ...rest];
}

/** Minimum and maximum for each number of a camera. */
export function cameraLimits({ lowest }: Pick<Sights, 'lowest'>): readonly (readonly [number, number])[] {
  return CAMERA.map(([least, most], k) => [k === 1 ? lowest : least, most] as const);
}

/** Whether a camera can see bodies. */
export function hasBodies({ offers }: Pick<Sights, 'offers'>): boolean {
  return offers.includes('turn') || offers.includes('frames');
}

/** The view that the words describe, and the faults that were corrected or left out. */
export function read(words: string, sights: Sights): { viewing: Viewing; faults: Fault[] } {
  const viewing: Viewing = {};
  const faults: Fault[] = [];
  for (const [key, given] of words.split('&').map(pairOf)) {
    if (key === 'view') readView(given, sights, viewing, faults);
    if (key === 'zoom') readZoom(given, viewing, faults);
    if (key === 'pace') viewing.pace = within(given, key, faults);
    if (key === 'step' && sights.offers.includes('forming')) viewing.step = within(given, key, faults);
    else if (key === 'step') faults.push({ what: 'step', given });
    if (key === 'camera' && hasBodies(sights)) readCamera(given, sights, viewing, faults);
    else if (key === 'camera') faults.push({ what: 'camera', given });
    if (key === 'cut') readCut(given, sights, viewing, faults);
    if (key === 'body' && hasBodies(sights) && BODY.test(given)) viewing.body = given;
    else if (key === 'body') faults.push({ what: 'body', given });
  }
  return { viewing, faults };
}

/** The words of a view; '' for the usual one. */
export function written({ view = 'auto', overlays = [], pace, step, zoom, camera, cut, body }: Viewing, sights: Pick<Sights, 'home'>): string {
  const drawn = [view, ...overlays].join('+');
  return [
    ...(drawn === 'auto' ? [] : [`view=${drawn}`]),
    ...(pace === undefined ? [] : [`pace=${pace}`]),
    ...(step === undefined ? [] : [`step=${step}`]),
    ...(zoom && zoom.scale > 1 ? [`zoom=${[zoom.scale, zoom.x, zoom.y].map((value) => Number(value.toFixed(4))).join()}`] : []),
    ...(camera ? [`camera=${cameraWords(camera, homeOf(sights))}`] : []),
    ...(cut ? [`cut=${cutWords(cut)}`] : []),
    ...(body ? [`body=${body}`] : []),
  ].join('&');
}

/** A camera as words of a link, without trailing numbers that are the usual ones. */
export function cameraWords(camera: Camera, home: Camera): string {
  const numbers = camera.map((value, k) => Number(value.toFixed(DIGITS[k])));
  const last = numbers.findLastIndex((value, k) => value !== home[k]);
  return numbers.slice(0, Math.max(1, last + 1)).join();
}

/** A plane as words of a link, and of the module's order for a frame. */
function cutWords(cut: Cut): string {
  return cut.map((value) => Number(value.toFixed(3))).join();
}

/** The word for a frame that is cut by a plane; '' without one. */
export function wholeBodies(cut: Cut | undefined): string {
  return cut ? `whole=${cutWords(cut)}` : '';
}

/** Moves the zoom so that the frame shows nothing beyond the picture. */
export function inFrame({ scale, x, y }: Zoomed): Zoomed {
  const kept = (at: number): number => Math.min(1 - 0.5 / scale, Math.max(0.5 / scale, at));
  return { scale, x: kept(x), y: kept(y) };
}

function pairOf(piece: string): [key: string, value: string] {
  const at = piece.indexOf('=');
  return at < 0 ? [decoded(piece), ''] : [decoded(piece.slice(0, at)), decoded(piece.slice(at + 1))];
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text).trim().toLowerCase();
  } catch {
    return text.trim().toLowerCase();
  }
}

/** Reads a view with layers over it, or layers alone. */
function readView(given: string, { bases, overlays }: Sights, viewing: Viewing, faults: Fault[]): void {
  const [first = '', ...more] = given.split(/[+,\s]+/);
  const isView = bases.includes(first);
  const isLayer = !isView && overlays.includes(first);
  if (!isView && !isLayer) faults.push({ what: 'view', given: first, kept: 'auto' });
  const layers = isLayer ? [first, ...more] : more;
  for (const word of layers) if (!overlays.includes(word)) faults.push({ what: 'layer', given: word });
  viewing.view = isView ? first : 'auto';
  viewing.overlays = overlays.filter((word) => layers.includes(word));
}

/** Reads a zoom's factor and its middle; by default the middle of the picture. */
function readZoom(given: string, viewing: Viewing, faults: Fault[]): void {
  const [times = '', ...place] = given.split(',');
  const [x, y] = (place.length ? place : ['0.5', '0.5']).map(numberIn);
  if (x === undefined || y === undefined || place.length > 2) return void faults.push({ what: 'zoom', given });
  const scale = within(times, 'zoom', faults);
  if (scale === undefined) return;
  const asked = { scale, x, y };
  if (Math.min(x, y) < 0 || Math.max(x, y) > 1) faults.push({ what: 'zoom', given, kept: written({ zoom: inFrame(asked) }, { home: '' }).slice(5) || '1' });
  viewing.zoom = inFrame(asked);
}

/** Reads up to seven numbers; missing ones are the usual ones. */
function readCamera(given: string, sights: Sights, viewing: Viewing, faults: Fault[]): void {
  const home = homeOf(sights);
  const numbers = given === '' ? [] : given.split(',').map(numberIn);
  if (numbers.length > home.length || numbers.includes(undefined)) return void faults.push({ what: 'camera', given });
  const asked = home.map((value, k) => numbers[k] ?? value);
  const kept = cameraLimits(sights).map(([least, most], k) => Math.min(most, Math.max(least, asked[k] ?? 0))) as unknown as Camera;
  if (kept.some((value, k) => value !== asked[k])) faults.push({ what: 'camera', given, kept: cameraWords(kept, home) });
  viewing.camera = kept;
}

/** Reads a direction and a distance. */
function readCut(given: string, { offers }: Sights, viewing: Viewing, faults: Fault[]): void {
  const [x, y, z, at, ...more] = given.split(',').map(numberIn);
  const isWhole = x !== undefined && y !== undefined && z !== undefined && at !== undefined && more.length === 0;
  if (!isWhole || !offers.includes('cut') || !(Math.hypot(x, y, z) > 0)) return void faults.push({ what: 'cut', given });
  viewing.cut = [x, y, z, Math.min(FARTHEST, Math.max(-FARTHEST, at))];
}

/** A number within the limits of its word, a whole number for steps; undefined if it is no number. */
function within(given: string, what: 'pace' | 'step' | 'zoom', faults: Fault[]): number | undefined {
  const number = numberIn(given);
  if (number === undefined) return void faults.push({ what, given });
  const [least, most] = LIMITS[what];
  const kept = Math.min(most, Math.max(least, what === 'step' ? Math.round(number) : number));
  if (kept !== number) faults.push({ what, given, kept: String(kept) });
  return kept;
}

function numberIn(text: string): number | undefined {
  return text.trim() !== '' && Number.isFinite(Number(text)) ? Number(text) : undefined;
}
