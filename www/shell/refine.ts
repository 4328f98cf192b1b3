/** What makes the finished picture finer comes when there is time, where the visitor wants it; without it there is the picture. */
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
