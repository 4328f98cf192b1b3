/** Shows the progress of a file with a button that stops it, then hands over the file. */
import { t } from '../words/take';
import { reasonOf } from '../base/errors';
import { clear, notice } from '../base/messages';
import { offer } from '../late/download';
import { stoppable, type ToldTask } from '../late/task';

/** The name of the file that is being made. */
let busy: string | undefined;

/**
 * Makes a file and hands it over. `work` throws an Error with a sentence if the file cannot be made. `hand` may hand
 * it over in another way, and then returns true.
 */
export async function working(name: string, work: (task: ToldTask) => Promise<Blob>, hand: (file: Blob, name: string) => boolean = () => false): Promise<void> {
  if (busy !== undefined) {
    notice('busy', t('busy', { name: busy }));
    return;
  }
  busy = name;
  const stopping = new AbortController();
  try {
    const file = await stoppable({ topic: 'files', sentence: t('making', { name }), name, stop: t('stop') }, stopping, work);
    if (!hand(file, name)) {
      offer(file, name);
      notice('files', t('saved', { name }));
    }
  } catch (error) {
    if (stopping.signal.aborted) notice('files', t('stopped', { name }));
    else notice('files', reasonOf(error));
  }
  clear('busy');
  busy = undefined;
}
