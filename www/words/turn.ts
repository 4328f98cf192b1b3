/** The words of the turntable, in the language in use. They come with it, in both languages. */
import { en, ja } from '../strings/turn.json';
import { wordsOf } from './words';

export type Word = keyof typeof en;

export const t = wordsOf({ en, ja });

/** Whether there are such words: of a step that is not known there are none. */
export function isWord(word: string): word is Word {
  return word in en;
}
