/** Lengths and shapes of SVG. */
import { shift, stretch, times, type Matrix } from './matrix';
import { parsePath, type Run } from './path';
import type { Properties } from './style';

/** CSS pixels per unit of length. */
const UNITS: Record<string, number> = { '': 1, px: 1, pt: 4 / 3, pc: 16, mm: 96 / 25.4, cm: 96 / 2.54, in: 96, q: 96 / 101.6, em: 16, rem: 16, ex: 8, ch: 8 };

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A length in user units; 100 % stands for `of`. */
export function lengthOf(text: string | undefined, of: number, otherwise = 0): number {
  const [, number, unit = ''] = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*([a-z%]*)\s*$/i.exec(text ?? '') ?? [];
  const value = Number(number) * (unit === '%' ? of / 100 : (UNITS[unit.toLowerCase()] ?? NaN));
  return Number.isFinite(value) ? value : otherwise;
}

export function boxOf(said: Properties): Box | undefined {
  const [x = NaN, y = NaN, width = NaN, height = NaN] = (said.get('viewBox') ?? '').trim().split(/[\s,]+/).map(Number);
  return width > 0 && height > 0 && [x, y, width, height].every(Number.isFinite) ? { x, y, width, height } : undefined;
}

/** Fits a view box into a frame of this size. */
export function fit(box: Box, width: number, height: number, said: Properties): Matrix {
  const [align = '', how] = (said.get('preserveAspectRatio') ?? 'xMidYMid').split(/\s+/);
  const [across, down] = [width / box.width, height / box.height];
  if (align === 'none') return times(stretch(across, down), shift(-box.x, -box.y));
  const scale = how === 'slice' ? Math.max(across, down) : Math.min(across, down);
  const part = (word: string | undefined): number => ({ min: 0, max: 1 })[word?.toLowerCase() ?? ''] ?? 0.5;
  const [, h, v] = /^x(min|mid|max)y(min|mid|max)$/i.exec(align) ?? [];
  const place = shift((width - box.width * scale) * part(h), (height - box.height * scale) * part(v));
  return times(place, times(stretch(scale), shift(-box.x, -box.y)));
}

export const SHAPES = new Set(['path', 'polygon', 'polyline', 'line', 'rect', 'circle', 'ellipse']);

export function runsOf(shape: string, said: Properties, { width: across, height: down }: Box): Run[] {
  return parsePath(dataOf(shape, (key, of, otherwise) => lengthOf(said.get(key), of, otherwise), said, across, down));
}

/** A shape as path data. */
function dataOf(shape: string, at: (name: string, of: number, otherwise?: number) => number, said: Properties, across: number, down: number): string {
  const round = (cx: number, cy: number, rx: number, ry: number): string =>
    rx > 0 && ry > 0 ? `M${cx + rx} ${cy}A${rx} ${ry} 0 1 1 ${cx - rx} ${cy}A${rx} ${ry} 0 1 1 ${cx + rx} ${cy}Z` : '';
  switch (shape) {
    case 'path':
      return (said.get('d') ?? '').replace(/^path\(\s*(["'])(.*)\1\s*\)$/s, '$2');
    case 'line':
      return `M${at('x1', across)} ${at('y1', down)}L${at('x2', across)} ${at('y2', down)}`;
    case 'circle': {
      const r = at('r', Math.hypot(across, down) / Math.SQRT2);
      return round(at('cx', across), at('cy', down), r, r);
    }
    case 'ellipse':
      return round(at('cx', across), at('cy', down), at('rx', across, at('ry', down)), at('ry', down, at('rx', across)));
    case 'rect': {
      const [x, y, width, height] = [at('x', across), at('y', down), at('width', across), at('height', down)];
      if (!(width > 0 && height > 0)) return '';
      const rx = Math.min(at('rx', across, at('ry', down)), width / 2);
      const ry = Math.min(at('ry', down, at('rx', across)), height / 2);
      if (!(rx > 0 && ry > 0)) return `M${x} ${y}h${width}v${height}h${-width}Z`;
      const corner = (dx: number, dy: number): string => `a${rx} ${ry} 0 0 1 ${dx} ${dy}`;
      return `M${x + rx} ${y}h${width - 2 * rx}${corner(rx, ry)}v${height - 2 * ry}${corner(-rx, ry)}h${2 * rx - width}${corner(-rx, -ry)}v${2 * ry - height}${corner(rx, -ry)}Z`;
    }
    default:
      return `M${said.get('points') ?? ''}${shape === 'polygon' ? 'Z' : ''}`;
  }
}
