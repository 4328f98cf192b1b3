/** Parts of the page that are loaded when they are first asked for. */
import { t } from '../words/words';
import { alertOf, clear } from './messages';

export class Later<T> {
  /** The part, once it is here. */
  here: T | undefined;
  private readonly bring: () => Promise<T>;
  private coming: Promise<T | undefined> | undefined;

  constructor(bring: () => Promise<T>) {
    this.bring = bring;
  }

  /** Loads the part, once; tells where that failed, so that it can be tried again. */
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

  /** Calls `act` with the part: at once where it is here, else when it is loaded. */
  ask(act: (part: T) => void): void {
    if (this.here !== undefined) act(this.here);
    else void this.load().then((part) => part !== undefined && act(part));
  }
}
