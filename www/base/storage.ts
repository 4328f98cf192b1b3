/** What this browser keeps of the page: the only file that touches its storage, but for public/theme.js, which reads there. */

const PREFIX = 'bubblestone.';

/** What was kept by this name; undefined where there is nothing, or no storage. */
export function kept(name: string): string | undefined {
  try {
    return localStorage.getItem(PREFIX + name) ?? undefined;
  } catch {
    return undefined;
  }
}

/** Keeps a text for later visits; false where the storage is full or forbidden. */
export function keep(name: string, text: string): boolean {
  try {
    localStorage.setItem(PREFIX + name, text);
    return true;
  } catch {
    return false;
  }
}

/** Whether nothing is kept here from an earlier visit; from now on something is. */
export function isFirstVisit(): boolean {
  try {
    const isFirst = !Object.keys(localStorage).some((name) => name.startsWith(PREFIX));
    keep('visited', 'yes');
    return isFirst;
  } catch {
    return true;
  }
}
