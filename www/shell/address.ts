/** The address: the recipe, and the view that a link asked for, until the visitor goes on from that. */
import { t } from '../words/words';
import { make } from '../base/dom';
import { clear, offerOf } from '../base/messages';
import { Link } from '../state/link';
import type { State } from '../state/store';
import { joined, parted } from '../state/viewing';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import type { Parts } from './parts';

export class Address {
  private readonly work: Work;
  private readonly loop: Loop;
  private readonly linked: Parts['linked'];
  private readonly undo: () => void;
  private readonly link: Link;
  /** The words of the view. */
  private words = '';
  /** What changes now is what a link asked for. */
  private showing = false;

  /** `undo` goes one step back. */
  constructor(work: Work, loop: Loop, linked: Parts['linked'], undo: () => void) {
    this.work = work;
    this.loop = loop;
    this.linked = linked;
    this.undo = undo;
    const { store } = work;
    this.link = new Link((fragment, ours) => this.open(fragment, ours));
    store.on(['recipe', 'view', 'overlays', 'pace', 'zoom', 'paused', 'turn', 'camera'], () => this.leave());
    store.on(['recipe'], () => {
      loop.until = undefined;
      this.write();
    });
    // What did not come leaves the address of what is shown.
    store.on(['coming'], ({ coming }) => coming || this.write());
  }

  write(): void {
    this.link.write(joined(this.work.store.state.recipe, this.words));
  }

  /** The next change is an entry of its own in the browser's history. */
  push(): void {
    this.link.next = 'push';
  }

  /** Shows what a link's words of the view ask for, then goes on. */
  show(words: string, then: () => void): void {
    const shown = (now: string): void => {
      this.words = now;
      this.write();
      then();
    };
    if (words === '') return shown('');
    const change = (asked: Partial<State>): void => {
      this.showing = true;
      this.work.store.update(asked);
      this.showing = false;
    };
    void this.linked.load().then((it) => shown(it?.show(words, this.work, this.loop, change) ?? ''));
  }

  /** The visitor goes on from what a link asked for: the address has the recipe alone again. */
  leave(): void {
    if (this.showing || this.words === '') return;
    this.words = '';
    this.write();
  }

  /** A link was opened over work of the visitor's own: that is one step back. */
  tellReplaced(): void {
    const back = make('button', { type: 'button' }, t('replaced_back'));
    back.addEventListener('click', () => {
      clear('replaced');
      this.undo();
    });
    offerOf('replaced', t('replaced'), back);
  }

  /** `ours` says that the page had written this address before. */
  private open(fragment: string, ours: boolean): void {
    const { store } = this.work;
    const { own, recipe: before } = store.state;
    const { recipe, words } = parted(fragment);
    const then = (): void => {
      if (own && !ours && store.state.recipe !== before) this.tellReplaced();
    };
    this.work.open(recipe, { then: () => this.show(words, then) });
  }
}
