/** The words for surfaces in space, in the page's language. They are loaded with www/space, in both languages. */
import { en, ja } from '../strings/space.json';
import { wordsOf } from './words';

export const t = wordsOf({ en, ja });
