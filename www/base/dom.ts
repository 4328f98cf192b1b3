/** Small helpers for plain elements. */

/** The element with this id, which the page's markup guarantees. */
export function byId(id: string): HTMLElement {
  return byIdAs(id, HTMLElement);
}

/** The element with this id, which must be an instance of the class `kind`. */
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

/**
 * Enables a button, or disables it. A button in use by keyboard keeps the focus until that leaves: the next key press must
 * not reach another button, nor the page.
 */
export function enable(button: HTMLButtonElement, enabled: boolean): void {
  const stays = !enabled && button.matches(':focus-visible');
  button.disabled = !enabled && !stays;
  button.ariaDisabled = stays ? 'true' : null;
  if (stays) button.addEventListener('blur', () => button.ariaDisabled === 'true' && enable(button, false), { once: true });
}

/** Moves by arrow keys from button to button of a toolbar. Only one of them is a stop for Tab. */
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

/**
 * Closes a dialog by a press and a release beside it. Events on the backdrop have the dialog as their target, and so do those
 * on the dialog's own margins and gaps, where a finger may miss a button, and those of a drag that ends there.
 */
export function closeFromBeside(dialog: HTMLDialogElement): void {
  const isBeside = ({ target, clientX, clientY }: MouseEvent): boolean => {
    const { left, right, top, bottom } = dialog.getBoundingClientRect();
    return target === dialog && (clientX < left || clientX > right || clientY < top || clientY > bottom);
  };
  let began = false;
  dialog.addEventListener('pointerdown', (event) => (began = isBeside(event)));
  dialog.addEventListener('click', (event) => began && isBeside(event) && dialog.close());
}

/** Whether an element is laid out: neither it nor an ancestor is hidden. */
export function isShown(element: Element): boolean {
  return element.getClientRects().length > 0;
}

/** Whether the visitor prefers reduced motion. */
export function wantsStill(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}

/** Waits until the browser has painted, or 200 ms if it does not paint, as in a hidden tab. */
export function frame(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, 200);
  });
}

/** Waits until the browser is idle. In browsers that do not report it, such as Safari, waits some milliseconds. */
export function idle(otherwise: number): Promise<void> {
  return new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve());
    else setTimeout(resolve, otherwise);
  });
}

/** Sets a text only if it differs, so that idle frames change nothing. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** A paper's symbol as it is printed: the first letter in italics, the rest as a subscript. */
export function symbol(text: string): HTMLElement {
  const sign = make('i', { class: 'symbol' }, text.slice(0, 1));
  if (text.length > 1) sign.append(make('sub', {}, text.slice(1)));
  return sign;
}
