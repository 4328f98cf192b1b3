/** A file in the making: how far it is, and a way to stop it; then the file. */
import { make } from '../dom';
import { offer } from '../download';
import { clear, notice, passing, underWay } from '../messages';
import { t } from './words';

export interface Task {
  /** How much is done, 0..1; nothing is known where it is never said. */
  progress(done: number): void;
  readonly signal: AbortSignal;
}

/** What is being made. */
let busy: string | undefined;

/** Makes a file and hands it over; `work` throws a sentence where it cannot be made. */
export async function working(name: string, work: (task: Task) => Promise<Blob>): Promise<void> {
  if (busy !== undefined) {
    passing('busy', t('busy', { name: busy }));
    return;
  }
  busy = name;
  const stopping = new AbortController();
  const bar = make('progress', { max: '1', 'aria-label': name });
  const stop = make('button', { type: 'button', id: 'stop-file' }, t('stop'));
  stop.addEventListener('click', () => stopping.abort());
  underWay('files', t('making', { name }), bar, stop);
  try {
    const file = await work({ progress: (done) => (bar.value = done), signal: stopping.signal });
    stopping.signal.throwIfAborted();
    offer(file, name);
    clear('files');
    passing('files', t('saved', { name }));
  } catch (error) {
    clear('files');
    if (stopping.signal.aborted) passing('files', t('stopped', { name }));
    else notice('files', error instanceof Error ? error.message : String(error));
  }
  clear('busy');
  busy = undefined;
}
