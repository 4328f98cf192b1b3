/**
 * Style sheets that did not load. The bundler's loader asks for the sheets of a late part only once, so after a failure the
 * part would come without them.
 */
import { make } from './dom';

/** The addresses of sheets that are to be fetched again. */
const lost = new Set<string>();

/** Begins to note sheets that do not load. */
export function noteLostStyles(): void {
  const note = ({ target }: Event): void => {
    if (!(target instanceof HTMLLinkElement) || target.rel !== 'stylesheet') return;
    lost.add(target.href);
    target.remove();
  };
  document.addEventListener('error', note, { capture: true });
}

/** Fetches those sheets again. To be called before a part is loaded. Rejects if one fails again. */
export async function bringLostStyles(): Promise<void> {
  const all = [...lost];
  lost.clear();
  await Promise.all(all.map(brought));
}

function brought(href: string): Promise<unknown> {
  const sheet = make('link', { rel: 'stylesheet', crossorigin: '', href });
  return new Promise((resolve, reject) => {
    sheet.addEventListener('load', resolve);
    sheet.addEventListener('error', () => reject(new Error(href)));
    document.head.append(sheet);
  });
}
