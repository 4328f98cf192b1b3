/** Keys that work anywhere on the page unless the focused element needs them itself. */
import { byId } from './dom';
import { Later } from './later';
import { isOffered, type Binding } from './binding';

const bindings: Binding[] = [];

const list = new Later(() => import('./key-list'));

/** Adds keys. The list shows them in this order. */
export function bindKeys(...more: Binding[]): void {
  bindings.push(...more);
}

/** Starts to listen to keys. The key `?` and a button show the list of keys. */
export function listenToKeys(): void {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.altKey || isComposed(event)) return;
    const combined = `${event.ctrlKey || event.metaKey ? 'ctrl+' : ''}${event.shiftKey && event.key.length > 1 ? 'shift+' : ''}${shifted(event)}`;
    const binding = bindings.find(({ keys, part }) => keys.includes(combined) && isOffered(part));
    if (!binding || (event.target instanceof Element && needs(event.target, event.key))) return;
    if (document.querySelector('dialog[open]')) return;
    event.preventDefault();
    if (!event.repeat || binding.repeats) binding.act(event.key.toLowerCase());
  });
  const show = (): void => list.ask(({ showKeys }) => showKeys(bindings));
  bindKeys({ keys: ['?'], word: 'keys', act: show });
  byId('keys-button').addEventListener('click', show);
}

/** Whether an input method takes this key. Safari tells so of the last key only by its number, 229. */
// eslint-disable-next-line @typescript-eslint/no-deprecated
function isComposed({ isComposing, keyCode }: KeyboardEvent): boolean {
  return isComposing || keyCode === 229;
}

/** The name of a key press. Letters have `shift+` only together with Ctrl, as signs such as `?` need Shift anyway. */
function shifted({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
  const letter = key.toLowerCase();
  return shiftKey && letter.length === 1 && (ctrlKey || metaKey) ? `shift+${letter}` : letter;
}

/** Whether this element uses this key itself. */
function needs(target: Element, key: string): boolean {
  if (target.matches('input[type=number], input[type=text], select, textarea')) return true;
  return key === ' ' && target.matches('button, summary, a, input:not([type=range])');
}
