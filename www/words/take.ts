/** The words of sharing and saving, in the page's language. They are loaded with them, in both languages. */
import { en, ja } from '../strings/take.json';
import { wordsOf } from './words';

export const t = wordsOf({ en, ja });
