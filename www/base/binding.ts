/** A binding of keys, and the part of the page that it serves. */
import type { KeysWord } from '../words/keys';

export interface Binding {
  /** `KeyboardEvent.key` in lower case, after `ctrl+` and `shift+`. `ctrl+` means Ctrl or Cmd. */
  keys: string[];
  /** The keys as the list of keys shows them. Without it, the list shows `keys` in capitals. */
  shown?: string[];
  /** The effect of the keys, as a word of the list of keys. */
  word: KeysWord;
  /** The part of the page that the keys serve. If a generator does not offer it, the keys do nothing. */
  part?: string;
  act: (key: string) => void;
  /** Holding the key down repeats the action. */
  repeats?: boolean;
}

/** Whether the page offers this part now. */
export function isOffered(part?: string): boolean {
  return part === undefined || (document.documentElement.dataset['offers'] ?? '').split(' ').includes(part);
}
