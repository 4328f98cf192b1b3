/** What the visitor sees when the program itself broke. */
import { t } from '../words/words';
import { make } from '../base/dom';
import { alertOf } from '../base/messages';
import { address, reopen } from '../state/link';

/** Says it in words, with a link to the same recipe and a button that starts afresh. */
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
