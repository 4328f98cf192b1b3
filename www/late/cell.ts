/** The measures of a cell or a body as rows of a card, each with its name. */
import { t, type LookWord } from '../words/look';
import { make } from '../base/dom';
import { fixed } from '../base/fixed';
import { FEATURE, ROWS, TEXTS, type MeasureRow } from './measures';

/** A row's value; undefined if one of its numbers is unknown. */
function valueOf({ numbers, value }: MeasureRow, measures: ReadonlyMap<string, unknown>): string | undefined {
  const values: Record<string, string> = {};
  for (const [word, digits] of Object.entries(numbers)) {
    const number = measures.get(word);
    if (typeof number !== 'number') return undefined;
    values[word] = fixed(number, digits).replace('-', '−');
  }
  const [first = ''] = Object.values(values);
  const word = typeof value === 'object' ? value[Number(first)] : value;
  return word ? t(word, values) : first;
}

/**
 * The rows for the measures and the texts that a generator gives, by their words. A row that only repeats the card's
 * `title` is left out.
 */
export function cellNumbers(measures: object, texts: Readonly<Record<string, string>> = {}, title = ''): [name: string, value: string][] {
  const given = new Map<string, unknown>(Object.entries(measures));
  const rows = new Map<LookWord, string>();
  for (const row of ROWS) {
    const value = (row.text === undefined ? undefined : texts[row.text]) ?? valueOf(row, given);
    if (value !== undefined && value !== row.usual && !rows.has(row.name)) rows.set(row.name, value);
  }
  for (const [word, name] of Object.entries(TEXTS)) if (texts[word]) rows.set(name, texts[word]);
  return [...rows].filter(([, value]) => value !== title).map(([name, value]) => [t(name), value]);
}

/** The measures of `cellNumbers` as rows of a card. */
export function cellRows(...given: Parameters<typeof cellNumbers>): HTMLElement[] {
  return cellNumbers(...given).map(([name, value]) => make('div', {}, make('span', {}, name), make('b', {}, value)));
}

/** The name of a corner, an edge or a face, which is one of its measures. */
export function featureName(measures: object): string {
  return valueOf(FEATURE, new Map(Object.entries(measures))) ?? '';
}
