/** The stages of the work: their order, their end, and how far the work is. */
import type { Status } from './types';

/** In their order; then comes 'done', or 'error'. */
export const STAGES = ['domain', 'fields', 'packing', 'mesh', 'cells', 'planes', 'weather', 'shading'] as const;

/** Its place in the order, from 0; -1 when the work is over. */
export function placeOf(stage: string): number {
  return STAGES.findIndex((word) => word === stage);
}

/** Whether there is no work left at this stage. */
export function isEnd(stage: string): boolean {
  return stage === 'done' || stage === 'error';
}

/** The part of the whole time, 0..1, at which each stage of a common recipe begins. */
const BEGINS: Record<string, number> = { domain: 0, fields: 0.02, packing: 0.1, mesh: 0.6, cells: 0.62, planes: 0.66, weather: 0.92, shading: 0.95 };

/** Every so many packing steps the rest of the way is taken to be half as long, as nobody knows how many it takes. */
const HALF = 60;

/** How far the work on a picture is, about: 0..1, and never less than before while a picture is made. */
export function progressOf(stage: string, { steps, stones, cells }: Status): number {
  const at = placeOf(stage);
  if (at < 0) return 1;
  const begin = BEGINS[stage] ?? 0;
  const end = BEGINS[STAGES[at + 1] ?? ''] ?? 1;
  const within = stage === 'packing' ? 1 - 2 ** (-steps / HALF) : stage === 'planes' && cells ? Math.min(1, stones / cells) : 0;
  return begin + (end - begin) * within;
}
