/** Dialogs made by script: a heading, what they hold, and the way out. Closed, they give the focus back to where it was. */
import { make } from '../base/dom';
import { t } from '../words/take';
import '../styles/take.css';

export function dialogOf(id: string, title: string, ...body: HTMLElement[]): HTMLDialogElement {
  const heading = make('h2', { id: `${id}-title` }, title);
  const close = make('button', { type: 'button', class: 'key', 'data-close': '' }, t('close'));
  const dialog = make('dialog', { id, class: 'take', 'aria-labelledby': `${id}-title` }, heading, ...body, make('div', { class: 'take-end' }, close));
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', ({ target }) => target === dialog && dialog.close());
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
