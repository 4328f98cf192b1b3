/**
 * The finished picture with as many pixels as the screen has, laid over the canvas while it stands still.
 *
 * The canvas has the recipe's own pixels. It looks soft on a screen with finer pixels, or when it is zoomed. After it
 * stood still for a while, a worker computes the link again and paints it with two to eight times as many pixels along a
 * side. That picture fades in over the canvas, and the first change removes it. Scripts, files and the probe still read
 * the canvas below. `data-fine` of the sheet has the number of pixels, for scripts.
 */
import { byId } from '../base/dom';
import { answerOf } from '../late/worker';
import { CRISP } from '../picture/frame';
import type { View } from '../picture/view';
import { isPicture } from '../state/fine';
import type { Work } from '../state/work';
import type { Answer, Order } from './fine.worker';
import '../styles/late/fine.css';

/** The picture must stand still for this many milliseconds before the work begins. */
const STILL = 1000;

/** Pixels may be stretched by this factor: a sheet slightly larger than the picture needs no finer one. */
const SLACK = 1.04;

/** Largest number of fine pixels per pixel of the recipe, along a side. */
const MOST_SCALE = 8;

/** Most pixels along a side: the module's own limit if there is much memory, else a share of it. */
const MOST_PIXELS = 4096;
const MUCH_MEMORY = 8;
/** Gigabytes to assume if the browser does not report them. */
const USUAL_MEMORY = 4;

/** A finished picture on the canvas: its link, its side, and the zoom. */
interface Asked {
  readonly link: string;
  readonly side: number;
  readonly zoom: number;
}

/** A fine picture that exists, or is to be made. */
interface Picture {
  readonly link: string;
  readonly scale: number;
}

/** Keeps the page's own picture fine while the visitor wants that. */
export function keepFine({ engine, store }: Work, view: View): void {
  const fine = new Fine(view.canvas, () => {
    const { recipe, stage, held, repeat, compare, turn, editing, zoom, fine: wanted } = store.state;
    const isPlain = isPicture(view.words) && repeat === 1 && !compare && !turn && editing === undefined;
    return wanted && isPlain && !held && stage === 'done' ? { link: recipe, side: engine.side(), zoom: zoom.scale } : undefined;
  });
  store.on(['recipe', 'stage', 'held', 'view', 'overlays', 'repeat', 'compare', 'turn', 'editing', 'zoom', 'fine'], () => fine.follow());
}

export class Fine {
  private readonly sheet = byId('sheet');
  private readonly canvas: HTMLCanvasElement;
  private readonly asked: () => Asked | undefined;
  private inSight = false;
  /** The fine picture over the canvas. */
  private shown: (Picture & { canvas: HTMLCanvasElement }) | undefined;
  /** The fine picture that is waited for, being made, or could not be made. */
  private next: Picture | undefined;
  private making = new AbortController();

  /** `asked` describes the picture on the canvas; undefined if that is unfinished, or not wanted finer. */
  constructor(canvas: HTMLCanvasElement, asked: () => Asked | undefined) {
    this.canvas = canvas;
    this.asked = asked;
    const follow = (): void => this.follow();
    document.addEventListener('visibilitychange', follow);
    addEventListener('resize', follow);
    new ResizeObserver(follow).observe(this.sheet);
    new IntersectionObserver((seen) => {
      this.inSight = seen.at(-1)?.isIntersecting ?? false;
      follow();
    }).observe(this.sheet);
  }

  /** Call this after any change that may affect `asked`. */
  follow(): void {
    const asked = this.asked();
    if (this.shown && this.shown.link !== asked?.link) this.clear();
    if (asked) this.look(asked.zoom);
    const next = asked && this.inSight && !document.hidden ? this.missing(asked) : undefined;
    if (next?.link === this.next?.link && next?.scale === this.next?.scale) return;
    this.making.abort();
    this.next = next;
    if (next) this.begin(next);
  }

  /** The coarsest picture that is fine enough for the screen, if it is finer than the present one. */
  private missing({ link, side, zoom }: Asked): Picture | undefined {
    const needed = (this.sheet.clientWidth * devicePixelRatio * zoom) / side;
    const scale = Math.min(Math.ceil(needed / SLACK), Math.floor(mostPixels() / side), MOST_SCALE);
    return scale > (this.shown?.scale ?? 1) ? { link, scale } : undefined;
  }

  private begin(picture: Picture): void {
    const { signal } = (this.making = new AbortController());
    const timer = setTimeout(() => {
      // If this fails, the canvas below stays visible.
      this.make(picture, signal).catch(() => undefined);
    }, STILL);
    signal.addEventListener('abort', () => clearTimeout(timer));
  }

  private async make(picture: Picture, signal: AbortSignal): Promise<void> {
    const worker = new Worker(new URL('./fine.worker.ts', import.meta.url), { type: 'module' });
    const order: Order = [picture.link, picture.scale];
    const answer = await answerOf<Answer>(worker, order, { progress: () => undefined, signal });
    if ('picture' in answer && !signal.aborted) await this.show(picture, answer.picture);
  }

  /** The new picture fades in over the old one, which is then removed. */
  private async show(picture: Picture, pixels: ImageBitmap): Promise<void> {
    const canvas = document.createElement('canvas');
    canvas.className = 'fine';
    canvas.ariaHidden = 'true';
    canvas.width = canvas.height = pixels.width;
    this.sheet.dataset['fine'] = String(pixels.width);
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(pixels);
    const before = this.shown?.canvas;
    (before ?? this.canvas).after(canvas);
    this.shown = { ...picture, canvas };
    this.next = undefined;
    this.follow();
    await Promise.allSettled(canvas.getAnimations().map(({ finished }) => finished));
    empty(before);
  }

  /** Shows fine pixels as squares at a high zoom, as the canvas does. */
  private look(zoom: number): void {
    this.shown?.canvas.toggleAttribute('data-crisp', zoom >= CRISP * this.shown.scale);
  }

  private clear(): void {
    // There are two while one fades in.
    for (const canvas of this.sheet.querySelectorAll<HTMLCanvasElement>('.fine')) empty(canvas);
    this.shown = undefined;
    delete this.sheet.dataset['fine'];
  }
}

/** Removes a canvas and frees its memory. */
function empty(canvas: HTMLCanvasElement | undefined): void {
  if (!canvas) return;
  canvas.remove();
  canvas.width = canvas.height = 0;
}

function mostPixels(): number {
  const { deviceMemory = USUAL_MEMORY } = navigator as { deviceMemory?: number };
  return MOST_PIXELS * Math.min(1, Math.sqrt(deviceMemory / MUCH_MEMORY));
}
