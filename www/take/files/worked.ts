/** Finishes a studio's recipe, so that a file can be made from it. */
import type { Bubblestone } from '../../../pkg/bubblestone.js';
import { BUDGET, making } from '../../module/run';
import { progressOf, type Course } from '../../module/stages';
import type { Status } from '../../module/types';
import { Refusal } from './refusal';

/** Receives the progress, 0..1. */
export type Progress = (done: number) => void;

/**
 * Finishes the recipe. If `looksOn` is given, it is called after each single step of the packing or single body.
 * Throws a Refusal if there is no picture.
 */
export function workedOut(studio: Bubblestone, course: Course, progress: Progress, looksOn?: (stage: string, status: Status) => void): void {
  for (const [stage, status] of looksOn ? making(studio, 0, 1) : making(studio, BUDGET)) {
    looksOn?.(stage, status);
    progress(progressOf(course, stage, status));
  }
  const problem = studio.problem();
  if (problem) throw new Refusal(problem);
}
