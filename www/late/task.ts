/** A task that takes a while: its progress, and a way to stop it. */
import { make, say } from '../base/dom';
import { remove, underWay, type Topic } from '../base/messages';

/** Milliseconds. A shorter task shows no bar. */
const SOON = 250;

export interface Task {
  /** Reports the share that is done, 0..1. Until the first call, the bar shows no share. */
  progress(done: number): void;
  readonly signal: AbortSignal;
}

/** A task whose sentence stands beside the bar. */
export interface ToldTask extends Task {
  /** The name of its result. */
  readonly name: string;
  /** Changes the sentence. */
  tell(sentence: string): void;
}

/** Shows a bar and a stop button while the work goes on. Throws the work's error, and an error when it is stopped. */
export async function stoppable<T>(
  { topic, sentence, name, stop }: { topic: Topic; sentence: string; name: string; stop: string },
  stopping: AbortController,
  work: (task: ToldTask) => Promise<T>,
): Promise<T> {
  const bar = make('progress', { max: '1', 'aria-label': name });
  const button = make('button', { type: 'button', id: `stop-${topic}` }, stop);
  button.addEventListener('click', () => stopping.abort());
  let note: HTMLElement | undefined;
  let now = sentence;
  const timer = setTimeout(() => (note = underWay(topic, now, bar, button)), SOON);
  const tell = (sentence: string): void => {
    now = sentence;
    const shown = note?.querySelector('p');
    if (shown) say(shown, now);
  };
  try {
    const made = await work({ progress: (done) => (bar.value = done), tell, name, signal: stopping.signal });
    stopping.signal.throwIfAborted();
    return made;
  } finally {
    clearTimeout(timer);
    if (note) remove(note);
  }
}
