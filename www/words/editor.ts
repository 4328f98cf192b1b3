/** The editor's words in the page's language. They are loaded with the editor, in both languages. */
import { en, ja } from '../strings/editor.json';
import { wordsOf } from './words';

export type EditorWord = keyof typeof en;

export const t = wordsOf({ en, ja });
