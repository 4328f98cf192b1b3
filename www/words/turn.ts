/** The words of the turntable, in the page's language. They are loaded with it, in both languages. */
import { en, ja } from '../strings/turn.json';
import { wordsOf } from './words';

type TurnWord = keyof typeof en;

export const t = wordsOf({ en, ja });

/** Whether this is a word of the turntable. Some steps have none. */
export function isWord(word: string): word is TurnWord {
  return word in en;
}
