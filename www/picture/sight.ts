/**
 * On a narrow page the picture stays in sight above the controls, and shrinks as the page goes under it. Its frame keeps
 * its height and sticks by the lower edge (styles/layout.css), so that nothing else moves; here is only the scale.
 */
import { byId, wantsStill } from '../base/dom';
import type { State, Store } from '../state/store';

/** A picture of less than this part of its size is to be looked at only: a press brings it back. */
const SMALL = 0.9;

/** What is done on the picture itself, and wants it large. */
const ON_PICTURE = ['editing', 'light', 'compare', 'turn'] as const satisfies readonly (keyof State)[];

export function keepInSight(store: Store): void {
  const frame = byId('frame');
  const enlarge = byId('enlarge');
  let due = 0;
  let above = 0;
  const fit = (): void => {
    due = 0;
    const { bottom, height } = frame.getBoundingClientRect();
    // Where the frame does not stick above the page's upper edge, the picture keeps its size.
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

/** Scrolls back to where the picture is large, where it is small now. */
function show(behavior: ScrollBehavior): void {
  if (byId('enlarge').hidden) return;
  scrollTo({ top: scrollY + byId('head').getBoundingClientRect().bottom, behavior: wantsStill() ? 'instant' : behavior });
}

/** Some browsers lay their keyboard over the page: what is left of it is told to the styles, and how much is hidden above it. */
function followKeyboard(changed: (above: number) => void): void {
  const seen = window.visualViewport;
  if (!seen) return;
  const follow = (): void => {
    // A page that is zoomed by two fingers is another thing.
    const covered = seen.scale < 1.01 && seen.height < innerHeight - 1;
    const { style } = document.documentElement;
    style.setProperty('--seen-height', covered ? `${seen.height}px` : '');
    style.setProperty('--seen-top', covered ? `${seen.offsetTop}px` : '');
    changed(covered ? seen.offsetTop : 0);
  };
  for (const sign of ['resize', 'scroll']) seen.addEventListener(sign, follow);
}
