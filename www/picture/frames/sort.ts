/** The sort of the bodies in a frame, which decides what one of them is called. */

export type Sort = 'stone' | 'scale' | 'body' | 'block' | 'feature' | 'cell' | 'element' | 'dart';

/** Views that show something else than bodies. */
const OTHERS: Record<string, Sort> = { packed: 'cell', cells: 'cell', mesh: 'element', darts: 'dart', fates: 'dart', polygons: 'element', plan: 'feature', parity: 'feature', occupancy: 'feature', seams: 'feature' };

/**
 * `stone` is the recipe's form of stones, '' without stones; `view` is the word of the view that is shown; `isLaid` tells
 * that the bodies are blocks of a wall.
 */
export function sortOf(stone: string, view = '', isLaid = false): Sort {
  return OTHERS[view] ?? (stone === 'skin' ? 'scale' : stone !== '' ? 'stone' : isLaid ? 'block' : 'body');
}
