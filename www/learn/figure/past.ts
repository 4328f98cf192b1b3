/** The past of a figure, which is kept while the figure is freed, far from the window or on another screen of a class. */
import type { Ask, Trial } from '../figures/figure';

export class Past {
  trials: readonly Trial[] = [];
  /** The furthest step of the present run that was seen. */
  furthest = 0;
  /** The questions that are answered. */
  readonly answered = new Set<Ask>();
}
