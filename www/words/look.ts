/** The words for looking closer, in the language in use: the page's, and those that come later, in both languages. */
import { en, ja } from '../strings/look.json';
import { t as common, wordsOf, type Word as Common } from './words';

const own = wordsOf({ en, ja });

export type Word = Common | keyof typeof en;

export function t(key: Word, values: Record<string, string | number> = {}): string {
  return key in en ? own(key as keyof typeof en, values) : common(key as Common, values);
}
