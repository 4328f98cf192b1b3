/**
 * Rings from SVG: paths and shapes with their transforms, curves as short pieces, corners as they are.
 * The file is parsed aside from the page (as HTML, which forgives most mistakes), and only numbers are taken from it.
 */
import type { Point, Ring } from '../types';
import { parsePath } from './path-data';
import { tell } from './words';

const SHAPES = 'path, polygon, polyline, rect, circle, ellipse';

/** What is never drawn itself. */
const ASIDE = 'defs, clipPath, mask, pattern, symbol, marker';

/** The rings of all shapes, and the side of the page where that is a square from 0. */
export function svgRings(text: string, name: string): { rings: Ring[]; page: number | undefined } {
  // What a file would do or look like in a page has no place here; without it, the browser need not refuse it aloud.
  const bare = text.replace(/<(script|style)\b.*?<\/\1\s*>/gis, '').replace(/\s(on\w+|style)\s*=/gi, ' data-$1=');
  const root = new DOMParser().parseFromString(/<svg[\s>]/i.test(bare) ? bare : `<svg>${bare}</svg>`, 'text/html').querySelector('svg');
  if (!root) throw new Error(tell('no_shapes', { name }));
  const shapes = [...root.querySelectorAll(SHAPES)].filter((shape) => !shape.closest(ASIDE));
  const filled = shapes.filter((shape) => !/^none$|fill:\s*none/.test(`${shape.getAttribute('fill') ?? ''}${shape.getAttribute('data-style') ?? ''}`));
  const rings = (filled.length ? filled : shapes).flatMap((shape) => {
    const matrix = matrixOf(shape, root);
    return parsePath(dataOf(shape)).map((ring) => ring.map(([x, y]): Point => [matrix.a * x + matrix.c * y + matrix.e, matrix.b * x + matrix.d * y + matrix.f]));
  });
  const usable = rings.filter((ring) => ring.length > 2);
  if (!usable.length) throw new Error(tell('no_shapes', { name }));
  const [x, y, width, height] = (root.getAttribute('viewBox') ?? '').split(/[\s,]+/).map(Number);
  return { rings: usable, page: x === 0 && y === 0 && width === height ? width : undefined };
}

/** The rings of path data alone. */
export function pathRings(text: string, name: string): Ring[] {
  const rings = parsePath(text.trim()).filter((ring) => ring.length > 2);
  if (!rings.length) throw new Error(tell('no_path', { name }));
  return rings;
}

/** A shape as path data. */
function dataOf(shape: Element): string {
  const at = (name: string, otherwise = 0): number => {
    const number = parseFloat(shape.getAttribute(name) ?? '');
    return Number.isFinite(number) ? number : otherwise;
  };
  const round = (cx: number, cy: number, rx: number, ry: number): string =>
    rx > 0 && ry > 0 ? `M${cx - rx} ${cy}A${rx} ${ry} 0 1 1 ${cx + rx} ${cy}A${rx} ${ry} 0 1 1 ${cx - rx} ${cy}Z` : '';
  switch (shape.localName) {
    case 'path':
      return shape.getAttribute('d') ?? '';
    case 'circle':
      return round(at('cx'), at('cy'), at('r'), at('r'));
    case 'ellipse':
      return round(at('cx'), at('cy'), at('rx'), at('ry'));
    case 'rect': {
      const [x, y, width, height] = [at('x'), at('y'), at('width'), at('height')];
      const rx = Math.min(at('rx', at('ry')), width / 2);
      const ry = Math.min(at('ry', at('rx')), height / 2);
      if (!(rx > 0 && ry > 0)) return `M${x} ${y}h${width}v${height}h${-width}Z`;
      const corner = (dx: number, dy: number): string => `a${rx} ${ry} 0 0 1 ${dx} ${dy}`;
      return `M${x + rx} ${y}h${width - 2 * rx}${corner(rx, ry)}v${height - 2 * ry}${corner(-rx, ry)}h${2 * rx - width}${corner(-rx, -ry)}v${2 * ry - height}${corner(rx, -ry)}Z`;
    }
    default:
      return `M${shape.getAttribute('points') ?? ''}Z`;
  }
}

/** A shape's transforms up to the root, which the browser reads; an element of the page's own takes each of them. */
function matrixOf(shape: Element, root: Element): DOMMatrix {
  let matrix = new DOMMatrix();
  for (let element: Element | null = shape; element && element !== root; element = element.parentElement) {
    const text = element.getAttribute('transform');
    if (text) matrix = ownMatrix(text).multiply(matrix);
  }
  return matrix;
}

function ownMatrix(text: string): DOMMatrix {
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
