/** Finds the shapes of letters by painting them and tracing the pixels. The worker runs this. */
import type { Ring } from '../../module/types';
import { contour, tidy } from '../geometry/contour';
import { fitted } from '../geometry/fit';
import { area } from '../geometry/plane';
import { arranged } from '../geometry/rings';
import { broken, lettersIn } from './lines';
import { strokeWidth } from './strokes';

/** Pixels along the longer side, and the free border around them. */
const PIXELS = 1024;
const RIM = 6;

/** Largest number of letters. */
export const MOST_LETTERS = 120;

/** Largest error of an outline: OF_STROKE stroke widths, but at least FINEST and at most TOLERANCE pixels. */
const TOLERANCE = 1.28;
const FINEST = 0.5;
const OF_STROKE = 0.07;

/**
 * Limits of the program (src/domain/check.rs): the number of points, and the smallest ring. The latter is the side of a
 * square of equal area, in sides of the picture, with some reserve.
 */
export const MOST_POINTS = 4096;
const SMALLEST = 1.02 / 128;

/** An outline with too many points may be coarser by up to this factor. */
const COARSER = 4;

/** The gap between lines, and the pen that rounds letters, relative to the font's size. */
const GAP = 0.16;
const PEN = 0.045;

/** The typefaces. Each lists several fonts, as systems differ. */
export const FACES = {
  serif: '"Noto Serif CJK JP", "Noto Serif JP", "Hiragino Mincho ProN", "Yu Mincho", serif',
  sans: 'system-ui, "Hiragino Sans", "Yu Gothic", "Noto Sans CJK JP", sans-serif',
  round: 'ui-rounded, "Hiragino Maru Gothic ProN", "Arial Rounded MT Bold", Nunito, "Noto Sans CJK JP", sans-serif',
} as const;

export type Face = keyof typeof FACES;

export interface LettersRequest {
  text: string;
  face: Face;
  /** The outline is this many times finer than usual. */
  finer: number;
}

/** The outline of letters, with lengths in sides of the picture. */
export interface Letters {
  rings: Ring[];
  lines: string[];
  /** The median width of strokes. */
  stroke: number;
  /** Number of letters in the text; at most MOST_LETTERS were used. */
  given: number;
  /** Number of dots and holes left out because no stone fits into them. */
  specks: number;
}

export function letters({ text, face, finer }: LettersRequest): Letters {
  const all = lettersIn(text);
  const { values, columns, lines } = painted(all.slice(0, MOST_LETTERS).join(''), face);
  const stroke = strokeWidth(values, columns);
  const tolerance = Math.max(FINEST, Math.min(TOLERANCE, OF_STROKE * stroke)) / finer;
  const outline = tidy(contour(values, columns), tolerance, MOST_POINTS, COARSER);
  const shapes = outline.length ? fitted(outline, 1, 0) : [];
  const rings = arranged(shapes.filter((ring) => sizeOf(ring) >= SMALLEST));
  return { rings, lines, stroke: (stroke * sizeOf(shapes[0])) / (sizeOf(outline[0]) || 1), given: all.length, specks: shapes.length - rings.length };
}

/** The side of a square with the ring's area. */
function sizeOf(ring: Ring = []): number {
  return Math.sqrt(Math.abs(area(ring)));
}

/** Paints a text in lines on a grid. Numbers are above 0 on ink, never at the border. */
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

/** The box of a line's ink. The next line may come closer where no letter reaches below the line. */
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
