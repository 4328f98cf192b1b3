/** Workers with one job each: the request and the answer. */
import { reasonOf } from '../base/errors';
import { brokenBy } from './broken';
import type { Task } from './task';

/** The worker failed, and why. */
interface Broken {
  broken: string;
}

/** A worker's messages: its progress, 0..1, and at last its answer or its failure. */
type WorkerMessage<Result> = { progress: number } | Result | Broken;

/** The least step of a reported progress. */
const STEP = 0.01;

/**
 * In a worker: does the job that the page requests by `answerOf`, and answers. Parts of the answer in `moved` are
 * transferred, not copied.
 */
export function serve<Result extends object>(
  work: (order: never, progress: (done: number) => void) => Result | Promise<Result>,
  moved: (answer: Result) => Transferable[] = () => [],
): void {
  const say = (said: WorkerMessage<Result>, transfer: Transferable[] = []): void => postMessage(said, { transfer });
  let told = 0;
  const progress = (done: number): void => {
    if (done >= told + STEP) say({ progress: (told = done) });
  };
  addEventListener('message', ({ data }: MessageEvent<unknown>) => {
    Promise.resolve(data as never)
      .then((order) => work(order, progress))
      .then((answer) => say(answer, moved(answer)))
      .catch((error: unknown) => say({ broken: reasonOf(error) }));
  });
}

/** On the page: sends a job to a worker. Ends the worker with its answer, or when the task is stopped, to free its memory. */
export async function answerOf<Result extends object>(worker: Worker, order: unknown, task: Task): Promise<Result | Broken> {
  const answer = new Promise<Result | Broken>((resolve, reject) => {
    worker.addEventListener('error', (event) => resolve({ broken: brokenBy(event) }));
    worker.addEventListener('message', ({ data }: MessageEvent<WorkerMessage<Result>>) => {
      if ('progress' in data) task.progress(data.progress);
      else resolve(data);
    });
    task.signal.addEventListener('abort', () => reject(new Error()));
    worker.postMessage(order);
  });
  return answer.finally(() => worker.terminate());
}
