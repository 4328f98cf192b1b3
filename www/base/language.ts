/** The language of the page: the one that was chosen here, or the browser's. Words of other languages than English are loaded when they are needed. */
import { t, translate } from '../words/words';
import { byIdAs } from './dom';
import { notice } from './messages';
import { keep, kept } from './storage';

/** Takes the language that was chosen here before, or the first one of the browser's that the page has; English where its words do not come. */
export async function takeLanguage(): Promise<void> {
  const wanted = [kept('language'), ...navigator.languages].map((code) => code?.slice(0, 2));
  const known = [...byIdAs('language', HTMLSelectElement).options].map(({ value }) => value);
  if (wanted.find((code) => code && known.includes(code)) !== 'ja') return;
  const root = document.documentElement;
  // Else the English words would be seen for a moment, and the layout would shift.
  root.toggleAttribute('data-wordless', true);
  try {
    const japanese = await import('../strings/ja');
    translate('ja', japanese);
    for (const element of document.querySelectorAll<HTMLElement>('[data-t]')) fill(element, japanese.page);
  } catch {
    // The English ones are here.
    notice('language', t('lost_language'));
  } finally {
    root.toggleAttribute('data-wordless', false);
  }
}

/** Loads the page anew in another language; the work stays. */
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
