/** Locks against randomising and presets: groups of parameters, and the seed. The browser remembers them. */
import { keep, kept } from '../base/storage';
import type { Store } from './store';

const CHOICE = 'locks';

/** The locks of the last visit. */
export function keptLocks(): string[] {
  return (kept(CHOICE) ?? '').split('/').filter((name) => name !== '');
}

export function isLocked({ state }: Store, name: string): boolean {
  return state.locks.includes(name);
}

export function toggleLock(store: Store, name: string): void {
  const { locks } = store.state;
  const after = locks.includes(name) ? locks.filter((lock) => lock !== name) : [...locks, name];
  keep(CHOICE, after.join('/'));
  store.update({ locks: after });
}

/** Shows the locks now and after each change. */
export function onLocks(store: Store, show: () => void): void {
  store.on(['locks'], show);
  show();
}
