/** The state in the address: the only file that touches `location` and `history`. */

/** Browsers refuse addresses that change too often; Safari allows a hundred in half a minute. */
const THROTTLE = 500;

export class Link {
  private written = fragment();
  private waiting: string | undefined;
  private timer = 0;
  private last = -THROTTLE;

  /** `open` gets the fragment of an address that the visitor came to by other ways than the page's. */
  constructor(open: (fragment: string) => void) {
    const moved = (): void => {
      if (fragment() === this.written) return;
      this.forget();
      this.written = fragment();
      open(this.written);
    };
    addEventListener('hashchange', moved);
    addEventListener('popstate', moved);
    addEventListener('pagehide', () => this.flush());
  }

  /** Writes the state into the address, soon. */
  replace(state: string): void {
    if (state === (this.waiting ?? this.written)) return;
    this.waiting = state;
    if (this.timer) return;
    this.timer = window.setTimeout(() => this.flush(), Math.max(0, this.last + THROTTLE - performance.now()));
  }

  /** Writes the state as a new entry, so that the browser's Back button leads to the one before. */
  push(state: string): void {
    this.flush();
    if (state === this.written) return;
    this.write(state, 'pushState');
  }

  private flush(): void {
    const state = this.waiting;
    this.forget();
    if (state !== undefined && state !== this.written) this.write(state, 'replaceState');
  }

  private forget(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.waiting = undefined;
  }

  private write(state: string, how: 'pushState' | 'replaceState'): void {
    this.written = state;
    this.last = performance.now();
    history[how](null, '', address(state));
  }
}

/** The fragment of the address, without '#'. */
export function fragment(): string {
  return location.hash.replace(/^#/, '');
}

/** The whole address of a state. */
export function address(state: string): string {
  const bare = location.href.replace(/#.*$/s, '');
  return state ? `${bare}#${state}` : bare;
}

/** Loads the page anew with a state. */
export function reopen(state: string): void {
  history.replaceState(null, '', address(state));
  location.reload();
}
