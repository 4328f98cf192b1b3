/** The recipe in the store, which the engine follows: everything that changes it goes this way. */
import type { Preset, Ring } from '../module/types';
import { clear, notice } from '../base/messages';
import { Arrivals } from './arrivals';
import type { Engine, Told } from './engine';
import type { State, Store } from './store';

/** How a link is opened. */
interface Opening {
  /** It is the visitor's own work. */
  own?: boolean;
  /** What it is called where it is not exactly a preset's link. */
  preset?: Preset;
  /** Called once it is open. */
  then?: () => void;
}

/** Another picture that goes along with the one at work. */
export interface Partner {
  /** Takes over what was changed by a control: the recipe in the store has it. */
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
      const preset = presetOf(engine.presets, recipe);
      const { word } = engine.generator;
      store.update(preset ? { preset, make: word } : { make: word });
    });
    this.arrivals = new Arrivals((coming) => store.update({ coming }));
  }

  /** Calls `act` once a link can be opened, at once or when its generator has come; a change that the visitor makes meanwhile comes first. */
  reach(link: string, act: () => void): void {
    this.arrivals.reach(link, act);
  }

  /** Stays with what there is, whatever was on its way. */
  stay(): void {
    this.arrivals.cancel();
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

  /** Many values in one step; those that do not fit are kept within their limits, and the answer is what is to be told of that. */
  setAll(values: readonly (readonly [key: string, text: string])[], held = false): string[] {
    const sentences = values.flatMap(([key, text]) => this.engine.set(key, text).sentences);
    this.changed(held);
    return sentences;
  }

  /** Rings of a free outline: whether they were refused, and what is to be said. */
  outline(rings: Ring[], held = false): Told {
    const told = this.engine.setOutline(rings);
    this.changed(held);
    return told;
  }

  /** A whole other recipe; a link's mistakes are told. */
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

  /** Exactly one packing step. */
  step(): void {
    this.engine.step();
    this.partner?.step();
  }

  /** All stages again. */
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

/** The preset that a recipe is. */
export function presetOf(presets: Preset[], recipe: string): State['preset'] {
  const found = presets.find(({ link }) => link.replace(/^#/, '') === recipe);
  return found && { shown: found, recipe };
}
