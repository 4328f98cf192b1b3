/** The names of the components of piles. */
import type { Parameter } from '../module/types';

/** The parameter whose choices name all components. */
const KEY = 'c1';

/** The name of a component by its word, in the page's language; the word itself if it is unknown. */
export function componentIn(schema: readonly Pick<Parameter, 'key' | 'choices'>[], word: string): string {
  const row = schema.find(({ key }) => key === KEY);
  return row?.choices.find((choice) => choice.word === word)?.label ?? word;
}
