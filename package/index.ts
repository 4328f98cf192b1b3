/**
 * Bubblestone for other pages and programs: the WebAssembly module, and pictures made with it.
 *
 * Call `load` once and await it before anything else here. Everything runs locally; the only file fetched is the module.
 */
import init, { Bubblestone, type InitInput, type Status } from './bubblestone.js';

export { Bubblestone, generators, presets, schema } from './bubblestone.js';
export type { Answer, Generator, Histogram, Histograms, MeshSlice, Notice, NoticeArg, Parameter, PictureSlice, PixelMap, Preset, Probe, Rings, Rows, Series, Status } from './bubblestone.js';

/** Milliseconds of a slice, after which the page can do other things. */
const SLICE = 8;

/**
 * More packing steps than fit into a slice. The package is compiled file by file, without a bundler, and pauses between
 * slices; so it has loops of its own and imports nothing of the page (`making` in www/module/run.ts).
 */
const STEPS = 100_000;

let loading: Promise<void> | undefined;

/**
 * Loads the module once, however often it is called. Without `source` it loads the file beside this script, which bundlers
 * bring along. `source` may be an address, a response, bytes, or a compiled module.
 *
 * Throws an Error with a sentence where loading fails. The next call tries again.
 */
export function load(source?: InitInput | Promise<InitInput>): Promise<void> {
  return (loading ??= begin(source));
}

async function begin(source?: InitInput | Promise<InitInput>): Promise<void> {
  try {
    if (typeof WebAssembly !== 'object') throw new Error('there is no WebAssembly here');
    await init(source === undefined ? undefined : { module_or_path: source });
  } catch (cause) {
    loading = undefined;
    throw new Error(`The WebAssembly module of Bubblestone could not be loaded (${cause instanceof Error ? cause.message : String(cause)}).`, { cause });
  }
}

/** Options of `paint`. */
export interface Painting {
  /** The words of a view, joined by '+', as for `Bubblestone.draw`; 'picture' by default. */
  view?: string;
  /** Stops the work: `paint` then throws the signal's reason. */
  signal?: AbortSignal;
  /** Called after each slice of work. Read from the studio, but do not keep it. */
  progress?: (studio: Bubblestone) => void;
}

/** The result of `paint`. */
export interface Painted {
  /** The recipe, complete and without '#': the same link gives the same picture on every machine. */
  link: string;
  /** The digest of the planes. */
  digest: string;
  status: Status;
  /** Sentences about parts of the link that were mended or left out. */
  notices: string[];
}

/**
 * Makes the picture of a link (an address, a fragment, or '' for the default recipe) and paints it on a canvas, which it
 * resizes. It works in slices of some milliseconds and frees its memory at the end.
 *
 * Throws an Error with a sentence where the recipe gives no picture.
 */
export async function paint(canvas: HTMLCanvasElement | OffscreenCanvas, link: string, { view = 'picture', signal, progress }: Painting = {}): Promise<Painted> {
  await load();
  const studio = new Bubblestone(link);
  try {
    while (!isEnd(studio)) {
      signal?.throwIfAborted();
      studio.tick(SLICE, STEPS);
      progress?.(studio);
      await pause();
    }
    const problem = studio.problem();
    if (problem) throw new Error(problem.text);
    while (!studio.prepare(view, SLICE)) await pause();
    signal?.throwIfAborted();
    const context = canvas.getContext('2d');
    if (!context) throw new Error('The canvas has no context for two dimensions.');
    // Only methods are called that both kinds of canvas have.
    drawWhole(studio, canvas, context as CanvasRenderingContext2D, view);
    return { link: studio.link(), digest: studio.digest(), status: studio.status(), notices: studio.notices().map(({ text }) => text) };
  } finally {
    studio.free();
  }
}

/** Draws a view on a canvas, which gets its size first: a drawing may have more pixels than the recipe's picture. */
export function drawWhole(studio: Bubblestone, canvas: HTMLCanvasElement | OffscreenCanvas, context: CanvasRenderingContext2D, view: string): void {
  const putImageData = (image: ImageData, x: number, y: number): void => {
    if (canvas.width !== image.width || canvas.height !== image.height) [canvas.width, canvas.height] = [image.width, image.height];
    context.putImageData(image, x, y);
  };
  // The studio asks a context for this method alone.
  studio.draw({ putImageData } as CanvasRenderingContext2D, view);
}

/** Whether there is no work left. */
export function isEnd(studio: Bubblestone): boolean {
  return ['done', 'error'].includes(studio.stage());
}

function pause(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
