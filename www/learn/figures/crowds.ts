/** The cells of a crowd, and its stops, found in the engine's numbers. */
import type { Crowd, Moment, PackedCell, Stop, Trace } from './figure';

/** How many numbers a cell has in a crowd's rows. */
export const ROW = 11;

/** The crowd at a step; the last one after the end of the run. */
export function crowdAt({ steps }: Trace, step: number): Crowd | undefined {
  return steps[Math.min(step, steps.length - 1)];
}

export const countOf = ({ rows }: Crowd): number => rows.length / ROW;

/** The cells of a crowd by rising ids. */
export function packedOf(crowd: Crowd, side: number): PackedCell[] {
  return Array.from({ length: countOf(crowd) }, (_, k) => packed(crowd.rows.subarray(k * ROW, (k + 1) * ROW), side));
}

function packed([id = 0, x = 0, y = 0, size = 0, held = 0, vx = 0, vy = 0, fx = 0, fy = 0, energy = 0, least = 0]: Float64Array, side: number): PackedCell {
  return { id, x: x / side, y: y / side, size: size / side, isHeld: held === 1, speed: [vx, vy], force: [fx, fy], energy, least };
}

/** The cell whose centre is nearest to a place. */
export function nearestTo(cells: readonly PackedCell[], [x = 0, y = 0]: readonly number[]): PackedCell | undefined {
  const far = (cell: PackedCell): number => Math.hypot(cell.x - x, cell.y - y);
  return cells.reduce<PackedCell | undefined>((best, cell) => (best && far(best) <= far(cell) ? best : cell), undefined);
}

/** The sum of a crowd's energies, which falls unless a step is too long. */
export const energyOf = ({ pairs, walls, motion }: Crowd): number => pairs + walls + motion;

/** Two cells as a pair. `from` is where the left one was at the start: its x in pixels. */
export function momentOf({ step, rows, pairs, motion }: Crowd, from: number): Moment {
  const at = (place: number): number => rows[place] ?? 0;
  const size = at(3);
  return { step, left: (at(1) - from) / size, w: (at(ROW + 1) - at(1)) / size, speed: at(ROW + 5) - at(5), force: at(ROW + 7), energy: pairs, motion };
}

/** The last step of a run, at rest or not. */
export const lastOf = ({ steps }: Trace): number | undefined => steps.at(-1)?.step;

/** The step at which a run ended by itself, because all was at rest. */
export const restOf = (trace: Trace): number | undefined => (trace.isOver ? lastOf(trace) : undefined);

/** A stop of the first packing. */
export const ofFirst = (find: (trace: Trace) => number | undefined): Stop['find'] => ([trace]) => trace && find(trace);

/** The step at which all packings have reached a stop. */
export const ofAll = (find: (trace: Trace) => number | undefined): Stop['find'] => (traces) => {
  const steps = traces.map(find);
  return steps.reduce((latest, step) => (latest === undefined || step === undefined ? undefined : Math.max(latest, step)), 0);
};

export const AT_REST: Stop = { key: 'rest', name: { en: 'Rest', ja: '静止' }, find: ofAll(restOf) };
export const OVER: Stop = { key: 'end', name: { en: 'Last step', ja: '最後' }, find: ofAll(lastOf) };
