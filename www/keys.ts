/** Keys that work anywhere on the page, except where the element in focus needs them itself. */

/** What a key does, by `KeyboardEvent.key` in lower case. */
export type Bindings = Record<string, () => void>;

export function bindKeys(bindings: Bindings): void {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const act = bindings[event.key.toLowerCase()];
    if (!act || (event.target instanceof Element && needs(event.target, event.key))) return;
    event.preventDefault();
    if (!event.repeat || event.key === '.' || event.key.toLowerCase() === 's') act();
  });
}

/** Whether this element makes something of this key. */
function needs(target: Element, key: string): boolean {
  if (target.matches('input[type=number], input[type=text], select, textarea')) return true;
  return key === ' ' && target.matches('button, summary, a, input:not([type=range])');
}
