/**
 * Undo and redo of every change of the recipe. All changes of a drag are one step, which ends when it is let go.
 *
 * A link that is opened is a step like any other, so the work that was there is one step back.
 */
import type { Store } from './store';

/** Steps that are kept. */
const DEPTH = 400;

export class History {
  private readonly store: Store;
  /** The recipe of the last step. */
  private settled: string;

  constructor(store: Store) {
    this.store = store;
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
    const to = step(past, future, recipe);
    if (to.recipe === undefined) return;
    this.settled = to.recipe;
    this.store.update({ past: to.past, future: to.future, recipe: to.recipe, own: true });
  }

  private settle(): void {
    const { recipe, held, past } = this.store.state;
    if (held || recipe === this.settled) return;
    const before = this.settled;
    this.settled = recipe;
    this.store.update({ past: [...past, before].slice(-DEPTH), future: [] });
  }
}
