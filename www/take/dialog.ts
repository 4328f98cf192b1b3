/** The dialogs of what is taken away, with a way out at their end. */
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
