/** Files of models and buildings that the visitor opens: they are identified by their digest, stored, and named in the recipe. */
import { piecesOf } from '../module/given';
import { generators } from '../module/generators';
import { loadWhole } from '../module/load';
import type { SceneStudio, Whole } from '../module/scene';
import { keepFile } from '../module/shelf';
import type { Parameter } from '../module/types';
import { t } from '../words/space';
import { reasonOf } from '../base/errors';
import { moreWords } from '../base/language';
import { alertOf, clear, notice } from '../base/messages';
import { stoppable, type Task } from '../late/task';
import { withValues } from '../state/link';
import type { Work } from '../state/work';
import { unbent } from './roles';
import { GUESSED, SIDE } from './sides';
import { MADE, tried } from './trial';
import { METRES, otherUnit, UNIT } from './units';

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

/** A file to be opened, and the role that it should get. Only generators with buildings take the file of a building. */
export interface Given {
  readonly file: File;
  readonly role?: string | undefined;
  readonly isBuilding: boolean;
}

/** The parameter that chooses a building; one of its words stands for a file. */
const BUILDING = 'building';

/** Stops the reading that goes on now. */
let now: AbortController | undefined;

/**
 * Opens a file and names it in the recipe, if something can be made of it; else nothing changes. The other settings
 * stay if the present generator takes files. Without a role, the file gets the role that the recipe waits for, or else
 * the first one. If the recipe already names the file, the recipe does not change, and `again` is called. Returns
 * whether the file is open.
 */
export async function openModel(work: Work, given: Given, again: () => void): Promise<boolean> {
  now?.abort();
  const stopping = (now = new AbortController());
  const { file, file: { name } } = given;
  const refuse = (reason: string): void => alertOf('outline', t('refused', { name, reason }));
  if (file.size > LARGEST) {
    refuse(t('too_large', { most: LARGEST / 1e6 }));
    return false;
  }
  try {
    const sentence = t('reading', { name });
    const taken = await stoppable({ topic: 'files', sentence, name, stop: t('stop') }, stopping, (task) => trialOf(work, given, task));
    const isKept = await keepFile(taken.named.digest, name, file);
    take(work, given, taken, again);
    if (!isKept) notice('files', t('not_kept', { name }));
    return true;
  } catch (error) {
    if (!stopping.signal.aborted) refuse(reasonOf(error));
    // If another file has replaced this one, its own message is shown.
    else if (stopping === now) notice('files', t('stopped', { name }));
    return false;
  }
}

/** A file that has passed its trial. */
interface Taken {
  named: Named;
  /** The link with the file, and the recipe that it was made of. */
  link: string;
  before: string;
  studio: SceneStudio;
  /** The unit in which the file is read because it is far too large in metres. */
  unit?: string;
}

async function trialOf(work: Work, given: Given, task: Task): Promise<Taken> {
  const { file } = given;
  const named = await nameOf(file, task);
  const { recipe: before } = work.store.state;
  const link = askingFor(named, work, given);
  try {
    return { named, link, before, studio: await tried(named.module, link, file, task) };
  } catch (error) {
    const unit = otherUnit(error);
    // A link that waits for this file has its unit.
    if (unit === undefined || link === before) throw error;
    const other = withValues(link, [[UNIT, unit]]);
    return { named, link: other, before, studio: await tried(named.module, other, file, task), unit };
  }
}

/** Throws the browser's error if the file has gone or the module does not load. */
async function nameOf(file: File, task: Task): Promise<Named> {
  const [module] = await Promise.all([loadWhole(), moreWords()]);
  const digest = new module.FileDigest(file.size);
  try {
    let read = 0;
    for await (const piece of piecesOf(file)) {
      task.signal.throwIfAborted();
      digest.add(piece);
      read += piece.length;
      task.progress((MADE * read) / file.size);
    }
    return { digest: digest.text(), value: digest.value(file.name), module };
  } finally {
    digest.free();
  }
}

/**
 * The link of a recipe that names a file: the present recipe with it, or one of another generator if this one takes no
 * such files. If the recipe waits for this very file, the link stays the same.
 */
function askingFor({ digest, value, module }: Named, { engine, store: { state: { make, recipe } } }: Work, { role, isBuilding }: Given): string {
  const missing = engine.missing();
  const wanted = role ?? missing[0]?.role;
  if (missing.some((one) => one.digest === digest)) return recipe;
  const rowOf = (word: string): Parameter | undefined => {
    const rows = module.schema(word).filter(({ item, shownFor }) => item === 'file' && (!isBuilding || shownFor?.key === BUILDING));
    return rows.find(({ key }) => key === wanted) ?? rows[0];
  };
  const taker = rowOf(make) ? make : generators.find(({ word }) => rowOf(word))?.word;
  const row = taker === undefined ? undefined : rowOf(taker);
  if (!row || taker === undefined) return recipe;
  // The parameter may apply only with certain values of another one.
  const beside = row.shownFor?.words.slice(0, 1).map((word) => [row.shownFor?.key ?? '', word] as const) ?? [];
  const sides = module.schema(taker).some(({ key }) => key === SIDE) ? [[SIDE, GUESSED] as const] : [];
  const link = taker === make ? recipe : `v=1&make=${taker}`;
  // A new file is in metres until it proves to be too large.
  const isKnown = recipe.includes(`${row.key}=${value}`);
  const units = !isKnown && module.schema(taker).some(({ key }) => key === UNIT) ? [[UNIT, METRES] as const] : [];
  return withValues(link, [...beside, [row.key, value], ...unbent(link, row.key), ...sides, ...units]);
}

function take(work: Work, given: Given, { named, link, before, studio, unit }: Taken, again: () => void): void {
  const { engine, store } = work;
  const { name } = given.file;
  const [asked] = engine.missing();
  const isAsked = link === before;
  const play = (): void => store.update({ paused: false });
  clear('outline');
  // If the recipe has changed meanwhile, the file goes into the new one.
  if (store.state.recipe === before) work.adopt(studio, named.module, play);
  else {
    studio.free();
    work.open(withValues(askingFor(named, work, given), unit === undefined ? [] : [[UNIT, unit]]), { own: true, then: play });
  }
  if (isAsked) again();
  if (asked && !isAsked) notice('files', t('other', { name, asked: asked.name }));
  else if (unit === undefined) notice('opened', t('opened', { name }));
  else {
    const row = engine.schema.find(({ key }) => key === UNIT);
    const choice = row?.choices.find(({ word }) => word === unit);
    notice('opened', t('opened_unit', { name, unit: choice?.label ?? unit }));
  }
}
