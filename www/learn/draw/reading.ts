/** Reads a packing's numbers at all its steps, in slices. */
import type { Cell, Figure, Moment, Trace } from '../figures/figure';
import type { Bubbles, Studio } from './studio';

/** The numbers of a cell in `packedCells`. */
const ROW = 11;

/** The stages before the first step. */
const BEFORE = ['domain', 'fields'];

/** The stages up to the cells. */
const UP_TO_CELLS = [...BEFORE, 'packing', 'mesh', 'cells'];

export class Reading implements Trace {
  moments: readonly Moment[] = [];
  cells: readonly Cell[] = [];
  private readonly studio: Studio;
  private readonly figure: Figure;
  private readonly own: Readonly<Record<string, string>>;
  private made: Moment[] = [];
  private readonly found: Cell[] = [];

  /** `own` are the values of this packing alone, set after those of the recipe. */
  constructor(module: Bubbles, figure: Figure, recipe: string, own: Readonly<Record<string, string>>) {
    [this.figure, this.own] = [figure, own];
    this.studio = new module.Bubblestone(recipe);
    for (const [key, text] of Object.entries(own)) this.studio.set(key, text);
  }

  readonly value = (key: string): string => (key === 'held' ? String(this.given()[2] ?? 0) : this.studio.get(key));

  get link(): string {
    return this.studio.link();
  }

  /** The present distance at the start, in stable distances. */
  get distance(): number {
    const [x = 0, , , other = 0] = this.given();
    return ((other - x) * this.studio.side()) / Number(this.studio.get('cs'));
  }

  /** Whether the recipe has two given bubbles and no others. */
  get isPair(): boolean {
    return this.given().length === 6 && this.studio.get('pop') === 'off';
  }

  private given(): Float64Array {
    return this.studio.list('given').numbers;
  }

  /** Sets a parameter, the distance `w` or whether the left bubble is `held`. The numbers must be read again. */
  change(key: string, text: string): void {
    if (key === 'w' || key === 'held') this.place(key === 'w' ? Number(text) : this.distance, key === 'held' ? text : this.value('held'));
    else if (!(key in this.own)) this.studio.set(key, text);
    this.made = [];
  }

  private place(w: number, held: string): void {
    const [x = 0.25, y = 0.5] = this.given();
    const other = x + (w * Number(this.studio.get('cs'))) / this.studio.side();
    this.studio.set('given', `${x},${y},${held};${other.toFixed(9)},${y},0`);
  }

  /** Works for about `budget` milliseconds; true once all numbers are there. */
  advance(budget: number): boolean {
    const end = performance.now() + budget;
    if (this.figure.steps === 'layer') return this.readCells(end);
    this.studio.hold(this.made.length);
    while (BEFORE.includes(this.studio.stage())) {
      if (performance.now() > end) return false;
      this.studio.tick(budget, 0);
    }
    while (this.made.length <= this.figure.last) {
      this.studio.hold(this.made.length);
      if (!this.studio.reach(budget)) return false;
      this.made.push(this.moment());
      if (performance.now() > end) break;
    }
    const isWhole = this.made.length > this.figure.last;
    if (isWhole) this.moments = this.made;
    return isWhole;
  }

  private moment(): Moment {
    const numbers = this.studio.packedCells();
    const [pairs = 0, , motion = 0] = this.studio.energyParts();
    const at = (place: number): number => numbers[place] ?? 0;
    const size = at(3);
    return {
      step: this.made.length,
      left: (at(1) - (this.given()[0] ?? 0) * this.studio.side()) / size,
      w: (at(ROW + 1) - at(1)) / size,
      speed: at(ROW + 5) - at(5),
      force: at(ROW + 7),
      energy: pairs,
      motion,
    };
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
    this.cells = this.found;
    return true;
  }

  private cell([id = 0, x = 0, y = 0, size = 0]: Float64Array): Cell {
    const side = this.studio.side();
    const outline = Array.from(this.studio.probe(x, y)?.outline ?? [], (value) => value / side);
    return { id, x: x / side, y: y / side, radius: size / 2 / side, outline };
  }

  /** The hash of the state at a step, or of a finished pavement. A kept state is at most ten steps away, and steps of a pair are short. */
  hashAt(step: number): string {
    if (this.figure.steps === 'layer') return this.studio.stateHash();
    this.studio.hold(step);
    while (!this.studio.reach(50));
    return this.studio.stateHash();
  }

  free(): void {
    this.studio.free();
  }
}
