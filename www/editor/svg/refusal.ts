/** The reason why an outline was refused, or what it lost, as data. The page has the words. */
import type { Word } from '../../words/editor';

export interface Told {
  word: Word;
  values: Record<string, string | number>;
}

export class Refusal extends Error {
  readonly told: Told;
  readonly left: Count;

  constructor(word: Word, values: Told['values'] = {}, left: Count = {}) {
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
