/** What can be edited: figures with points to move. */
import type { Point } from '../../module/types';

/** A ring, a line, a spot (its middle and a point of its rim), or the seed of a part. */
export interface Figure {
  points: Point[];
  /** Of a spot its factor or ratio, of a seed the place of its kind among the kinds, of a road its width in hundredths of the side. */
  value: number;
  /** What runs from each point of a ring to the next one, where that is not a straight line. */
  stretches?: Stretch[];
}

/** What runs from a handle to the next one. */
export interface Stretch {
  /** The handle at its beginning is smooth; else it is a corner. */
  smooth: boolean;
  /** Where its ends were when it was made, and how long it was. */
  from: Point;
  to: Point;
  length: number;
  /** Places between them, each with the part of the length before it. */
  inner: { at: Point; along: number }[];
}

/** A point of a figure. */
export interface Place {
  figure: number;
  index: number;
}

/** A sort of figures. */
export interface Sort {
  /** 'outline', 'road', or the key of a list. */
  word: string;
  label: string;
  /** What one of them is called. */
  figure: string;
  form: 'ring' | 'line' | 'spot' | 'seed';
  /** A figure has at least so many points. */
  least: number;
  /** How one is drawn, in a sentence. */
  tip: string;
  /** What a figure's point is called. */
  name(place: Place, all: Figure[]): string;
  /** What the value of a figure is; `words` where it is one of some words. */
  value?: FigureValue | undefined;
  /** Drawn as a band as broad as its value, in hundredths of the picture's side. */
  broad?: boolean;
}

export interface FigureValue {
  label: string;
  /** The same in a word, before a number's field. */
  brief?: string;
  min: number;
  max: number;
  step: number;
  first: number;
  words?: string[];
  shown(value: number): string;
}

/** Where a band's width can be taken: at both sides of its first piece. */
export function knobs({ points: [from, to], value }: Figure, side: number): Point[] {
  if (!from || !to) return [];
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [x, y] = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const half = (value / 200) * side;
  const [dx, dy] = [((from[1] - to[1]) / length) * half, ((to[0] - from[0]) / length) * half];
  return [
    [x + dx, y + dy],
    [x - dx, y - dy],
  ];
}

/** A figure, or the points of its line, as an SVG path. */
export function drawn(form: Sort['form'], points: Point[]): string {
  const [first, second] = points;
  if (form === 'seed' || !first) return '';
  if (form !== 'spot' || !second) return `M${points.map(([x, y]) => `${x} ${y}`).join('L')}${form === 'ring' ? 'Z' : ''}`;
  const r = Math.hypot(second[0] - first[0], second[1] - first[1]);
  return `M${first[0] - r} ${first[1]}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

/** A ring with six corners, one of them at `corner`; it runs as holes do. */
export function hexagon([x, y]: Point, corner: Point): Point[] {
  const [dx, dy] = [corner[0] - x, corner[1] - y];
  return Array.from({ length: 6 }, (_, k): Point => {
    const [cos, sin] = [Math.cos((k * Math.PI) / 3), -Math.sin((k * Math.PI) / 3)];
    return [x + dx * cos - dy * sin, y + dx * sin + dy * cos];
  });
}
