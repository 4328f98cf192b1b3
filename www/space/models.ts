/** Model files that the visitor opens: they are identified by their digest, stored, and named in the recipe. */
import { piecesOf } from '../module/given';
import { generators } from '../module/generators';
import { loadWhole } from '../module/load';
import type { Whole } from '../module/scene';
import { keepFile } from '../module/shelf';
import type { Parameter } from '../module/types';
import { t } from '../words/space';
import { reasonOf } from '../base/errors';
import { alertOf, clear, notice, passing } from '../base/messages';
import { stoppable, type Task } from '../late/task';
import { withValues } from '../state/link';
import type { State } from '../state/store';
import type { Work } from '../state/work';

/** Largest file in bytes; a model with the most triangles allowed has some two hundred million. */
const LARGEST = 400_000_000;

/** A file as recipes name it. */
interface Named {
  digest: string;
  /** The value of the parameter for it. */
  value: string;
  /** The module that has computed the digest. */
  module: Whole;
}

/** Stops the file that is being read. */
let now: AbortController | undefined;

/**
 * Opens a file and names it in the recipe. The other settings stay if the present generator takes files. If the
 * recipe already names the file, the engine receives it, and `again` is called because the recipe does not change.
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
    // Unless another file has taken its place.
    else if (stopping === now) passing('files', t('stopped', { name }));
  }
}

/** Throws the browser's error if the file has gone or the module does not load. */
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
    return { digest: digest.text(), value: digest.value(file.name), module };
  } finally {
    digest.free();
  }
}

/**
 * The link of a recipe that names a file: the present recipe with it, or one of another generator if this one takes
 * no files. `role` is the key of the parameter that the recipe waits for.
 */
function askingFor({ value, module }: Named, { make, recipe }: State, role: string | undefined): string {
  const rowOf = (word: string): Parameter | undefined => {
    const rows = module.schema(word).filter(({ item }) => item === 'file');
    return rows.find(({ key }) => key === role) ?? rows[0];
  };
  const taker = rowOf(make) ? make : generators.find(({ word }) => rowOf(word))?.word;
  const row = taker === undefined ? undefined : rowOf(taker);
  if (!row) return recipe;
  // The parameter may apply only with certain values of another one.
  const beside = row.shownFor?.words.slice(0, 1).map((word) => [row.shownFor?.key ?? '', word] as const) ?? [];
  return withValues(taker === make ? recipe : `v=1&make=${taker}`, [...beside, [row.key, value]]);
}

function take(work: Work, name: string, named: Named, again: () => void): void {
  const { engine, store } = work;
  const missing = engine.missing();
  const [asked] = missing;
  clear('outline');
  if (missing.some(({ digest }) => digest === named.digest)) {
    engine.open(store.state.recipe);
    again();
    return passing('files', t('opened', { name }));
  }
  work.open(askingFor(named, store.state, asked?.role), { own: true, then: () => store.update({ paused: false }) });
  if (asked) notice('files', t('other', { name, asked: asked.name }));
  else passing('files', t('opened', { name }));
}
