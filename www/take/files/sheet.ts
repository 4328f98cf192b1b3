/**
 * The sheet that a film's frames are drawn on. A square sheet holds the picture alone. An upright sheet shows the
 * picture over a blurred, darkened enlargement of itself, with its title below.
 */
import { SHAPES, type FormingShape } from './codecs';

/** The place of the picture on the sheet. */
const BOXES = { square: { x: 0, y: 0, side: 1080 }, upright: { x: 28, y: 356, side: 1024 } };

/**
 * The upright sheet, in pixels: the radius of its round corners, the base lines of title and name below the picture,
 * and the greatest width of the title.
 */
const ROUND = 18;
const LINES = { title: 124, name: 196 };
const WIDEST = 940;

/** Pixels along the side of the blurred picture. */
const COARSE = 7;

/** The brightness of the background, 0..255. It is dark because the letters on it are white. */
const DARK = 66;

/** The texts on the sheet. */
export interface SheetTexts {
  title: string;
  /** The font of the page, and the font of its name. */
  font: string;
  latin: string;
}

type Context = OffscreenCanvasRenderingContext2D;

export class FilmSheet {
  readonly side: number;
  private readonly context: Context;
  private ground: OffscreenCanvas | undefined;

  constructor(
    private readonly shape: FormingShape,
    private readonly words: SheetTexts,
  ) {
    this.context = contextOf(SHAPES[shape].width, SHAPES[shape].height);
    this.side = BOXES[shape].side;
  }

  /** Draws the background from the finished picture. */
  lay(picture: OffscreenCanvas): void {
    if (this.shape === 'upright') this.ground = groundOf(picture, this.words);
  }

  /** The pixels of a frame: one picture, with `share` of another one blended over it. */
  frame(one: OffscreenCanvas, other: OffscreenCanvas, share: number): Uint8ClampedArray {
    const { context, ground } = this;
    const { width, height } = context.canvas;
    context.save();
    if (ground) {
      context.drawImage(ground, 0, 0);
      roundBox(context);
      context.clip();
    }
    if (share < 1) this.put(one);
    context.globalAlpha = share;
    if (share > 0) this.put(other);
    context.restore();
    return context.getImageData(0, 0, width, height).data;
  }

  private put(picture: OffscreenCanvas): void {
    const { x, y, side } = BOXES[this.shape];
    this.context.drawImage(picture, x, y, side, side);
  }
}

/** A context for pictures that are copied between canvases; the browser keeps it in main memory. */
export function contextOf(width: number, height: number): Context {
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true, alpha: false });
  if (!context) throw new Error('OffscreenCanvas');
  context.imageSmoothingQuality = 'high';
  return context;
}

function roundBox(context: Context): void {
  const { x, y, side } = BOXES.upright;
  context.beginPath();
  context.roundRect(x, y, side, side, ROUND);
}

function groundOf(picture: OffscreenCanvas, words: SheetTexts): OffscreenCanvas {
  const { width, height } = SHAPES.upright;
  const context = contextOf(width, height);
  // Not all browsers have filters on canvases. Scaling down and up again in steps blurs as well.
  const soft = outOfFocus(picture, COARSE, 900);
  const all = [(width - height) / 2, 0, height, height] as const;
  context.drawImage(soft, ...all);
  // Multiplying a picture by itself makes bright colours deep. Dark colours are deep already.
  context.globalCompositeOperation = 'multiply';
  context.globalAlpha = Math.min(1, Math.max(0, brightnessOf(context) / DARK - 1));
  context.drawImage(soft, ...all);
  context.globalCompositeOperation = 'source-over';
  context.globalAlpha = Math.max(0, 1 - DARK / brightnessOf(context));
  context.fillRect(0, 0, width, height);
  context.globalAlpha = 1;
  const shade = context.createLinearGradient(0, 0, 0, height);
  for (const [at, dark] of [[0, 0.2], [0.4, 0], [0.7, 0.1], [1, 0.4]] as const) shade.addColorStop(at, `rgb(0 0 0 / ${dark})`);
  context.fillStyle = shade;
  context.fillRect(0, 0, width, height);
  context.save();
  context.shadowColor = 'rgb(0 0 0 / 0.55)';
  context.shadowBlur = 60;
  context.shadowOffsetY = 18;
  roundBox(context);
  context.fill();
  context.restore();
  write(context, words);
  return context.canvas;
}

/** The mean brightness of a canvas, 0..255, at least 1. */
function brightnessOf(context: Context): number {
  const one = contextOf(1, 1);
  one.drawImage(outOfFocus(context.canvas, 1, 1), 0, 0);
  const [red = 0, green = 0, blue = 0] = one.getImageData(0, 0, 1, 1).data;
  return Math.max(1, 0.2126 * red + 0.7152 * green + 0.0722 * blue);
}

/** Blurs a picture: halves its side down to `least` pixels, then doubles it until it has at least `most`. */
function outOfFocus(picture: OffscreenCanvas, least: number, most: number): OffscreenCanvas {
  let soft = picture;
  let side = picture.width;
  const to = (next: number): void => {
    const context = contextOf(next, next);
    context.drawImage(soft, 0, 0, next, next);
    [soft, side] = [context.canvas, next];
  };
  while (side > least) to(Math.max(least, Math.ceil(side / 2)));
  while (side < most) to(side * 2);
  return soft;
}

function write(context: Context, { title, font, latin }: SheetTexts): void {
  const { y, side } = BOXES.upright;
  const middle = context.canvas.width / 2;
  context.textAlign = 'center';
  context.fillStyle = 'rgb(255 252 246 / 0.94)';
  context.font = `62px ${font}`;
  const wide = context.measureText(title).width;
  if (wide > WIDEST) context.font = `${Math.floor((62 * WIDEST) / wide)}px ${font}`;
  context.fillText(title, middle, y + side + LINES.title);
  context.fillStyle = 'rgb(255 252 246 / 0.62)';
  context.font = `italic 36px ${latin}`;
  context.fillText('Bubblestone', middle, y + side + (title ? LINES.name : LINES.title));
}
