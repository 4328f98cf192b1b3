/**
 * A figure as data. The drawing (`learn/draw`) and the runtime (`learn/figure`) follow it, and have no code for any single
 * figure. The state of a figure is its recipe, a step, and the place that is looked at; nothing else is kept.
 */
export type Language = 'en' | 'ja';
export type Words = Readonly<Record<Language, string>>;

/** Two bubbles at a step. Lengths are in stable distances, energies in k0, both as the engine gives them. */
export interface Moment {
  readonly step: number;
  /** The place of the left bubble, from its first place. */
  readonly left: number;
  /** The distance between the centres. */
  readonly w: number;
  /** How fast the distance grows. */
  readonly speed: number;
  /** The force on the right bubble: a push is positive. */
  readonly force: number;
  /** The energy of the pair, and that of its motion. */
  readonly energy: number;
  readonly motion: number;
}

/** A bubble of a pavement and the cell that was made of it, in shares of the picture's side. */
export interface Cell {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  readonly outline: readonly number[];
}

/** The numbers of one packing at all its steps, as far as they are made; the cells of a pavement, once it is finished. */
export interface Trace {
  readonly moments: readonly Moment[];
  readonly cells: readonly Cell[];
  /** The value of a parameter in the recipe; that of `held` is 1 if the left bubble is held, else 0. */
  readonly value: (key: string) => string;
}

/** A step with a name. */
export interface Stop {
  readonly key: string;
  readonly name: Words;
  /** The step, if there is one in these moments. */
  readonly find: (moments: readonly Moment[]) => number | undefined;
}

/** A number with a slider, a box and, on some plates, a grip. `key` is a parameter's, or `w`, or `mark`. */
export interface NumberHandle {
  readonly kind: 'number';
  readonly key: string;
  readonly name: Words;
  readonly symbol: string;
  readonly unit: Words;
  readonly from: number;
  readonly to: number;
  /** Strides: by arrow, finer with Shift, coarser by Page. */
  readonly stride: number;
  readonly fine: number;
  readonly coarse: number;
  readonly digits: number;
  /** The plates that have a grip for it. */
  readonly plates?: readonly number[];
}

export interface ChoiceHandle {
  readonly kind: 'choice';
  readonly key: string;
  readonly name: Words;
  readonly choices: readonly { readonly word: string; readonly name: Words }[];
}

export type Handle = NumberHandle | ChoiceHandle;

/** A drawing of a figure, and the packing that it shows. */
export interface Plate {
  readonly draw: 'force' | 'track' | 'valley' | 'pavement';
  readonly packing: number;
  readonly title?: Words;
}

/** A start that was let go of, and how it ended; `undefined` until that is seen. */
export interface Trial {
  readonly w: number;
  readonly parted: boolean;
}

/** All that a rule may look at. */
export interface Seen {
  readonly traces: readonly Trace[];
  readonly step: number;
  readonly trials: readonly Trial[];
  /** The mark on the curve. */
  readonly mark: number;
  /** The distance, apart from rest, at which the potential is 0. */
  readonly zero: number;
}

/** A question that the figure answers by its numbers. */
export interface Ask {
  readonly key: string;
  /** The answers in words, by the values of their buttons. */
  readonly answers: Readonly<Record<string, Words>>;
  /** The sentences on what happened and why, once it has happened. */
  readonly seen: (seen: Seen, language: Language) => string | undefined;
  /** Whether the place where the potential is 0 is shown from then on. */
  readonly showsZero?: boolean;
}

export interface Figure {
  readonly name: string;
  /** The words of the recipe, and what each packing has of its own. */
  readonly recipe: string;
  readonly packings: readonly Readonly<Record<string, string>>[];
  /** The last step, the one that the figure opens at, and what its steps are called. */
  readonly last: number;
  readonly opens: number;
  readonly steps: 'step' | 'layer';
  readonly plates: readonly Plate[];
  readonly stops: readonly Stop[];
  readonly handles: readonly Handle[];
  /** Handles in a fold. */
  readonly more: readonly Handle[];
  readonly mark?: number;
  readonly asks: readonly Ask[];
  readonly told: (seen: Seen, language: Language) => string;
}
