/** The reason why an outline was refused, or what it lost, as data. The page has the words. */
import type { EditorWord } from '../../words/editor';

export interface RefusalReason {
  word: EditorWord;
  values: Record<string, string | number>;
}

export class Refusal extends Error {
  readonly told: RefusalReason;
  readonly left: Count;

  constructor(word: EditorWord, values: RefusalReason['values'] = {}, left: Count = {}) {
    super(word);
    this.told = { word, values };
    this.left = left;
  }
}

/** Features of a drawing that an outline cannot have. */
export const LEFT = ['text', 'image', 'mask', 'filter', 'pattern', 'marker', 'clip', 'link', 'far', 'speck'] as const;

export type Left = (typeof LEFT)[number];

/** How many of each feature were left out. */
export type Count = Partial<Record<Left, number>>;
