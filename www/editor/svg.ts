/**
 * Rings from SVG: paths and shapes with their transforms, curves as short pieces, corners as they are.
 * The file is parsed aside from the page (as HTML, which forgives most mistakes), and only numbers are taken from it.
 */
import type { Point, Ring } from '../types';
import { parsePath } from './path-data';
import { tell } from './words';

const SHAPES = 'path, polygon, polyline, rect, circle, ellipse';

/** What is never drawn itself; a symbol is where it is used. */
const ASIDE = 'defs, clipPath, mask, pattern, symbol, marker';

/** What uses itself ends here. */
const DEEPEST = 20;

/** CSS pixels of the units that lengths may have. */
const UNITS: Record<string, number> = { pt: 4 / 3, pc: 16, mm: 96 / 25.4, cm: 96 / 2.54, in: 96, em: 16, rem: 16 };

interface Shape {
  rings: Ring[];
  filled: boolean;
}

/** The rings of all shapes, and the side of the page where that is a square from 0. */
export function svgRings(text: string, name: string): { rings: Ring[]; page: number | undefined } {
  // What a file would do or look like in a page has no place here; without it, the browser need not refuse it aloud.
  const bare = text.replace(/<(script|style)\b.*?<\/\1\s*>/gis, '').replace(/\s(on\w+|style)\s*=/gi, ' data-$1=');
  const root = new DOMParser().parseFromString(/<svg[\s>]/i.test(bare) ? bare : `<svg>${bare}</svg>`, 'text/html').querySelector('svg');
  if (!root) throw new Error(tell('no_shapes', { name }));
  const box = boxOf(root);
  const page = box ?? { width: lengthOf(root, 'width', 0, 100), height: lengthOf(root, 'height', 0, 100) };
  const shapes: Shape[] = [];
  const walk = (element: Element, before: DOMMatrix, filledBefore: boolean, deep: number): void => {
    if (deep > DEEPEST || said(element, 'display') === 'none') return;
    const fill = said(element, 'fill');
    const filled = fill ? fill !== 'none' : filledBefore;
    let matrix = before.multiply(ownMatrix(element.getAttribute('transform') ?? ''));
    const within = (child: Element): void => walk(child, matrix, filled, deep + 1);
    const at = (key: string, of: number, otherwise = 0): number => lengthOf(element, key, of, otherwise);
    const used = element.localName === 'use' && root.querySelector(`[id="${CSS.escape((element.getAttribute('href') ?? element.getAttribute('xlink:href') ?? '').slice(1))}"]`);
    if (element !== root && (used || element.localName === 'svg')) matrix = matrix.translate(at('x', page.width), at('y', page.height));
    const framed = used ? used.localName === 'symbol' || used.localName === 'svg' : element !== root && element.localName === 'svg';
    if (framed) matrix = matrix.multiply(fit(boxOf(used || element), at('width', page.width, page.width), at('height', page.height, page.height)));
    if (used) [...(framed ? used.children : [used])].forEach(within);
    else if (element.matches(SHAPES)) shapes.push({ rings: parsePath(dataOf(element, page)).map((ring) => ring.map((point) => moved(matrix, point))), filled });
    else if (element === root || !element.matches(ASIDE)) [...element.children].forEach(within);
  };
  walk(root, new DOMMatrix(), true, 0);
  const drawn = shapes.some(({ filled }) => filled) ? shapes.filter(({ filled }) => filled) : shapes;
  const usable = drawn.flatMap(({ rings }) => rings).filter((ring) => ring.length > 2);
  if (!usable.length) throw new Error(tell('no_shapes', { name }));
  return { rings: usable, page: box && box.x === 0 && box.y === 0 && box.width === box.height ? box.width : undefined };
}

/** What an element says of its look, by an attribute or in its style. */
function said(element: Element, key: string): string {
  const style = new RegExp(`(?:^|;)\\s*${key}\\s*:\\s*([^;!]*)`, 'i').exec(element.getAttribute('data-style') ?? '')?.[1];
  return (style ?? element.getAttribute(key) ?? '').trim().toLowerCase();
}

function moved({ a, b, c, d, e, f }: DOMMatrix, [x, y]: Point): Point {
  return [a * x + c * y + e, b * x + d * y + f];
}

function boxOf(element: Element): { x: number; y: number; width: number; height: number } | undefined {
  const [x = NaN, y = NaN, width = NaN, height = NaN] = (element.getAttribute('viewBox') ?? '').trim().split(/[\s,]+/).map(Number);
  return width > 0 && height > 0 && Number.isFinite(x + y) ? { x, y, width, height } : undefined;
}

/** Puts a view box into the middle of a frame of this size. */
function fit(box: ReturnType<typeof boxOf>, width: number, height: number): DOMMatrix {
  if (!box) return new DOMMatrix();
  const scale = Math.min(width / box.width, height / box.height);
  return new DOMMatrix().translate(width / 2, height / 2).scale(scale).translate(-box.x - box.width / 2, -box.y - box.height / 2);
}

/** A length in user units; `of` is what all of it (100 %) would be. */
function lengthOf(element: Element, key: string, of: number, otherwise = 0): number {
  const [, number, unit = ''] = /^\s*([-+.\d]+(?:e[-+]?\d+)?)\s*([a-z%]*)/i.exec(element.getAttribute(key) ?? '') ?? [];
  const value = Number(number) * (unit === '%' ? of / 100 : (UNITS[unit.toLowerCase()] ?? 1));
  return Number.isFinite(value) ? value : otherwise;
}

/** The rings of path data alone. */
export function pathRings(text: string, name: string): Ring[] {
  const rings = parsePath(text.trim()).filter((ring) => ring.length > 2);
  if (!rings.length) throw new Error(tell('no_path', { name }));
  return rings;
}

/** A shape as path data. */
function dataOf(shape: Element, { width: across, height: down }: { width: number; height: number }): string {
  const at = (name: string, of = across, otherwise = 0): number => lengthOf(shape, name, of, otherwise);
  const round = (cx: number, cy: number, rx: number, ry: number): string =>
    rx > 0 && ry > 0 ? `M${cx - rx} ${cy}A${rx} ${ry} 0 1 1 ${cx + rx} ${cy}A${rx} ${ry} 0 1 1 ${cx - rx} ${cy}Z` : '';
  switch (shape.localName) {
    case 'path':
      return shape.getAttribute('d') ?? '';
    case 'circle':
      return round(at('cx'), at('cy', down), at('r'), at('r'));
    case 'ellipse':
      return round(at('cx'), at('cy', down), at('rx', across, at('ry', down)), at('ry', down, at('rx')));
    case 'rect': {
      const [x, y, width, height] = [at('x'), at('y', down), at('width'), at('height', down)];
      const rx = Math.min(at('rx', across, at('ry', down)), width / 2);
      const ry = Math.min(at('ry', down, at('rx')), height / 2);
      if (!(rx > 0 && ry > 0)) return `M${x} ${y}h${width}v${height}h${-width}Z`;
      const corner = (dx: number, dy: number): string => `a${rx} ${ry} 0 0 1 ${dx} ${dy}`;
      return `M${x + rx} ${y}h${width - 2 * rx}${corner(rx, ry)}v${height - 2 * ry}${corner(-rx, ry)}h${2 * rx - width}${corner(-rx, -ry)}v${2 * ry - height}${corner(rx, -ry)}Z`;
    }
    default:
      return `M${shape.getAttribute('points') ?? ''}Z`;
  }
}

/** Transforms, which the browser reads; an element of the page's own takes them. */
function ownMatrix(text: string): DOMMatrix {
  if (!text) return new DOMMatrix();
  const group = document.createElementNS('http://www.w3.org/2000/svg', 'g');
  group.setAttribute('transform', text);
  const found = group.transform.baseVal.consolidate()?.matrix;
  return found ? new DOMMatrix([found.a, found.b, found.c, found.d, found.e, found.f]) : new DOMMatrix();
}

/** The outline as an SVG file of one path. */
export function svgFile(rings: Ring[], side: number): string {
  const d = rings.map((ring) => `M${ring.map(([x, y]) => `${short(x)} ${short(y)}`).join('L')}Z`).join('');
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${side} ${side}" width="${side}" height="${side}"><path fill-rule="evenodd" d="${d}"/></svg>\n`;
}

/** The outline as polygon JSON. */
export function jsonFile(rings: Ring[], side: number): string {
  return `${JSON.stringify({ size: [side, side], rings: rings.map((ring) => ring.map((point) => point.map(short))) })}\n`;
}

function short(number: number): number {
  return Number(number.toFixed(3));
}
