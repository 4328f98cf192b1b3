/** Draws the editor's lines, handles and guides over the canvas. */
import type { Point } from '../module/types';
import { t } from '../words/editor';
import { make } from '../base/dom';
import { shape } from '../late/svg';
import { lines, middle } from './geometry/curve';
import { drawn, knobs, type Figure, type FigurePoint, type Sort } from './geometry/figures';
import { distance } from './geometry/plane';
import { depth } from './geometry/rings';

/** Shorter edges, in CSS pixels, have no handle that adds a point. For fingers, edges must be longer. */
const ROOM = 56;
const ROOM_FOR_FINGERS = 112;

/** The part of the drawing under a pointer. */
export type SheetPart =
  | { part: 'point' | 'edge'; place: FigurePoint }
  | { part: 'line' | 'knob'; figure: number }
  | { part: 'nothing' };

export class EditorSheet {
  readonly layer: HTMLElement;
  private readonly lines = shape('svg', { 'aria-hidden': 'true' });
  private readonly grips = shape('g');
  private readonly paths: Record<'rim' | 'band' | 'draft' | 'edge' | 'guide', SVGElement>;
  private readonly edges = make('div', { 'aria-hidden': 'true' });
  private readonly handles = make('div', { class: 'handles' });
  private readonly room = matchMedia('(pointer: coarse)').matches ? ROOM_FOR_FINGERS : ROOM;

  constructor(layer: HTMLElement) {
    this.layer = layer;
    this.paths = { rim: path('rim'), band: path('band'), draft: path('draft'), edge: path('edge'), guide: path('guide') };
    this.lines.append(this.paths.rim, this.paths.band, this.paths.edge, this.grips, this.paths.draft, this.paths.guide);
    layer.replaceChildren(this.lines, this.edges, this.handles);
    layer.tabIndex = -1;
  }

  /** The place in the picture under a pointer, however the layer is moved and scaled. */
  at(event: MouseEvent, side: number): Point {
    const box = this.layer.getBoundingClientRect();
    return [((event.clientX - box.left) / box.width) * side, ((event.clientY - box.top) / box.height) * side];
  }

  /** The length of a CSS pixel, in units of the picture. */
  unit(side: number): number {
    return side / (this.layer.getBoundingClientRect().width || side);
  }

  /** Makes elements for these figures, without placing them. */
  build(sort: Sort, figures: Figure[]): void {
    this.grips.replaceChildren(...figures.map((_, figure) => marked(path('grip'), { figure })));
    const points = figures.flatMap(({ points }, figure) => points.map((_, index): FigurePoint => ({ figure, index })));
    this.handles.replaceChildren(
      ...points.map((place) => marked(make('button', { type: 'button', class: 'handle' }), { ...place })),
      ...(sort.broad ? figures.flatMap((_, figure) => [0, 1].map(() => marked(make('span', { class: 'handle knob', 'aria-hidden': 'true' }), { figure }))) : []),
    );
    const divided = sort.form === 'ring' || sort.form === 'line';
    this.edges.replaceChildren(...(divided ? points : []).map((place) => marked(make('span', { class: 'handle ghost', title: t('ghost') }), { ...place })));
  }

  /** Moves all elements to their figures. */
  place(sort: Sort, figures: Figure[], at: FigurePoint, side: number): void {
    const shortest = this.room * this.unit(side);
    this.lines.setAttribute('viewBox', `0 0 ${side} ${side}`);
    const courses = figures.map((figure) => lines(figure, side));
    const rings = courses.map((course) => course.flat());
    const paths = rings.map((ring) => drawn(sort.form, ring));
    this.paths.edge.setAttribute('d', paths.join(''));
    paths.forEach((d, figure) => {
      const grip = this.grips.children[figure];
      grip?.setAttribute('d', d);
      grip?.classList.toggle('hole', sort.form === 'ring' && depth(rings[figure] ?? [], rings) % 2 === 1);
    });
    let handle = this.handles.firstElementChild;
    let edge = this.edges.firstElementChild;
    const put = (element: Element | null, [x, y]: Point): element is HTMLElement => {
      if (!(element instanceof HTMLElement)) return false;
      element.style.left = `${(100 * x) / side}%`;
      element.style.top = `${(100 * y) / side}%`;
      return true;
    };
    figures.forEach((figure, f) =>
      figure.points.forEach((point, index) => {
        if (put(handle, point)) {
          handle.setAttribute('aria-label', `${sort.name({ figure: f, index }, figures)}, ${t('at', { x: Math.round(point[0]), y: Math.round(point[1]) })}`);
          handle.toggleAttribute('data-marked', at.figure === f && at.index === index);
          const tag = index === 0 && !sort.broad && sort.value?.shown(figure.value);
          if (tag) handle.dataset['tag'] = tag;
        }
        handle = handle?.nextElementSibling ?? null;
        const next = figure.points[index + 1] ?? (sort.form === 'ring' ? figure.points[0] : undefined);
        if (edge && put(edge, next ? middle(courses[f]?.[index] ?? [point], next) : point)) {
          edge.hidden = !next || distance(point, next) < shortest;
        }
        edge = edge?.nextElementSibling ?? null;
      }),
    );
    for (const figure of sort.broad ? figures : []) {
      for (const knob of knobs(figure, side)) {
        put(handle, knob);
        handle = handle?.nextElementSibling ?? null;
      }
    }
  }

  /** Shows the figure being drawn. A road also has a band, `width` units of the picture wide. */
  draft(d: string, width: number): void {
    this.paths.draft.setAttribute('d', d);
    this.paths.band.setAttribute('d', width ? d : '');
    this.paths.band.style.strokeWidth = `${width}px`;
  }

  /** Shows the outline that roads make. */
  rim(d: string): void {
    this.paths.rim.setAttribute('d', d);
  }

  guide(d: string): void {
    this.paths.guide.setAttribute('d', d);
  }

  /** Moves the keyboard focus to a point. Returns false if there is none. */
  focus(figures: Figure[], { figure, index }: FigurePoint): boolean {
    const before = figures.slice(0, figure).reduce((total, { points }) => total + points.length, 0);
    const handle = this.handles.children[before + index];
    if (!(handle instanceof HTMLButtonElement)) return false;
    handle.focus({ preventScroll: true });
    return true;
  }

  /** The part under a pointer. */
  part(target: EventTarget | null): SheetPart {
    if (!(target instanceof HTMLElement || target instanceof SVGElement)) return { part: 'nothing' };
    const [figure, index] = [Number(target.dataset['figure']), Number(target.dataset['index'])];
    if (target.matches('.ghost')) return { part: 'edge', place: { figure, index } };
    if (target.matches('.knob')) return { part: 'knob', figure };
    if (target.matches('.handle')) return { part: 'point', place: { figure, index } };
    return target.matches('.grip') ? { part: 'line', figure } : { part: 'nothing' };
  }
}

function path(name: string): SVGElement {
  return shape('path', { class: name });
}

function marked<E extends HTMLElement | SVGElement>(element: E, data: Record<string, number>): E {
  for (const [name, value] of Object.entries(data)) element.dataset[name] = String(value);
  return element;
}
