/** The state in the address: no other file reads or writes the address and the browser's history. */

/** Milliseconds between two changes of the address. */
const THROTTLE = 500;

/**
 * The most changes of each kind within SPAN milliseconds. Browsers limit their rate: Safari refuses more than a hundred
 * in half a minute, and a state that waits may be written just before another one. Beyond `pushState`, a new state
 * replaces the present one; beyond `replaceState`, it waits. The page's own history has each step in any case.
 */
const SPAN = 30_000;
const MOST = { pushState: 60, replaceState: 90 };

/** Marks the entries that the page wrote into the browser's history. */
const OURS = 'ours';

export class Link {
  /** How to write the next state: as a new entry of the browser's history, or in place of the present one. */
  next: 'push' | 'replace' = 'replace';
  private written = fragment();
  private waiting: string | undefined;
  private timer = 0;
  private last = -THROTTLE;
  /** The times of the last changes. */
  private times: number[] = [];

  /** `open` gets the fragment of an address that the visitor went to; `ours` is true if the page wrote it. */
  constructor(open: (fragment: string, ours: boolean) => void) {
    const moved = (): void => {
      if (fragment() === this.written) return;
      this.forget();
      this.written = fragment();
      open(this.written, history.state === OURS);
    };
    history.replaceState(OURS, '');
    addEventListener('hashchange', moved);
    addEventListener('popstate', moved);
    addEventListener('pagehide', () => this.flush());
  }

  /** Writes the state into the address: after a short wait, or at once as a new entry. */
  write(state: string): void {
    const how = this.next;
    this.next = 'replace';
    if (how === 'push') this.push(state);
    else this.replace(state);
  }

  private replace(state: string): void {
    if (state === (this.waiting ?? this.written)) return;
    this.waiting = state;
    if (this.timer) return;
    const soon = this.last + THROTTLE - performance.now();
    this.timer = window.setTimeout(() => this.flush(), Math.max(0, soon, this.wait('replaceState')));
  }

  private push(state: string): void {
    if (this.wait('pushState') > 0) {
      this.replace(state);
      return;
    }
    this.flush();
    if (state === this.written) return;
    this.enter(state, 'pushState');
  }

  private flush(): void {
    const state = this.waiting;
    this.forget();
    if (state !== undefined && state !== this.written) this.enter(state, 'replaceState');
  }

  /** Milliseconds until another change of this kind is allowed. */
  private wait(how: keyof typeof MOST): number {
    const now = performance.now();
    this.times = this.times.filter((time) => time > now - SPAN);
    const oldest = this.times[this.times.length - MOST[how]];
    return oldest === undefined ? 0 : oldest + SPAN - now;
  }

  private forget(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.waiting = undefined;
  }

  private enter(state: string, how: 'pushState' | 'replaceState'): void {
    this.written = state;
    this.last = performance.now();
    this.times.push(this.last);
    history[how](OURS, '', address(state));
  }
}

/** The word in the query that shows the picture alone, without the page around it. */
const EMBED = 'embed';

export function isEmbedded(): boolean {
  return new URLSearchParams(location.search).has(EMBED);
}

/** The address of the picture alone. */
export function embedAddress(state: string): string {
  const url = new URL(location.href);
  url.search = EMBED;
  url.hash = state;
  return url.href;
}

/** The address of the whole page, from the picture alone. */
export function pageAddress(state: string): string {
  const url = new URL(location.href);
  url.search = '';
  url.hash = state;
  return url.href;
}

/** The pieces of a state, as `key=value`, without those of these keys. */
function without(state: string, keys: readonly string[]): string[] {
  return state.split('&').filter((piece) => piece !== '' && !keys.some((key) => piece.startsWith(`${key}=`)));
}

/** The state with these values in place of its own. */
export function withValues(state: string, values: readonly (readonly [key: string, text: string])[]): string {
  const kept = without(state, values.map(([key]) => key));
  return [...kept, ...values.map(([key, text]) => `${key}=${text}`)].join('&');
}

/** The values of a state, as `key=value`. */
export function valuesIn(state: string): string[] {
  return without(state, ['v']);
}

/** The fragment of the address, without '#'. */
export function fragment(): string {
  return location.hash.replace(/^#/, '');
}

/** Takes a value out of the address, so that no copy of the address has it. '' if there is none. */
export function takeValue(key: string): string {
  const state = fragment();
  const own = state.split('&').find((piece) => piece.startsWith(`${key}=`));
  if (own === undefined) return '';
  history.replaceState(null, '', address(without(state, [key]).join('&')));
  return own.slice(key.length + 1);
}

/** Whether the visitor reloads the page. Its address may be a moment behind the work. */
export function isReload(): boolean {
  const [entry] = performance.getEntriesByType('navigation');
  return entry instanceof PerformanceNavigationTiming && entry.type === 'reload';
}

/** The whole address of a state. */
export function address(state: string): string {
  const bare = location.href.replace(/#.*$/s, '');
  return state ? `${bare}#${state}` : bare;
}

/** Reloads the page with a state. */
export function reopen(state: string): void {
  history.replaceState(null, '', address(state));
  location.reload();
}
