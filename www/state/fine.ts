/** Whether the picture is shown as finely as the screen can: a choice of the visitor's. */
import { keep, kept } from '../base/storage';
import type { Store } from './store';

const CHOICE = 'fine';

/** The choice of the last visit; at first it is so, but where data is to be spared. */
export function wantsFine(): boolean {
  const choice = kept(CHOICE);
  const { connection } = navigator as { connection?: { saveData?: boolean } };
  return choice === undefined ? !connection?.saveData : choice === 'yes';
}

/** The views that end with the picture, which alone can be painted finer. */
const PICTURES = ['auto', 'picture'];

/** Whether a view, in the words of the module, is the picture and nothing over it, once it is finished. */
export function isPicture(view: string): boolean {
  return PICTURES.includes(view);
}

export function chooseFine(store: Store, fine: boolean): void {
  keep(CHOICE, fine ? 'yes' : 'no');
  store.update({ fine });
}
