/** What is wrong with an outline, or was left out of it, as data: the page has the words. */
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

/** What a drawing may have that an outline cannot. */
export const LEFT = ['text', 'image', 'mask', 'filter', 'pattern', 'marker', 'clip', 'link', 'far', 'speck'] as const;

export type Left = (typeof LEFT)[number];

/** How many of each were left out. */
export type Count = Partial<Record<Left, number>>;
