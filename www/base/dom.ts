/** Small helpers for plain elements. */

/** The element with this id; the page's own markup promises it. */
export function byId(id: string): HTMLElement {
  return byIdAs(id, HTMLElement);
}

/** The same, of a certain class. */
export function byIdAs<T extends Element>(id: string, kind: new () => T): T {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`The page has no element “${id}” that is a ${kind.name}.`);
  return found;
}

/** Makes an element with attributes ('' sets a bare one, undefined leaves it out) and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | undefined> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** Arrow keys go from button to button of a toolbar; only one of them is a stop for Tab. */
export function walkByArrows(toolbar: HTMLElement): void {
  toolbar.addEventListener('keydown', (event) => {
    const step = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    const shown = [...toolbar.querySelectorAll('button')].filter(isShown);
    const at = shown.findIndex((button) => button === event.target);
    if (!step || at < 0) return;
    event.preventDefault();
    const next = shown.at((at + step) % shown.length);
    for (const button of shown) button.tabIndex = button === next ? 0 : -1;
    next?.focus();
  });
}

/** A click beside a dialog closes it: what is there is its own ground, too. */
export function closeFromBeside(dialog: HTMLDialogElement): void {
  dialog.addEventListener('click', ({ target }) => target === dialog && dialog.close());
}

/** Whether an element is laid out now: neither it nor what it is in is hidden. */
export function isShown(element: Element): boolean {
  return element.getClientRects().length > 0;
}

/** Whether the visitor asks for less motion. */
export function wantsStill(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}

/** Waits until the browser has painted, or 200 ms where it does not, as in a hidden tab. */
export function frame(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, 200);
  });
}

/** The browser has nothing to do; where it does not tell, as Safari, some milliseconds pass. */
export function idle(otherwise: number): Promise<void> {
  return new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve());
    else setTimeout(resolve, otherwise);
  });
}

/** Sets a text only when it differs, so that idle frames touch nothing. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** A paper's symbol, the way it is printed: first letter in italics, the rest lowered. */
export function symbol(text: string): HTMLElement {
  const sign = make('i', { class: 'symbol' }, text.slice(0, 1));
  if (text.length > 1) sign.append(make('sub', {}, text.slice(1)));
  return sign;
}
