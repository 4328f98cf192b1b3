/** Files of a recipe, made in a worker that packs it anew, so that the page stays free; to stop it frees all it held. */
import type { Task } from '../base/task';
import type { Notice } from '../module/types';
import { t } from '../words/take';
import { said } from '../words/words';

/** What is to be made; `normals` is the word of the normal map. */
export type Job =
  | { file: 'svg' | 'gif' | 'glb' | 'obj' }
  | { file: 'picture'; scale: number }
  | { file: 'maps'; normals: string };

/** What the worker gets: the recipe and what to make of it. */
export type Order = [link: string, job: Job];

/** What it says: how far it is, then the file; or what went wrong. */
export type Said = { progress: number } | { file: Blob } | { trouble: Notice | string };

/** Throws a sentence where the file cannot be made. */
export function fileOf(link: string, job: Job, task: Task): Promise<Blob> {
  if ((job.file === 'picture' || job.file === 'maps') && typeof CompressionStream !== 'function') throw new Error(t('old'));
  const worker = new Worker(new URL('./job.worker.ts', import.meta.url), { type: 'module' });
  const made = new Promise<Blob>((resolve, reject) => {
    const failed = (why: Notice | string): void => reject(new Error(t('not_made', { reason: typeof why === 'string' ? why : said(why) })));
    worker.addEventListener('error', ({ message }) => failed(message));
    worker.addEventListener('message', ({ data }: MessageEvent<Said>) => {
      if ('progress' in data) task.progress(data.progress);
      else if ('file' in data) resolve(data.file);
      else failed(data.trouble);
    });
    task.signal.addEventListener('abort', () => reject(new Error()));
    worker.postMessage([link, job] satisfies Order);
  });
  return made.finally(() => worker.terminate());
}
