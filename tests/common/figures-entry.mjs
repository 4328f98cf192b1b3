// The parts of the figures that tests need, in one file for the bundler.
export { FIGURES } from '../../www/learn/figures/figures';
export { stopsOf } from '../../www/learn/draw/picture';
export { Reading } from '../../www/learn/draw/reading';
export { between, parting, rest, touch, trialOf, turn } from '../../www/learn/figures/rules';
