/** The view in a link (viewing.ts): reads and checks its words, and writes them. */
import type { Camera, Viewing, Zoomed } from './viewing';

/** The properties of a generator that limit views. */
export interface Sights {
  readonly bases: readonly string[];
  readonly overlays: readonly string[];
  /**
   * The parts that the generator offers. Only one with a forming has steps; a camera needs frames, or bodies that
   * can be turned.
   */
  readonly offers: readonly string[];
  /** The first camera as numbers with commas, and the lowest elevation in degrees. */
  readonly home: string;
  readonly lowest: number;
}

/** A word of a link that cannot be used as it is. */
export interface Fault {
  readonly what: 'view' | 'layer' | 'pace' | 'step' | 'zoom' | 'camera';
  readonly given: string;
  /** The value used instead; without one the word is dropped. */
  readonly kept?: string;
}

/** The least and the greatest value of each word. */
export const LIMITS = { pace: [0.01, 100_000], step: [0, 100_000], zoom: [1, 16] } as const;

/** The same for each number of a camera; angles wrap around. */
export const CAMERA = [[0, 360], [5, 90], [0.05, 20], [5, 100], [-2, 2], [-2, 2], [-2, 2]] as const;

/** The first camera for a picture in a plane; other generators replace its first numbers. */
const HOME: Camera = [330, 40, 2.95, 28, 0, 0, 0];

/** Decimals of each number in a link. */
const DIGITS = [1, 1, 3, 1, 4, 4, 4];

/** The first camera of a generator, which links leave out. */
export function homeOf({ home }: Pick<Sights, 'home'>): Camera {
  const numbers = home.split(',').map(numberIn);
  return HOME.map((value, k) => numbers[k] ?? value) as unknown as Camera;
}

/** The least and the greatest value of each number of a generator's camera. */
export function cameraLimits({ lowest }: Pick<Sights, 'lowest'>): readonly (readonly [number, number])[] {
  return CAMERA.map(([least, most], k) => [k === 1 ? lowest : least, most] as const);
}

/** Whether there are bodies for a camera to see. */
export function hasBodies({ offers }: Pick<Sights, 'offers'>): boolean {
  return offers.includes('turn') || offers.includes('frames');
}

/** Reads the words of a view; also returns the faults that were mended or dropped. */
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
  }
  return { viewing, faults };
}

/** The words for a view; '' for the usual one. */
export function written({ view = 'auto', overlays = [], pace, step, zoom, camera }: Viewing, sights: Pick<Sights, 'home'>): string {
  const drawn = [view, ...overlays].join('+');
  return [
    ...(drawn === 'auto' ? [] : [`view=${drawn}`]),
    ...(pace === undefined ? [] : [`pace=${pace}`]),
    ...(step === undefined ? [] : [`step=${step}`]),
    ...(zoom && zoom.scale > 1 ? [`zoom=${[zoom.scale, zoom.x, zoom.y].map((value) => Number(value.toFixed(4))).join()}`] : []),
    ...(camera ? [`camera=${cameraWords(camera, homeOf(sights))}`] : []),
  ].join('&');
}

/** A camera in the words of links; trailing numbers with their usual values are left out. */
export function cameraWords(camera: Camera, home: Camera): string {
  const numbers = camera.map((value, k) => Number(value.toFixed(DIGITS[k])));
  const last = numbers.findLastIndex((value, k) => value !== home[k]);
  return numbers.slice(0, Math.max(1, last + 1)).join();
}

/** The same zoom, moved so that nothing beyond the picture is in the frame. */
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

/** Reads a view with overlays, or overlays alone. */
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

/** Reads the scale and the middle; without one, that of the picture. */
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

/** Reads up to seven numbers; missing ones have their usual values. */
function readCamera(given: string, sights: Sights, viewing: Viewing, faults: Fault[]): void {
  const home = homeOf(sights);
  const numbers = given === '' ? [] : given.split(',').map(numberIn);
  if (numbers.length > home.length || numbers.includes(undefined)) return void faults.push({ what: 'camera', given });
  const asked = home.map((value, k) => numbers[k] ?? value);
  const kept = cameraLimits(sights).map(([least, most], k) => Math.min(most, Math.max(least, asked[k] ?? 0))) as unknown as Camera;
  if (kept.some((value, k) => value !== asked[k])) faults.push({ what: 'camera', given, kept: cameraWords(kept, home) });
  viewing.camera = kept;
}

/** A number clamped to the limits of its word, whole for steps; undefined if it is not a number. */
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
