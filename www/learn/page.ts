/** Starts a page of the chapters: theme, language, marks of symbols, class mode, printing, and the figures. */
import { byId, idle } from '../base/dom';
import { followTheme } from '../base/theme';
import { mountFigures } from './figure/mount';
import { bindClass } from './lesson';

import './page.css';
import './lesson.css';

const language = document.documentElement.lang === 'ja' ? 'ja' : 'en';

function button(id: string, act: () => void): void {
  const found = document.getElementById(id);
  if (!found) return;
  found.hidden = false;
  found.addEventListener('click', act);
}

/** Makes the link to the other language open the same figure in the same state. */
function keepState(link: HTMLAnchorElement): void {
  const follow = (): void => {
    link.hash = location.hash;
  };
  // The figures write the address without an event.
  for (const event of ['pointerdown', 'focus', 'click']) link.addEventListener(event, follow);
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
  button('print', () => print());
  unfoldOnPaper();
  const link = document.getElementById('language');
  if (link instanceof HTMLAnchorElement) keepState(link);
  for (const ask of document.querySelectorAll('[data-ask]')) openReplies(ask);
  markSymbols();
  bindClass(language);
  mountFigures(document, language);
  addEventListener('load', () => void store());
}

start();
