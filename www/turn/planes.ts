/** The choice between a frame's light and its data planes, which are usually saved to files. */
import { t } from '../words/turn';
import { make } from '../base/dom';
import type { Plane } from '../picture/frames/source';

const PLANES: readonly Plane[] = ['light', 'depth', 'normal', 'id', 'alpha'];

/** The control that chooses a plane, and calls `chosen` with it. */
export function planes(chosen: (plane: Plane) => void): HTMLSelectElement {
  const options = PLANES.map((plane) => make('option', { value: plane }, t(`plane_${plane}`)));
  const select = make('select', { id: 'turn-plane', 'aria-label': t('plane'), title: t('plane') }, ...options);
  select.addEventListener('change', () => chosen(PLANES.find((plane) => plane === select.value) ?? 'light'));
  // Events here are neither for the frame nor for the picture below.
  for (const sign of ['click', 'dblclick', 'pointerdown', 'pointermove', 'touchstart', 'keydown']) select.addEventListener(sign, (event) => event.stopPropagation());
  return select;
}
