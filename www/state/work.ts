/** Every change of the recipe in the store goes through here; the engine follows. */
import type { Module } from '../module/load';
import type { SceneStudio } from '../module/scene';
import type { Preset, Ring } from '../module/types';
import { clear, notice } from '../base/messages';
import { Arrivals } from './arrivals';
import type { Engine, SetResult } from './engine';
import type { State, Store } from './store';

/** How a link is opened. */
interface Opening {
  /** The link is the visitor's own work. */
  own?: boolean;
  /** The preset to name. By default it is the one that has this link. */
  preset?: Preset;
  /** Called once the link is open. */
  then?: () => void;
}

/** A second picture that changes with the page's own. */
export interface Partner {
  /** Copies a control's change from the recipe in the store. */
  follow(): void;
  step(): void;
  restart(): void;
}

export class Work {
  partner: Partner | undefined;
  readonly engine: Engine;
  readonly store: Store;
  private readonly arrivals: Arrivals;

  constructor(engine: Engine, store: Store) {
    this.engine = engine;
    this.store = store;
    store.on(['recipe'], ({ recipe }) => {
      if (engine.link() !== recipe) engine.open(recipe);
      const preset = presetOf(engine.presets, recipe, store.state.preset);
      const { word } = engine.generator;
      store.update(preset ? { preset, make: word } : { make: word });
    });
    this.arrivals = new Arrivals((coming) => store.update({ coming }));
  }

  /**
   * Calls `act` once a link can be opened: now, or when its generator is loaded. Another change by the visitor
   * cancels the wait.
   */
  reach(link: string, act: () => void): void {
    this.arrivals.reach(link, act);
  }

  /** Keeps the present recipe and cancels a link that is still loading. */
  stay(): void {
    this.arrivals.cancel();
  }

  /** Sets a parameter; `held` while a slider still moves. */
  set(key: string, text: string, held = false): void {
    notice('value', ...this.engine.set(key, text).sentences);
    this.changed(held);
  }

  /** Sets a parameter, but returns the notices instead of showing them. */
  write(key: string, text: string, held = false): SetResult {
    const told = this.engine.set(key, text);
    this.changed(held);
    return told;
  }

  /** Sets many values in one step, clamped to their limits. Returns the notices. */
  setAll(values: readonly (readonly [key: string, text: string])[], held = false): string[] {
    const sentences = values.flatMap(([key, text]) => this.engine.set(key, text).sentences);
    this.changed(held);
    return sentences;
  }

  /** Sets the rings of a free outline. Returns whether they were refused, and the notices. */
  outline(rings: Ring[], held = false): SetResult {
    const told = this.engine.setOutline(rings);
    this.changed(held);
    return told;
  }

  /** Opens another recipe, and shows the link's faults. */
  open(link: string, { own = false, preset, then }: Opening = {}): void {
    const { engine, store } = this;
    this.reach(link, () => {
      notice('link', ...engine.open(link));
      clear('value');
      clear('outline');
      const recipe = engine.link();
      const shown = preset ? { shown: preset, recipe } : presetOf(engine.presets, recipe);
      store.update({ recipe, own, preset: shown, make: engine.generator.word, held: false });
      then?.();
    });
  }

  /** Goes on with a studio that has begun to work on the visitor's own recipe. */
  adopt(studio: SceneStudio, module: Module, then: () => void): void {
    const { engine, store } = this;
    this.stay();
    engine.adopt(studio, module);
    notice('link', ...engine.notices());
    clear('value');
    store.update({ recipe: engine.link(), own: true, preset: undefined, make: engine.generator.word, held: false });
    then();
  }

  /** Makes exactly one packing step. */
  step(): void {
    this.engine.step();
    this.partner?.step();
  }

  /** Makes the steps again, and all stages after them. */
  restart(): void {
    this.engine.restart();
    this.partner?.restart();
  }

  private changed(held: boolean): void {
    this.stay();
    this.store.update({ recipe: this.engine.link(), held, own: true });
    this.partner?.follow();
  }
}

/** The preset with exactly this recipe; of several, which differ in their views only, the opened one. */
export function presetOf(presets: Preset[], recipe: string, opened?: State['preset']): State['preset'] {
  if (opened?.recipe === recipe) return opened;
  const found = presets.find(({ link }) => link.replace(/^#/, '') === recipe);
  return found && { shown: found, recipe };
}
