/** The words of sharing and saving, in the page's language. Both languages are loaded together with the dialogs. */
import { en, ja } from '../strings/take.json';
import { wordsOf } from './words';

export const t = wordsOf({ en, ja });
