/** The last work and its history, kept in this browser: the only file that touches its storage, but for public/theme.js, which reads there. */
import type { State, Store } from './store';

const WORK = 'bubblestone.work';
const CHOICE = 'bubblestone.';

/** Milliseconds between two writings. */
const THROTTLE = 400;

export type LastWork = Pick<State, 'recipe' | 'past' | 'future' | 'own'>;

/** The last work; undefined where there is none, or it cannot be read. */
export function lastWork(): LastWork | undefined {
  try {
    const { recipe, past, future, own } = JSON.parse(localStorage.getItem(WORK) ?? 'null') as Record<keyof LastWork, unknown>;
    if (typeof recipe !== 'string' || !areLinks(past) || !areLinks(future)) return undefined;
    return { recipe, past, future, own: own === true };
  } catch {
    return undefined;
  }
}

function areLinks(list: unknown): list is string[] {
  return Array.isArray(list) && list.every((link) => typeof link === 'string');
}

/** Whether nothing is stored here from an earlier visit; from now on something is. */
export function isFirstVisit(): boolean {
  try {
    const isFirst = !Object.keys(localStorage).some((key) => key.startsWith(CHOICE));
    choose('visited', 'yes');
    return isFirst;
  } catch {
    return true;
  }
}

/** A choice of the visitor's about the page: its language, for one. */
export function choiceOf(name: string): string | undefined {
  try {
    return localStorage.getItem(CHOICE + name) ?? undefined;
  } catch {
    return undefined;
  }
}

export function choose(name: string, word: string): void {
  try {
    localStorage.setItem(CHOICE + name, word);
  } catch {
    // Without a storage the choice holds as long as the page does.
  }
}

/** Writes each step of the work into the storage, soon, and says in the store whether it is there. */
export function remember(store: Store): void {
  let timer = 0;
  const write = (): void => {
    clearTimeout(timer);
    timer = 0;
    const { recipe, past, future, own } = store.state;
    try {
      localStorage.setItem(WORK, JSON.stringify({ recipe, past, future, own }));
      store.update({ stored: true });
    } catch {
      // Full or forbidden: the link in the address still holds the work.
    }
  };
  store.on(['recipe', 'past', 'future', 'own', 'held'], ({ held }) => {
    store.update({ stored: false });
    if (!held && !timer) timer = window.setTimeout(write, THROTTLE);
  });
  addEventListener('pagehide', () => timer && write());
}
