/** Moving points over the canvas, by mouse, touch and keyboard: of rings, lines, spots and seeds of parts. */
import { EditorBar } from './editor-bar';
import { make } from './dom';
import { distance, toSegment } from './simplify';
import type { Figure, Point, Sort } from './types';

const SVG = 'http://www.w3.org/2000/svg';

/** Picture units that an arrow key moves a point; with Shift ten times as many. */
const NUDGE = 1;

/** A point of a figure. */
interface Place {
  figure: number;
  index: number;
}

export interface EditorNeeds {
  side(): number;
  /** All that can be edited now. */
  sorts(): Sort[];
  /** Another sort was chosen in the bar. */
  choose(word: string): void;
  /** A new figure, away from those that are there; for a seed the one at this place. */
  fresh(sort: Sort, figures: Figure[], at?: Point): Figure | undefined;
  /** Takes the figures over, or says why it cannot and answers false. */
  change(sort: Sort, figures: Figure[]): boolean;
  /** A drag begins or ends. */
  live(on: boolean): void;
  closed(): void;
}

export class Editor {
  private readonly layer: HTMLElement;
  private readonly bar: EditorBar;
  private readonly needs: EditorNeeds;
  private readonly lines = document.createElementNS(SVG, 'svg');
  private readonly handles = make('div', { class: 'handles' });
  private sort: Sort | undefined;
  private figures: Figure[] = [];
  private marked: Place = { figure: 0, index: 0 };
  private frame = 0;
  /** Where the pointer that drags a whole figure was last. */
  private held: Point | undefined;
  private dragging = false;

  /** The layer lies over the canvas; the bar takes the buttons for the marked point. */
  constructor(layer: HTMLElement, bar: HTMLElement, needs: EditorNeeds) {
    this.layer = layer;
    this.needs = needs;
    this.bar = new EditorBar(bar, {
      choose: (word) => needs.choose(word),
      addFigure: () => this.addFigure(),
      addPoint: () => this.addAfter(this.marked),
      remove: () => this.take(this.marked),
      value: (value) => this.setValue(value),
      close: () => this.close(),
    });
    this.lines.setAttribute('aria-hidden', 'true');
    layer.replaceChildren(this.lines, this.handles);
    for (const place of [layer, bar]) {
      place.addEventListener('keydown', (event) => {
        if (event.key === 'Escape') this.close();
      });
    }
    layer.addEventListener('click', (event) => {
      if (event.target === layer && this.sort?.form === 'seed') this.addFigure(this.at(event));
    });
  }

  /** The word of the sort that is edited. */
  get word(): string | undefined {
    return this.layer.hidden ? undefined : this.sort?.word;
  }

  /** Shows handles on these figures. */
  open(sort: Sort, figures: Figure[]): void {
    this.drop();
    this.sort = sort;
    this.figures = figures;
    this.marked = { figure: 0, index: 0 };
    this.layer.hidden = false;
    this.layer.dataset['form'] = sort.form;
    this.layer.setAttribute('aria-label', sort.label);
    this.layer.classList.remove('bad');
    this.rebuild();
  }

  /** Puts the keyboard on the marked point; where there is none, on one of a new figure. */
  start(): void {
    if (this.figures.length) this.focus();
    else this.addFigure();
  }

  /** Puts the keyboard on the marked point, or where figures are added. */
  private focus(): void {
    const before = this.figures.slice(0, this.marked.figure).reduce((total, { points }) => total + points.length, 0);
    const handle = this.handles.children[before + this.marked.index];
    if (handle instanceof HTMLElement) handle.focus({ preventScroll: true });
    else this.bar.focus();
  }

  close(): void {
    if (this.layer.hidden) return;
    this.drop();
    this.layer.hidden = true;
    this.bar.hide();
    this.needs.closed();
  }

  private rebuild(): void {
    this.drop();
    this.handles.replaceChildren();
    this.lines.replaceChildren(...['edge', ...this.figures.map(() => 'grip')].map(path));
    this.figures.forEach(({ points }, figure) => {
      points.forEach((_, index) => this.handles.append(this.handle({ figure, index })));
      this.grip(figure);
    });
    this.place();
  }

  private handle(place: Place): HTMLButtonElement {
    const handle = make('button', { type: 'button', class: 'handle' });
    handle.addEventListener('focus', () => this.mark(place));
    handle.addEventListener('keydown', (event) => this.key(event, place));
    handle.addEventListener('pointerdown', (event) => {
      handle.setPointerCapture(event.pointerId);
      this.mark(place);
    });
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      this.drag();
      this.move(place, this.at(event));
    });
    handle.addEventListener('lostpointercapture', () => this.drop());
    return handle;
  }

  /** A figure's line takes a point by double click; lines and spots are dragged by it. */
  private grip(figure: number): void {
    const grip = this.lines.children[figure + 1];
    if (!(grip instanceof SVGElement)) return;
    grip.addEventListener('dblclick', (event) => this.split(figure, this.at(event)));
    if (this.sort?.form === 'ring') return;
    grip.addEventListener('pointerdown', (event) => {
      grip.setPointerCapture(event.pointerId);
      this.held = this.at(event);
      this.mark({ figure, index: 0 });
    });
    grip.addEventListener('pointermove', (event) => {
      if (!this.held || !grip.hasPointerCapture(event.pointerId)) return;
      this.drag();
      const [x, y] = this.at(event);
      this.shift(figure, [x - this.held[0], y - this.held[1]]);
      this.held = [x, y];
    });
    grip.addEventListener('lostpointercapture', () => this.drop());
  }

  /** The pointer that holds a point has moved. */
  private drag(): void {
    if (this.dragging) return;
    this.dragging = true;
    this.needs.live(true);
  }

  /** The pointer let go: by rising, by being cancelled, or as what it held is gone. */
  private drop(): void {
    if (!this.dragging) return;
    this.dragging = false;
    if (this.frame) this.hand();
    this.needs.live(false);
  }

  /** Puts lines, handles and buttons where the points are. */
  private place(): void {
    const { sort } = this;
    if (!sort) return;
    const side = this.needs.side();
    this.lines.setAttribute('viewBox', `0 0 ${side} ${side}`);
    const paths = this.figures.map(({ points }) => drawn(sort, points));
    [paths.join(''), ...paths].forEach((d, k) => this.lines.children[k]?.setAttribute('d', d));
    let at = 0;
    this.figures.forEach((figure, f) =>
      figure.points.forEach(([x, y], index) => {
        const handle = this.handles.children[at++] as HTMLButtonElement;
        handle.style.left = `${(100 * x) / side}%`;
        handle.style.top = `${(100 * y) / side}%`;
        handle.setAttribute('aria-label', `${sort.name(f, index, figure)}, at ${Math.round(x)}, ${Math.round(y)}`);
        handle.toggleAttribute('data-marked', this.marked.figure === f && this.marked.index === index);
        const tag = index === 0 && sort.value?.shown(figure.value);
        if (tag) handle.dataset['tag'] = tag;
      }),
    );
    this.bar.show(this.needs.sorts(), sort, this.figures[this.marked.figure], this.removable());
  }

  /** The outer ring keeps three points. */
  private removable(): boolean {
    const marked = this.figures[this.marked.figure];
    const outer = this.sort?.form === 'ring' && this.marked.figure === 0;
    return marked !== undefined && !(outer && marked.points.length <= 3);
  }

  private mark(place: Place): void {
    this.marked = place;
    this.place();
  }

  /** The picture's place under a pointer. */
  private at(event: MouseEvent): Point {
    const box = this.layer.getBoundingClientRect();
    const side = this.needs.side();
    return [((event.clientX - box.left) / box.width) * side, ((event.clientY - box.top) / box.height) * side];
  }

  private move({ figure, index }: Place, [x, y]: Point): void {
    const points = this.figures[figure]?.points;
    const here = points?.[index];
    if (!points || !here) return;
    if (this.sort?.form === 'spot' && index === 0) return this.shift(figure, [x - here[0], y - here[1]]);
    const side = this.needs.side();
    points[index] = [Math.min(side, Math.max(0, x)), Math.min(side, Math.max(0, y))];
    this.changed();
  }

  /** Moves a whole figure, as far as its points (of a spot, its middle) stay in the picture. */
  private shift(figure: number, by: Point): void {
    const points = this.figures[figure]?.points;
    if (!points) return;
    const side = this.needs.side();
    const inside = this.sort?.form === 'spot' ? points.slice(0, 1) : points;
    const [dx, dy] = [0, 1].map((axis) => {
      const places = inside.map((point) => point[axis] ?? 0);
      const [back, on] = [Math.min(0, -Math.min(...places)), Math.max(0, side - Math.max(...places))];
      return Math.min(on, Math.max(back, by[axis] ?? 0));
    });
    points.forEach((point) => {
      point[0] += dx ?? 0;
      point[1] += dy ?? 0;
    });
    this.changed();
  }

  private key(event: KeyboardEvent, place: Place): void {
    const point = this.figures[place.figure]?.points[place.index];
    if (!point) return;
    const step = NUDGE * (event.shiftKey ? 10 : 1);
    const [x, y] = point;
    const go = (dx: number, dy: number) => (): void => {
      if (event.ctrlKey || event.metaKey) this.shift(place.figure, [dx * step, dy * step]);
      else this.move(place, [x + dx * step, y + dy * step]);
    };
    const moves: Record<string, () => void> = {
      ArrowLeft: go(-1, 0),
      ArrowRight: go(1, 0),
      ArrowUp: go(0, -1),
      ArrowDown: go(0, 1),
      Delete: () => this.take(place),
      Backspace: () => this.take(place),
      Insert: () => this.addAfter(place),
    };
    const act = moves[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private setValue(value: number): void {
    const figure = this.figures[this.marked.figure];
    if (!figure || Number.isNaN(value)) return this.place();
    figure.value = value;
    this.changed();
  }

  private addFigure(at?: Point): void {
    const fresh = this.sort && this.needs.fresh(this.sort, this.figures, at);
    if (!fresh) return;
    this.figures.push(fresh);
    this.restructured({ figure: this.figures.length - 1, index: 0 });
  }

  /** Adds a point half the way to the next one; behind the end of a line, on the way on. */
  private addAfter({ figure, index }: Place): void {
    const points = this.figures[figure]?.points;
    const here = points?.[index];
    const closed = this.sort?.form === 'ring';
    const before = points?.[index - 1];
    const next = points?.[closed && points.length ? (index + 1) % points.length : index + 1] ?? (before && here && mirrored(before, here));
    if (!points || !here || !next || !(closed || this.sort?.form === 'line')) return;
    points.splice(index + 1, 0, this.clamped([(here[0] + next[0]) / 2, (here[1] + next[1]) / 2]));
    this.restructured({ figure, index: index + 1 });
  }

  private clamped([x, y]: Point): Point {
    const side = this.needs.side();
    return [Math.min(side, Math.max(0, x)), Math.min(side, Math.max(0, y))];
  }

  /** Adds a point on the piece of a ring or a line that is nearest to this place. */
  private split(figure: number, point: Point): void {
    const points = this.figures[figure]?.points;
    const closed = this.sort?.form === 'ring';
    if (!points || !(closed || this.sort?.form === 'line')) return;
    let nearest = { index: 0, distance: Infinity };
    points.forEach((from, index) => {
      const to = points[closed ? (index + 1) % points.length : index + 1];
      const far = to ? toSegment(point, from, to) : Infinity;
      if (far < nearest.distance) nearest = { index, distance: far };
    });
    points.splice(nearest.index + 1, 0, point);
    this.restructured({ figure, index: nearest.index + 1 });
  }

  /** Takes a point away; of a figure that has no more than it needs, all go. The outer ring stays. */
  private take({ figure, index }: Place): void {
    const points = this.figures[figure]?.points;
    const { sort } = this;
    if (!points || !sort || !this.removable()) return;
    if (points.length > sort.least) points.splice(index, 1);
    else this.figures.splice(figure, 1);
    const left = this.figures[figure] === undefined ? this.figures.length - 1 : figure;
    const most = (this.figures[left]?.points.length ?? 1) - 1;
    this.restructured({ figure: Math.max(0, left), index: Math.min(index, most) });
  }

  private restructured(marked: Place): void {
    this.marked = marked;
    this.rebuild();
    this.focus();
    this.changed();
  }

  /** Hands the figures over once a frame; bad ones stay drawn here, so that they can be mended. */
  private changed(): void {
    this.place();
    this.frame ||= requestAnimationFrame(() => this.hand());
  }

  private hand(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (!this.sort) return;
    this.layer.classList.toggle('bad', !this.needs.change(this.sort, this.figures));
    // Other sorts may do something now.
    this.place();
  }
}

function path(name: string): SVGElement {
  const element = document.createElementNS(SVG, 'path');
  element.classList.add(name);
  return element;
}

/** The place as far behind the second point as the first one is before it. */
function mirrored(from: Point, at: Point): Point {
  return [2 * at[0] - from[0], 2 * at[1] - from[1]];
}

/** A figure as an SVG path. */
function drawn({ form }: Sort, points: Point[]): string {
  const [first, second] = points;
  if (form === 'seed' || !first) return '';
  if (form !== 'spot' || !second) return `M${points.map(([x, y]) => `${x} ${y}`).join('L')}${form === 'ring' ? 'Z' : ''}`;
  const r = distance(first, second);
  return `M${first[0] - r} ${first[1]}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}
