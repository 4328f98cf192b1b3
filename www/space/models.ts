/** Files of models, as the visitor opens them: known by their digest, kept, and made the recipe's. */
import { piecesOf } from '../module/given';
import { loadWhole } from '../module/load';
import { keepFile } from '../module/shelf';
import { t } from '../words/space';
import { reasonOf } from '../base/errors';
import { alertOf, clear, notice, passing } from '../base/messages';
import { stoppable, type Task } from '../late/task';
import { withValues } from '../state/link';
import type { Work } from '../state/work';

/** The generator of surfaces, and its parameter that names a file. */
const SURFACE = 'surface';
export const MODEL = 'model';

/** Bytes of a file; a model of as many triangles as can be taken has some two hundred million. */
const LARGEST = 400_000_000;

/** A file, as recipes name it. */
interface Named {
  digest: string;
  /** The value of the parameter that names it. */
  value: string;
}

/** What is read now. */
let now: AbortController | undefined;

/**
 * Opens a file: the recipe asks for it from now on, all other settings stay where it is of a surface already. One that the
 * recipe asks for is given to it. `again` is called where only that is new.
 */
export async function openModel(work: Work, file: File, again: () => void): Promise<void> {
  now?.abort();
  const stopping = (now = new AbortController());
  const { name } = file;
  if (file.size > LARGEST) {
    alertOf('outline', t('too_large', { name, most: LARGEST / 1e6 }));
    return;
  }
  try {
    const sentence = t('reading', { name });
    const named = await stoppable({ topic: 'files', sentence, name, stop: t('stop') }, stopping, (task) => nameOf(file, task));
    const isKept = await keepFile(named.digest, name, file);
    take(work, name, named, again);
    if (!isKept) notice('files', t('not_kept', { name }));
  } catch (error) {
    if (!stopping.signal.aborted) alertOf('outline', t('unread', { name, reason: reasonOf(error) }));
    // Another file has taken its place.
    else if (stopping === now) passing('files', t('stopped', { name }));
  }
}

/** Throws what a browser throws where the file went, or the module does not come. */
async function nameOf(file: File, task: Task): Promise<Named> {
  const module = await loadWhole();
  const digest = new module.FileDigest(file.size);
  try {
    let read = 0;
    for await (const piece of piecesOf(file)) {
      task.signal.throwIfAborted();
      digest.add(piece);
      read += piece.length;
      task.progress(read / file.size);
    }
    return { digest: digest.text(), value: digest.value(file.name) };
  } finally {
    digest.free();
  }
}

function take(work: Work, name: string, { digest, value }: Named, again: () => void): void {
  const { engine, store } = work;
  const { recipe, make } = store.state;
  const missing = engine.missing();
  const [asked] = missing;
  clear('outline');
  if (missing.some((one) => one.digest === digest)) {
    engine.open(recipe);
    again();
    return passing('files', t('opened', { name }));
  }
  const inRole = asked && make !== SURFACE ? withValues(recipe, [[asked.role, value]]) : undefined;
  const base = make === SURFACE ? recipe : `v=1&make=${SURFACE}`;
  const opened = inRole ?? withValues(base, [['form', 'file'], [MODEL, value]]);
  work.open(opened, { own: true, then: () => store.update({ paused: false }) });
  if (asked) notice('files', t('other', { name, asked: asked.name }));
  else passing('files', t('opened', { name }));
}
