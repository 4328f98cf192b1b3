/** What is shown of a frame: its light, or a plane of it that else goes into files. */
import { t } from '../words/turn';
import { make } from '../base/dom';

/** Depth, normals and numbers are those of the module's maps; coverage is the picture's alpha with nothing behind. */
export type Plane = 'light' | 'depth' | 'normal' | 'id' | 'alpha';

const PLANES: readonly Plane[] = ['light', 'depth', 'normal', 'id', 'alpha'];

/** Where one of them is chosen; `chosen` is told. */
export function planes(chosen: (plane: Plane) => void): HTMLSelectElement {
  const options = PLANES.map((plane) => make('option', { value: plane }, t(`plane_${plane}`)));
  const select = make('select', { id: 'turn-plane', 'aria-label': t('plane'), title: t('plane') }, ...options);
  select.addEventListener('change', () => chosen(PLANES.find((plane) => plane === select.value) ?? 'light'));
  // What is done here is not for the frame, nor the picture below.
  for (const sign of ['click', 'dblclick', 'pointerdown', 'pointermove', 'touchstart', 'keydown']) select.addEventListener(sign, (event) => event.stopPropagation());
  return select;
}
