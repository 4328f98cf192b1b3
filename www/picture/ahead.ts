/**
 * Runs a recipe unseen at full speed while it forms slowly on the screen, so that scripts need not wait.
 *
 * It provides stage, status and digest for scripts, and its studio is freed when the recipe is done.
 */
import { soon } from '../base/soon';
import { making } from '../module/run';
import type { Status } from '../module/types';
import { Engine } from '../state/engine';

/** Milliseconds of work at a time, between frames. */
const SLICE = 12;

export class Ahead {
  /** The results, once the planes are done; the studio that made them is freed by then. */
  planes: { digest: string; status: Status } | undefined;
  private readonly studio: Engine;
  private readonly tell: () => void;
  private readonly work: ReturnType<typeof making>;
  private isEnded = false;

  /** `tell` is called after each piece of work. */
  constructor(recipe: string, crashed: (error: unknown, link: string) => void, tell: () => void) {
    this.studio = new Engine(recipe, crashed);
    this.work = making(this.studio, SLICE);
    this.tell = tell;
    this.wait();
  }

  /** The current stage, 'done' at the end. */
  get stage(): string {
    return this.planes ? 'done' : this.studio.stage();
  }

  get status(): Status {
    return this.planes?.status ?? this.studio.status();
  }

  /** Stops the work and frees the studio. */
  end(): void {
    this.isEnded = true;
    this.studio.free();
  }

  private wait(): void {
    soon(() => this.isEnded || this.goOn());
  }

  private goOn(): void {
    if (!this.work.next().done) this.wait();
    else if (this.studio.stage() === 'done') {
      this.planes = { digest: this.studio.digest(), status: this.studio.status() };
      this.studio.free();
    }
    this.tell();
  }
}
