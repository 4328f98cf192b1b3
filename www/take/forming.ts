/** The looping animation of the forming, made in a worker, so that the page stays free. */
import type { Engine } from '../engine';
import { t } from './words';
import type { Task } from './working';

/** What the worker says: how far it is, then the file; or what went wrong. */
export type Said = { progress: number } | { file: Uint8Array<ArrayBuffer> } | { trouble: string };

export function formingGif(engine: Engine, task: Task): Promise<Blob> {
  const worker = new Worker(new URL('./forming.worker.ts', import.meta.url), { type: 'module' });
  const made = new Promise<Blob>((resolve, reject) => {
    const failed = (reason: string): void => reject(new Error(t('no_gif', { reason })));
    worker.addEventListener('error', ({ message }) => failed(message));
    worker.addEventListener('message', ({ data }: MessageEvent<Said>) => {
      if ('progress' in data) task.progress(data.progress);
      else if ('file' in data) resolve(new Blob([data.file], { type: 'image/gif' }));
      else failed(data.trouble);
    });
    task.signal.addEventListener('abort', () => reject(new Error()));
    worker.postMessage(engine.link());
  });
  return made.finally(() => worker.terminate());
}
