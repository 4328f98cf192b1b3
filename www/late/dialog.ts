/** Dialogs made by script. A closed dialog is removed and returns the focus to its former place. */
import { closeFromBeside, make } from '../base/dom';

/** Shows a dialog with a heading and a body. Escape and a click outside close it. */
export function dialogOf(id: string, look: string, title: string, ...body: HTMLElement[]): HTMLDialogElement {
  const dialog = make('dialog', { id, class: look, 'aria-labelledby': `${id}-title` }, make('h2', { id: `${id}-title` }, title), ...body);
  // Two presses while the code was loading ask for two.
  const earlier = document.getElementById(id);
  if (earlier instanceof HTMLDialogElement) earlier.close();
  closeFromBeside(dialog);
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
