/** The figures that are edited over the canvas, and all that is done to them, by whatever hand. */
import type { Point } from '../module/types';
import { divide, join, nearestLine, settle, turnOver } from './geometry/curve';
import type { Figure, Place, Sort } from './geometry/figures';
import { distance, nearest, toSegment } from './geometry/plane';
import { snap } from './geometry/snap';
import { Sheet } from './sheet';

/** CSS pixels from which Shift draws a point to others and to directions. */
const REACH = 9;

export interface FigureNeeds {
  side(): number;
  /** A new figure, away from those that are there; for a seed the one at this place. */
  fresh(sort: Sort, figures: Figure[], at?: Point): Figure | undefined;
  /** The value of a figure that was drawn. */
  first(sort: Sort): number;
  /** Takes the figures over, or says why it cannot and answers false. */
  change(sort: Sort, figures: Figure[]): boolean;
  /** A drag begins or ends. */
  live(on: boolean): void;
  /** A ring was drawn. */
  disarmed(): void;
}

/** Who shows what can be done with the figures. */
interface Around {
  /** The figures were drawn anew, or something else can be done with them now. */
  follow(): void;
  /** Puts the keyboard on the marked point, or where figures are added. */
  focus(): void;
}

export class EditedFigures {
  readonly sheet: Sheet;
  sort: Sort | undefined;
  /** The next drag over the canvas draws a ring. */
  armed = false;
  /** The marked point. */
  at: Place = { figure: 0, index: 0 };
  private readonly needs: FigureNeeds;
  private readonly around: Around;
  private all: Figure[] = [];
  private frame = 0;
  private holding = false;

  /** The layer lies over the canvas. */
  constructor(layer: HTMLElement, needs: FigureNeeds, around: Around) {
    this.sheet = new Sheet(layer);
    this.needs = needs;
    this.around = around;
  }

  get side(): number {
    return this.needs.side();
  }

  get isEmpty(): boolean {
    return this.all.length === 0;
  }

  /** The figure with the marked point. */
  get marked(): Figure | undefined {
    return this.all[this.at.figure];
  }

  /** Whether the line goes round the marked point. */
  get smooth(): boolean {
    return this.marked?.stretches?.[this.at.index]?.smooth ?? false;
  }

  /** Handles on these figures; `armed` where a ring is to be drawn next. */
  begin(sort: Sort, figures: Figure[], armed: boolean): void {
    if (this.sort?.word !== sort.word || this.sheet.layer.hidden) this.at = { figure: 0, index: 0 };
    this.sort = sort;
    this.all = figures;
    this.armed = armed;
    const { layer } = this.sheet;
    layer.hidden = false;
    layer.dataset['form'] = sort.form;
    layer.toggleAttribute('data-armed', armed);
    layer.toggleAttribute('data-draws', armed || drawsFreely(sort));
    layer.setAttribute('aria-label', sort.label);
    layer.classList.remove('bad');
    this.rebuild(this.at);
  }

  /** Something else can be done with the figures now. */
  follow(): void {
    this.around.follow();
  }

  /** Puts the keyboard on the marked point; false where there is none. */
  focus(): boolean {
    return this.sheet.focus(this.all, this.at);
  }

  /** Elements for all figures, and a point that exists marked. */
  private rebuild({ figure, index }: Place): void {
    if (!this.sort) return;
    const known = Math.max(0, Math.min(figure, this.all.length - 1));
    this.at = { figure: known, index: Math.max(0, Math.min(index, (this.all[known]?.points.length ?? 1) - 1)) };
    this.sheet.build(this.sort, this.all);
    this.place();
  }

  /** Puts lines and handles where the points are. */
  place(): void {
    if (!this.sort) return;
    this.sheet.place(this.sort, this.all, this.at, this.side);
    this.follow();
  }

  /** The value that a line being drawn will have. */
  get firstValue(): number {
    return this.sort ? this.needs.first(this.sort) : 0;
  }

  /** The outer ring keeps three points. */
  get removable(): boolean {
    const { marked } = this;
    const only = this.sort?.form === 'ring' && this.all.length === 1;
    return marked !== undefined && !(only && marked.points.length <= 3);
  }

  mark(place: Place): void {
    if (place.figure === this.at.figure && place.index === this.at.index) return;
    this.at = place;
    this.place();
  }

  /** Where a point goes: with Shift, to what is near. Tells by a guide to what. */
  snapped(at: Point, snaps: boolean, place: Place | undefined, neighbour?: Point): Point {
    if (!snaps) {
      this.sheet.guide('');
      return at;
    }
    const points = place ? this.all[place.figure]?.points : undefined;
    const own = place && points?.[place.index];
    const closed = this.sort?.form === 'ring';
    const beside = (step: number): Point | undefined =>
      points && place && this.sort?.form !== 'spot' ? points[closed ? (place.index + step + points.length) % points.length : place.index + step] : undefined;
    const others = this.all.flatMap((figure) => figure.points).filter((point) => point !== own);
    const neighbours = [beside(-1), beside(1), neighbour].filter((point) => point !== undefined);
    const found = snap(at, this.side, REACH * this.sheet.unit(this.side), neighbours, others);
    this.sheet.guide(found.guide);
    return found.at;
  }

  move({ figure, index }: Place, [x, y]: Point): void {
    const points = this.all[figure]?.points;
    const here = points?.[index];
    if (!points || !here) return;
    if (this.sort?.form === 'spot' && index === 0) return this.shift(figure, [x - here[0], y - here[1]]);
    points[index] = this.clamped([x, y]);
    this.changed();
  }

  /** Moves a whole figure, as far as its points (of a spot, its middle) stay in the picture. */
  shift(figure: number, by: Point): void {
    const points = this.all[figure]?.points;
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

  /** Moves a point, or the `whole` figure, by a key; all moves of one that is held down (`again`) are one step. */
  nudge(place: Place, [dx, dy]: Point, whole: boolean, again: boolean): void {
    const point = this.all[place.figure]?.points[place.index];
    if (!point) return;
    if (again) this.hold();
    else this.settle();
    if (whole) this.shift(place.figure, [dx, dy]);
    else this.move(place, [point[0] + dx, point[1] + dy]);
  }

  /** A band's side is at this place. */
  widen(index: number, at: Point): void {
    const figure = this.all[index];
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
    for (const figure of this.all) settle(figure, this.side);
  }

  /** It is let go: by rising, by being cancelled, or as what it held is gone. */
  drop(): void {
    this.sheet.guide('');
    if (!this.holding) return;
    this.holding = false;
    if (this.frame) this.hand();
    this.needs.live(false);
  }

  setValue(value: number, last: boolean): void {
    const figure = this.marked;
    const limits = this.sort?.value;
    if (!figure || !limits || Number.isNaN(value)) return this.place();
    if (!last) this.hold();
    figure.value = Math.min(limits.max, Math.max(limits.min, value));
    this.changed();
    if (last) this.drop();
  }

  addFigure(at?: Point): void {
    const fresh = this.sort && this.needs.fresh(this.sort, this.all, at);
    if (fresh) this.add(fresh);
  }

  /** A figure that was drawn, or a fresh one. */
  add(figure: Figure): void {
    this.all.push({ ...figure, points: figure.points.map((point) => this.clamped(point)) });
    if (this.armed) this.disarm();
    this.restructured({ figure: this.all.length - 1, index: 0 });
  }

  disarm(): void {
    this.armed = false;
    this.sheet.layer.removeAttribute('data-armed');
    this.sheet.layer.toggleAttribute('data-draws', this.sort !== undefined && drawsFreely(this.sort));
    this.needs.disarmed();
  }

  /** Adds a point half the way to the next one; behind the end of a line, on the way on. */
  addAfter({ figure, index }: Place): void {
    const found = this.all[figure];
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
    const found = this.all[figure];
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
    this.at = { figure, index };
    const found = this.all[figure];
    const { sort } = this;
    if (!found || !sort || !this.removable) return;
    if (found.points.length <= sort.least) this.all.splice(figure, 1);
    else if (sort.form === 'ring') join(found, index, this.side);
    else found.points.splice(index, 1);
    this.restructured({ figure, index });
  }

  /** Makes a ring's corner smooth, or a smooth point a corner. */
  turnOver({ figure, index }: Place): void {
    const found = this.all[figure];
    if (!found || this.sort?.form !== 'ring') return;
    turnOver(found, index, this.side);
    this.changed();
  }

  private restructured(marked: Place): void {
    this.rebuild(marked);
    this.around.focus();
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
    this.sheet.layer.classList.toggle('bad', !this.needs.change(this.sort, this.all));
    // Other sorts may do something now.
    this.follow();
  }
}

/** Whether a drag over the canvas draws a figure of this sort at any time. */
function drawsFreely({ form }: Sort): boolean {
  return form === 'line' || form === 'spot';
}

/** The place as far behind the second point as the first one is before it. */
function mirrored(from: Point, at: Point): Point {
  return [2 * at[0] - from[0], 2 * at[1] - from[1]];
}
