/**
 * The finished picture with as many pixels as the screen has, laid over the canvas while it stands still.
 *
 * The canvas has the recipe's own pixels, and browsers stretch it: on a screen of fine pixels, or where one comes
 * closer, it is soft. Once it stood still for a while, a worker works the link out anew and paints it with two to eight
 * times as many pixels along a side, which come in softly. They are gone with the first change. What scripts, files and
 * the probe read stays the canvas below. For scripts the sheet tells their number as `data-fine`.
 */
import { byId } from '../base/dom';
import { answerOf } from '../late/worker';
import { CRISP } from '../picture/frame';
import type { View } from '../picture/view';
import { isPicture } from '../state/fine';
import type { Work } from '../state/work';
import type { Answer, Order } from './fine.worker';
import '../styles/late/fine.css';

/** Milliseconds that the picture stands still before the work begins. */
const STILL = 1000;

/** So far the pixels may be stretched: a sheet a little larger than the picture is no reason for four times as many. */
const SLACK = 1.04;

/** At most so many pixels for one of the picture along a side. */
const MOST_SCALE = 8;

/** At most so many along a side: as many as the module makes where there is much memory, else in proportion to that. */
const MOST_PIXELS = 4096;
const MUCH_MEMORY = 8;
/** Gigabytes, where the browser does not tell. */
const USUAL_MEMORY = 4;

/** A finished picture as the canvas shows it: its link and side, and how much closer than all of it one is. */
interface Asked {
  readonly link: string;
  readonly side: number;
  readonly zoom: number;
}

/** A picture that is made, or is to be. */
interface Picture {
  readonly link: string;
  readonly scale: number;
}

/** Keeps the page's own picture fine, while the visitor wants that. */
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
  /** What lies over the canvas. */
  private shown: (Picture & { canvas: HTMLCanvasElement }) | undefined;
  /** What is to be made, or is being made, or could not be made. */
  private next: Picture | undefined;
  private making = new AbortController();

  /** `asked` is what the canvas shows; undefined where that is no finished picture, or not wanted finer. */
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

  /** Is to be called after whatever may change what is asked for. */
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

  /** What is finer than what is there; the least that the screen can show. */
  private missing({ link, side, zoom }: Asked): Picture | undefined {
    const needed = (this.sheet.clientWidth * devicePixelRatio * zoom) / side;
    const scale = Math.min(Math.ceil(needed / SLACK), Math.floor(mostPixels() / side), MOST_SCALE);
    return scale > (this.shown?.scale ?? 1) ? { link, scale } : undefined;
  }

  private begin(picture: Picture): void {
    const { signal } = (this.making = new AbortController());
    const timer = setTimeout(() => {
      // Without it there is the canvas below.
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

  /** The new one comes in over what was there, which then goes. */
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

  /** Pixels are squares as they are below, only later. */
  private look(zoom: number): void {
    this.shown?.canvas.toggleAttribute('data-crisp', zoom >= CRISP * this.shown.scale);
  }

  private clear(): void {
    // While one comes in there are two.
    for (const canvas of this.sheet.querySelectorAll<HTMLCanvasElement>('.fine')) empty(canvas);
    this.shown = undefined;
    delete this.sheet.dataset['fine'];
  }
}

/** Takes a canvas away, with the memory of its pixels. */
function empty(canvas: HTMLCanvasElement | undefined): void {
  if (!canvas) return;
  canvas.remove();
  canvas.width = canvas.height = 0;
}

function mostPixels(): number {
  const { deviceMemory = USUAL_MEMORY } = navigator as { deviceMemory?: number };
  return MOST_PIXELS * Math.min(1, Math.sqrt(deviceMemory / MUCH_MEMORY));
}
