/**
 * The last work and its history, kept in this browser. Each tab keeps its own, too, so that a reload finds it. A tab
 * that overwrites the work of another tab puts the other's work aside; a new tab finds it at the start of its history.
 */
import { keep, keepInTab, kept, keptInTab } from '../base/storage';
import type { State, Store } from './store';

const WORK = 'work';

/** The works of other tabs, the newest first, and the most of them. */
const OTHERS = 'works';
const MOST_OTHERS = 3;

/** Milliseconds between two writes. */
const THROTTLE = 400;

export type LastWork = Pick<State, 'recipe' | 'past' | 'future' | 'own'>;

/** A stored work, with a word that differs between any two loads of the page. */
type Stored = LastWork & { page: string };

/** This tab's last work, else the last one of this browser; undefined if there is none, or it cannot be read. */
export function lastWork(): LastWork | undefined {
  const own = workIn(keptInTab(WORK));
  if (own) return own;
  const last = workIn(kept(WORK));
  const before = others().flatMap(({ past, recipe }) => [...past, recipe]);
  return last && { ...last, past: [...before, ...last.past] };
}

function workIn(text: string | undefined): Stored | undefined {
  try {
    return workOf(JSON.parse(text ?? 'null'));
  } catch {
    return undefined;
  }
}

function workOf(stored: unknown): Stored | undefined {
  if (!(stored instanceof Object)) return undefined;
  const { recipe, past, future, own, page } = stored as Partial<Record<keyof Stored, unknown>>;
  if (typeof recipe !== 'string' || !areLinks(past) || !areLinks(future)) return undefined;
  return { recipe, past, future, own: own === true, page: typeof page === 'string' ? page : '' };
}

function others(): Stored[] {
  try {
    const all: unknown = JSON.parse(kept(OTHERS) ?? '[]');
    return Array.isArray(all) ? all.map(workOf).filter((one) => one !== undefined) : [];
  } catch {
    return [];
  }
}

function areLinks(list: unknown): list is string[] {
  return Array.isArray(list) && list.every((link) => typeof link === 'string');
}

/** Writes each step of the work into the storage, soon after it, and notes in the store whether that worked. */
export function remember(store: Store): void {
  let timer = 0;
  const page = `${Date.now()}-${Math.random()}`;
  const write = (): void => {
    clearTimeout(timer);
    timer = 0;
    const { recipe, past, future, own } = store.state;
    const work = JSON.stringify({ recipe, past, future, own, page } satisfies Stored);
    putAside(page, [recipe, ...past, ...future]);
    keepInTab(WORK, work);
    // If the storage is full or forbidden, the link in the address still holds the work.
    if (keep(WORK, work)) store.update({ stored: true });
  };
  store.on(['recipe', 'past', 'future', 'own', 'held'], ({ held }) => {
    store.update({ stored: false });
    if (!held && !timer) timer = window.setTimeout(write, THROTTLE);
  });
  addEventListener('pagehide', () => timer && write());
}

/** Keeps the works of other pages, unless this page's history has them. */
function putAside(page: string, ours: string[]): void {
  const last = workIn(kept(WORK));
  const all = [...(last ? [last] : []), ...others()];
  const lost = all.filter((one, k) => one.own && one.page !== page && !ours.includes(one.recipe) && all.findIndex((other) => other.page === one.page) === k);
  if (lost.length || kept(OTHERS) !== undefined) keep(OTHERS, JSON.stringify(lost.slice(0, MOST_OTHERS)));
}
