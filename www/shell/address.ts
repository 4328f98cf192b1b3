/** The address of the page: the recipe, and the view of an opened link until the visitor changes the view. */
import { t } from '../words/words';
import { make } from '../base/dom';
import { clear, offerOf } from '../base/messages';
import { Link } from '../state/link';
import type { State } from '../state/store';
import type { Preset } from '../module/types';
import { joined, parted, WHOLE } from '../state/viewing';
import type { Work } from '../state/work';
import type { Loop } from '../picture/loop';
import type { PageParts } from './parts';

/** The usual view. */
const USUAL: Partial<State> = { view: 'auto', overlays: [], zoom: WHOLE, camera: undefined, cut: undefined };

export class Address {
  private readonly work: Work;
  private readonly loop: Loop;
  private readonly linked: PageParts['linked'];
  private readonly undo: () => void;
  private readonly link: Link;
  /** The words of the view. */
  private words = '';
  /** True while the view of a link is being applied. */
  private showing = false;

  /** `undo` goes one step back in the history. */
  constructor(work: Work, loop: Loop, linked: PageParts['linked'], undo: () => void) {
    this.work = work;
    this.loop = loop;
    this.linked = linked;
    this.undo = undo;
    const { store } = work;
    this.link = new Link((fragment, ours) => this.open(fragment, ours));
    store.on(['recipe', 'view', 'overlays', 'pace', 'zoom', 'paused', 'turn', 'camera', 'cut'], () => this.leave());
    store.on(['body'], ({ body }) => {
      if (!body || !this.words.split('&').includes(`body=${body.subject}`)) this.leave();
    });
    store.on(['recipe'], () => {
      loop.until = undefined;
      this.write();
    });
    // If a recipe is abandoned before it is loaded, the address shows the present one again.
    store.on(['coming'], ({ coming }) => coming || this.write());
  }

  write(): void {
    this.link.write(joined(this.work.store.state.recipe, this.words));
  }

  /** Makes the next change an entry of its own in the browser's history. */
  push(): void {
    this.link.next = 'push';
  }

  /**
   * Opens a preset by one of its links, in its view. First returns to the usual view if the preset has a view of its
   * own, or if the view of another link is still shown.
   */
  openPreset(preset: Preset, link: string): void {
    const { work } = this;
    const isSet = this.words !== '' || preset.view !== '';
    const then = (): void => {
      if (isSet) {
        this.loop.until = undefined;
        work.store.update({ ...USUAL, turn: work.engine.offers('frames') });
      }
      this.show(preset.view, () => undefined);
    };
    work.open(link, { preset, then });
  }

  /** Applies a link's words of the view, then calls `then`. */
  show(words: string, then: () => void): void {
    const shown = (now: string): void => {
      this.words = now;
      this.name();
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

  /** Names the preset that has this view, if several presets share the recipe. */
  private name(): void {
    const { engine, store } = this.work;
    const { recipe } = store.state;
    const found = engine.presets.find(({ link, view }) => link === recipe && view === this.words);
    if (found) store.update({ preset: { shown: found, recipe } });
  }

  /** The visitor has changed the view of a link: the address holds the recipe alone again. */
  leave(): void {
    if (this.showing || this.words === '') return;
    this.words = '';
    this.write();
  }

  /** A link was opened over the visitor's own work; offers to undo that. */
  tellReplaced(): void {
    const back = make('button', { type: 'button' }, t('replaced_back'));
    back.addEventListener('click', () => {
      clear('replaced');
      this.undo();
    });
    offerOf('replaced', t('replaced'), back);
  }

  /** `ours` is true if the page itself had written this address before. */
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
