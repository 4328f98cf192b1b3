/** The dialogs for saving and sharing, each with a button at its end that closes it. */
import { t } from '../words/take';
import { make } from '../base/dom';
import { dialogOf } from '../late/dialog';
import '../styles/late/take.css';

export function takeDialog(id: string, title: string, ...body: HTMLElement[]): HTMLDialogElement {
  const close = make('button', { type: 'button', class: 'key', 'data-close': '' }, t('close'));
  const dialog = dialogOf(id, 'take', title, ...body, make('div', { class: 'take-end' }, close));
  close.addEventListener('click', () => dialog.close());
  return dialog;
}

/** A choice whose name only screen readers announce. */
export function select(id: string, name: string, options: Record<string, string>, value: string): HTMLSelectElement {
  const element = make('select', { id, 'aria-label': name }, ...Object.entries(options).map(([word, text]) => make('option', { value: word }, text)));
  element.value = value;
  return element;
}

/** A row of a dialog: a heading, a note, and the controls that export it. */
export function row(what: string, note: string, ...ways: HTMLElement[]): HTMLElement {
  const count = (tag: string): number => ways.filter(({ tagName }) => tagName === tag).length;
  // The words keep a column of their own only beside a few controls.
  const wide = ways.length > 3 || count('SELECT') > 1 || count('OUTPUT') > 0;
  return make(
    'section',
    { class: wide ? 'take-save take-wide' : 'take-save', role: 'group', 'aria-label': what },
    make('div', {}, make('h3', {}, what), make('p', { class: 'take-note' }, note)),
    make('div', { class: 'take-ways' }, ...ways),
  );
}

/** A number as the page's language writes it. */
export function shown(count: number): string {
  return count.toLocaleString(document.documentElement.lang);
}
