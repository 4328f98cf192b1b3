/** Lazy parts of the page, loaded at their first use. */
import { t } from '../words/words';
import { make } from './dom';
import { bringLostStyles } from './lost-styles';
import { alertOf, clear } from './messages';

export class Later<T> {
  /** The part, once it is loaded. */
  here: T | undefined;
  private readonly bring: () => Promise<T>;
  private coming: Promise<T | undefined> | undefined;
  /** Whether the last try failed, which a message tells. */
  private isLost = false;

  constructor(bring: () => Promise<T>) {
    this.bring = bring;
  }

  /** Loads the part once. Reports a failure, after which the next call tries again. */
  load(): Promise<T | undefined> {
    this.coming ??= bringLostStyles().then(this.bring).then(
      (part) => {
        // The message of another part, or of the turntable, stays.
        if (this.isLost) clear('part');
        this.isLost = false;
        return (this.here = part);
      },
      () => {
        this.coming = undefined;
        this.isLost = true;
        tellLost();
        return undefined;
      },
    );
    return this.coming;
  }

  /** Calls `act` with the part: now if it is loaded, else as soon as it is. Calls `lost` if it does not load. */
  ask(act: (part: T) => void, lost?: () => void): void {
    if (this.here !== undefined) act(this.here);
    else void this.load().then((part) => (part === undefined ? lost?.() : act(part)));
  }
}

/**
 * Tells that a part did not load. Another try is in vain in browsers that never fetch a script again, such as Firefox, and
 * after the site was replaced by a newer build. So the page can be loaded again, which keeps the work.
 */
export function tellLost(): void {
  const again = make('button', { type: 'button' }, t('reload'));
  again.addEventListener('click', () => location.reload());
  alertOf('part', t('lost_part'), again);
}
