/** The focus goes back from a message that is removed: the next key press must not reach the page. */
import { isShown } from './dom';

/** The element that had the focus before the messages. */
let before: Element | undefined;

/** Remembers the element from which the focus comes to messages in this box. */
export function followFocus(box: HTMLElement): void {
  box.addEventListener('focusin', ({ relatedTarget }) => {
    const from = relatedTarget instanceof Element ? relatedTarget : undefined;
    if (!from?.closest('.message')) before = from;
  });
}

/**
 * Gives the focus to the element that had it before, else to the next message, else to the picture. Removed and disabled
 * elements, and those behind an open dialog, do not take it.
 */
export function giveBack(): void {
  const ways = [before, ...document.querySelectorAll('.message .close'), ...document.querySelectorAll('#cells, #turn')];
  for (const way of ways) {
    if (!(way instanceof HTMLElement) || !isShown(way)) continue;
    way.focus();
    if (way === document.activeElement) return;
  }
}
