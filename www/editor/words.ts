/** The editor's words, which come with it, in the visitor's language. */
import * as english from '../strings/editor.en.json';
import { filled, language } from '../words';

export type EditorWord = Exclude<keyof typeof english, 'default'>;

const words: Record<EditorWord, string> = language() === 'ja' ? await import('../strings/editor.ja.json') : english;

/** The words of a key, with `{name}` replaced by values. */
export function tell(key: EditorWord, values: Record<string, string | number> = {}): string {
  return filled(words[key], values);
}
