/**
 * The picture or the drawing with as many pixels as the screen has, laid over the canvas while it stands still.
 *
 * The canvas has the recipe's own pixels. It looks soft on a screen with finer pixels, or when it is zoomed. After it
 * stood still for a while, a worker computes the link again and paints the finished picture with two to eight times as
 * many pixels along a side. A drawing needs no worker: the page's own studio draws it soon, with two or three times as
 * many. Either fades in over the canvas, and the first change removes it. Scripts, files and the probe still read the
 * canvas below. `data-fine` of the sheet has the number of pixels, for scripts.
 */
import { byId, frame } from '../base/dom';
import { answerOf } from '../late/worker';
import { CRISP } from '../picture/frame';
import type { View } from '../picture/view';
import type { Engine } from '../state/engine';
import { isPicture } from '../state/fine';
import type { Work } from '../state/work';
import type { FineRequest, FineResult } from './fine.worker';
import '../styles/late/fine.css';

/** The picture must stand still for this many milliseconds before the work begins. A drawing is little work. */
const STILL = 1000;
const DRAWING_STILL = 200;

/** Milliseconds of a slice for a drawing. */
const PIECE = 12;

/** Pixels may be stretched by this factor: a sheet slightly larger than the picture needs no finer one. */
const SLACK = 1.04;

/** Largest number of fine pixels per pixel of the recipe, along a side. */
const MOST_SCALE = 8;

/** Largest scale of a drawing, and its most pixels along a side: limits of the module. */
const DRAWN_SCALE = 3;
const DRAWN_PIXELS = 2048;

/** Most pixels along a side: the module's own limit. With less than MUCH_MEMORY gigabytes, a share of it. */
const MOST_PIXELS = 4096;
const MUCH_MEMORY = 8;
/** Gigabytes to assume if the browser does not report them. */
const USUAL_MEMORY = 4;

/** A finished picture or a drawing on the canvas: its link, its side, and the zoom. */
interface CanvasPicture {
  readonly link: string;
  readonly side: number;
  readonly zoom: number;
  /** The words of a drawing. */
  readonly drawing?: string;
}

/** A fine picture that exists, or is to be made. Only its key tells drawings of one link apart. */
interface Picture {
  readonly key: string;
  readonly link: string;
  readonly scale: number;
  readonly drawing: string | undefined;
}

/** The facts that decide whether the canvas stands still. */
export interface Standing {
  readonly stage: string;
  readonly isPaused: boolean;
}

/** The words of a drawing that stands still; an empty object for the finished picture; undefined while work goes on. */
export function standing(engine: Engine, view: string, { stage, isPaused }: Standing): Pick<CanvasPicture, 'drawing'> | undefined {
  if (stage === 'done' && isPicture(view)) return {};
  return (stage === 'done' || isPaused) && !engine.offers('frames') ? { drawing: view } : undefined;
}

/** Keeps the page's own picture fine while the visitor wants that. */
export function keepFine({ engine, store }: Work, view: View): void {
  const fine = new Fine(view.canvas, engine, () => {
    const { recipe, stage, paused, held, repeat, compare, turn, editing, zoom, fine: wanted } = store.state;
    const isPlain = repeat === 1 && !compare && !turn && editing === undefined;
    const still = wanted && isPlain && !held ? standing(engine, view.words, { stage, isPaused: paused }) : undefined;
    return still && { link: recipe, side: engine.side(), zoom: zoom.scale, ...still };
  });
  view.drawn(() => fine.redrawn());
  store.on(['recipe', 'stage', 'paused', 'held', 'view', 'overlays', 'repeat', 'compare', 'turn', 'editing', 'zoom', 'fine'], () => fine.follow());
}

export class Fine {
  private readonly sheet = byId('sheet');
  private readonly canvas: HTMLCanvasElement;
  private readonly engine: Engine;
  private readonly asked: () => CanvasPicture | undefined;
  /** How often the canvas was drawn. */
  private drawings = 0;
  private inSight = false;
  /** The fine picture over the canvas. */
  private shown: (Picture & { canvas: HTMLCanvasElement }) | undefined;
  /** The fine picture that is waited for, being made, or could not be made. */
  private next: Picture | undefined;
  private making = new AbortController();

  /** `asked` describes the picture on the canvas. It returns undefined if no finer one is wanted, or not yet. */
  constructor(canvas: HTMLCanvasElement, engine: Engine, asked: () => CanvasPicture | undefined) {
    [this.canvas, this.engine, this.asked] = [canvas, engine, asked];
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
    if (this.shown && this.shown.key !== (asked && this.keyOf(asked))) this.clear();
    if (asked) this.look(asked.zoom);
    const next = asked && this.inSight && !document.hidden ? this.missing(asked) : undefined;
    if (next?.key === this.next?.key && next?.scale === this.next?.scale) return;
    this.making.abort();
    this.next = next;
    if (next) this.begin(next);
  }

  /** Call this after each drawing of the canvas. */
  redrawn(): void {
    this.drawings += 1;
    this.follow();
  }

  /** A picture's key is its link. A drawing may change while its link stays, so its key counts the drawings, too. */
  private keyOf({ link, drawing }: CanvasPicture): string {
    return drawing === undefined ? link : `${link} ${drawing} ${this.drawings}`;
  }

  /** The coarsest picture that is fine enough for the screen, if it is finer than the present one. */
  private missing(asked: CanvasPicture): Picture | undefined {
    const { link, side, zoom, drawing } = asked;
    const needed = (this.sheet.clientWidth * devicePixelRatio * zoom) / side;
    const [pixels, most] = drawing === undefined ? [mostPixels(), MOST_SCALE] : [DRAWN_PIXELS, DRAWN_SCALE];
    const scale = Math.min(Math.ceil(needed / SLACK), Math.floor(pixels / side), most);
    return scale > (this.shown?.scale ?? 1) ? { key: this.keyOf(asked), link, scale, drawing } : undefined;
  }

  private begin(picture: Picture): void {
    const { signal } = (this.making = new AbortController());
    const timer = setTimeout(() => {
      // If this fails, the canvas below stays visible.
      this.make(picture, signal).catch(() => undefined);
    }, picture.drawing === undefined ? STILL : DRAWING_STILL);
    signal.addEventListener('abort', () => clearTimeout(timer));
  }

  private async make(picture: Picture, signal: AbortSignal): Promise<void> {
    if (picture.drawing !== undefined) return this.draw(picture, `${picture.drawing}+x${picture.scale}`, signal);
    const worker = new Worker(new URL('./fine.worker.ts', import.meta.url), { type: 'module' });
    const order: FineRequest = [picture.link, picture.scale];
    const answer = await answerOf<FineResult>(worker, order, { progress: () => undefined, signal });
    if (!('picture' in answer) || signal.aborted) return;
    const canvas = blank(answer.picture.width);
    canvas.getContext('bitmaprenderer')?.transferFromImageBitmap(answer.picture);
    await this.show(picture, canvas);
  }

  /** Draws in slices. A view may give fewer pixels than asked for; if they are only the recipe's, shows nothing. */
  private async draw(picture: Picture, words: string, signal: AbortSignal): Promise<void> {
    const { engine } = this;
    for (let isReady = false; !isReady; ) {
      isReady = engine.prepare(words, PIECE);
      await frame();
      if (signal.aborted) return;
    }
    const canvas = blank(engine.side() * picture.scale);
    const context = canvas.getContext('2d', { alpha: false });
    const side = context ? engine.draw(context, words) : 0;
    if (!context || side <= engine.side()) return;
    if (side < canvas.width) {
      canvas.width = canvas.height = side;
      engine.draw(context, words);
    }
    await this.show(picture, canvas);
  }

  /** The new picture fades in over the old one, which is then removed. */
  private async show(picture: Picture, canvas: HTMLCanvasElement): Promise<void> {
    this.sheet.dataset['fine'] = String(canvas.width);
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

function blank(side: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.className = 'fine';
  canvas.ariaHidden = 'true';
  canvas.width = canvas.height = side;
  return canvas;
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
