/** The figures of all chapters, by name. */
import type { Figure } from './figure';
import { TWO_BUBBLES } from './two-bubbles';

export const FIGURES: readonly Figure[] = TWO_BUBBLES;

export function figureOf(name: string): Figure | undefined {
  return FIGURES.find((figure) => figure.name === name);
}
