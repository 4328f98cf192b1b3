/** The list of keys and their effects, in a dialog. */
import { t, type KeysWord } from '../words/keys';
import { isOffered, type Binding } from './binding';
import { byId, byIdAs, closeFromBeside, make } from './dom';

const dialog = byIdAs('keys', HTMLDialogElement);
closeFromBeside(dialog);

/**
 * Keys that work only on the picture, or while points are edited, each with the part of the page that it serves. The
 * list shows them after the bindings.
 */
const ON_PICTURE: readonly [shown: string[], word: KeysWord, part: string][] = [
  [['← ↑ → ↓'], 'walk', 'probe'],
  [['← ↑ → ↓'], 'orbit', 'turn'],
  [['← ↑ → ↓'], 'around', 'space'],
  [['← ↑ → ↓'], 'move', 'outline'],
  [['Shift'], 'far', 'outline'],
  [['Shift'], 'snap', 'outline'],
  [['Ctrl'], 'whole', 'outline'],
  [['Insert'], 'insert', 'outline'],
  [['Delete'], 'delete', 'outline'],
  [['Enter'], 'turn', 'outline'],
  [['Enter'], 'finish', 'outline'],
  [['Esc'], 'escape', 'outline'],
];

/** Shows the keys whose part of the page is offered now. */
export function showKeys(bindings: readonly Binding[]): void {
  byId('keys-list').replaceChildren(
    ...bindings.filter(({ part }) => isOffered(part)).map(({ keys, shown, word }) => row(shown ?? keys.map((key) => key.toUpperCase()), word)),
    ...ON_PICTURE.filter(([, , part]) => isOffered(part)).map(([shown, word]) => row(shown, word)),
  );
  dialog.showModal();
  // The focused close button may be below the visible part.
  dialog.scrollTop = 0;
}

function row(shown: readonly string[], word: KeysWord): HTMLElement {
  return make('div', {}, make('dt', {}, ...shown.flatMap((key, k) => [...(k ? [' '] : []), make('kbd', {}, key)])), make('dd', {}, t(word)));
}
