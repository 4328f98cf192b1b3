/**
 * The pieces that an SVG file draws, in painting order, each with its clips. No element of the file enters the page.
 *
 * style.ts finds the properties that rules and attributes set. Each piece is a fill or a stroke (stroke.ts), of ink or
 * of white. seen.ts combines the pieces.
 */
import { DomHandler, isDirective, isTag, type ChildNode, type Document, type Element } from 'domhandler';
import { Parser } from 'htmlparser2';
import type { Point } from '../../module/types';
import type { Rule } from './area';
import { back, growth, matrixOf, moved, shift, STILL, stretch, times, type Matrix } from './matrix';
import { paintOf, type Paint } from './paint';
import { POINTS, type Run } from './path';
import { Refusal, type Count, type Left } from './refusal';
import { boxOf, fit, lengthOf, runsOf, SHAPES, type Box } from './shapes';
import type { Pen } from './stroke';
import { INHERITED, StyleRules, type Properties } from './style';

/** Most elements of a drawing, each counted once per use, and the deepest nesting. */
const ELEMENTS = 50_000;
const DEEPEST = 200;

/** Elements that are never drawn themselves. */
const ASIDE = new Set(['defs', 'clipPath', 'mask', 'pattern', 'symbol', 'marker', 'linearGradient', 'radialGradient', 'filter', 'style', 'script', 'title', 'desc', 'metadata']);

const PICTURES = new Set(['image', 'foreignObject', 'video', 'iframe', 'canvas']);

export interface DrawingPiece {
  runs: Run[];
  /** Maps the piece to the drawing's own units. */
  matrix: Matrix;
  rule: Rule;
  /** The pen of a stroke; `still` if its width stays the same at any scale. */
  pen?: Pen & { still: boolean };
  paint: Exclude<Paint, undefined>;
  /** All clips of the piece. */
  clips: Clip[];
}

export interface Clip {
  pieces: DrawingPiece[];
}

export interface Drawing {
  pieces: DrawingPiece[];
  /** The visible part of the drawing; undefined if the file does not define it. */
  frame: Box | undefined;
  left: Count;
}

/** The context that an element inherits. */
interface Around {
  matrix: Matrix;
  look: Properties;
  opacity: number;
  /** The box that percentages refer to. */
  page: Box;
  /** The elements whose use led here. They are not drawn again, so none uses itself. */
  used: Element[];
  deep: number;
  /** All shapes count as areas, as they clip others. */
  cutting: boolean;
}

/** Undefined if the text has no drawing. */
export function drawingOf(text: string): Drawing | undefined {
  const whole = parsed(text);
  const root = [...elements(whole)].find(({ name }) => name === 'svg') ?? [...elements(parsed(`<svg>${text}</svg>`))][0];
  return root && new Reader(root, whole).read();
}

/** Stops where elements are nested so deeply that reading takes quadratic time. */
class Shallow extends DomHandler {
  override onopentag(name: string, attributes: Record<string, string>): void {
    super.onopentag(name, attributes);
    if (this.tagStack.length > DEEPEST) throw new Refusal('too_deep', { most: DEEPEST });
  }
}

function parsed(text: string): Document {
  const handler = new Shallow();
  new Parser(handler, { xmlMode: true }).end(withEntities(text));
  return handler.root;
}

/** The text with the entities replaced that the file declares. Some programs write styles this way. */
function withEntities(text: string): string {
  const known = new Map([...text.slice(0, 20_000).matchAll(/<!ENTITY\s+([\w.-]+)\s+(?:"([^"]{0,300})"|'([^']{0,300})')\s*>/g)].map(([, name, one, other]) => [name, one ?? other ?? '']));
  let most = 20_000;
  return known.size ? text.replace(/&([\w.-]+);/g, (whole, name: string) => (most-- > 0 ? (known.get(name) ?? whole) : whole)) : text;
}

/** All elements in document order. */
function* elements(within: Document | Element): Generator<Element> {
  const left: ChildNode[] = within.children.toReversed();
  for (let node = left.pop(); node; node = left.pop()) {
    if (!isTag(node)) continue;
    yield node;
    for (let k = node.children.length - 1; k >= 0; k -= 1) left.push(node.children[k] as ChildNode);
  }
}

function textOf(element: Element): string {
  return element.children.map((node) => ('data' in node ? node.data : 'children' in node ? node.children.map((inner) => ('data' in inner ? inner.data : '')).join('') : '')).join('');
}

class Reader {
  private readonly root: Element;
  private readonly sheet: StyleRules;
  private readonly known = new Map<Element, Properties>();
  private readonly byId = new Map<string, Element>();
  private readonly left: Count = {};
  private pieces: DrawingPiece[] = [];
  private seen = 0;
  private points = 0;
  /** CSS pixels per unit of the drawing. */
  private scale = 1;

  constructor(root: Element, whole: Document) {
    this.root = root;
    const sheets: string[] = [];
    for (const element of elements(root)) {
      const { id } = element.attribs;
      if (id !== undefined && !this.byId.has(id)) this.byId.set(id, element);
      if (element.name === 'style') sheets.push(textOf(element));
    }
    this.count('link', sheets.join('').match(/@import\b/g)?.length ?? 0);
    this.count('link', whole.children.filter((node) => isDirective(node) && /^\?xml-stylesheet\b/.test(node.data)).length);
    this.sheet = new StyleRules(sheets);
  }

  read(): Drawing {
    const said = this.said(this.root);
    const box = boxOf(said);
    const [width, height] = ['width', 'height'].map((key) => lengthOf(said.get(key), 0)) as [number, number];
    const page = box ?? { x: 0, y: 0, width: width || 100, height: height || 100 };
    if (box && width > 0 && height > 0) this.scale = growth(fit(box, width, height, said)) / Math.SQRT2;
    this.walk(this.root, { matrix: STILL, look: new Map(), opacity: 1, page, used: [], deep: 0, cutting: false });
    const open = /visible|auto/.test(said.get('overflow') ?? '') || !(box ?? (width > 0 && height > 0));
    return { pieces: this.pieces, frame: open ? undefined : shown(box, width, height, said), left: this.left };
  }

  private count(what: Left, by = 1): void {
    if (by) this.left[what] = (this.left[what] ?? 0) + by;
  }

  private said(element: Element): Properties {
    const said = this.known.get(element) ?? this.sheet.of(element);
    this.known.set(element, said);
    return said;
  }

  private walk(element: Element, before: Around): void {
    if (ASIDE.has(element.name)) return;
    if ((this.seen += 1) > ELEMENTS) throw new Refusal('too_many_shapes', { most: ELEMENTS });
    if (before.deep > DEEPEST) throw new Refusal('too_deep', { most: DEEPEST });
    const said = this.said(element);
    const opacity = before.opacity * share(said.get('opacity'));
    if (said.get('display') === 'none' || !(opacity > 0 || before.cutting)) return;
    const around: Around = { ...before, opacity, look: inherited(before.look, said), matrix: times(before.matrix, transformOf(said)), deep: before.deep + 1 };
    const from = this.pieces.length;
    const hidden = /hidden|collapse/.test(around.look.get('visibility') ?? '');
    if (SHAPES.has(element.name)) {
      if (!hidden) this.shape(element.name, said, around);
    } else if (element.name === 'text') {
      if (!hidden && textOf(element).trim()) this.count('text');
    } else if (PICTURES.has(element.name)) {
      if (!hidden) this.count('image');
    } else if (element.name === 'use') this.use(said, around);
    else this.inside(element, element.name === 'svg' && element !== this.root, said, around);
    if (this.pieces.length > from) this.cut(said, around, from);
  }

  /** Draws the content of a group, a nested picture, or a used element. */
  private inside(element: Element, framed: boolean, said: Properties, around: Around, size: Properties = said): void {
    let within = around;
    if (framed) {
      const at = (key: string, of: number, otherwise = 0): number => lengthOf(size.get(key) ?? said.get(key), of, otherwise);
      const { width, height } = around.page;
      const page = { x: 0, y: 0, width: at('width', width, width), height: at('height', height, height) };
      if (!(page.width > 0 && page.height > 0)) return;
      const place = element.name === 'svg' ? shift(lengthOf(said.get('x'), width), lengthOf(said.get('y'), height)) : STILL;
      const box = boxOf(said);
      const matrix = times(around.matrix, place);
      const from = this.pieces.length;
      within = { ...around, page: box ?? page, matrix: box ? times(matrix, fit(box, page.width, page.height, said)) : matrix };
      this.children(element, within);
      if (!/visible|auto/.test(said.get('overflow') ?? '')) this.cutFrom(from, { pieces: [frameOf(page, matrix)] });
      return;
    }
    this.children(element, within);
  }

  private children(element: Element, around: Around): void {
    const children = element.children.filter(isTag);
    // A switch draws the first child that is allowed.
    const may = ({ name, attribs }: Element): boolean => name !== 'foreignObject' && attribs['requiredExtensions'] === undefined && /^$|\ben\b/.test(attribs['systemLanguage'] ?? '');
    const chosen = element.name === 'switch' ? children.filter(may).slice(0, 1) : children;
    for (const child of chosen) this.walk(child, around);
  }

  private use(said: Properties, around: Around): void {
    const href = said.get('href') ?? said.get('xlink:href') ?? '';
    if (!href.startsWith('#')) return this.count('link', href ? 1 : 0);
    const used = this.byId.get(href.slice(1));
    // An element that uses itself is not drawn.
    if (!used || around.used.includes(used)) return;
    const { width, height } = around.page;
    const matrix = times(around.matrix, shift(lengthOf(said.get('x'), width), lengthOf(said.get('y'), height)));
    const within = { ...around, matrix, used: [...around.used, used] };
    if (used.name !== 'symbol' && used.name !== 'svg') return this.walk(used, within);
    const own = this.said(used);
    if (own.get('display') === 'none') return;
    if ((this.seen += 1) > ELEMENTS) throw new Refusal('too_many_shapes', { most: ELEMENTS });
    this.inside(used, true, own, { ...within, look: inherited(within.look, own), deep: within.deep + 1 }, said);
  }

  private shape(name: string, said: Properties, { matrix, look, opacity, page, cutting }: Around): void {
    const runs = runsOf(name, said, page);
    if (!runs.some(({ curves, closed }) => curves.length || closed)) return;
    this.points += runs.reduce((sum, { curves }) => sum + 1 + curves.length, 0);
    if (this.points > POINTS) throw new Refusal('too_many_points', { most: POINTS });
    const rule = look.get(cutting ? 'clip-rule' : 'fill-rule') === 'evenodd' ? 'evenodd' : 'nonzero';
    const fill = cutting ? 'ink' : this.paint(look, 'fill', 'black', opacity);
    if (fill && name !== 'line') this.pieces.push({ runs, matrix, rule, paint: fill, clips: [] });
    const stroke = cutting ? undefined : this.paint(look, 'stroke', 'none', opacity);
    const pen = penOf(look, Math.hypot(page.width, page.height) / Math.SQRT2);
    if (!stroke || !(pen.width > 0)) return;
    const still = said.get('vector-effect') === 'non-scaling-stroke';
    const own = still ? { ...pen, width: pen.width / this.scale, dashes: pen.dashes.map((length) => length / this.scale), offset: pen.offset / this.scale } : pen;
    this.pieces.push({ runs, matrix, rule: 'nonzero', pen: { ...own, still }, paint: stroke, clips: [] });
    if (name !== 'rect' && ['marker-start', 'marker-mid', 'marker-end'].some((key) => /url/.test(look.get(key) ?? ''))) this.count('marker');
  }

  private paint(look: Properties, key: 'fill' | 'stroke', otherwise: string, opacity: number): Paint {
    const value = withoutVariables(look.get(key) ?? '') || otherwise;
    const [, id, fallback = ''] = /^url\(\s*["']?#([^"')]*)["']?\s*\)\s*(.*)$/.exec(value) ?? [];
    const server = id === undefined ? undefined : this.byId.get(id);
    if (server?.name === 'pattern') this.count('pattern');
    const colour = server ? 'black' : id === undefined ? value : fallback || 'none';
    return paintOf(/^currentcolor$/i.test(colour) ? (look.get('color') ?? 'black') : colour, opacity * share(look.get(`${key}-opacity`)));
  }

  /** Applies the element's clip to the pieces that were added since `from`. */
  private cut(said: Properties, around: Around, from: number): void {
    if (/\(/.test(said.get('mask') ?? '') && !around.cutting) this.count('mask');
    if (/\(/.test(said.get('filter') ?? '') && !around.cutting) this.count('filter');
    const value = said.get('clip-path') ?? '';
    if (!value || value === 'none') return;
    const id = /^url\(\s*["']?#([^"')]*)["']?\s*\)/.exec(value)?.[1];
    const by = id === undefined ? undefined : this.byId.get(id);
    if (id === undefined) this.count('clip');
    if (by?.name !== 'clipPath' || around.used.includes(by)) return;
    const told = this.said(by);
    const inBox = told.get('clipPathUnits') === 'objectBoundingBox';
    const matrix = inBox ? times(around.matrix, this.boxFrom(from, around.matrix)) : around.matrix;
    const pieces = this.pieces;
    this.pieces = [];
    const within = { ...around, matrix: times(matrix, transformOf(told)), look: inherited(new Map(), told), used: [...around.used, by], cutting: true, deep: around.deep + 1 };
    this.children(by, within);
    this.cut(told, within, 0);
    const clip = { pieces: this.pieces };
    this.pieces = pieces;
    this.cutFrom(from, clip);
  }

  private cutFrom(from: number, clip: Clip): void {
    for (const piece of this.pieces.slice(from)) piece.clips.push(clip);
  }

  /** Maps 0..1 to the box around the pieces since `from`, in the element's units. */
  private boxFrom(from: number, matrix: Matrix): Matrix {
    const inverse = back(matrix) ?? STILL;
    const points = this.pieces.slice(from).flatMap((piece) => placesOf(piece).map((point) => moved(inverse, point)));
    const [left, right, top, bottom] = boundsOf(points);
    return times(shift(left, top), stretch(right - left, bottom - top));
  }
}

/** The end points and control points of a piece. */
export function placesOf({ runs, matrix }: DrawingPiece): Point[] {
  return runs.flatMap(({ start, curves }) => [start, ...curves.flat()].map((point) => moved(matrix, point)));
}

/** Left, right, top and bottom of points. */
export function boundsOf(points: Point[]): [number, number, number, number] {
  return points.reduce<[number, number, number, number]>(
    ([left, right, top, bottom], [x, y]) => [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)],
    [Infinity, -Infinity, Infinity, -Infinity],
  );
}

/** The part of a drawing that a browser shows, in the drawing's units. */
function shown(box: Box | undefined, width: number, height: number, said: Properties): Box {
  if (!box) return { x: 0, y: 0, width, height };
  const inverse = width > 0 && height > 0 ? back(fit(box, width, height, said)) : undefined;
  if (!inverse) return box;
  const [[x, y], [right, bottom]] = [moved(inverse, [0, 0]), moved(inverse, [width, height])];
  return { x, y, width: right - x, height: bottom - y };
}

function frameOf({ width, height }: Box, matrix: Matrix): DrawingPiece {
  const curves: Point[][] = [[[width, 0]], [[width, height]], [[0, height]]];
  return { runs: [{ start: [0, 0], curves, closed: true }], matrix, rule: 'nonzero', paint: 'ink', clips: [] };
}

function inherited(look: Properties, said: Properties): Properties {
  const told = INHERITED.filter((key) => said.has(key) && said.get(key) !== 'inherit');
  if (!told.length) return look;
  const own = new Map(look);
  for (const key of told) {
    if (said.get(key) === 'initial') own.delete(key);
    else own.set(key, said.get(key) ?? '');
  }
  return own;
}

/** A transform about its transform-origin. */
function transformOf(said: Properties): Matrix {
  const matrix = matrixOf(said.get('transform') ?? '');
  const [x = NaN, y = NaN] = (said.get('transform-origin') ?? '').split(/\s+/).map((part) => (/^-?[\d.]+(px)?$/.test(part) ? parseFloat(part) : NaN));
  return Number.isFinite(x + y) ? times(times(shift(x, y), matrix), shift(-x, -y)) : matrix;
}

/** A number or percentage as 0..1; 1 if there is none. */
function share(text: string | undefined): number {
  const number = parseFloat(text ?? '');
  return Number.isFinite(number) ? Math.min(1, Math.max(0, text?.endsWith('%') ? number / 100 : number)) : 1;
}

function penOf(look: Properties, of: number): Pen {
  const told = (key: string): string => withoutVariables(look.get(key) ?? '');
  const limit = parseFloat(told('stroke-miterlimit'));
  const list = told('stroke-dasharray');
  return {
    width: lengthOf(told('stroke-width'), of, 1),
    cap: told('stroke-linecap'),
    join: told('stroke-linejoin'),
    limit: limit >= 1 ? limit : 4,
    dashes: !list || list === 'none' ? [] : list.split(/[\s,]+/).map((length) => lengthOf(length, of, NaN)),
    offset: lengthOf(told('stroke-dashoffset'), of),
  };
}

/** The text with each variable replaced by its fallback, as no page gives it a value. */
function withoutVariables(value: string): string {
  return value.replace(/var\(\s*--[\w-]+\s*(?:,([^()]*(?:\([^()]*\))?[^()]*))?\)/g, '$1').trim();
}
