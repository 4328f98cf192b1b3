/**
 * The light and the dark theme. It follows the system until the visitor chooses the other one. www/start.js sets
 * it before the first paint.
 */
import { byId } from './dom';
import { keep, kept } from './storage';

const CHOICE = 'theme';

const system = matchMedia('(prefers-color-scheme: dark)');

/** The event on the window for parts that draw with the page's colours. */
export const REPAINT = 'theme';

const ofSystem = (): string => (system.matches ? 'dark' : 'light');

/** Binds the switch. Choosing the system's own theme makes the page follow the system again. */
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
  // The browser kept this page while another theme may have been chosen on the next one.
  addEventListener('pageshow', ({ persisted }) => {
    if (!persisted) return;
    chosen = kept(CHOICE) ?? chosen;
    show();
  });
  show();
}

function apply(theme: string): void {
  document.documentElement.dataset['theme'] = theme;
  byId('theme').setAttribute('aria-pressed', String(theme === 'dark'));
  for (const meta of document.querySelectorAll<HTMLMetaElement>('meta[name=theme-color]')) meta.media = meta.dataset['theme'] === theme ? 'all' : 'not all';
  dispatchEvent(new Event(REPAINT));
}
