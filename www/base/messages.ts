/** Messages over the canvas: notices that may go by themselves, and errors that stay until dismissed. */
import { t } from '../words/words';
import { byId, make } from './dom';

/** Notices of the same topic replace each other. */
export type Topic = 'link' | 'value' | 'outline' | 'done' | 'files' | 'busy' | 'replaced' | 'offline' | 'trouble' | 'module' | 'part' | 'language' | 'remarks';

/** Milliseconds that a passing message stays. Longer texts stay until dismissed. */
const PASSING = 4000;

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
  note?.querySelector('.close')?.remove();
  note?.append(make('div', { class: 'actions' }, ...actions));
  return note;
}

/** Shows a short message that goes by itself. */
export function passing(topic: Topic, sentence: string): void {
  const note = put('notices', topic, [sentence]);
  setTimeout(() => note?.remove(), PASSING);
}

/** Shows an error, with `actions` below the sentence. */
export function alertOf(topic: Topic, sentence: string, ...actions: HTMLElement[]): void {
  const note = put('alerts', topic, [sentence]);
  if (note && actions.length) note.append(make('div', { class: 'actions' }, ...actions));
}

/** Removes the messages of a topic. */
export function clear(topic: Topic): void {
  for (const note of document.querySelectorAll(`.message[data-topic="${topic}"]`)) note.remove();
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
  close.addEventListener('click', () => note.remove());
  byId(place).append(note);
  return note;
}
