/** Starts a page of the chapters: theme, language, marks of symbols, class mode, printing, and the figures. */
import { readSigns } from '../base/decimals';
import { byId, idle } from '../base/dom';
import { followTheme } from '../base/theme';
import { keepState, restore, takeScreen } from './carried';
import { mountFigures } from './figure/mount';
import { bindClass } from './lesson';

import './page.css';
import './lesson.css';
import './sheet.css';

const language = document.documentElement.lang === 'ja' ? 'ja' : 'en';

function button(id: string, act: () => void): void {
  const found = document.getElementById(id);
  if (!found) return;
  found.hidden = false;
  found.addEventListener('click', act);
}

/** Choosing an answer marks it and opens the discussion of the answers. */
function openReplies(ask: Element): void {
  const key = ask.getAttribute('data-ask') ?? '';
  const replies = document.querySelector<HTMLDetailsElement>(`[data-ask="${key}"] ~ details.answers`);
  ask.addEventListener('change', ({ target }) => {
    // A number of raised hands is no answer.
    if (!replies || !(target instanceof HTMLInputElement) || target.type !== 'radio') return;
    replies.open = true;
    for (const reply of replies.querySelectorAll<HTMLElement>('[data-reply]')) reply.toggleAttribute('data-chosen', reply.dataset['reply'] === target.value);
  });
}

/** Pointing at a symbol in a formula or a figure, or at its handle, marks the symbol everywhere. */
function markSymbols(): void {
  const mark = (target: EventTarget | null, isOn: boolean): void => {
    if (!(target instanceof Element)) return;
    const symbol = (target.closest('[data-symbol]') ?? target.closest('.handle')?.querySelector('[data-symbol]'))?.getAttribute('data-symbol');
    if (!symbol) return;
    for (const one of document.querySelectorAll(`[data-symbol="${symbol}"]`)) one.classList.toggle('marked', isOn);
  };
  for (const [on, off] of [['pointerover', 'pointerout'], ['focusin', 'focusout']] as const) {
    document.addEventListener(on, ({ target }) => mark(target, true));
    document.addEventListener(off, ({ target }) => mark(target, false));
  }
}

/** On paper the answers are unfolded. Those that the reader had not opened are folded again, as they would tell too much. */
function unfoldOnPaper(): void {
  let folded: readonly HTMLDetailsElement[] = [];
  addEventListener('beforeprint', () => {
    folded = [...document.querySelectorAll<HTMLDetailsElement>('details.answers:not([open])')];
    for (const fold of folded) fold.open = true;
  });
  addEventListener('afterprint', () => {
    for (const fold of folded) fold.open = false;
  });
}

/** Stores the site, so that the next lesson needs no connection. A failure changes nothing. */
async function store(): Promise<void> {
  await idle(3000);
  const offline = await import('../base/offline').catch(() => undefined);
  offline?.register(() => undefined);
}

function start(): void {
  byId('theme').hidden = false;
  followTheme();
  readSigns();
  button('print', () => print());
  unfoldOnPaper();
  const lesson = bindClass(language);
  const link = document.getElementById('language');
  if (link instanceof HTMLAnchorElement) keepState(link, lesson);
  for (const ask of document.querySelectorAll('[data-ask]')) openReplies(ask);
  restore();
  markSymbols();
  const screen = takeScreen();
  mountFigures(document, language);
  // Figures have read their state, which may belong to another screen.
  if (screen !== undefined) lesson?.begin(screen);
  addEventListener('load', () => void store());
}

start();
