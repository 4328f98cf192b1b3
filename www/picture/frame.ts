/** Computes which part of the picture its frame shows. styles/stage.css lays the pane out in the same way. */
import type { Zoomed } from '../state/viewing';

/** From this zoom on, the picture's pixels are shown as squares. */
export const CRISP = 3;

export function layInFrame(sheet: HTMLElement, { scale, x, y }: Zoomed): void {
  sheet.style.setProperty('--zoom', String(scale));
  sheet.style.setProperty('--pan-x', String(0.5 - x * scale));
  sheet.style.setProperty('--pan-y', String(0.5 - y * scale));
  sheet.toggleAttribute('data-zoomed', scale > 1);
  sheet.toggleAttribute('data-crisp', scale >= CRISP);
}
