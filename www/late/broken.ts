/** Why a worker failed. */
import { t } from '../words/words';

/** The message of the error in a worker. If its script did not load, the browser sends none, and a sentence stands for it. */
export function brokenBy({ message }: Partial<ErrorEvent>): string {
  return message ?? t('lost_part');
}
