/** The part of the sheet that asks for a file which the recipe needs. */
import { t } from '../words/space';
import { byId, make } from '../base/dom';

export class FileRequest {
  private readonly choose: () => void;
  private element: HTMLElement | undefined;

  /** `choose` opens the browser's dialog for files. */
  constructor(choose: () => void) {
    this.choose = choose;
  }

  /** Asks for the file of this name; without a name, removes the question. */
  show(name: string | undefined): void {
    if (name === this.element?.dataset['name']) return;
    this.element?.remove();
    this.element = undefined;
    if (name === undefined) return;
    const open = make('button', { type: 'button', class: 'key', id: 'open-missing' }, t('open_name', { name }));
    open.addEventListener('click', this.choose);
    const text = make('div', { role: 'status' }, make('strong', {}, t('asked', { name })), make('p', {}, t('asked_why')));
    this.element = make('div', { class: 'asked', role: 'group', 'aria-label': t('asked_label'), 'data-name': name }, text, open, make('p', {}, t('drop')));
    // Events here are not for the picture below.
    for (const sign of ['click', 'dblclick', 'pointerdown', 'touchstart']) this.element.addEventListener(sign, (event) => event.stopPropagation());
    byId('sheet').append(this.element);
  }
}
