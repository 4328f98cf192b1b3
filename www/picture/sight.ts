/**
 * On a narrow page the picture stays visible above the controls, and shrinks as the page scrolls under it. Its frame keeps
 * its height and sticks by its lower edge (styles/layout.css), so nothing else moves. This file computes only the scale.
 */
import { byId, wantsStill } from '../base/dom';
import type { State, Store } from '../state/store';

/** A picture below this share of its size is only for viewing: a press scrolls back to it. */
const SMALL = 0.9;

/** Tools on the picture itself, which need it large. */
const ON_PICTURE = ['editing', 'light', 'compare', 'turn'] as const satisfies readonly (keyof State)[];

export function keepInSight(store: Store): void {
  const frame = byId('frame');
  const enlarge = byId('enlarge');
  let due = 0;
  let above = 0;
  const fit = (): void => {
    due = 0;
    const { bottom, height } = frame.getBoundingClientRect();
    // If the frame does not stick above the page's upper edge, the picture keeps its size.
    const least = 1 + Math.min(0, (parseFloat(getComputedStyle(frame).top) || 0) - above) / height;
    const scale = Math.min(1, Math.max(least, (bottom - above) / height));
    frame.style.setProperty('--shrunk', String(scale));
    enlarge.hidden = scale >= SMALL;
  };
  const soon = (): void => void (due ||= requestAnimationFrame(fit));
  addEventListener('scroll', soon, { passive: true });
  new ResizeObserver(soon).observe(frame);
  followKeyboard((top) => {
    above = top;
    soon();
  });
  enlarge.addEventListener('click', () => show('smooth'));
  for (const tool of ON_PICTURE) {
    store.on([tool], (state) => {
      if (state[tool]) show('instant');
    });
  }
}

/** Scrolls back to where the picture is large, if it is small now. */
function show(behavior: ScrollBehavior): void {
  if (byId('enlarge').hidden) return;
  // Round down: part of a pixel too far would shrink the picture.
  scrollTo({ top: Math.floor(scrollY + byId('head').getBoundingClientRect().bottom), behavior: wantsStill() ? 'instant' : behavior });
}

/**
 * Some browsers lay their keyboard over the page. This passes the visible height, and the height hidden above, to the
 * styles.
 */
function followKeyboard(changed: (above: number) => void): void {
  const seen = window.visualViewport;
  if (!seen) return;
  const follow = (): void => {
    // A zoom of the page by two fingers also shrinks the viewport, but it is no keyboard.
    const covered = seen.scale < 1.01 && seen.height < innerHeight - 1;
    const { style } = document.documentElement;
    style.setProperty('--seen-height', covered ? `${seen.height}px` : '');
    style.setProperty('--seen-top', covered ? `${seen.offsetTop}px` : '');
    changed(covered ? seen.offsetTop : 0);
  };
  for (const sign of ['resize', 'scroll']) seen.addEventListener(sign, follow);
}
