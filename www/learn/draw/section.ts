/** The potential along the line through the middle of an edge, and along that through a corner, over the distance w. */
import type { Landscape, Plate, View } from '../figures/figure';
import { neighbourAt } from '../figures/neighbour';
import { number } from '../figures/words';
import { FINE, HALF } from './ground';
import { circle, line, path, svg, symbol, text, WIDTH, X } from './plate';

const [TOP, BOTTOM] = [34, WIDTH - 24];

const [LOWEST, HIGHEST] = [-0.13, 0.09];

const Y = (energy: number): number => BOTTOM - ((energy - LOWEST) / (HIGHEST - LOWEST)) * (BOTTOM - TOP);

const MARKS = [-0.1, -0.05, 0, 0.05];

/** The end of the axis. */
const END = 2;

export function section(view: View, { packing }: Plate): string {
  const trace = view.traces[packing];
  const land = trace?.landscape;
  if (!trace || !land) return svg(WIDTH, '', '');
  const said = view.language === 'ja' ? '辺の真ん中と角を通る直線に沿ったポテンシャル' : 'The potential along the lines through the middle of an edge and through a corner';
  return svg(WIDTH, said, `${axes(view)}${path(over(land, 0), 'curve')}${path(over(land, 1), 'curve dashed')}${names(view)}${lowest(land)}${here(view, packing)}`);
}

/** The points of a curve, from where it comes into the plate at the top. */
function over({ at: energy }: Landscape, slope: 0 | 1): (readonly [number, number])[] {
  const all = Array.from({ length: HALF + 1 }, (_, i) => [(i / FINE) * Math.hypot(1, slope), energy(i, slope * i)] as const).filter(([w]) => w <= END + 0.02);
  const first = all.findLastIndex(([, value]) => value > HIGHEST);
  const [[w, psi], [above, higher]] = [all[first + 1] ?? [0, 0], all[first] ?? [0, HIGHEST]];
  const share = (HIGHEST - psi) / (higher - psi);
  const cut: readonly [number, number] = [X(w + share * (above - w)), Y(HIGHEST)];
  return [...(first < 0 ? [] : [cut]), ...all.slice(first + 1).map(([place, value]) => [X(place), Y(value)] as const)];
}

function axes({ language }: View): string {
  const across = [0, 0.5, 1, 1.5, 2].map((w) => `${line([X(w), BOTTOM], [X(w), BOTTOM + 4], 'tick')}${text(X(w), BOTTOM + 16, String(w), 'number')}`);
  const up = MARKS.map((value) => `${line([X(0), Y(value)], [X(END), Y(value)], value ? 'grid' : 'axis')}${text(X(0) - 6, Y(value) + 4, number(value, 2), 'number', 'end')}`);
  const touch = `${line([X(1), TOP - 12], [X(1), BOTTOM], 'stable')}${text(X(1) + 5, TOP - 4, language === 'ja' ? '辺と辺が接する' : 'edges touch', 'number', 'start')}`;
  return `${up.join('')}${across.join('')}${touch}${text(X(0) - 6, TOP - 14, symbol('psi', 'Ψ'), 'curve-name', 'end')}${text(X(END) + 16, BOTTOM + 16, symbol('w', 'w'), 'number', 'middle')}`;
}

/** The names of the two lines, with a piece of each. */
function names({ language }: View): string {
  const rows = language === 'ja' ? ['辺の真ん中の先', '角の先（45°）'] : ['beyond an edge', 'beyond a corner (45°)'];
  return rows.map((words, k) => `${line([X(1.05), TOP + 16 + 18 * k], [X(1.18), TOP + 16 + 18 * k], k ? 'curve dashed' : 'curve')}${text(X(1.22), TOP + 20 + 18 * k, words, 'key halo', 'start')}`).join('');
}

/** The well and the pass with their places, and the barrier between them. */
function lowest({ well, pass }: Landscape): string {
  const dot = (w: number, energy: number): string => circle([X(w), Y(energy)], 3.5, 'extreme');
  const [low, high, x] = [Y(well.energy), Y(pass.energy), X(END) - 18];
  const bar = low - high < 4 ? '' : `${line([X(well.w), low], [x + 5, low], 'guide')}${line([X(pass.w), high], [x + 5, high], 'guide')}${line([x, low], [x, high], 'measure')}${text(x - 6, (low + high) / 2 + 4, number(pass.energy - well.energy, 4), 'measured', 'end')}`;
  return `${bar}${dot(well.w, well.energy)}${dot(pass.w, pass.energy)}${text(X(well.w), low + 18, `${symbol('w', 'w')} = ${number(well.w, 2)}`, 'measured halo')}`;
}

function here({ traces, step }: View, packing: number): string {
  const trace = traces[packing];
  const one = trace && neighbourAt(trace, step);
  if (!one || one.energy > HIGHEST || one.w > END) return '';
  return circle([X(one.w), Y(one.energy)], 5.5, 'here');
}
