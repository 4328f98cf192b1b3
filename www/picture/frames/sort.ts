/** The sort of the bodies in a frame, which decides what one of them is called. */

export type Sort = 'stone' | 'scale' | 'body' | 'cell' | 'element' | 'dart';

/** Views that show something else than bodies. */
const OTHERS: Record<string, Sort> = { packed: 'cell', cells: 'cell', mesh: 'element', darts: 'dart', fates: 'dart' };

/** `stone` is the recipe's form of stones, '' without stones; `view` is the word of the view that is shown. */
export function sortOf(stone: string, view = ''): Sort {
  return OTHERS[view] ?? (stone === 'skin' ? 'scale' : stone === '' ? 'body' : 'stone');
}
