/** The recipe in the store, which the engine follows: everything that changes it goes this way. */
import type { Preset, Ring } from '../module/types';
import { t } from '../words/words';
import { make } from '../base/dom';
import { alertOf, clear, notice } from '../base/messages';
import type { Engine, Told } from './engine';
import type { State, Store } from './store';

export class Work {
  readonly engine: Engine;
  readonly store: Store;

  constructor(engine: Engine, store: Store) {
    this.engine = engine;
    this.store = store;
    store.on(['recipe'], ({ recipe }) => {
      if (engine.link() !== recipe) engine.open(recipe);
      const preset = presetOf(engine.presets, recipe);
      store.update(preset ? { preset, ...this.made() } : this.made());
    });
    engine.arrived = (sentences, failed) => this.arrived(sentences, failed);
  }

  /** What is made, and that what is to be made is still on its way. */
  private made(): Pick<State, 'make' | 'held'> {
    const { engine, store } = this;
    return engine.waits ? { make: store.state.make, held: true } : { make: engine.generator.word, held: store.state.held };
  }

  /** The generator that a link needed is here, or cannot be had: then the picture that was there stays. */
  private arrived(sentences: string[], failed: boolean): void {
    const asked = this.store.state.recipe;
    const recipe = this.engine.link();
    if (failed) {
      const again = make('button', { type: 'button' }, t('module_again'));
      again.addEventListener('click', () => {
        clear('trouble');
        this.open(asked);
      });
      alertOf('trouble', sentences.join(' '), again);
    } else notice('link', ...sentences);
    this.store.update({ recipe, held: false, make: this.engine.generator.word, preset: presetOf(this.engine.presets, recipe) });
  }

  /** A parameter's new value; `held` while a slider is still on its way. */
  set(key: string, text: string, held = false): void {
    notice('value', ...this.engine.set(key, text).sentences);
    this.changed(held);
  }

  /** The same, but answers what is to be told instead of telling it. */
  write(key: string, text: string, held = false): Told {
    const told = this.engine.set(key, text);
    this.changed(held);
    return told;
  }

  /** Many values in one step; those that do not fit are kept within their limits. */
  setAll(values: readonly [key: string, text: string][]): void {
    for (const [key, text] of values) this.engine.set(key, text);
    this.changed(false);
  }

  /** Rings of a free outline: whether they were refused, and what is to be said. */
  outline(rings: Ring[], held = false): Told {
    const told = this.engine.setOutline(rings);
    this.changed(held);
    return told;
  }

  /** A whole other recipe; a link's mistakes are told. `preset` is what it is called where it is not exactly a preset's link. */
  open(link: string, own = false, preset?: Preset): void {
    notice('link', ...this.engine.open(link));
    clear('value');
    clear('outline');
    const recipe = this.engine.link();
    const shown = preset ? { shown: preset, recipe } : presetOf(this.engine.presets, recipe);
    this.store.update({ recipe, own, preset: shown, ...this.made(), held: this.engine.waits });
  }

  private changed(held: boolean): void {
    this.store.update({ recipe: this.engine.link(), held, own: true });
  }
}

/** The preset that a recipe is. */
export function presetOf(presets: Preset[], recipe: string): State['preset'] {
  const found = presets.find(({ link }) => link.replace(/^#/, '') === recipe);
  return found && { shown: found, recipe };
}
