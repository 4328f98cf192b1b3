/** The page's language: the visitor's choice, or the browser's. Words other than English are loaded when needed. */
import { extend, language, t, translate } from '../words/words';
import { byIdAs } from './dom';
import { notice } from './messages';
import { keep, kept } from './storage';

/** The event on the window after a change of the language, for parts that are made again with other words. */
export const RETOLD = 'languagechange';

/** The words of the page's markup in one language, by key. The English ones are read from the markup. */
type Dictionary = Record<string, string>;
const english: Dictionary = {};

/**
 * Uses the language that the visitor chose before, or else the first of the browser's languages that the page has. If
 * its words cannot be loaded, the page stays English. `whole` adds the words of the second module.
 */
export async function takeLanguage(whole: boolean): Promise<void> {
  for (const element of document.querySelectorAll<HTMLElement>('[data-t]')) {
    for (const [name, key] of partsOf(element)) english[key] ??= textOf(element, name);
  }
  const wanted = [kept('language'), ...navigator.languages].map((code) => code?.slice(0, 2));
  const known = [...byIdAs('language', HTMLSelectElement).options].map(({ value }) => value);
  if (wanted.find((code) => code && known.includes(code)) !== 'ja') return;
  const root = document.documentElement;
  // Hide the page: the English words would show for a moment, and the layout would shift.
  root.toggleAttribute('data-wordless', true);
  try {
    const japanese = await import('../strings/ja');
    translate('ja', japanese);
    if (whole) await moreWords();
    const page: Dictionary = japanese.page;
    for (const element of document.querySelectorAll<HTMLElement>('[data-t]')) {
      for (const [name, key] of partsOf(element)) fill(element, name, page[key] ?? '');
    }
  } catch {
    // The page keeps its English words.
    notice('language', t('lost_language'));
  } finally {
    root.toggleAttribute('data-wordless', false);
  }
}

/** Loads the words of the second module. Without them, its parameters and presets keep their English. */
export async function moreWords(): Promise<void> {
  if (language() !== 'ja') return;
  const more = await Promise.all([import('../strings/ja-surface'), import('../strings/ja-pile'), import('../strings/ja-masonry'), import('../strings/ja-house')]).catch(() => []);
  for (const words of more) extend(words);
}

/** How often another language was asked for. */
let asked = 0;

/**
 * Changes the words on the page; nothing else changes. Only the language asked for last counts, as words may arrive in
 * another order. Rejects if they cannot be loaded.
 */
export async function speak(code: string): Promise<void> {
  const own = (asked += 1);
  const [{ retell }, japanese] = await Promise.all([import('./retell'), import('../strings/ja')]);
  if (own !== asked) return;
  keep('language', code);
  translate(code, code === 'ja' ? japanese : undefined);
  // The page may show surfaces, or show them later.
  await moreWords();
  if (own !== asked) return;
  const page: Record<'en' | 'ja', Dictionary> = { en: english, ja: japanese.page };
  retell(page, code === 'ja' ? 'ja' : 'en', partsOf);
  dispatchEvent(new Event(RETOLD));
}

/** The parts of `data-t="key title=other"`: the element's text ('') and attributes, each with the key of its words. */
function partsOf(element: HTMLElement): [name: string, key: string][] {
  const parts = (element.dataset['t'] ?? '').split(' ').map((part) => part.split('='));
  return parts.map(([name = '', key]) => (key === undefined ? ['', name] : [name, key]));
}

function textOf(element: Element, name: string): string {
  return (name ? element.getAttribute(name) : element.textContent) ?? '';
}

function fill(element: Element, name: string, text: string): void {
  if (name) element.setAttribute(name, text);
  else element.textContent = text;
}
