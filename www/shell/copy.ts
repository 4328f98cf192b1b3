/** Copies the link to the clipboard. */
import { t } from '../words/words';
import { notice } from '../base/messages';
import { address } from '../state/link';

export async function copyLink(link: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(address(link));
    notice('done', t('copied'));
  } catch {
    notice('done', t('not_copied', { link: address(link) }));
  }
}
