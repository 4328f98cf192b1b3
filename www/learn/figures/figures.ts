/** The figures of all chapters, by name. */
import type { Figure } from './figure';
import { HOW_MANY } from './how-many';
import { MANY_BUBBLES } from './many-bubbles';
import { SQUARES } from './squares';
import { TWO_BUBBLES } from './two-bubbles';

export const FIGURES: readonly Figure[] = [...TWO_BUBBLES, ...MANY_BUBBLES, ...SQUARES, ...HOW_MANY];

export function figureOf(name: string): Figure | undefined {
  return FIGURES.find((figure) => figure.name === name);
}
