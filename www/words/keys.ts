/** The effects of keys in the page's language. They are loaded with the list of keys, in both languages. */
import { en, ja } from '../strings/keys.json';
import { wordsOf } from './words';

export type KeysWord = keyof typeof en;

export const t = wordsOf({ en, ja });
