/** Loads the smoothing of the finished picture, if the visitor wants it. Without it the plain picture stays. */
import type { View } from '../picture/view';
import type { Work } from '../state/work';

export function refine(work: Work, view: View): void {
  const { store } = work;
  let coming: Promise<unknown> | undefined;
  const bring = (): void => {
    if (store.state.fine) coming ??= import('../look/fine').then(({ keepFine }) => keepFine(work, view), () => (coming = undefined));
  };
  store.on(['fine'], bring);
  bring();
}
