/** A worker that makes outlines of letters, one after another. */
import { serve } from '../../late/worker';
import { letters, type Letters, type LettersRequest } from './painted';

export type { Letters, LettersRequest };

serve((order: LettersRequest): Letters => letters(order));
