/** The figures of chapter 4 with their drawings. */
import { SQUARES } from '../figures/squares';
import { map } from './map';
import { ofPlaces, WIDTH, type Drawings } from './plate';
import { relief } from './relief';
import { section } from './section';
import { squares } from './squares';

export const drawings: Drawings = {
  figures: SQUARES,
  drawn: { squares: ofPlaces(squares), landscape: ofPlaces(map), relief: { height: WIDTH, draw: relief }, section: { height: WIDTH, draw: section } },
};
