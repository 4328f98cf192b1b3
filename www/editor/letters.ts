/** The shapes of letters, by way of pixels. */
import type { Ring } from '../module/types';
import { t } from '../words/editor';
import { make } from '../base/dom';
import { contour, tidy } from './geometry/contour';
import { fitted } from './geometry/fit';

/** Pixels along the longer side, and free ones around. */
const PIXELS = 640;
const RIM = 4;

/** How far an outline may be off, in pixels, and its points at most. */
const TOLERANCE = 0.8;
const MOST = 300;

/** The look of letters; systems differ in the fonts that they have. */
export const FACES = {
  serif: '"Noto Serif CJK JP", "Noto Serif JP", "Hiragino Mincho ProN", "Yu Mincho", serif',
  sans: 'system-ui, "Hiragino Sans", "Yu Gothic", "Noto Sans CJK JP", sans-serif',
  round: 'ui-rounded, "Hiragino Maru Gothic ProN", "Arial Rounded MT Bold", Nunito, "Noto Sans CJK JP", sans-serif',
} as const;

export type Face = keyof typeof FACES;

/** The rings around what is painted, in pixels. */
function painted(width: number, height: number, draw: (context: CanvasRenderingContext2D) => void): Ring[] {
  const canvas = make('canvas', { width: String(width + 2 * RIM), height: String(height + 2 * RIM) });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error(t('no_canvas'));
  context.translate(RIM, RIM);
  draw(context);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  const values = Float32Array.from({ length: data.length / 4 }, (_, k) => (data[4 * k + 3] ?? 0) - 127.5);
  return tidy(contour(values, canvas.width), TOLERANCE, MOST);
}

/** Letters as an outline of a picture of this side; each word has a line. */
export function letters(text: string, face: Face, side: number): Ring[] {
  const words = text.split(/\s+/).filter((word) => word !== '');
  if (!words.length) return [];
  const font = (size: number): string => `${face === 'serif' ? 700 : 900} ${size}px ${FACES[face]}`;
  const measure = make('canvas').getContext('2d');
  if (!measure) throw new Error(t('no_canvas'));
  measure.font = font(100);
  const boxes = words.map((word) => measure.measureText(word));
  const widest = Math.max(1, ...boxes.map((box) => box.actualBoundingBoxLeft + box.actualBoundingBoxRight));
  const size = Math.min(PIXELS, (PIXELS * 100) / widest, PIXELS / words.length);
  // Letters without parts below the line stand close to the next one.
  const heights = boxes.map((box) => ((box.actualBoundingBoxAscent + box.actualBoundingBoxDescent) * size) / 100);
  const gap = 0.16 * size;
  const total = heights.reduce((sum, height) => sum + height + gap, 2 * gap);
  const rings = painted(PIXELS + 2 * Math.ceil(gap), Math.ceil(total), (context) => {
    context.font = font(size);
    context.lineWidth = 0.045 * size;
    context.lineJoin = 'round';
    let y = gap;
    words.forEach((word, k) => {
      const box = boxes[k];
      const [left, right, ascent] = [box?.actualBoundingBoxLeft ?? 0, box?.actualBoundingBoxRight ?? 0, box?.actualBoundingBoxAscent ?? 0].map((length) => (length * size) / 100) as [number, number, number];
      const x = (PIXELS + 2 * gap - left - right) / 2 + left;
      context.fillText(word, x, y + ascent);
      if (face === 'round') context.strokeText(word, x, y + ascent);
      y += (heights[k] ?? 0) + gap;
    });
  });
  return rings.length ? fitted(rings, side, 0) : [];
}
