/** Figures over the canvas, and what is done with them: by pointers (gestures.ts), keys, and the bar's buttons. */
import { byId } from '../base/dom';
import type { Point } from '../module/types';
import { EditorBar } from './bar';
import { divide, join, nearestLine, settle, turnOver } from './geometry/curve';
import { drawn, type Figure, type Place, type Sort } from './geometry/figures';
import { distance, nearest, toSegment } from './geometry/plane';
import { snap } from './geometry/snap';
import { Gestures } from './gestures';
import { Sheet } from './sheet';

/** Picture units that an arrow key moves a point; with Shift ten times as many. */
const NUDGE = 1;

/** CSS pixels from which Shift draws a point to others and to directions. */
const REACH = 9;

export interface EditorNeeds {
  side(): number;
  /** All that can be edited now. */
  sorts(): Sort[];
  /** Another sort was chosen in the bar. */
  choose(word: string): void;
  /** A new figure, away from those that are there; for a seed the one at this place. */
  fresh(sort: Sort, figures: Figure[], at?: Point): Figure | undefined;
  /** The value of a figure that was drawn. */
  first(sort: Sort): number;
  /** Takes the figures over, or says why it cannot and answers false. */
  change(sort: Sort, figures: Figure[]): boolean;
  /** The outline that the figures make, where they are not that themselves. */
  rim(): Point[][];
  /** A drag begins or ends. */
  live(on: boolean): void;
  /** A ring was drawn. */
  disarmed(): void;
  closed(): void;
}

export class Editor {
  readonly sheet: Sheet;
  private readonly bar: EditorBar;
  private readonly needs: EditorNeeds;
  private readonly gestures: Gestures;
  private figures: Figure[] = [];
  private marked: Place = { figure: 0, index: 0 };
  private frame = 0;
  private holding = false;
  sort: Sort | undefined;
  /** The next drag over the canvas draws a ring. */
  armed = false;

  /** The layer lies over the canvas; the bar takes the buttons for the marked point. */
  constructor(layer: HTMLElement, bar: HTMLElement, needs: EditorNeeds) {
    this.needs = needs;
    this.sheet = new Sheet(layer);
    this.bar = new EditorBar(bar, {
      choose: (word) => needs.choose(word),
      addFigure: () => this.addFigure(),
      addPoint: () => this.addAfter(this.marked),
      remove: () => this.take(this.marked),
      turnOver: () => this.turnOver(this.marked),
      value: (value, last) => this.setValue(value, last),
      finish: () => this.gestures.finish(),
      cancel: () => this.gestures.cancel(),
      close: () => this.close(),
    });
    this.gestures = new Gestures(this);
    for (const place of [layer, bar]) place.addEventListener('keydown', (event) => this.keyAnywhere(event));
    // After a tool was clicked the keyboard is on its button.
    byId('edit-tools').addEventListener('keydown', (event) => this.open && event.key === 'Escape' && this.keyAnywhere(event));
    document.body.addEventListener('keydown', (event) => this.open && event.target === document.body && this.keyAnywhere(event));
    layer.addEventListener('focusin', ({ target }) => {
      const part = this.sheet.part(target);
      if (part.part === 'point') this.mark(part.place);
    });
    layer.addEventListener('keydown', (event) => {
      const part = this.sheet.part(event.target);
      if (part.part === 'point') this.key(event, part.place);
    });
    layer.addEventListener('keyup', () => this.drop());
  }

  get open(): boolean {
    return !this.sheet.layer.hidden;
  }

  get side(): number {
    return this.needs.side();
  }

  /** Shows handles on these figures; `armed` where a ring is to be drawn next. */
  show(sort: Sort, figures: Figure[], armed = false): void {
    this.drop();
    const same = this.sort?.word === sort.word && this.open;
    const focused = this.sheet.layer.contains(document.activeElement);
    this.sort = sort;
    this.figures = figures;
    this.armed = armed;
    if (!same) this.marked = { figure: 0, index: 0 };
    this.gestures.reset();
    const { layer } = this.sheet;
    layer.hidden = false;
    layer.dataset['form'] = sort.form;
    layer.toggleAttribute('data-armed', armed);
    layer.toggleAttribute('data-draws', armed || sort.form === 'line' || sort.form === 'spot');
    layer.setAttribute('aria-label', sort.label);
    layer.classList.remove('bad');
    this.rebuild(this.marked);
    if (focused && same) this.focus();
  }

  /** Puts the keyboard on the marked point; where there is none, on one of a new figure if there may be one. */
  start(fresh: boolean): void {
    if (this.figures.length || !fresh) this.focus();
    else this.addFigure();
  }

  /** Puts the keyboard on the marked point, or where figures are added. */
  focus(): void {
    if (!this.sheet.focus(this.figures, this.marked)) this.bar.focus();
  }

  close(): void {
    if (!this.open) return;
    this.gestures.reset();
    this.drop();
    this.sheet.layer.hidden = true;
    this.bar.hide();
    this.needs.closed();
  }

  /** Elements for all figures, and a point that is there marked. */
  private rebuild({ figure, index }: Place): void {
    if (!this.sort) return;
    const known = Math.max(0, Math.min(figure, this.figures.length - 1));
    this.marked = { figure: known, index: Math.max(0, Math.min(index, (this.figures[known]?.points.length ?? 1) - 1)) };
    this.sheet.build(this.sort, this.figures);
    this.place();
  }

  /** Puts lines, handles and buttons where the points are. */
  place(): void {
    const { sort } = this;
    if (!sort) return;
    this.sheet.place(sort, this.figures, this.marked, this.side);
    this.showBar();
  }

  showBar(): void {
    if (!this.sort) return;
    this.sheet.rim(this.needs.rim().map((ring) => drawn('ring', ring)).join(''));
    const { drawing } = this.gestures;
    const marked = this.figures[this.marked.figure];
    const smooth = marked?.stretches?.[this.marked.index]?.smooth ?? false;
    this.bar.show(this.needs.sorts(), this.sort, { marked, smooth, removable: this.removable(), drawing, armed: this.armed });
  }

  /** The value that a line being drawn will have. */
  get firstValue(): number {
    return this.sort ? this.needs.first(this.sort) : 0;
  }

  /** The outer ring keeps three points. */
  private removable(): boolean {
    const marked = this.figures[this.marked.figure];
    const only = this.sort?.form === 'ring' && this.figures.length === 1;
    return marked !== undefined && !(only && marked.points.length <= 3);
  }

  mark(place: Place): void {
    if (place.figure === this.marked.figure && place.index === this.marked.index) return;
    this.marked = place;
    this.place();
  }

  /** Where a point goes: with Shift, to what is near. Tells by a guide to what. */
  snapped(at: Point, snaps: boolean, place: Place | undefined, neighbour?: Point): Point {
    if (!snaps) {
      this.sheet.guide('');
      return at;
    }
    const points = place ? this.figures[place.figure]?.points : undefined;
    const own = place && points?.[place.index];
    const closed = this.sort?.form === 'ring';
    const beside = (step: number): Point | undefined =>
      points && place && this.sort?.form !== 'spot' ? points[closed ? (place.index + step + points.length) % points.length : place.index + step] : undefined;
    const others = this.figures.flatMap((figure) => figure.points).filter((point) => point !== own);
    const neighbours = [beside(-1), beside(1), neighbour].filter((point) => point !== undefined);
    const found = snap(at, this.side, REACH * this.sheet.unit(this.side), neighbours, others);
    this.sheet.guide(found.guide);
    return found.at;
  }

  move({ figure, index }: Place, [x, y]: Point): void {
    const points = this.figures[figure]?.points;
    const here = points?.[index];
    if (!points || !here) return;
    if (this.sort?.form === 'spot' && index === 0) return this.shift(figure, [x - here[0], y - here[1]]);
    points[index] = this.clamped([x, y]);
    this.changed();
  }

  /** Moves a whole figure, as far as its points (of a spot, its middle) stay in the picture. */
  shift(figure: number, by: Point): void {
    const points = this.figures[figure]?.points;
    if (!points) return;
    const inside = this.sort?.form === 'spot' ? points.slice(0, 1) : points;
    const [dx, dy] = [0, 1].map((axis) => {
      const places = inside.map((point) => point[axis] ?? 0);
      const [back, on] = [Math.min(0, -Math.min(...places)), Math.max(0, this.side - Math.max(...places))];
      return Math.min(on, Math.max(back, by[axis] ?? 0));
    });
    points.forEach(([x, y], k) => (points[k] = [x + (dx ?? 0), y + (dy ?? 0)]));
    this.changed();
  }

  /** A band's side is at this place. */
  widen(index: number, at: Point): void {
    const figure = this.figures[index];
    const value = this.sort?.value;
    const [from, to] = figure?.points ?? [];
    if (!figure || !value || !from || !to) return;
    const across = Math.abs((at[0] - from[0]) * (to[1] - from[1]) - (at[1] - from[1]) * (to[0] - from[0])) / (distance(from, to) || 1);
    figure.value = Math.min(value.max, Math.max(value.min, (200 * across) / this.side));
    this.changed();
  }

  /** Whether a figure's line moves it: an outline's first ring stays where it is. */
  loose(figure: number): boolean {
    return this.sort?.form !== 'ring' || figure > 0;
  }

  /** The pointer or the key that changes something is held down: all is one step until it is let go. */
  hold(): void {
    if (this.holding) return;
    this.settle();
    this.holding = true;
    this.needs.live(true);
  }

  /** What is moved next is moved from here. */
  private settle(): void {
    for (const figure of this.figures) settle(figure, this.side);
  }

  /** It is let go: by rising, by being cancelled, or as what it held is gone. */
  drop(): void {
    this.sheet.guide('');
    if (!this.holding) return;
    this.holding = false;
    if (this.frame) this.hand();
    this.needs.live(false);
  }

  /** Escape leaves the points; while something is drawn, it only takes that back. */
  private keyAnywhere(event: KeyboardEvent): void {
    if (event.target instanceof HTMLElement && event.target.matches('input, select') && event.key !== 'Escape') return;
    if (this.gestures.key(event)) return event.preventDefault();
    if (event.key === 'Escape') this.close();
  }

  private key(event: KeyboardEvent, place: Place): void {
    const point = this.figures[place.figure]?.points[place.index];
    if (!point || event.defaultPrevented) return;
    const step = NUDGE * (event.shiftKey ? 10 : 1);
    const [x, y] = point;
    const go = (dx: number, dy: number) => (): void => {
      if (event.repeat) this.hold();
      else this.settle();
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
      Enter: () => this.turnOver(place),
    };
    const act = moves[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  private setValue(value: number, last: boolean): void {
    const figure = this.figures[this.marked.figure];
    const limits = this.sort?.value;
    if (!figure || !limits || Number.isNaN(value)) return this.place();
    if (!last) this.hold();
    figure.value = Math.min(limits.max, Math.max(limits.min, value));
    this.changed();
    if (last) this.drop();
  }

  addFigure(at?: Point): void {
    const fresh = this.sort && this.needs.fresh(this.sort, this.figures, at);
    if (fresh) this.add(fresh);
  }

  /** A figure that was drawn, or a fresh one. */
  add(figure: Figure): void {
    this.figures.push({ ...figure, points: figure.points.map((point) => this.clamped(point)) });
    if (this.armed) this.disarm();
    this.restructured({ figure: this.figures.length - 1, index: 0 });
  }

  disarm(): void {
    this.armed = false;
    this.sheet.layer.removeAttribute('data-armed');
    this.sheet.layer.toggleAttribute('data-draws', this.sort?.form === 'line' || this.sort?.form === 'spot');
    this.gestures.reset();
    this.needs.disarmed();
  }

  /** Adds a point half the way to the next one; behind the end of a line, on the way on. */
  addAfter({ figure, index }: Place): void {
    const found = this.figures[figure];
    const form = this.sort?.form;
    const [before, here] = [found?.points[index - 1], found?.points[index]];
    const next = found?.points[index + 1] ?? (before && here && mirrored(before, here));
    if (found && form === 'ring') divide(found, index, undefined, this.side);
    else if (found && here && next && form === 'line') found.points.splice(index + 1, 0, this.clamped([(here[0] + next[0]) / 2, (here[1] + next[1]) / 2]));
    else return;
    this.restructured({ figure, index: index + 1 });
  }

  private clamped([x, y]: Point): Point {
    const { side } = this;
    return [Math.min(side, Math.max(0, x)), Math.min(side, Math.max(0, y))];
  }

  /** Adds a point on the piece of a ring or a line that is nearest to this place. */
  split(figure: number, point: Point): void {
    const found = this.figures[figure];
    const form = this.sort?.form;
    if (!found || !(form === 'ring' || form === 'line')) return;
    const { points } = found;
    const index = form === 'ring' ? nearestLine(found, point, this.side) : nearest(points.slice(1).map((to, k) => toSegment(point, points[k] ?? to, to)));
    if (form === 'ring') divide(found, index, point, this.side);
    else points.splice(index + 1, 0, point);
    this.restructured({ figure, index: index + 1 });
  }

  /** Takes a point away; of a figure that has no more than it needs, all go. The last ring stays. */
  take({ figure, index }: Place): void {
    this.marked = { figure, index };
    const found = this.figures[figure];
    const { sort } = this;
    if (!found || !sort || !this.removable()) return;
    if (found.points.length <= sort.least) this.figures.splice(figure, 1);
    else if (sort.form === 'ring') join(found, index, this.side);
    else found.points.splice(index, 1);
    this.restructured({ figure, index });
  }

  /** Makes a ring's corner smooth, or a smooth point a corner. */
  private turnOver({ figure, index }: Place): void {
    const found = this.figures[figure];
    if (!found || this.sort?.form !== 'ring') return;
    turnOver(found, index, this.side);
    this.changed();
  }

  private restructured(marked: Place): void {
    this.rebuild(marked);
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
    this.sheet.layer.classList.toggle('bad', !this.needs.change(this.sort, this.figures));
    // Other sorts may do something now.
    this.showBar();
  }
}

/** The place as far behind the second point as the first one is before it. */
function mirrored(from: Point, at: Point): Point {
  return [2 * at[0] - from[0], 2 * at[1] - from[1]];
}
