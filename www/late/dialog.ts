/** Dialogs made by script. They go when they are closed, and give the focus back to where it was. */
import { closeFromBeside, make } from '../base/dom';

/** A heading and what it holds, shown at once. Escape and a click beside it close it. */
export function dialogOf(id: string, look: string, title: string, ...body: HTMLElement[]): HTMLDialogElement {
  const dialog = make('dialog', { id, class: look, 'aria-labelledby': `${id}-title` }, make('h2', { id: `${id}-title` }, title), ...body);
  closeFromBeside(dialog);
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
