/** The editor's words, in the language in use. They come with it, in both languages. */
import { en, ja } from '../strings/editor.json';
import { wordsOf } from './words';

export type EditorWord = keyof typeof en;

export const tell = wordsOf({ en, ja });
