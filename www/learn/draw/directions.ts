/** Reads directions from a recipe whose fields are made, and keeps them by their places. */
import { placesOn, type Direction, type Directions, type SegmentTerms, type Singular, type Turned } from '../figures/directions';
import type { Studio } from './studio';

/** How many numbers the engine gives for a segment's terms, a place of a walk, and a singular point. */
const [TERM, WALK, SINGULAR] = [9, 4, 3];

/** How many numbers come before those of the terms. */
const BEFORE = 3;

const QUARTERS = 4;

/** The place whose terms are hashed. */
const LOOKED = [0.4, 0.45];

const rows = (numbers: Float64Array, width: number, from = 0): Float64Array[] => Array.from({ length: (numbers.length - from) / width }, (_, k) => numbers.subarray(from + k * width, from + (k + 1) * width));

/** A hash of all bits (FNV-1a): 32 bits of the upper halves of the numbers, and 32 of the lower ones. */
function hashOf(numbers: readonly number[]): string {
  const halves = [...new Uint32Array(Float64Array.from(numbers).buffer)];
  const sum = (from: number): number => halves.reduce((hash, half, k) => (k % 2 === from ? Math.imul(hash ^ half, 0x01000193) : hash), 0x811c9dc5);
  return [1, 0].map((from) => (sum(from) >>> 0).toString(16).padStart(8, '0')).join('');
}

export class DirectionReading implements Directions {
  field: readonly Direction[] = [];
  private readonly studio: Studio;
  private readonly side: number;
  private readonly kept = new Map<string, unknown>();
  private work: Generator<undefined, undefined> | undefined;

  constructor(studio: Studio, side: number) {
    [this.studio, this.side] = [studio, side];
  }

  /** Forgets all, because the fields are made anew. */
  clear(): void {
    this.kept.clear();
    this.work = undefined;
  }

  readonly at = (place: readonly number[]): Direction =>
    this.once(`at ${place.slice(0, 2).join(' ')}`, () => {
      const [x = 0, y = 0] = place;
      const [across = 0, down = 0, certainty = 0] = this.studio.directionAt(x * this.side, y * this.side);
      return { place: [x, y], along: [across, down], certainty };
    });

  readonly terms = (place: readonly number[]): SegmentTerms => this.once(`terms ${place.slice(0, 2).join(' ')}`, () => this.readTerms(place));

  private readTerms([x = 0, y = 0]: readonly number[]): SegmentTerms {
    const { side } = this;
    const numbers = this.studio.segmentTerms(x * side, y * side);
    const all = rows(numbers, TERM, BEFORE);
    const lengths = all.reduce((sum, [, , , , , across = 0, down = 0]) => sum + Math.hypot(across, down), 0) || 1;
    const [across = 0, down = 0, share = 0] = numbers;
    const list = all.map(([a = 0, b = 0, c = 0, d = 0, , u = 0, v = 0, p = 0, q = 0]) => ({ from: [a / side, b / side], to: [c / side, d / side], printed: [u / lengths, v / lengths], turned: [p, q] }) as const);
    return { list, printed: [across / lengths, down / lengths], share };
  }

  readonly walk = (circle: readonly number[]): readonly Turned[] =>
    this.once(`walk ${circle.join(' ')}`, () => {
      const places = placesOn(circle);
      const numbers = this.studio.directionsAlong(Float64Array.from(places.flat(), (value) => value * this.side));
      return rows(numbers, WALK).map(([x = 0, y = 0, certainty = 0, turns = 0], k) => ({ place: places[k % places.length] ?? [0, 0], along: [x, y], certainty, quarters: QUARTERS * turns }) as const);
    });

  readonly singular = (): readonly Singular[] => this.once('singular', () => rows(this.studio.singularPoints(), SINGULAR).map(([x = 0, y = 0, index = 0]) => ({ place: [x / this.side, y / this.side], quarters: QUARTERS * index })));

  /** A hash of an outline with the directions in it. */
  readonly hash = (outline: readonly (readonly number[])[]): string =>
    this.once('hash', () => {
      const [x, y] = LOOKED.map((share) => share * this.side) as [number, number];
      const field = this.field.flatMap(({ along, certainty }) => [...along, certainty]);
      return hashOf([...outline.flat(), ...field, ...this.studio.directionAt(x, y), ...this.studio.segmentTerms(x, y)]);
    });

  private once<T>(name: string, read: () => T): T {
    if (!this.kept.has(name)) this.kept.set(name, read());
    return this.kept.get(name) as T;
  }

  /** Reads the field until the time `end`, at `across` places in each row and column; true once it is there. */
  advance(across: number, end: number): boolean {
    this.work ??= this.survey(across);
    while (!this.work.next().done) if (performance.now() > end) return false;
    this.work = undefined;
    return true;
  }

  /** Reads the field row by row. At a place outside the outline, the engine gives no numbers. */
  private *survey(across: number): Generator<undefined, undefined> {
    const found: Direction[] = [];
    const share = (k: number): number => (k + 0.5) / across;
    for (let row = 0; row < across; row++) {
      for (let column = 0; column < across; column++) {
        const [x, y] = [share(column), share(row)];
        const [u, v, certainty] = this.studio.directionsAlong(Float64Array.of(x * this.side, y * this.side));
        if (u !== undefined && v !== undefined && certainty !== undefined) found.push({ place: [x, y], along: [u, v], certainty });
      }
      yield;
    }
    this.field = found;
  }
}
