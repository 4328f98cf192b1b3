/** The figures of chapter 2 with their drawings. */
import { MANY_BUBBLES } from '../figures/many-bubbles';
import { crowd } from './crowd';
import { lens } from './lens';
import { levels } from './levels';
import { ofPlaces, WIDTH, type Drawings } from './plate';
import { plot } from './plot';

export const drawings: Drawings = {
  figures: MANY_BUBBLES,
  drawn: { crowd: ofPlaces(crowd), lens: { height: WIDTH, draw: lens }, levels: { height: WIDTH, draw: levels }, plot: { height: WIDTH, draw: plot } },
};
