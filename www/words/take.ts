/** The words of what is taken away, in the language in use. They come with it, in both languages. */
import { en, ja } from '../strings/take.json';
import { wordsOf } from './words';

export const t = wordsOf({ en, ja });
