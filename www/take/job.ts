/**
 * Files of a recipe, made in a worker.
 *
 * The worker runs the recipe's link again, with the same result to the bit. So the page is never blocked, and Stop
 * ends the worker with all its memory. Only the picture on the screen and the recipe are saved without a worker.
 */
import { t } from '../words/take';
import { said } from '../words/words';
import type { Task } from '../late/task';
import { answerOf } from '../late/worker';
import type { Job, JobRequest, JobResult } from './files/job.worker';

/** Throws an Error with a sentence if the file cannot be made. */
export async function fileOf(link: string, job: Job, task: Task): Promise<Blob> {
  const packs = job.file === 'picture' || job.file === 'turn' || job.file === 'maps' || (job.file === 'glb' && job.images);
  if (packs && typeof CompressionStream !== 'function') throw new Error(t('old'));
  const worker = new Worker(new URL('./files/job.worker.ts', import.meta.url), { type: 'module' });
  const answer = await answerOf<JobResult>(worker, [link, job] satisfies JobRequest, task);
  if ('file' in answer) return answer.file;
  if ('refused' in answer) throw new Error(t('not_made', { reason: said(answer.refused) }));
  // A module that runs out of memory ends without a message.
  const isLarge = 'scale' in job && job.scale > 1;
  throw new Error(t(isLarge ? 'not_made_large' : 'not_made', { reason: answer.broken }));
}
