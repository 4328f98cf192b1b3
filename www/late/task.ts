/** Work that goes on for a while: how far it is, and a way to stop it. */
import { make } from '../base/dom';
import { underWay, type Topic } from '../base/messages';

/** Milliseconds; shorter work shows no bar. */
const SOON = 250;

export interface Task {
  /** How much is done, 0..1; until this is called the bar does not tell. */
  progress(done: number): void;
  readonly signal: AbortSignal;
}

/** Shows a bar and a button to stop the work while it goes on; throws what the work throws, and when it was stopped. */
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
