/** The figures that are edited over the canvas, and every change to them, by pointer or by keyboard. */
import type { Point } from '../module/types';
import { divide, join, nearestLine, settle, turnOver } from './geometry/curve';
import type { Figure, FigurePoint, Sort } from './geometry/figures';
import { distance, nearest, toSegment } from './geometry/plane';
import { snap } from './geometry/snap';
import { EditorSheet } from './sheet';

/** With Shift, a point snaps to other points and to directions within this many CSS pixels. */
const REACH = 9;

export interface FigureNeeds {
  side(): number;
  /** A new figure, away from the existing ones. A new seed is put at `at`. */
  fresh(sort: Sort, figures: Figure[], at?: Point): Figure | undefined;
  /** The initial value of a figure that was drawn. */
  first(sort: Sort): number;
  /** Writes the figures into the recipe. Returns false, with a message, if they are refused. */
  change(sort: Sort, figures: Figure[]): boolean;
  /** A drag begins or ends. */
  live(on: boolean): void;
  /** `armed` ends: its ring was added, or drawing was cancelled. */
  disarmed(): void;
}

/** The editor around the figures, which shows the possible actions. */
interface Around {
  /** Called when the figures were drawn again, or the possible actions changed. */
  follow(): void;
  /** Moves the keyboard focus to the marked point, or to the button that adds figures. */
  focus(): void;
}

export class EditedFigures {
  readonly sheet: EditorSheet;
  sort: Sort | undefined;
  /** The next drag over the canvas draws a ring. */
  armed = false;
  /** The marked point. */
  at: FigurePoint = { figure: 0, index: 0 };
  private readonly needs: FigureNeeds;
  private readonly around: Around;
  private all: Figure[] = [];
  private frame = 0;
  private holding = false;

  /** `layer` lies over the canvas. */
  constructor(layer: HTMLElement, needs: FigureNeeds, around: Around) {
    this.sheet = new EditorSheet(layer);
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

  /** Whether the line is smooth at the marked point. */
  get smooth(): boolean {
    return this.marked?.stretches?.[this.at.index]?.smooth ?? false;
  }

  /** Puts handles on these figures. `armed`: the next drag draws a ring. */
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

  /** The possible actions changed. */
  follow(): void {
    this.around.follow();
  }

  /** Moves the keyboard focus to the marked point. Returns false if there is none. */
  focus(): boolean {
    return this.sheet.focus(this.all, this.at);
  }

  /** Makes elements for all figures, and marks this point. Indices that are too large are clamped. */
  private rebuild({ figure, index }: FigurePoint): void {
    if (!this.sort) return;
    const known = Math.max(0, Math.min(figure, this.all.length - 1));
    this.at = { figure: known, index: Math.max(0, Math.min(index, (this.all[known]?.points.length ?? 1) - 1)) };
    this.sheet.build(this.sort, this.all);
    this.place();
  }

  /** Moves lines and handles to their points. */
  place(): void {
    if (!this.sort) return;
    this.sheet.place(this.sort, this.all, this.at, this.side);
    this.follow();
  }

  /** The value that a line being drawn will have. */
  get firstValue(): number {
    return this.sort ? this.needs.first(this.sort) : 0;
  }

  /** Whether the marked point may be removed: the outer ring keeps three points. */
  get removable(): boolean {
    const { marked } = this;
    const only = this.sort?.form === 'ring' && this.all.length === 1;
    return marked !== undefined && !(only && marked.points.length <= 3);
  }

  mark(place: FigurePoint): void {
    if (place.figure === this.at.figure && place.index === this.at.index) return;
    this.at = place;
    this.place();
  }

  /** The new place of a point. With Shift it snaps, and a guide shows the target. */
  snapped(at: Point, snaps: boolean, place: FigurePoint | undefined, neighbour?: Point): Point {
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

  move({ figure, index }: FigurePoint, [x, y]: Point): void {
    const points = this.all[figure]?.points;
    const here = points?.[index];
    if (!points || !here) return;
    if (this.sort?.form === 'spot' && index === 0) return this.shift(figure, [x - here[0], y - here[1]]);
    points[index] = this.clamped([x, y]);
    this.changed();
  }

  /** Moves a whole figure as far as its points stay in the picture. For a spot, only its middle must stay. */
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

  /** Moves a point, or the `whole` figure, by a key. Repeats of a key that is held down (`again`) are one step. */
  nudge(place: FigurePoint, [dx, dy]: Point, whole: boolean, again: boolean): void {
    const point = this.all[place.figure]?.points[place.index];
    if (!point) return;
    if (again) this.hold();
    else this.settle();
    if (whole) this.shift(place.figure, [dx, dy]);
    else this.move(place, [point[0] + dx, point[1] + dy]);
  }

  /** Sets the width of a band so that its side passes through this place. */
  widen(index: number, at: Point): void {
    const figure = this.all[index];
    const value = this.sort?.value;
    const [from, to] = figure?.points ?? [];
    if (!figure || !value || !from || !to) return;
    const across = Math.abs((at[0] - from[0]) * (to[1] - from[1]) - (at[1] - from[1]) * (to[0] - from[0])) / (distance(from, to) || 1);
    figure.value = Math.min(value.max, Math.max(value.min, (200 * across) / this.side));
    this.changed();
  }

  /** Whether dragging a figure's line moves the figure. The first ring of an outline stays where it is. */
  loose(figure: number): boolean {
    return this.sort?.form !== 'ring' || figure > 0;
  }

  /** Begins a step of the history: all changes until `drop` are undone together. */
  hold(): void {
    if (this.holding) return;
    this.settle();
    this.holding = true;
    this.needs.live(true);
  }

  /** Makes the present curves the originals that the next move bends. */
  private settle(): void {
    for (const figure of this.all) settle(figure, this.side);
  }

  /** Ends the step: the pointer rose, it was cancelled, or the figure it held is gone. */
  drop(): void {
    this.sheet.guide('');
    if (!this.holding) return;
    this.holding = false;
    if (this.frame) this.hand();
    this.needs.live(false);
  }

  /** Ends the step without its last change, as the figures are no longer those of the recipe. */
  abandon(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.drop();
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

  /** Adds a figure that was drawn, or a fresh one. */
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

  /** Adds a point halfway to the next one. After the last point of a line, the new point extends the line. */
  addAfter({ figure, index }: FigurePoint): void {
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

  /** Adds a point to a ring or a line, on the piece nearest to this place. */
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

  /** Removes a point. Removes the figure where too few points would be left. The last ring stays. */
  take({ figure, index }: FigurePoint): void {
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
  turnOver({ figure, index }: FigurePoint): void {
    const found = this.all[figure];
    if (!found || this.sort?.form !== 'ring') return;
    turnOver(found, index, this.side);
    this.changed();
  }

  private restructured(marked: FigurePoint): void {
    this.rebuild(marked);
    this.around.focus();
    this.changed();
  }

  /** Passes the figures on once per frame. Invalid ones stay on the canvas, so that the visitor can mend them. */
  private changed(): void {
    this.place();
    this.frame ||= requestAnimationFrame(() => this.hand());
  }

  private hand(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (!this.sort) return;
    this.sheet.layer.classList.toggle('bad', !this.needs.change(this.sort, this.all));
    // The change may have enabled other sorts.
    this.follow();
  }
}

/** Whether a drag that starts on the canvas draws a figure of this sort, without a button first. */
function drawsFreely({ form }: Sort): boolean {
  return form === 'line' || form === 'spot';
}

/** The mirror image of `from` in the point `at`. */
function mirrored(from: Point, at: Point): Point {
  return [2 * at[0] - from[0], 2 * at[1] - from[1]];
}
