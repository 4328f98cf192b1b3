/** The storage of this browser. No other file touches it, except www/start.js, which reads it. */

const PREFIX = 'bubblestone.';

/** A storage of the browser. Asking for it throws where storing is forbidden. */
type StoragePlace = () => Storage;

const BROWSER: StoragePlace = () => localStorage;
const TAB: StoragePlace = () => sessionStorage;

function textIn(place: StoragePlace, name: string): string | undefined {
  try {
    return place().getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

function put(place: StoragePlace, name: string, text: string): boolean {
  try {
    place().setItem(PREFIX + name, text);
    return true;
  } catch {
    return false;
  }
}

/** The text stored under this name; undefined if there is none, or no storage. */
export const kept = (name: string): string | undefined => textIn(BROWSER, name);

/** Stores a text for later visits; false if the storage is full or forbidden. */
export const keep = (name: string, text: string): boolean => put(BROWSER, name, text);

/** The text stored under this name for this tab alone; undefined if there is none, or no storage. */
export const keptInTab = (name: string): string | undefined => textIn(TAB, name);

/** Stores a text for this tab alone; false if the storage is full or forbidden. */
export const keepInTab = (name: string, text: string): boolean => put(TAB, name, text);

/** Whether nothing is stored from an earlier visit. Marks the visit, so that the next one is not the first. */
export function isFirstVisit(): boolean {
  try {
    const isFirst = !Object.keys(localStorage).some((name) => name.startsWith(PREFIX));
    keep('visited', 'yes');
    return isFirst;
  } catch {
    return true;
  }
}
