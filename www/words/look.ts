/**
 * The words of the tools for a closer look and the page's own words, in the page's language. They are loaded with the
 * tools, in both languages.
 */
import { en, ja } from '../strings/look.json';
import { t as common, wordsOf, type PageWord as Common } from './words';

const own = wordsOf({ en, ja });

export type LookWord = Common | keyof typeof en;

/** An overlay's name, and a sentence about it; without them, its word and ''. */
export function overlayIn(word: string): [name: string, note: string] {
  const known = (key: string): string | undefined => (key in en ? own(key as keyof typeof en) : undefined);
  return [known(`over_${word}`) ?? word, known(`note_over_${word}`) ?? ''];
}

export function t(key: LookWord, values: Record<string, string | number> = {}): string {
  return key in en ? own(key as keyof typeof en, values) : common(key as Common, values);
}
