/** Keys that work anywhere on the page, except where the element in focus needs them itself, and the list of them. */
import { t, type Word } from '../words/words';
import { byId, byIdAs, closeFromBeside, make } from './dom';

interface Binding {
  /** By `KeyboardEvent.key` in lower case, with `ctrl+` and `shift+` before it; of Ctrl and Cmd either does. */
  keys: string[];
  /** How the list shows them, where not just in capitals. */
  shown?: string[];
  /** What they do, for the list. */
  word: Word;
  /** The part of the page that they serve, where only some generators offer it: without it there are no such keys. */
  part?: string;
  act: (key: string) => void;
  /** Holding the key down acts again and again. */
  repeats?: boolean;
}

const bindings: Binding[] = [];

/** Adds keys; the list has them in this order. */
export function bindKeys(...more: Binding[]): void {
  bindings.push(...more);
}

/** The keys that mean something only on the picture, or while points are edited, with their parts; they are told in the same list. */
const ON_PICTURE: readonly [shown: string[], word: Word, part: string][] = [
  [['← ↑ → ↓'], 'key_walk', 'probe'],
  [['← ↑ → ↓'], 'key_orbit', 'turn'],
  [['← ↑ → ↓'], 'key_around', 'space'],
  [['← ↑ → ↓'], 'key_move', 'outline'],
  [['Shift'], 'key_far', 'outline'],
  [['Shift'], 'key_snap', 'outline'],
  [['Ctrl'], 'key_whole', 'outline'],
  [['Insert'], 'key_insert', 'outline'],
  [['Delete'], 'key_delete', 'outline'],
  [['Enter'], 'key_turn', 'outline'],
  [['Enter'], 'key_finish', 'outline'],
  [['Esc'], 'key_escape', 'outline'],
];

/** Listens from now on, and shows the list under `?` and its button. */
export function listenToKeys(): void {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.altKey) return;
    const combined = `${event.ctrlKey || event.metaKey ? 'ctrl+' : ''}${event.shiftKey && event.key.length > 1 ? 'shift+' : ''}${shifted(event)}`;
    const binding = bindings.find(({ keys, part }) => keys.includes(combined) && isOffered(part));
    if (!binding || (event.target instanceof Element && needs(event.target, event.key))) return;
    if (document.querySelector('dialog[open]')) return;
    event.preventDefault();
    if (!event.repeat || binding.repeats) binding.act(event.key.toLowerCase());
  });
  const dialog = byIdAs('keys', HTMLDialogElement);
  const show = (): void => {
    const row = (shown: string[], word: Word): HTMLElement =>
      make('div', {}, make('dt', {}, ...shown.flatMap((key, k) => [...(k ? [' '] : []), make('kbd', {}, key)])), make('dd', {}, t(word)));
    byId('keys-list').replaceChildren(
      ...bindings.filter(({ part }) => isOffered(part)).map(({ keys, shown, word }) => row(shown ?? keys.map((key) => key.toUpperCase()), word)),
      ...ON_PICTURE.filter(([, , part]) => isOffered(part)).map(([shown, word]) => row([...shown], word)),
    );
    dialog.showModal();
    // The button to close it has the focus, and may be below what is to be seen.
    dialog.scrollTop = 0;
  };
  bindKeys({ keys: ['?'], word: 'key_keys', act: show });
  byId('keys-button').addEventListener('click', show);
  closeFromBeside(dialog);
}

/** Whether the page has this part now. */
function isOffered(part?: string): boolean {
  return part === undefined || (document.documentElement.dataset['offers'] ?? '').split(' ').includes(part);
}

/** Letters are bound with `shift+` only together with Ctrl; signs such as `?` need Shift anyway. */
function shifted({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
  const letter = key.toLowerCase();
  return shiftKey && letter.length === 1 && (ctrlKey || metaKey) ? `shift+${letter}` : letter;
}

/** Whether this element uses this key itself. */
function needs(target: Element, key: string): boolean {
  if (target.matches('input[type=number], input[type=text], select, textarea')) return true;
  return key === ' ' && target.matches('button, summary, a, input:not([type=range])');
}
