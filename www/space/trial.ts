/**
 * A model file is tried before the page shows anything of it: an engine of its own works on the new recipe until the
 * surface is made. So a file that is refused changes nothing. If it is taken, the page goes on with that engine, and no
 * work is done twice.
 */
import { piecesOf, supply } from '../module/given';
import type { SceneStudio, Whole } from '../module/scene';
import { generatorOf } from '../module/run';
import { isEnd } from '../module/stages';
import type { Notice } from '../module/types';
import type { Task } from '../late/task';
import { said } from '../words/words';

/** Milliseconds of work in a slice, between which the page can act. */
const BUDGET = 10;

/** The place on the progress bar, 0..1, at which the file has been read and the surface begins. */
export const MADE = 0.5;

/** The module's refusal of a file. */
export class RefusedFile extends Error {
  constructor(readonly notice: Notice) {
    super(said(notice));
  }
}

/**
 * A studio that has made the surface of a link with this file, or that waits for yet another file. Throws a
 * RefusedFile with the module's reason, or another error when it is stopped.
 */
export async function tried(module: Whole, link: string, file: File, task: Task): Promise<SceneStudio> {
  const studio = new module.Bubblestone(link);
  try {
    studio.beginFile(file.name, file.size);
    for await (const piece of piecesOf(file)) {
      task.signal.throwIfAborted();
      studio.addToFile(piece);
    }
    studio.giveFile();
    await supply(studio, () => !task.signal.aborted);
    await surface(module, studio, task);
    return studio;
  } catch (error) {
    studio.free();
    throw error;
  }
}

/**
 * Works until the first stage is done. It goes slice by slice and never into the next stage: a surface that the present
 * settings cannot pack is no fault of the file, and a fast machine must not refuse the file for it.
 */
async function surface(module: Whole, studio: SceneStudio, task: Task): Promise<void> {
  const [first] = generatorOf(module, studio).stages;
  let done = MADE;
  while (studio.stage() === first) {
    task.signal.throwIfAborted();
    const end = performance.now() + BUDGET;
    do studio.tick(0, 1);
    while (studio.stage() === first && performance.now() < end);
    // The true progress is unknown: each slice counts as a hundredth of the rest.
    task.progress((done += (1 - done) / 100));
    await new Promise((resolve) => setTimeout(resolve));
  }
  task.signal.throwIfAborted();
  const problem = isEnd(studio.stage()) && !studio.missingFiles().length ? studio.problem() : undefined;
  if (problem) throw new RefusedFile(problem);
}
