/** At most two figures of a page work at a time. */

/** A figure that wants to work. */
interface Worker {
  /** Stops its run, because another figure begins one. */
  pause(): void;
}

const MOST = 2;

export class Turns {
  private working: Worker[] = [];

  /** Whether this figure may work now. One that plays takes the turn of the figure that began first. */
  take(worker: Worker, isPlaying: boolean): boolean {
    if (this.working.includes(worker)) return true;
    if (this.working.length >= MOST) {
      if (!isPlaying) return false;
      this.working.shift()?.pause();
    }
    this.working.push(worker);
    return true;
  }

  leave(worker: Worker): void {
    this.working = this.working.filter((other) => other !== worker);
  }
}
