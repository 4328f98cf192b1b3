/** The seed: type it, randomise it, step to the next or previous one, or lock it. */
import { typedIn } from '../base/decimals';
import { byId, byIdAs } from '../base/dom';
import type { Engine } from '../state/engine';
import { isLocked, onLocks, toggleLock } from '../state/locks';
import type { Work } from '../state/work';

/** The largest seed, and the number of seeds kept to go back to. */
const MOST = 4_294_967_295;
const KEPT = 200;

export const SEED = 'seed';

export class Seed {
  private readonly box = byIdAs('seed', HTMLInputElement);
  private readonly back = byIdAs('seed-back', HTMLButtonElement);
  private readonly lock = byId('seed-lock');
  private readonly work: Work;
  private readonly engine: Engine;
  /** The seeds before the present one (`now`). */
  private before: string[] = [];
  private now: string;

  /** `push` is called before a change that the browser's Back button should undo. */
  constructor(work: Work, push: () => void) {
    const { engine, store } = work;
    this.work = work;
    this.engine = engine;
    this.now = engine.get(SEED);
    this.box.addEventListener('change', () => {
      const text = typedIn(this.box);
      // The text in a focused box is replaced by the engine's value only if the box is empty.
      this.box.value = '';
      this.take(text);
    });
    byId('dice').addEventListener('click', () => {
      push();
      this.take(String(engine.randomSeed()));
    });
    byId('seed-next').addEventListener('click', () => this.take(String(Number(this.now) >= MOST ? 0 : Number(this.now) + 1)));
    this.back.addEventListener('click', () => this.goBack());
    this.lock.addEventListener('click', () => toggleLock(store, SEED));
    store.on(['recipe'], () => this.show());
    onLocks(store, () => this.lock.setAttribute('aria-pressed', String(isLocked(store, SEED))));
    this.show();
  }

  private take(text: string): void {
    this.work.set(SEED, text);
    this.show();
  }

  private goBack(): void {
    const seed = this.before.pop();
    if (seed === undefined) return;
    this.now = seed;
    this.take(seed);
  }

  private show(): void {
    const seed = this.engine.get(SEED);
    if (seed !== this.now) this.before = [...this.before, this.now].slice(-KEPT);
    this.now = seed;
    // A disabled button would lose the focus: move it to the next button.
    if (!this.before.length && document.activeElement === this.back) byId('seed-next').focus();
    this.back.disabled = !this.before.length;
    if (document.activeElement !== this.box || this.box.value === '') this.box.value = seed;
  }
}
