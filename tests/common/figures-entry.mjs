// The parts of the figures that tests need, in one file for the bundler.
export { FIGURES } from '../../www/learn/figures/figures';
export { countOf, crowdAt, nearestTo, packedOf } from '../../www/learn/figures/crowds';
export { lastStepOf, stopsOf } from '../../www/learn/draw/picture';
export { Reading } from '../../www/learn/draw/reading';
export { stillOf } from '../../www/learn/draw/still';
export { between, parting, rest, touch, trialOf, turn } from '../../www/learn/figures/rules';
