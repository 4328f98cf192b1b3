/**
 * Waits until the picture is done, for files of the finished picture: the visitor has to see what is saved. A change of the
 * recipe ends the wait, as the visitor asked for another picture. So does a pause, which may have no end.
 */
import { t } from '../words/take';
import { frame } from '../base/dom';
import type { ToldTask } from '../late/task';
import { isEnd } from '../module/stages';
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';

/** Throws an Error with a sentence if there will be no finished picture, and an error when the task is stopped. */
export async function finished(engine: Engine, store: Store, task: ToldTask): Promise<void> {
  const { recipe } = store.state;
  const isDone = (): boolean => [engine.stage(), store.state.stage].every((stage) => stage === 'done');
  if (isDone()) return;
  task.tell(t('waiting', { name: task.name }));
  while (!isDone()) {
    if (store.state.recipe !== recipe) throw new Error(t('changed', { name: task.name }));
    if (engine.stage() === 'error') throw new Error(engine.problem() || t('wait'));
    if (store.state.paused) throw new Error(t('wait'));
    await frame();
    task.signal.throwIfAborted();
  }
  task.tell(t('making', { name: task.name }));
}

/** Waits in the same way, unless the work stands: then what is shown can be saved as it is. */
export async function still(engine: Engine, store: Store, task: ToldTask): Promise<void> {
  if (!store.state.paused && !isEnd(engine.stage())) await finished(engine, store, task);
}
