/** The editor's words, in the language in use. They come with it, in both languages. */
import { en, ja } from '../strings/editor.json';
import { wordsOf } from './words';

export type Word = keyof typeof en;

export const t = wordsOf({ en, ja });
