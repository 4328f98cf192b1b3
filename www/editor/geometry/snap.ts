/** Where a point goes while Shift is held: to other points, to multiples of 15 degrees, or to a grid. */
import type { Point } from '../../module/types';
import { drawn } from './figures';
import { distance } from './plane';

/** Squares of the grid along the picture's side. */
const SQUARES = 32;
const STEP = Math.PI / 12;

interface Snapped {
  at: Point;
  /** The line or point that the point snapped to, as an SVG path. */
  guide: string;
}

/** `reach` is the largest distance of a snap, `neighbours` are joined to the point, `others` are points it may fall on. */
export function snap(at: Point, side: number, reach: number, neighbours: Point[], others: Point[]): Snapped {
  const near = others.filter((point) => distance(point, at) < reach).sort((a, b) => distance(a, at) - distance(b, at))[0];
  if (near) return { at: [...near], guide: drawn('spot', [near, [near[0] + 0.7 * reach, near[1]]]) };
  const rays = neighbours.map((from) => onRay(from, at)).filter((found) => distance(found.at, at) < reach);
  const [first, second] = rays;
  const both = first && second && meeting(first, second);
  if (both && distance(both, at) < 1.5 * reach) return { at: both, guide: rays.map(({ from }) => drawn('line', [from, both])).join('') };
  if (first) return { at: first.at, guide: line(first) };
  const unit = side / SQUARES;
  const node: Point = [Math.round(at[0] / unit) * unit, Math.round(at[1] / unit) * unit];
  return { at: node, guide: `M${node[0]} 0V${side}M0 ${node[1]}H${side}` };
}

interface Ray {
  from: Point;
  angle: number;
  at: Point;
}

/** The nearest place on one of the directions from a point. */
function onRay(from: Point, at: Point): Ray {
  const angle = Math.round(Math.atan2(at[1] - from[1], at[0] - from[0]) / STEP) * STEP;
  const far = (at[0] - from[0]) * Math.cos(angle) + (at[1] - from[1]) * Math.sin(angle);
  return { from, angle, at: [from[0] + far * Math.cos(angle), from[1] + far * Math.sin(angle)] };
}

function meeting(a: Ray, b: Ray): Point | undefined {
  const sine = Math.sin(b.angle - a.angle);
  if (Math.abs(sine) < 0.1) return undefined;
  const far = ((b.from[0] - a.from[0]) * Math.sin(b.angle) - (b.from[1] - a.from[1]) * Math.cos(b.angle)) / sine;
  return [a.from[0] + far * Math.cos(a.angle), a.from[1] + far * Math.sin(a.angle)];
}

/** The line through the point in the snapped direction, extended somewhat beyond it. */
function line({ from, at }: Ray): string {
  return drawn('line', [from, [2 * at[0] - from[0], 2 * at[1] - from[1]]]);
}
