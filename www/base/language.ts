/** The page's language: the visitor's choice, or the browser's. Words other than English are loaded when needed. */
import { t, translate } from '../words/words';
import { byIdAs } from './dom';
import { notice } from './messages';
import { keep, kept } from './storage';

/**
 * Uses the language chosen here before, or the first of the browser's that the page has. Where its words cannot be
 * loaded, the page stays English.
 */
export async function takeLanguage(): Promise<void> {
  const wanted = [kept('language'), ...navigator.languages].map((code) => code?.slice(0, 2));
  const known = [...byIdAs('language', HTMLSelectElement).options].map(({ value }) => value);
  if (wanted.find((code) => code && known.includes(code)) !== 'ja') return;
  const root = document.documentElement;
  // Hide the page: the English words would show for a moment, and the layout would shift.
  root.toggleAttribute('data-wordless', true);
  try {
    const japanese = await import('../strings/ja');
    translate('ja', japanese);
    for (const element of document.querySelectorAll<HTMLElement>('[data-t]')) fill(element, japanese.page);
  } catch {
    // The English words are there.
    notice('language', t('lost_language'));
  } finally {
    root.toggleAttribute('data-wordless', false);
  }
}

/** Reloads the page in another language. The work stays. */
export function speak(code: string): void {
  keep('language', code);
  location.reload();
}

/** `data-t="key title=other"`: the element's text, then attributes. */
function fill(element: HTMLElement, page: Record<string, string>): void {
  for (const part of (element.dataset['t'] ?? '').split(' ')) {
    const [name = '', key] = part.split('=');
    if (key === undefined) element.textContent = page[name] ?? '';
    else element.setAttribute(name, page[key] ?? '');
  }
}
