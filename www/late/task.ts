/** A task that takes a while: its progress, and a way to stop it. */
import { make } from '../base/dom';
import { underWay, type Topic } from '../base/messages';

/** Milliseconds. A shorter task shows no bar. */
const SOON = 250;

export interface Task {
  /** Reports the share that is done, 0..1. Until the first call, the bar shows no share. */
  progress(done: number): void;
  readonly signal: AbortSignal;
}

/** Shows a bar and a stop button while the work goes on. Throws the work's error, and an error when it is stopped. */
export async function stoppable<T>(
  { topic, sentence, name, stop }: { topic: Topic; sentence: string; name: string; stop: string },
  stopping: AbortController,
  work: (task: Task) => Promise<T>,
): Promise<T> {
  const bar = make('progress', { max: '1', 'aria-label': name });
  const button = make('button', { type: 'button', id: `stop-${topic}` }, stop);
  button.addEventListener('click', () => stopping.abort());
  let note: HTMLElement | undefined;
  const timer = setTimeout(() => (note = underWay(topic, sentence, bar, button)), SOON);
  try {
    const made = await work({ progress: (done) => (bar.value = done), signal: stopping.signal });
    stopping.signal.throwIfAborted();
    return made;
  } finally {
    clearTimeout(timer);
    note?.remove();
  }
}
