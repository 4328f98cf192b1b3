/** The figures of chapter 6 with their drawings. */
import { HOW_MANY } from '../figures/how-many';
import { held, HEIGHT as HELD } from './held';
import { population, HEIGHT } from './population';
import type { Drawings } from './plate';
import { gripOf, numbersOf, thresholds } from './thresholds';

export const drawings: Drawings = {
  figures: HOW_MANY,
  drawn: {
    population: { height: HEIGHT, draw: population },
    thresholds: { height: HEIGHT, draw: thresholds, grip: (_view, _plate, key, [value = 0]) => gripOf(key, value), numbers: numbersOf },
    held: { height: HELD, draw: held },
  },
};
