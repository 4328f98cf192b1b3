/**
 * Undo and redo of every change of the recipe. A drag is one step, which ends when the pointer rises.
 *
 * Opening a link is a step like any other, so undo brings the previous work back.
 */
import type { Store } from './store';

/** Largest number of steps. */
const DEPTH = 400;

export class History {
  private readonly store: Store;
  private readonly reach: (link: string, act: () => void) => void;
  /** The recipe of the last step. */
  private settled: string;

  /** `reach` calls `act` once a link can be opened. */
  constructor(store: Store, reach: (link: string, act: () => void) => void) {
    this.store = store;
    this.reach = reach;
    this.settled = store.state.recipe;
    store.on(['recipe', 'held'], () => this.settle());
  }

  undo(): void {
    this.go((past, future, recipe) => ({ past: past.slice(0, -1), recipe: past.at(-1), future: [recipe, ...future] }));
  }

  redo(): void {
    this.go((past, future, recipe) => ({ past: [...past, recipe], recipe: future[0], future: future.slice(1) }));
  }

  private go(step: (past: readonly string[], future: readonly string[], recipe: string) => { past: string[]; recipe: string | undefined; future: string[] }): void {
    this.store.update({ held: false });
    const { past, future, recipe } = this.store.state;
    const { recipe: to, ...steps } = step(past, future, recipe);
    if (to === undefined) return;
    this.reach(to, () => {
      this.settled = to;
      this.store.update({ ...steps, recipe: to, own: true });
    });
  }

  private settle(): void {
    const { recipe, held, past } = this.store.state;
    if (held || recipe === this.settled) return;
    const before = this.settled;
    this.settled = recipe;
    this.store.update({ past: [...past, before].slice(-DEPTH), future: [] });
  }
}
