/**
 * Messages beside the picture. Only the newest notice is shown. It disappears after the time that reading takes, unless
 * it is pointed at, has the focus, or shows that work goes on. Then the notice before it is shown. Errors stay until
 * dismissed.
 */
import { t } from '../words/words';
import { byId, make } from './dom';
import { followFocus, giveBack } from './message-focus';

/** Notices of the same topic replace each other. */
export type Topic = 'link' | 'value' | 'outline' | 'done' | 'files' | 'opened' | 'busy' | 'replaced' | 'offline' | 'trouble' | 'module' | 'part' | 'language' | 'remarks';

/** Milliseconds that a notice is shown: `letter` per letter, as a slow reader needs, but from `least` to `most`. */
const SHOWN = { least: 6000, letter: 70, most: 20_000 };

/** The notices that stay until something removes them. */
const staying = new WeakSet<Element>();
let timer = 0;
let watching: MutationObserver | undefined;

/** Shows one or more sentences that need no action. */
export function notice(topic: Topic, ...sentences: string[]): void {
  put('notices', topic, sentences);
}

/** Shows a sentence with `actions` below it, such as a way back. */
export function offerOf(topic: Topic, sentence: string, ...actions: HTMLElement[]): void {
  put('notices', topic, [sentence])?.append(make('div', { class: 'actions' }, ...actions));
}

/** Shows that work goes on. The message stays until the work ends or is stopped. */
export function underWay(topic: Topic, sentence: string, ...actions: HTMLElement[]): HTMLElement | undefined {
  const note = put('notices', topic, [sentence]);
  if (note) staying.add(note);
  note?.querySelector('.close')?.remove();
  note?.append(make('div', { class: 'actions' }, ...actions));
  return note;
}

/** Shows an error, with `actions` below the sentence. */
export function alertOf(topic: Topic, sentence: string, ...actions: HTMLElement[]): void {
  const note = put('alerts', topic, [sentence]);
  if (note && actions.length) note.append(make('div', { class: 'actions' }, ...actions));
}

/** Removes the messages of a topic. */
export function clear(topic: Topic): void {
  for (const note of document.querySelectorAll(`.message[data-topic="${topic}"]`)) remove(note);
}

/** Removes a message. If it is in use by keyboard, the focus goes back. */
export function remove(note: Element): void {
  const isUsed = note.querySelector(':focus-visible') !== null;
  note.remove();
  showNewest(byId('notices'));
  if (isUsed) giveBack();
}

function put(place: 'alerts' | 'notices', topic: Topic, sentences: string[]): HTMLElement | undefined {
  clear(topic);
  if (!sentences.length) return undefined;
  const close = make('button', { type: 'button', class: 'close', 'aria-label': t('dismiss'), title: t('dismiss') }, '×');
  const text =
    sentences.length === 1
      ? make('p', {}, sentences[0] ?? '')
      : make('div', {}, make('p', {}, t('things', { n: sentences.length })), make('ul', {}, ...sentences.map((sentence) => make('li', {}, sentence))));
  const note = make('div', { class: 'message', 'data-topic': topic }, text, close);
  close.addEventListener('click', () => remove(note));
  watching ??= watch();
  byId(place).append(note);
  return note;
}

/** Shows the newest notice alone after each change. */
function watch(): MutationObserver {
  const box = byId('notices');
  const observer = new MutationObserver(() => showNewest(box));
  observer.observe(box, { childList: true });
  for (const place of [box, byId('alerts')]) followFocus(place);
  for (const sign of ['pointerenter', 'pointerleave', 'focusin', 'focusout']) box.addEventListener(sign, () => wait(box));
  return observer;
}

function showNewest(box: HTMLElement): void {
  for (const note of box.children) if (note instanceof HTMLElement) note.hidden = note !== box.lastElementChild;
  wait(box);
}

/** Starts the timer that removes the newest notice. */
function wait(box: HTMLElement): void {
  clearTimeout(timer);
  const note = box.lastElementChild;
  if (!note || staying.has(note)) return;
  const time = Math.min(Math.max(SHOWN.least, SHOWN.letter * note.textContent.length), SHOWN.most);
  timer = window.setTimeout(() => (box.matches(':hover, :focus-within') ? undefined : note.remove()), time);
}
