/** The shapes of letters, by way of pixels: what the worker does. */
import type { Ring } from '../../module/types';
import { contour, tidy } from '../geometry/contour';
import { fitted } from '../geometry/fit';
import { area } from '../geometry/plane';
import { arranged } from '../geometry/rings';
import { broken, lettersIn } from './lines';
import { strokeWidth } from './strokes';

/** Pixels along the longer side, and free ones around. */
const PIXELS = 1024;
const RIM = 6;

/** Letters at most. */
export const MOST_LETTERS = 120;

/** How far an outline may be off, in pixels, and in widths of strokes where those are narrow. */
const TOLERANCE = 1.28;
const FINEST = 0.5;
const OF_STROKE = 0.07;

/** Points that the program takes, and the smallest area of a ring as a square, in sides (src/domain/check.rs), with something to spare. */
export const MOST_POINTS = 4096;
const SMALLEST = 1.02 / 128;

/** How much farther an outline may be off where it has too many points for that. */
const COARSER = 4;

/** Between lines, and the pen that makes letters round, in the font's size. */
const GAP = 0.16;
const PEN = 0.045;

/** The look of letters; systems differ in the fonts that they have. */
export const FACES = {
  serif: '"Noto Serif CJK JP", "Noto Serif JP", "Hiragino Mincho ProN", "Yu Mincho", serif',
  sans: 'system-ui, "Hiragino Sans", "Yu Gothic", "Noto Sans CJK JP", sans-serif',
  round: 'ui-rounded, "Hiragino Maru Gothic ProN", "Arial Rounded MT Bold", Nunito, "Noto Sans CJK JP", sans-serif',
} as const;

export type Face = keyof typeof FACES;

export interface Order {
  text: string;
  face: Face;
  /** 1, or how many times finer than that the outline is to be. */
  finer: number;
}

/** Letters as an outline, with lengths in sides of the picture. */
export interface Letters {
  rings: Ring[];
  lines: string[];
  /** The median width of strokes. */
  stroke: number;
  /** Letters that were given; the first MOST_LETTERS of them were taken. */
  given: number;
  /** Dots and holes that were left out, as no stone goes into them. */
  specks: number;
}

export function letters({ text, face, finer }: Order): Letters {
  const all = lettersIn(text);
  const { values, columns, lines } = painted(all.slice(0, MOST_LETTERS).join(''), face);
  const stroke = strokeWidth(values, columns);
  const tolerance = Math.max(FINEST, Math.min(TOLERANCE, OF_STROKE * stroke)) / finer;
  const outline = tidy(contour(values, columns), tolerance, MOST_POINTS, COARSER);
  const shapes = outline.length ? fitted(outline, 1, 0) : [];
  const rings = arranged(shapes.filter((ring) => sizeOf(ring) >= SMALLEST));
  return { rings, lines, stroke: (stroke * sizeOf(shapes[0])) / (sizeOf(outline[0]) || 1), given: all.length, specks: shapes.length - rings.length };
}

/** The side of a square of a ring's area. */
function sizeOf(ring: Ring = []): number {
  return Math.sqrt(Math.abs(area(ring)));
}

/** A text in lines, on a grid: above 0 where there is ink, never at the rim. */
function painted(text: string, face: Face): { lines: string[]; values: Float32Array; columns: number } {
  const measure = canvasOf(1, 1);
  const font = (size: number): string => `${face === 'serif' ? 700 : 900} ${size}px ${FACES[face]}`;
  measure.font = font(100);
  const boxes = new Map<string, Box>();
  const boxOf = (line: string): Box => boxes.get(line) ?? boxed(boxes, line, measure.measureText(line));
  const fill = (lines: string[]): number => Math.min(1 / Math.max(1, ...lines.map((line) => boxOf(line).width)), 1 / (lines.reduce((sum, line) => sum + boxOf(line).height + 100 * GAP, 0) || 1));
  const lines = broken(text, (part) => measure.measureText(part).width, fill);
  if (!lines.length) return { lines, values: new Float32Array(9), columns: 3 };
  const scale = PIXELS * fill(lines);
  const rim = Math.ceil(RIM + 100 * PEN * scale);
  const height = lines.reduce((sum, line) => sum + (boxOf(line).height + 100 * GAP) * scale, 0);
  const context = canvasOf(PIXELS + 2 * rim, Math.ceil(height) + 2 * rim);
  context.font = font(100 * scale);
  context.lineWidth = 100 * PEN * scale;
  context.lineJoin = 'round';
  let y = rim;
  for (const line of lines) {
    const box = boxOf(line);
    const [x, base] = [rim + (PIXELS - box.width * scale) / 2 + box.left * scale, y + box.ascent * scale];
    context.fillText(line, x, base);
    if (face === 'round') context.strokeText(line, x, base);
    y += (box.height + 100 * GAP) * scale;
  }
  const { width: columns, height: rows } = context.canvas;
  const { data } = context.getImageData(0, 0, columns, rows);
  return { lines, values: Float32Array.from({ length: columns * rows }, (_, k) => (data[4 * k + 3] ?? 0) - 127.5), columns };
}

function canvasOf(width: number, height: number): OffscreenCanvasRenderingContext2D {
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('no canvas');
  return context;
}

/** What a line's ink takes: letters without parts below the line stand close to the next one. */
interface Box {
  left: number;
  ascent: number;
  width: number;
  height: number;
}

function boxed(boxes: Map<string, Box>, line: string, { actualBoundingBoxLeft: left, actualBoundingBoxRight: right, actualBoundingBoxAscent: ascent, actualBoundingBoxDescent: descent }: TextMetrics): Box {
  const box = { left, ascent, width: left + right, height: ascent + descent };
  boxes.set(line, box);
  return box;
}
