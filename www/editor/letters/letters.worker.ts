/** A worker that makes outlines of letters, one after another. */
import { serve } from '../../late/worker';
import { letters, type Letters, type Order } from './painted';

export type { Letters, Order };

serve((order: Order): Letters => letters(order));
