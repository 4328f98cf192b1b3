/** The words for looking closer, in the language in use: the page's, and those that come later, in both languages. */
import { en, ja } from '../strings/look.json';
import { t as common, wordsOf, type Word as Common } from './words';

const own = wordsOf({ en, ja });

export type Word = Common | keyof typeof en;

/** A drawing's name, and the sentence about what one sees; its own word and nothing where there are none. */
export function overlayIn(word: string): [name: string, note: string] {
  const known = (key: string): string | undefined => (key in en ? own(key as keyof typeof en) : undefined);
  return [known(`over_${word}`) ?? word, known(`note_over_${word}`) ?? ''];
}

export function t(key: Word, values: Record<string, string | number> = {}): string {
  return key in en ? own(key as keyof typeof en, values) : common(key as Common, values);
}
