/** The page's storage in this browser. Only this file touches it, but for public/theme.js, which reads it. */

const PREFIX = 'bubblestone.';

/** The text kept under this name; undefined if there is none, or no storage. */
export function kept(name: string): string | undefined {
  try {
    return localStorage.getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Keeps a text for later visits; false if the storage is full or forbidden. */
export function keep(name: string, text: string): boolean {
  try {
    localStorage.setItem(PREFIX + name, text);
    return true;
  } catch {
    return false;
  }
}

/** Whether this is the first visit: nothing is kept yet. Remembers the visit. */
export function isFirstVisit(): boolean {
  try {
    const isFirst = !Object.keys(localStorage).some((name) => name.startsWith(PREFIX));
    keep('visited', 'yes');
    return isFirst;
  } catch {
    return true;
  }
}
