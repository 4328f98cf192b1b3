/** The visitor's choice to see the picture as finely as the screen can. */
import { keep, kept } from '../base/storage';
import type { Store } from './store';

const CHOICE = 'fine';

/** The choice of the last visit. By default it is on, unless the browser saves data. */
export function wantsFine(): boolean {
  const choice = kept(CHOICE);
  const { connection } = navigator as { connection?: { saveData?: boolean } };
  return choice === undefined ? !connection?.saveData : choice === 'yes';
}

/** Whether frames of bodies are refined: unless the visitor chose otherwise, as that loads nothing. */
export function refinesBodies({ state }: Store): boolean {
  return state.fine || kept(CHOICE) === undefined;
}

/** Only these views end with the picture, which alone can be painted finer. */
const PICTURES = ['auto', 'picture'];

/** Whether a view, in the module's words, is the finished picture without overlays. */
export function isPicture(view: string): boolean {
  return PICTURES.includes(view);
}

export function chooseFine(store: Store, fine: boolean): void {
  keep(CHOICE, fine ? 'yes' : 'no');
  store.update({ fine });
}
