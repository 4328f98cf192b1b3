/**
 * The potential of equation (4) around a held square, as the module computes it. One packing has many pairs of squares,
 * too far apart to act on each other; each pair measures one point of a grid. An eighth of the grid is enough, as the
 * potential has the symmetry of a square. Lengths are in stable distances, energies in k0.
 */
import { ROW } from '../figures/crowds';
import type { Landscape, Lowest } from '../figures/figure';
import type { Place } from '../figures/place';
import type { Heights } from './contours';
import { drawing, FINE, HALF } from './ground';
import type { Bubbles, Studio } from './studio';

/** A picture of 64 stable distances: places are kept to a 256th of one. */
const SIDE = 64;
const STRIDE = 1 / 256;
const RECIPE = 'outline=square&size=128&cs=2&kind=square&dir=constant&edge=open&pop=off&fend=0&mend=0&given=0.5,0.5,1;0.6,0.5,0';

/** Pairs of one packing: 256 cells may be given, and pairs this far apart do not act on each other. */
const PAIRS = 128;
const APART = 5;
const ACROSS = 12;

/** The place of a cell's energy among its numbers. */
const ENERGY = 9;

/** Stages before the first step. */
const BEFORE = ['domain', 'fields'];

/** The place of a grid point in the eighth, which has x >= y >= 0. */
const place = (i: number, j: number): number => (i * (i + 1)) / 2 + j;

/** The points of the eighth. Two cells cannot be at one place, so the point at the centre is moved by STRIDE. */
const EIGHTH: readonly Place[] = Array.from({ length: HALF + 1 }, (_, i) => Array.from({ length: i + 1 }, (__, j): Place => [i ? i / FINE : STRIDE, j / FINE])).flat();

/** No well and no pass is nearer to the centre than this, in units of the grid. */
const NEAREST = Math.round(0.7 * FINE);

/** Landscapes that are kept. */
const KEPT = 16;

/** The energy at a column and a row, from the energies at the points of the eighth. */
function heightsOf(eighth: Float64Array): Heights {
  return (column, row) => {
    const [i, j] = [Math.abs(column), Math.abs(row)];
    return eighth[place(Math.max(i, j), Math.min(i, j))] ?? 0;
  };
}

/** Reads landscapes, in slices, and keeps those that it has read last. */
export class Survey {
  /** The landscape that was read last. */
  latest: Landscape | undefined;
  private readonly studio: Studio;
  private readonly kept = new Map<string, Landscape>();
  private readonly energies = new Float64Array(EIGHTH.length);
  private work: Generator<undefined, Landscape> | undefined;
  private name = '';

  constructor({ Bubblestone }: Bubbles) {
    this.studio = new Bubblestone(RECIPE);
  }

  /** The landscape for a weight and a radius of the corner bubbles, if it is there. */
  of(weight: string, radius: string): Landscape | undefined {
    return this.kept.get(`${weight} ${radius}`);
  }

  /** Works for about `budget` milliseconds on a landscape; true once it is there. First finishes a begun one. */
  advance(weight: string, radius: string, budget: number): boolean {
    const end = performance.now() + budget;
    while (!this.of(weight, radius)) {
      this.work ??= this.read(weight, radius);
      const { done, value } = this.work.next();
      if (done) this.keep(value);
      if (performance.now() > end) return this.of(weight, radius) !== undefined;
    }
    return true;
  }

  private keep(landscape: Landscape): void {
    this.work = undefined;
    this.latest = landscape;
    if (this.kept.size >= KEPT) this.kept.delete(this.kept.keys().next().value ?? '');
    this.kept.set(this.name, landscape);
  }

  private *read(weight: string, radius: string): Generator<undefined, Landscape> {
    this.name = `${weight} ${radius}`;
    this.studio.set('cw', weight);
    this.studio.set('cr', radius);
    for (let done = 0; done < EIGHTH.length; done += PAIRS) {
      this.energies.set(this.measure(EIGHTH.slice(done, done + PAIRS)), done);
      yield;
    }
    const at = heightsOf(this.energies.slice());
    const [well, pass] = [this.lowest(0), this.lowest(1)];
    return { at, well, pass, ground: yield* drawing(at) };
  }

  /** The lowest place on the line where y is `slope` times x: first on the grid, then as fine as places are kept. */
  private lowest(slope: 0 | 1): Lowest {
    const energy = (i: number): number => this.energies[place(i, slope * i)] ?? 0;
    let best = NEAREST;
    for (let i = NEAREST; i < HALF; i++) if (energy(i) < energy(best)) best = i;
    const points = Array.from({ length: 2 / STRIDE / FINE + 1 }, (_, k): Place => [(best - 1) / FINE + k * STRIDE, slope * ((best - 1) / FINE + k * STRIDE)]);
    const measured = this.measure(points);
    const k = measured.indexOf(Math.min(...measured));
    const [x, y] = points[k] ?? [0, 0];
    return { w: Math.hypot(x, y), energy: measured[k] ?? 0 };
  }

  /** The energies of pairs whose second square is at these points from the first. */
  private measure(points: readonly Place[]): number[] {
    const pair = ([x, y]: Place, k: number): string => {
      const [left, top] = [1 + APART * (k % ACROSS), 1 + APART * Math.floor(k / ACROSS)];
      return `${left / SIDE},${top / SIDE},1;${(left + x) / SIDE},${(top + y) / SIDE},0`;
    };
    this.studio.set('given', points.map(pair).join(';'));
    this.studio.hold(0);
    while (BEFORE.includes(this.studio.stage())) this.studio.tick(8, 0);
    while (!this.studio.reach(8));
    const cells = this.studio.packedCells();
    // Each square of a pair has half of the pair's potential.
    return points.map((_, k) => 2 * (cells[2 * k * ROW + ENERGY] ?? 0));
  }

  free(): void {
    this.studio.free();
  }
}
