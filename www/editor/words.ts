/** The editor's words, in the language in use. They come with it, in both languages. */
import { wordsOf } from '../words';
import { en, ja } from '../strings/editor.json';

export type EditorWord = keyof typeof en;

export const tell = wordsOf({ en, ja });
