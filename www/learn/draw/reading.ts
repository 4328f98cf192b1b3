/** Reads a packing's numbers at all its steps, in slices. */
import { crowdAt, momentOf, packedOf, ROW } from '../figures/crowds';
import type { Cell, Coming, Crowd, Figure, Landscape, Listed, Moment, NearCell, PlaceList, PointHandle, PointList, Trace } from '../figures/figure';
import type { Flip, JoinedCells } from '../figures/joined';
import { markAt } from '../figures/marks';
import { Flips } from './flips';
import { DirectionReading } from './directions';
import { joinedBy } from './joined';
import { Survey } from './landscape';
import { listText, movedIn, pointsIn, rowsOf } from './lists';
import type { Bubbles, Studio } from './studio';

/** The stages before the first step. */
const BEFORE = ['domain', 'fields'];

/** The stages up to the cells. */
const UP_TO_CELLS = [...BEFORE, 'packing', 'mesh', 'cells'];

/** Milliseconds of a slice for a landscape, which follows the hand. */
const LAND = 12;

/** How many numbers a change of the population has, and a neighbour. */
const CHANGE = 5;
const NEAR = 4;

export class Reading implements Trace {
  steps: readonly Crowd[] = [];
  moments: readonly Moment[] = [];
  cells: readonly Cell[] = [];
  outline: readonly (readonly number[])[] = [];
  comings: readonly Coming[] = [];
  isOver = false;
  readonly side: number;
  readonly directions: DirectionReading;
  private readonly studio: Studio;
  private readonly survey: Survey | undefined;
  private readonly flips: Flips | undefined;
  private readonly joins = new Map<number, JoinedCells>();
  private readonly figure: Figure;
  private readonly own: Readonly<Record<string, string>>;
  private made: Crowd[] = [];
  private found: Cell[] = [];
  /** Whether all steps are made. */
  private isRead = false;

  /** `own` are the values of this packing alone, set after those of the recipe. */
  constructor(module: Bubbles, figure: Figure, recipe: string, own: Readonly<Record<string, string>>) {
    [this.figure, this.own] = [figure, own];
    this.studio = new module.Bubblestone(recipe);
    for (const [key, text] of Object.entries(own)) this.studio.set(key, text);
    this.side = this.studio.side();
    this.directions = new DirectionReading(this.studio, this.side);
    if (figure.hasLandscape) this.survey = new Survey(module);
    if (figure.hasFlips) this.flips = new Flips(module, recipe);
  }

  readonly value = (key: string): string => {
    const listed = this.listed(key);
    if (listed) return String(listed.read(this.points(listed.list)));
    return key === 'held' ? String(this.given()[2] ?? 0) : this.studio.get(key);
  };

  /** How a list stores the number of a handle; undefined if none does. */
  private listed(key: string): Listed | undefined {
    const handle = [...this.figure.handles, ...this.figure.more].find((one) => one.key === key);
    return handle?.kind === 'number' ? handle.listed : undefined;
  }

  readonly points = (list: PlaceList): readonly (readonly [number, number])[] => pointsIn(this.studio.list(list), list);

  /** The present landscape, or the last one while the next is being read. */
  get landscape(): Landscape | undefined {
    return this.survey?.of(this.value('cw'), this.value('cr')) ?? this.survey?.latest;
  }

  get link(): string {
    return this.studio.link();
  }

  /** The present distance of two given bubbles at the start, in stable distances. */
  get distance(): number {
    const [x = 0, , , other = 0] = this.given();
    return ((other - x) * this.side) / Number(this.studio.get('cs'));
  }

  private given(): Float64Array {
    return this.studio.list('given').numbers;
  }

  /** Sets a parameter, the distance `w` or whether the left bubble is `held`. The numbers must be read again. */
  change(key: string, text: string): void {
    if (key === 'w' || key === 'held') this.place(key === 'w' ? Number(text) : this.distance, key === 'held' ? text : this.value('held'));
    else for (const [own, words] of Object.entries(this.written(key, text))) if (!(own in this.own)) this.studio.set(own, words);
    this.forget();
  }

  /** The words of the recipe that a number or a choice changes. */
  private written(key: string, text: string): Readonly<Record<string, string>> {
    const listed = this.listed(key);
    return listed ? listed.write(Number(text), this.points(listed.list)) : { [key]: text };
  }

  private forget(): void {
    this.directions.clear();
    [this.made, this.found] = [[], []];
    this.joins.clear();
    this.isRead = false;
  }

  /** Moves a point of a list. Given bubbles that have moved by this step start from their places there. */
  move(list: PointList, row: number, to: readonly [number, number], step: number): void {
    if (list in this.own) return;
    const rows = rowsOf(this.studio.list(list), list);
    const cells = (list === 'given' && step > 0 && this.steps[step]?.rows) || new Float64Array();
    const isWhole = cells.length === rows.length * ROW;
    const placed = isWhole ? rows.map(([, , held = 0], k) => [(cells[k * ROW + 1] ?? 0) / this.side, (cells[k * ROW + 2] ?? 0) / this.side, held]) : rows;
    this.studio.set(list, listText(movedIn(placed, row, to), list));
    this.forget();
  }

  private place(w: number, held: string): void {
    const [x = 0.25, y = 0.5] = this.given();
    const other = x + (w * Number(this.studio.get('cs'))) / this.side;
    this.studio.set('given', `${x},${y},${held};${other.toFixed(9)},${y},0`);
  }

  /** Works for about `budget` milliseconds; true once all numbers are there. */
  advance(budget: number): boolean {
    const end = performance.now() + budget;
    if (this.figure.steps === 'layer') return this.readCells(end);
    // The landscape comes first, as it follows a drag of the weight; the steps come later.
    if (this.survey?.advance(this.value('cw'), this.value('cr'), LAND) === false) return false;
    if (this.figure.steps === 'walk') return this.readFields(budget, end);
    return (this.isRead || this.readSteps(budget, end)) && this.joinFirst(budget) && (this.flips?.advance({ places: this.points('given'), joined: this.joined(0) }, end) ?? true);
  }

  /** Goes on to the packing; true once that begins. */
  private toPacking(budget: number, end: number): boolean {
    this.studio.hold(this.made.length);
    while (BEFORE.includes(this.studio.stage())) {
      if (performance.now() > end) return false;
      this.studio.tick(budget, 0);
    }
    return true;
  }

  private readFields(budget: number, end: number): boolean {
    if (!this.toPacking(budget, end) || !this.directions.advance(this.figure.across ?? 0, end)) return false;
    this.outline = this.readOutline();
    return true;
  }

  private readSteps(budget: number, end: number): boolean {
    if (!this.toPacking(budget, end)) return false;
    while (this.made.length <= this.figure.last) {
      this.studio.hold(this.made.length);
      if (!this.studio.reach(budget)) return false;
      if (this.studio.status().steps < this.made.length) return this.finish();
      this.push(this.crowd());
      if (performance.now() > end) break;
    }
    return this.made.length > this.figure.last && this.finish();
  }

  /** Whether there are steps of the present recipe. Before that, none of its steps can be shown. */
  get isBegun(): boolean {
    return this.made.length > 0;
  }

  /** The first step of a run brings its outline. */
  private push(crowd: Crowd): void {
    this.made.push(crowd);
    if (this.made.length > 1) return;
    [this.steps, this.outline, this.comings, this.isOver] = [this.made, this.readOutline(), [], false];
  }

  private finish(): true {
    this.isRead = true;
    const { steps, converged } = this.studio.status();
    this.isOver = converged && steps === this.steps.length - 1;
    this.comings = this.readComings();
    const from = (this.given()[0] ?? 0) * this.side;
    const isPair = this.steps.every(({ rows }) => rows.length === 2 * ROW);
    this.moments = isPair ? this.steps.map((crowd) => momentOf(crowd, from)) : [];
    return true;
  }

  private crowd(): Crowd {
    const [pairs = 0, walls = 0, motion = 0] = this.studio.energyParts();
    return { step: this.made.length, rows: this.studio.packedCells(), pairs, walls, motion, move: this.studio.status().largestMove };
  }

  private readComings(): Coming[] {
    const numbers = this.studio.populationChanges();
    return Array.from({ length: numbers.length / CHANGE }, (_, k) => {
      const [step = 0, id = 0, x = 0, y = 0, came = 0] = numbers.subarray(k * CHANGE, (k + 1) * CHANGE);
      return { step, id, x: x / this.side, y: y / this.side, came: came === 1 };
    });
  }

  private readOutline(): number[][] {
    const { points, rings } = this.studio.outline();
    let from = 0;
    return Array.from(rings, (length) => {
      const ring = points.subarray(2 * from, 2 * (from += length));
      return Array.from(ring, (value) => value / this.side);
    });
  }

  private readCells(end: number): boolean {
    while (UP_TO_CELLS.includes(this.studio.stage())) {
      if (performance.now() > end) return false;
      this.studio.tick(4, 1000);
    }
    const numbers = this.studio.packedCells();
    while (this.found.length < numbers.length / ROW) {
      if (performance.now() > end) return false;
      this.found.push(this.cell(numbers.subarray(this.found.length * ROW)));
    }
    [this.cells, this.outline] = [this.found, this.readOutline()];
    return true;
  }

  private cell([id = 0, x = 0, y = 0, size = 0]: Float64Array): Cell {
    return { id, x: x / this.side, y: y / this.side, radius: size / 2 / this.side, outline: this.outlineAt(x, y) };
  }

  private outlineAt(x: number, y: number): number[] {
    return Array.from(this.studio.probe(x, y)?.outline ?? [], (value) => value / this.side);
  }

  /** Goes to a step. It needs no slices: a kept state is at most ten steps away, and steps of few cells are short. */
  private go(step: number): void {
    this.studio.hold(step);
    while (!this.studio.reach(50));
  }

  readonly neighbours = (step: number, id: number): readonly NearCell[] => {
    this.go(step);
    const numbers = this.studio.neighbours(id);
    return Array.from({ length: numbers.length / NEAR }, (_, k) => {
      const [other = 0, w = 0, x = 0, y = 0] = numbers.subarray(k * NEAR, (k + 1) * NEAR);
      return { id: other, w, force: [x, y] };
    });
  };

  readonly shapes = (step: number): readonly (readonly number[])[] => {
    this.go(step);
    const rows = this.studio.packedCells();
    return Array.from({ length: rows.length / ROW }, (_, k) => this.outlineAt(rows[k * ROW + 1] ?? 0, rows[k * ROW + 2] ?? 0));
  };

  /** The hash of the state at a step, of a finished pavement, or of the directions where no step is read. */
  readonly hashAt = (step: number): string => {
    if (this.figure.steps === 'walk') return this.directions.hash(this.outline);
    if (this.figure.steps === 'step') this.go(step);
    return this.studio.stateHash();
  };

  /** Joins the cells of the first step in slices: rounds of points may take longer than a frame has. */
  private joinFirst(budget: number): boolean {
    if (!this.figure.joinsFirst || this.joins.has(0)) return true;
    this.go(0);
    if (!this.studio.joinCells(budget)) return false;
    this.joined(0);
    return true;
  }

  readonly joined = (step: number): JoinedCells => {
    const kept = this.joins.get(step);
    if (kept) return kept;
    if (this.figure.steps === 'step') this.go(step);
    const made = joinedBy(this.studio, this.side);
    this.joins.set(step, made);
    return made;
  };

  get flip(): Flip | undefined {
    return this.flips?.latest;
  }

  free(): void {
    this.studio.free();
    this.survey?.free();
    this.flips?.free();
  }
}

/** The value of a number or a choice as a figure shows it at a step: a distance moves, and a mark is no part of the recipe. */
export function shownValue([reading]: readonly Reading[], step: number, at: readonly number[], key: string): string {
  const mark = markAt(key);
  if (mark !== undefined) return String(at[mark] ?? 0);
  return key === 'w' ? String(reading?.moments[step]?.w ?? reading?.distance ?? 0) : (reading?.value(key) ?? '');
}

/** The points of a handle at a step, in shares of the picture's side: given bubbles are where they have moved to. */
export function shownPoints([reading]: readonly Reading[], step: number, at: readonly number[], { key }: PointHandle): readonly (readonly [number, number])[] {
  if (key === 'at') return [[at[0] ?? 0, at[1] ?? 0]];
  const points = reading?.points(key) ?? [];
  const crowd = key === 'given' && reading ? crowdAt(reading, step) : undefined;
  const cells = crowd && reading ? packedOf(crowd, reading.side) : [];
  return cells.length === points.length ? cells.map(({ x, y }) => [x, y]) : points;
}
