/** The light and the dark page: as the system is, until the visitor wants the other one. public/theme.js begins before the first paint. */
import { byId } from './dom';
import { keep, kept } from './storage';

const CHOICE = 'theme';

const system = matchMedia('(prefers-color-scheme: dark)');

/** Who draws with the page's colours listens for this on the window. */
export const REPAINT = 'theme';

const ofSystem = (): string => (system.matches ? 'dark' : 'light');

/** Binds the switch. A choice that is the system's own follows the system again. */
export function followTheme(): void {
  let chosen = kept(CHOICE) ?? '';
  const show = (): void => apply(chosen || ofSystem());
  byId('theme').addEventListener('click', () => {
    const next = document.documentElement.dataset['theme'] === 'dark' ? 'light' : 'dark';
    chosen = next === ofSystem() ? '' : next;
    keep(CHOICE, chosen);
    show();
  });
  system.addEventListener('change', show);
  show();
}

function apply(theme: string): void {
  document.documentElement.dataset['theme'] = theme;
  byId('theme').setAttribute('aria-pressed', String(theme === 'dark'));
  for (const meta of document.querySelectorAll<HTMLMetaElement>('meta[name=theme-color]')) meta.media = meta.dataset['theme'] === theme ? 'all' : 'not all';
  dispatchEvent(new Event(REPAINT));
}
