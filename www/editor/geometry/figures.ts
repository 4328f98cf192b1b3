/** Figures: shapes with points that can be moved. */
import type { Point } from '../../module/types';

/** A ring, a line, a spot (its middle and a point of its border), or the seed of a part. */
export interface Figure {
  points: Point[];
  /** A spot's factor or ratio, the index of a seed's kind, or a road's width in hundredths of the side. */
  value: number;
  /** The stretches between a ring's points, unless they are straight. */
  stretches?: Stretch[];
}

/** The curve from a handle to the next one. */
export interface Stretch {
  /** The handle at its beginning is smooth; else it is a corner. */
  smooth: boolean;
  /** Its ends and its length when it was made. */
  from: Point;
  to: Point;
  length: number;
  /** The points between the ends; `along` is the fraction of the length before each. */
  inner: { at: Point; along: number }[];
}

/** A point of a figure. */
export interface FigurePoint {
  figure: number;
  index: number;
}

/** A sort of figures. */
export interface Sort {
  /** 'outline', 'road', or the key of a list. */
  word: string;
  label: string;
  /** The word for one figure of this sort. */
  figure: string;
  form: 'ring' | 'line' | 'spot' | 'seed';
  /** The least number of points of a figure. */
  least: number;
  /** A sentence on how to draw a figure of this sort. */
  tip: string;
  /** The label of a figure's point. */
  name(place: FigurePoint, all: Figure[]): string;
  /** The meaning of a figure's value; `words` if it is a choice of words. */
  value?: FigureValue | undefined;
  /** A figure is drawn as a band, and its value is the band's width in hundredths of the picture's side. */
  broad?: boolean;
}

export interface FigureValue {
  label: string;
  /** A label of one word, before the field of the number. */
  brief?: string;
  min: number;
  max: number;
  step: number;
  first: number;
  words?: string[];
  shown(value: number): string;
}

/** The handles of a band's width, at both sides of its first piece. */
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

/** A hexagon with one vertex at `corner`, in the orientation of a hole. */
export function hexagon([x, y]: Point, corner: Point): Point[] {
  const [dx, dy] = [corner[0] - x, corner[1] - y];
  return Array.from({ length: 6 }, (_, k): Point => {
    const [cos, sin] = [Math.cos((k * Math.PI) / 3), -Math.sin((k * Math.PI) / 3)];
    return [x + dx * cos - dy * sin, y + dx * sin + dy * cos];
  });
}
