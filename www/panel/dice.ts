/** The buttons that randomise: one for everything that is not locked, and a dice and a lock for each group. */
import type { Parameter } from '../module/types';
import { groupIn, t } from '../words/words';
import { byId, make } from '../base/dom';
import { Later } from '../base/later';
import { clear, offerOf } from '../base/messages';
import { valuesIn } from '../state/link';
import { isLocked, onLocks, toggleLock } from '../state/locks';
import { recipeOf } from '../state/rules';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { Panel } from './panel';
import { SEED } from './seed';

/** The group of patterns, and the keys of colours in other groups. */
const PATTERNS = 'Colour';
const PAINTS = ['palette', 'vary', 'ground', 'f1', 'f2', 'f3', 'f4'];

export class Dice {
  private readonly work: Work;
  private readonly push: () => void;
  private readonly ranges = new Later(async () => {
    const [{ thrown }, { drawnIn }, { CHANCES }] = await Promise.all([import('./chance'), import('./drawn'), import('./ranges')]);
    return { thrown, drawnIn, table: (word: string) => CHANCES[word] ?? {} };
  });
  private groups: { name: string; dice: HTMLButtonElement; lock: HTMLButtonElement }[] = [];

  /** `push` is called before a change that the browser's Back button should undo. */
  constructor(work: Work, push: () => void) {
    this.work = work;
    this.push = push;
    byId('throw').addEventListener('click', () => this.throw(this.groups.map(({ name }) => name)));
    byId('throw-colours').addEventListener('click', () => this.colours());
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

  /** Says that the visitor's own work was kept, and offers new values for it, too. */
  private tellKept(groups: readonly string[]): void {
    const too = make('button', { type: 'button', id: 'throw-drawn' }, t('throw_drawn'));
    too.addEventListener('click', () => {
      clear('value');
      this.throw(groups, true);
    });
    offerOf('value', t('drawn_kept'), too);
  }

  private show(): void {
    for (const { name, dice, lock } of this.groups) {
      const locked = isLocked(this.work.store, name);
      lock.setAttribute('aria-pressed', String(locked));
      dice.disabled = locked;
    }
  }

  /** New colours alone. */
  private colours(): void {
    const { engine, store } = this.work;
    this.ranges.ask(({ thrown, drawnIn, table }) => {
      const isPaint = ({ key, group }: Parameter): boolean => group === PATTERNS || PAINTS.includes(key);
      const groups = [...new Set(engine.schema.filter(isPaint).map(({ group }) => group))];
      const stay = drawnIn(recipeOf(engine), presetIn(store));
      for (const row of engine.schema) if (!isPaint(row)) stay.add(row.key);
      const values = thrown(table(engine.generator.chance), Math.random, groups, engine.schema, (key) => engine.get(key), stay);
      this.push();
      this.work.setAll(values);
    });
  }

  /** New values for these groups. The visitor's own work stays, unless `all` is true. */
  private throw(groups: readonly string[], all = false): void {
    const { engine, store } = this.work;
    this.ranges.ask(({ thrown, drawnIn, table }) => {
      const free = groups.filter((group) => !isLocked(store, group));
      const stay = all ? new Set<string>() : drawnIn(recipeOf(engine), presetIn(store));
      const values = thrown(table(engine.generator.chance), Math.random, free, engine.schema, (key) => engine.get(key), stay);
      if (groups.length > 1 && !isLocked(store, SEED)) values.push([SEED, String(engine.randomSeed())]);
      this.push();
      this.work.setAll(values);
      if (engine.schema.some(({ key, kind, group }) => kind === 'text' && stay.has(key) && free.includes(group))) this.tellKept(groups);
      // After all groups were randomised, the recipe is no variant of its preset.
      if (groups.length > 1) store.update({ preset: undefined });
    });
  }
}

/** The values of the recipe's preset. */
function presetIn({ state }: Store): string[] {
  return valuesIn(state.preset?.recipe ?? '');
}

/** A button with the icon of another button of the page. */
function signed(like: 'dice' | 'lock', words: string): HTMLButtonElement {
  const signs = Array.from(byId(like === 'lock' ? 'seed-lock' : 'dice').querySelectorAll('svg'), (sign) => sign.cloneNode(true));
  return make('button', { type: 'button', class: `key ${like}`, title: words, 'aria-label': words }, ...signs);
}
