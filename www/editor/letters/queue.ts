/** Requests outlines of letters. While one is being made, only the latest of the waiting requests is kept. */
import { brokenBy } from '../../late/broken';
import type { Letters, LettersRequest } from './letters.worker';

export class LettersQueue {
  private readonly worker = new Worker(new URL('./letters.worker.ts', import.meta.url), { type: 'module' });
  private works = false;
  /** The answer of the present work is still wanted. */
  private wanted = false;
  private next: LettersRequest | undefined;

  /** `come` gets the outline that was requested last; `broke` gets the reason of a failure. */
  constructor(come: (letters: Letters) => void, broke: (reason: string) => void) {
    const over = (act: () => void): void => {
      this.works = false;
      const { next } = this;
      this.next = undefined;
      if (next) this.ask(next);
      else if (this.wanted) act();
    };
    this.worker.addEventListener('message', ({ data }: MessageEvent<Letters | { broken: string }>) => over(() => ('broken' in data ? broke(data.broken) : come(data))));
    this.worker.addEventListener('error', (event) => over(() => broke(brokenBy(event))));
  }

  ask(order: LettersRequest): void {
    this.wanted = true;
    if (this.works) {
      this.next = order;
      return;
    }
    this.works = true;
    this.worker.postMessage(order);
  }

  /** Drops all requests. */
  forget(): void {
    this.wanted = false;
    this.next = undefined;
  }

  end(): void {
    this.worker.terminate();
  }
}
