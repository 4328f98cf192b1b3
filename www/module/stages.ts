/** The stages of the work as the page sees them: whether all is done, and how far it is. Each generator has its own. */
import type { Status } from './types';

/** Whether there is no work left at this stage. */
export function isEnd(stage: string): boolean {
  return stage === 'done' || stage === 'error';
}

/** The stage that goes in steps, which a pause holds. */
export const STEPPING = 'packing';

/** Whether a stage comes before the one that goes in steps, or is that one; where nothing does, a pause holds nothing. */
export function isUpToSteps(stages: readonly string[], stage: string): boolean {
  const stepping = stages.indexOf(STEPPING);
  return stepping < 0 || stages.indexOf(stage) <= stepping;
}

/** Where each stage begins, by its share of the time of common recipes; stages of which nothing is known take even shares. */
const BEGINS: Record<string, number> = { domain: 0, surface: 0, fields: 0.02, packing: 0.1, mesh: 0.6, cells: 0.62, planes: 0.66, stones: 0.66, light: 0.85, weather: 0.92, shading: 0.95 };

/** Every so many packing steps the rest of the way is taken to be half as long, as nobody knows how many it takes. */
const HALF = 60;

/** How far the work on a picture is, about: 0..1, and never less than before while a picture is made. */
export function progressOf(stages: readonly string[], stage: string, { steps, stones, cells }: Status): number {
  const at = stages.indexOf(stage);
  if (at < 0) return 1;
  const isKnown = stages.every((word) => word in BEGINS);
  const beginOf = (place: number): number => {
    const word = stages[place];
    if (word === undefined) return 1;
    return isKnown ? (BEGINS[word] ?? 0) : place / stages.length;
  };
  const [begin, end] = [beginOf(at), beginOf(at + 1)];
  const within = stage === STEPPING ? 1 - 2 ** (-steps / HALF) : stage === 'planes' && cells ? Math.min(1, stones / cells) : 0;
  return begin + (end - begin) * within;
}
