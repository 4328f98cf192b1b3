/** The buttons that randomise: one for everything that is not locked, and a dice and a lock for each group. */
import { groupIn, t } from '../words/words';
import { byId, make } from '../base/dom';
import { Later } from '../base/later';
import { isLocked, onLocks, toggleLock } from '../state/locks';
import type { Work } from '../state/work';
import type { Panel } from './panel';

export class Dice {
  private readonly work: Work;
  private readonly push: () => void;
  private readonly throws = new Later(() => import('./throws'));
  private groups: { name: string; dice: HTMLButtonElement; lock: HTMLButtonElement }[] = [];

  /** `push` is called before a change that the browser's Back button should undo. */
  constructor(work: Work, push: () => void) {
    this.work = work;
    this.push = push;
    byId('throw').addEventListener('click', () => this.throw(this.groups.map(({ name }) => name)));
    byId('throw-colours').addEventListener('click', () => this.throws.ask(({ colours }) => colours(work, push)));
    onLocks(work.store, () => this.show());
  }

  /** Adds a dice and a lock to each group of the panel. */
  build(panel: Panel): void {
    this.groups = Array.from(panel.groupings(), ([name, element]) => {
      const dice = signed('dice', t('throw_group', { group: groupIn(name) }));
      dice.addEventListener('click', () => this.throw([name]));
      const lock = signed('lock', t('lock_group', { group: groupIn(name) }));
      lock.addEventListener('click', () => toggleLock(this.work.store, name));
      element.prepend(make('div', { class: 'group-tools' }, dice, lock));
      return { name, dice, lock };
    });
    this.show();
  }

  private show(): void {
    for (const { name, dice, lock } of this.groups) {
      const locked = isLocked(this.work.store, name);
      lock.setAttribute('aria-pressed', String(locked));
      dice.disabled = locked;
    }
  }

  private throw(groups: readonly string[]): void {
    this.throws.ask((throws) => throws.groups(this.work, this.push, groups));
  }
}

/** A button with the icon of another button of the page. */
function signed(like: 'dice' | 'lock', words: string): HTMLButtonElement {
  const signs = Array.from(byId(like === 'lock' ? 'seed-lock' : 'dice').querySelectorAll('svg'), (sign) => sign.cloneNode(true));
  return make('button', { type: 'button', class: `key ${like}`, title: words, 'aria-label': words }, ...signs);
}
