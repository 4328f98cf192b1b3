/** The last work and its history, kept in this browser. */
import { keep, kept } from '../base/storage';
import type { State, Store } from './store';

const WORK = 'work';

/** Milliseconds between two writes. */
const THROTTLE = 400;

export type LastWork = Pick<State, 'recipe' | 'past' | 'future' | 'own'>;

/** The last work; undefined if there is none, or it cannot be read. */
export function lastWork(): LastWork | undefined {
  try {
    const { recipe, past, future, own } = JSON.parse(kept(WORK) ?? 'null') as Record<keyof LastWork, unknown>;
    if (typeof recipe !== 'string' || !areLinks(past) || !areLinks(future)) return undefined;
    return { recipe, past, future, own: own === true };
  } catch {
    return undefined;
  }
}

function areLinks(list: unknown): list is string[] {
  return Array.isArray(list) && list.every((link) => typeof link === 'string');
}

/** Writes each step of the work into the storage, soon after it, and notes in the store whether that worked. */
export function remember(store: Store): void {
  let timer = 0;
  const write = (): void => {
    clearTimeout(timer);
    timer = 0;
    const { recipe, past, future, own } = store.state;
    // If the storage is full or forbidden, the link in the address still holds the work.
    if (keep(WORK, JSON.stringify({ recipe, past, future, own }))) store.update({ stored: true });
  };
  store.on(['recipe', 'past', 'future', 'own', 'held'], ({ held }) => {
    store.update({ stored: false });
    if (!held && !timer) timer = window.setTimeout(write, THROTTLE);
  });
  addEventListener('pagehide', () => timer && write());
}
