/**
 * Loads look/fine.ts, which lays finer pixels over the canvas, if the visitor wants them. It is loaded with the first
 * finished picture, or at a pause, when a drawing stands still. Without it the plain canvas stays.
 */
import { bringLostStyles } from '../base/lost-styles';
import type { View } from '../picture/view';
import type { Work } from '../state/work';

export function refine(work: Work, view: View, finished: Promise<unknown>): void {
  const { store } = work;
  let coming: Promise<unknown> | undefined;
  let isStill = false;
  const bring = (): void => {
    if (isStill && store.state.fine) coming ??= bringLostStyles().then(() => import('../look/fine')).then(({ keepFine }) => keepFine(work, view), () => (coming = undefined));
  };
  const rest = (): void => {
    isStill = true;
    bring();
  };
  store.on(['fine'], bring);
  store.on(['paused'], rest);
  void finished.then(rest);
}
