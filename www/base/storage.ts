/** The storage of this browser. No other file touches it, except www/start.js, which reads it. */

const PREFIX = 'bubblestone.';

/** The text stored under this name; undefined if there is none, or no storage. */
export function kept(name: string): string | undefined {
  try {
    return localStorage.getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Stores a text for later visits; false if the storage is full or forbidden. */
export function keep(name: string, text: string): boolean {
  try {
    localStorage.setItem(PREFIX + name, text);
    return true;
  } catch {
    return false;
  }
}

/** The text stored under this name for this tab alone; undefined if there is none, or no storage. */
export function keptInTab(name: string): string | undefined {
  try {
    return sessionStorage.getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Stores a text for this tab alone, if it can. */
export function keepInTab(name: string, text: string): void {
  try {
    sessionStorage.setItem(PREFIX + name, text);
  } catch {
    // The other storage has the text, or the address holds the work.
  }
}

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
