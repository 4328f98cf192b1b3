/** Who comes and who goes: looks at the population, and what they find, in the engine's numbers. */
import { crowdAt, packedOf } from './crowds';
import type { Coming, PackedCell, Seen, Trace } from './figure';

/** A look at the population that changed it. */
export interface Look {
  readonly step: number;
  readonly came: readonly Coming[];
  readonly went: readonly Coming[];
}

/** Steps between two looks at most (`population_every` of the engine). */
const EVERY = 10;

/** The looks that changed the population, by rising steps. */
export function looksOf({ comings }: Trace): Look[] {
  const steps = [...new Set(comings.map(({ step }) => step))];
  return steps.map((step) => {
    const own = comings.filter((coming) => coming.step === step);
    return { step, came: own.filter(({ came }) => came), went: own.filter(({ came }) => !came) };
  });
}

/** The looks up to a step. */
export const looksUpTo = (trace: Trace, step: number): Look[] => looksOf(trace).filter((look) => look.step <= step);

/** The numbers of cells that came and that went up to a step. */
export function changesUpTo(trace: Trace, step: number): { readonly came: number; readonly went: number } {
  const own = trace.comings.filter((coming) => coming.step <= step);
  const came = own.filter((coming) => coming.came).length;
  return { came, went: own.length - came };
}

/** A cell below the threshold is crowded; one without neighbours is not. */
export function isCrowded(trace: Trace, { least }: PackedCell): boolean {
  return least > 0 && least < Number(trace.value('crowd'));
}

/** Whether the papers' rule brings a cell beside this one. */
export function isLonely(trace: Trace, { least }: PackedCell): boolean {
  return least === 0 || least >= Number(trace.value('room'));
}

/** The cells of a step that have a part in a look. */
export interface Marks {
  readonly cells: readonly PackedCell[];
  /** Those that the next look takes away, and those that the last one brought, by their ids. */
  readonly leaving: ReadonlySet<number>;
  readonly fresh: ReadonlySet<number>;
  /** The places that the next look fills. */
  readonly empty: readonly Coming[];
}

/** A look counts as next within this many steps ahead; an added cell counts as new within this many steps. */
const NEAR = EVERY;

export function marksAt(trace: Trace, step: number): Marks {
  const now = crowdAt(trace, step);
  const looks = looksOf(trace);
  const next = looks.find((look) => look.step > step && look.step <= step + NEAR);
  const last = looks.findLast((look) => look.step <= step && look.step > step - NEAR);
  return {
    cells: now ? packedOf(now, trace.side) : [],
    leaving: new Set(next?.went.map(({ id }) => id)),
    fresh: new Set(last?.came.map(({ id }) => id)),
    empty: next?.came ?? [],
  };
}

/** The number of cells at a step. */
export const numberAt = (trace: Trace, step: number): number => marksAt(trace, step).cells.length;

/** The smallest and the largest of the cells' smallest w at a step; `undefined` if no cell has a neighbour. */
export function leastRange(trace: Trace, step: number): readonly [number, number] | undefined {
  const all = marksAt(trace, step).cells.map(({ least }) => least).filter((least) => least > 0);
  return all.length ? [Math.min(...all), Math.max(...all)] : undefined;
}

/** Whether a run has ended at this step, at rest. */
export const isAtRest = ({ steps, isOver }: Trace, step: number): boolean => isOver && step >= steps.length - 1;

export const areAtRest = ({ traces, step }: Seen): boolean => traces.every((trace) => isAtRest(trace, step));

/** Three looks in a row, all seen, at which cells both came and went. */
export function restless(trace: Trace, step: number): readonly Look[] | undefined {
  const looks = looksUpTo(trace, step);
  const rows = looks.map((_, k) => looks.slice(k, k + 3)).filter((row) => row.length === 3);
  return rows.find((row) => row.every(({ came, went }) => came.length > 0 && went.length > 0) && (row[2]?.step ?? 0) - (row[0]?.step ?? 0) <= 2 * EVERY);
}
