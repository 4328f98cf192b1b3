/** Draws a new figure: a line point by point or in one stroke, a spot or a ring from its middle. */
import type { Point } from '../module/types';
import { drawn, hexagon, type Figure } from './geometry/figures';
import { distance } from './geometry/plane';
import { thinLine } from './geometry/simplify';

/** The radius of a spot and of a hole that were only tapped, in sides. */
const SPOT = 0.18;
const HOLE = 0.085;

/** The tolerance by which a line drawn by hand is simplified, in sides. */
const STEADY = 0.006;

/** Milliseconds between the two presses of a double click. */
export const DOUBLE = 400;

export class Pen {
  private points: Point[] = [];
  private path: Point[] = [];
  private pointer: Point | undefined;
  private released = { time: -Infinity, at: [0, 0] as Point };
  private readonly form: 'line' | 'spot' | 'ring';
  private readonly side: number;

  constructor(form: Pen['form'], side: number) {
    this.form = form;
    this.side = side;
  }

  /** A line has points, and more may follow. */
  get open(): boolean {
    return this.points.length > 0;
  }

  /** The point that the next one is joined to. */
  get last(): Point | undefined {
    return this.points.at(-1);
  }

  press(at: Point): void {
    this.path = [at];
    this.pointer = at;
  }

  /** The pressed pointer moves: it draws freely, or (`straight`) a straight line to its place. */
  draw(at: Point, straight: boolean): void {
    this.pointer = at;
    if (this.form !== 'line' || straight) this.path = [this.path[0] ?? at, at];
    else this.path.push(at);
  }

  /** Forgets the press. The points before it stay. */
  lift(): void {
    this.path = [];
    this.pointer = undefined;
  }

  hover(at: Point): void {
    this.pointer = at;
  }

  /**
   * The pointer is lifted. Places closer together than `near` count as one. Returns the figure that this ended, if any.
   */
  release(at: Point, moved: boolean, near: number, time: number): Figure | undefined {
    if (this.form !== 'line') return this.round(moved ? at : undefined);
    const path = moved ? thinLine(this.path, STEADY * this.side) : [at];
    this.path = [];
    const twice = !moved && time - this.released.time < DOUBLE && distance(at, this.released.at) < near;
    this.released = { time, at };
    const before = this.points.length;
    const again = this.last !== undefined && distance(this.last, at) < near;
    if (!moved && (twice || again)) return this.finish();
    const first = this.points[0];
    const closes = first !== undefined && before > 2 && distance(first, at) < near;
    this.points.push(...(before && moved && this.last && distance(this.last, path[0] ?? at) < near ? path.slice(1) : path));
    if (closes) this.points.splice(-1, 1, [...first]);
    return closes || (moved && before === 0) ? this.finish() : undefined;
  }

  /** The line as it is; undefined if it has less than two points. */
  finish(): Figure | undefined {
    const points = this.points;
    this.cancel();
    return points.length > 1 ? { points, value: 0 } : undefined;
  }

  cancel(): void {
    this.points = [];
    this.path = [];
    this.pointer = undefined;
  }

  back(): void {
    this.points.pop();
  }

  /** The unfinished figure as an SVG path. */
  shown(): string {
    if (this.form !== 'line') {
      const [middle, rim] = this.path;
      if (!middle || !rim) return '';
      return this.form === 'spot' ? drawn('spot', [middle, rim]) : drawn('ring', hexagon(middle, rim));
    }
    const pointer = this.path.length > 1 || !this.pointer ? this.path : [this.pointer];
    return this.points.length + pointer.length > 1 ? drawn('line', [...this.points, ...pointer]) : '';
  }

  private round(rim: Point | undefined): Figure {
    const middle = this.path[0] ?? [this.side / 2, this.side / 2];
    const end: Point = rim ?? [middle[0] + (this.form === 'spot' ? SPOT : HOLE) * this.side, middle[1]];
    this.cancel();
    return { points: this.form === 'spot' ? [middle, end] : hexagon(middle, end), value: 0 };
  }
}
