/** The buttons of chance: one that throws all that is not locked, and a dice and a lock for each group. */
import { groupIn, t } from '../words/words';
import { byId, make } from '../base/dom';
import { Later } from '../base/later';
import { isLocked, onLocks, toggleLock } from '../state/locks';
import type { Work } from '../state/work';
import type { Panel } from './panel';
import { SEED } from './seed';

/** `push` is called before a change that the browser's Back button shall take back. */
export function makeDice(work: Work, panel: Panel, push: () => void): void {
  const { engine, store } = work;
  const ranges = new Later(() => import('./ranges'));
  const throwAll = (groups: readonly string[]): void => {
    ranges.ask(({ thrown }) => {
      const free = groups.filter((group) => !isLocked(store, group));
      const values = thrown(Math.random, free, engine.schema, (key) => engine.get(key));
      if (groups.length > 1 && !isLocked(store, SEED)) values.push([SEED, String(engine.randomSeed())]);
      push();
      work.setAll(values);
      // What all groups were thrown for is no variant of the preset before.
      if (groups.length > 1) store.update({ preset: undefined });
    });
  };
  const names: string[] = [];
  for (const [name, element] of panel.groupings()) {
    names.push(name);
    const dice = signed('dice', t('throw_group', { group: groupIn(name) }));
    dice.addEventListener('click', () => throwAll([name]));
    const lock = signed('lock', t('lock_group', { group: groupIn(name) }));
    lock.addEventListener('click', () => toggleLock(store, name));
    onLocks(store, () => {
      lock.setAttribute('aria-pressed', String(isLocked(store, name)));
      dice.disabled = isLocked(store, name);
    });
    element.prepend(make('div', { class: 'group-tools' }, dice, lock));
  }
  byId('throw').addEventListener('click', () => throwAll(names));
}

/** A button with the icon of another one of the page. */
function signed(like: 'dice' | 'lock', words: string): HTMLButtonElement {
  const signs = Array.from(byId(like === 'lock' ? 'seed-lock' : 'dice').querySelectorAll('svg'), (sign) => sign.cloneNode(true));
  return make('button', { type: 'button', class: `key ${like}`, title: words, 'aria-label': words }, ...signs);
}
