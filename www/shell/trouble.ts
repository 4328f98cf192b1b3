/** Messages, with buttons, that the visitor sees when the program has failed or a recipe gives no picture. */
import { t } from '../words/words';
import { make } from '../base/dom';
import { alertOf } from '../base/messages';
import { address, reopen } from '../state/link';
import type { Work } from '../state/work';

/** Shows the error, a link to the same recipe, and a button that starts with an empty recipe. */
export function tellCrash(error: unknown, link: string): void {
  console.error(error);
  const again = make('a', { href: address(link) }, t('crash_again'));
  again.addEventListener('click', (event) => {
    event.preventDefault();
    reopen(link);
  });
  const afresh = make('button', { type: 'button' }, t('crash_afresh'));
  afresh.addEventListener('click', () => reopen(''));
  alertOf('trouble', t('crash'), again, afresh);
}

/** A button that sets the value that the problem's sentence names, if it names one. */
export function remedies(work: Work): HTMLElement[] {
  const remedy = work.engine.remedy();
  if (!remedy) return [];
  const [key, value] = remedy;
  const button = make('button', { type: 'button' }, t('set_to', { value }));
  button.addEventListener('click', () => work.set(key, value));
  return [button];
}
