/** Squares with the edges that they share; large ones with their bubbles. */
import { crowdAt, packedOf } from '../figures/crowds';
import type { PackedCell, Plate, Trace, View } from '../figures/figure';
import { edgesOf } from '../figures/neighbour';
import { SIDE } from './crowd';
import { at, circle, line, svg } from './plate';

/** Bubbles are drawn in squares that are at least this large, in units of the plate. */
const LARGE = 60;

/** The radius is half a size times `factor`; the factor of the central bubble is 1. */
const ring = (x: number, y: number, size: number, factor: number, kind: string): string => circle([x * SIDE, y * SIDE], (size / 2) * factor * SIDE, kind);

export function squares(view: View, { packing, title }: Plate): string {
  const trace = view.traces[packing];
  const now = trace && crowdAt(trace, view.step);
  if (!trace || !now) return svg(SIDE, '', '');
  const cells = packedOf(now, trace.side);
  const drawn = cells.map((cell) => square(cell, 'tile')).join('');
  const bubbles = cells.map((cell) => (cell.size * SIDE < LARGE ? '' : bubblesOf(cell, trace))).join('');
  const edges = edgesOf(cells).edges.map(([x, y, u, v]) => line([x * SIDE, y * SIDE], [u * SIDE, v * SIDE], 'shared')).join('');
  const said = view.language === 'ja' ? `${cells.length}個の正方形` : `${cells.length} squares`;
  return svg(SIDE, title ? `${title[view.language]}. ${said}` : said, `${drawn}${bubbles}${edges}`);
}

export function square({ x, y, size }: PackedCell, kind: string): string {
  return `<rect class="${kind}" x="${at((x - size / 2) * SIDE)}" y="${at((y - size / 2) * SIDE)}" width="${at(size * SIDE)}" height="${at(size * SIDE)}"/>`;
}

/** The central bubble, and those of the corners if they have a weight. */
export function bubblesOf({ x, y, size }: PackedCell, trace: Trace): string {
  const [weight, radius] = [Number(trace.value('cw')), Number(trace.value('cr'))];
  const corners = [-0.5, 0.5].flatMap((dx) => [-0.5, 0.5].map((dy) => ring(x + dx * size, y + dy * size, size, radius, 'corner-bubble')));
  return `${ring(x, y, size, 1, 'central-bubble')}${weight > 0 ? corners.join('') : ''}`;
}
