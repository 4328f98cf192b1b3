/** The values of a slider, and the end of each drag. */

/**
 * Reports each value of a slider; `last` is false while it is dragged. Browsers fire no `change` event if a drag ends
 * at the value where it began, so the end of the press ends the drag, too.
 */
export function onSlide(slider: HTMLInputElement, report: (last: boolean) => void): void {
  let slides = false;
  const end = (): void => {
    // A slider that is gone belonged to another recipe.
    if (slides && slider.isConnected) report(true);
    slides = false;
  };
  // The events `input` and `change` of the release come after it.
  const risen = (): void => void setTimeout(end);
  slider.addEventListener('pointerdown', () => {
    for (const sign of ['pointerup', 'pointercancel'] as const) addEventListener(sign, risen, { capture: true, once: true });
  });
  slider.addEventListener('blur', end);
  slider.addEventListener('input', () => {
    slides = true;
    report(false);
  });
  slider.addEventListener('change', () => {
    slides = true;
    end();
  });
}
