/** Lazy parts of the page, loaded at their first use. */
import { t } from '../words/words';
import { alertOf, clear } from './messages';

export class Later<T> {
  /** The part, once it is loaded. */
  here: T | undefined;
  private readonly bring: () => Promise<T>;
  private coming: Promise<T | undefined> | undefined;

  constructor(bring: () => Promise<T>) {
    this.bring = bring;
  }

  /** Loads the part once. Reports a failure, after which the next call tries again. */
  load(): Promise<T | undefined> {
    this.coming ??= this.bring().then(
      (part) => {
        clear('part');
        return (this.here = part);
      },
      () => {
        this.coming = undefined;
        alertOf('part', t('lost_part'));
        return undefined;
      },
    );
    return this.coming;
  }

  /** Calls `act` with the part: now if it is loaded, else as soon as it is. */
  ask(act: (part: T) => void): void {
    if (this.here !== undefined) act(this.here);
    else void this.load().then((part) => part !== undefined && act(part));
  }
}
