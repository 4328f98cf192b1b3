/** The words of what is taken away, in the language in use. They come with it, in both languages. */
import { wordsOf } from '../words';
import { en, ja } from '../strings/take.json';

export const t = wordsOf({ en, ja });
