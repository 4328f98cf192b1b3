/** The message that the visitor sees when the program itself has failed. */
import { t } from '../words/words';
import { make } from '../base/dom';
import { alertOf } from '../base/messages';
import { address, reopen } from '../state/link';

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
