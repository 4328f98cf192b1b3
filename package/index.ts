/**
 * Bubblestone for other pages and programs: the WebAssembly module, and pictures made with it.
 *
 * Call `load` once and wait for it; then everything here can be used. All of it runs where it is called and asks no
 * server for anything but the module's own file.
 */
import init, { Bubblestone, type InitInput, type Status } from './bubblestone.js';

export { Bubblestone, generators, presets, schema } from './bubblestone.js';
export type { Answer, Generator, Histogram, Histograms, MeshSlice, Notice, NoticeArg, Parameter, PictureSlice, PixelMap, Preset, Probe, Rings, Rows, Series, Status } from './bubblestone.js';

/** Milliseconds of work at a time, after which a page may do other things. */
const SLICE = 8;

/** More packing steps than fit into a slice. */
const STEPS = 100_000;

let loading: Promise<void> | undefined;

/**
 * Loads the module, once however often it is called. Without `source` it is the file beside this script, which bundlers
 * know how to bring along; else an address, a response, bytes, or a compiled module.
 *
 * Throws an Error with a sentence where the module cannot be had; the next call tries again.
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

/** How a picture is painted. */
export interface Painting {
  /** Words of a view, joined by '+', as `Bubblestone.draw` has them; 'picture' unless given. */
  view?: string;
  /** Stops the work: `paint` then throws the signal's reason. */
  signal?: AbortSignal;
  /** Called after each slice of work; what it gets may be asked, not kept. */
  progress?: (studio: Bubblestone) => void;
}

/** What was painted. */
export interface Painted {
  /** The recipe, complete and without '#': the same link gives the same picture on every machine. */
  link: string;
  /** Of the planes. */
  digest: string;
  status: Status;
  /** Sentences on what of the link did not fit and was mended or left out. */
  notices: string[];
}

/**
 * Makes the picture of a link (an address, a fragment, or '' for the default recipe) and paints it on a canvas, which
 * becomes as large as the picture. Works in slices of some milliseconds and frees what it took.
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
    canvas.width = canvas.height = studio.side();
    const context = canvas.getContext('2d');
    if (!context) throw new Error('The canvas has no context for two dimensions.');
    // Nothing is called but what both kinds of canvas have.
    studio.draw(context as CanvasRenderingContext2D, view);
    return { link: studio.link(), digest: studio.digest(), status: studio.status(), notices: studio.notices().map(({ text }) => text) };
  } finally {
    studio.free();
  }
}

/** Whether there is no work left. */
export function isEnd(studio: Bubblestone): boolean {
  return ['done', 'error'].includes(studio.stage());
}

function pause(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}
