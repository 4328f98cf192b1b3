/** Workers that do one thing each: how they are asked, and how they answer. */
import { reasonOf } from '../base/errors';
import type { Task } from './task';

/** It broke, and why. */
interface Broken {
  broken: string;
}

/** What a worker says: how far it is, 0..1, then what it ends with. */
type Said<Answer> = { progress: number } | Answer | Broken;

/** The least step of the progress that is told. */
const STEP = 0.01;

/**
 * In a worker: does what the page orders, and answers. The order is what the page gave to `answerOf`; `moved` are
 * the parts of the answer that are handed over, not copied.
 */
export function serve<Answer extends object>(
  work: (order: never, progress: (done: number) => void) => Answer | Promise<Answer>,
  moved: (answer: Answer) => Transferable[] = () => [],
): void {
  const say = (said: Said<Answer>, transfer: Transferable[] = []): void => postMessage(said, { transfer });
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

/** On the page: has a worker do its work, and ends it with that, or when the task is stopped, so that all it held is free. */
export async function answerOf<Answer extends object>(worker: Worker, order: unknown, task: Task): Promise<Answer | Broken> {
  const answer = new Promise<Answer | Broken>((resolve, reject) => {
    worker.addEventListener('error', ({ message }) => resolve({ broken: message }));
    worker.addEventListener('message', ({ data }: MessageEvent<Said<Answer>>) => {
      if ('progress' in data) task.progress(data.progress);
      else resolve(data);
    });
    task.signal.addEventListener('abort', () => reject(new Error()));
    worker.postMessage(order);
  });
  return answer.finally(() => worker.terminate());
}
