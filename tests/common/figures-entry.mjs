// The parts of the figures that tests need, in one file for the bundler.
export { linked, measured } from './figures-measured.mjs';
export { FIGURES } from '../../www/learn/draw/chapters';
export { countOf, crowdAt, nearestTo, packedOf } from '../../www/learn/figures/crowds';
export { curveOf, lastStepOf, markedAt, stopsOf } from '../../www/learn/draw/picture';
export { Reading } from '../../www/learn/draw/reading';
export { stillOf } from '../../www/learn/draw/still';
export { between, parting, rest, touch, trialOf, turn } from '../../www/learn/figures/rules';
export { inside, regions, simplified } from '../../www/learn/draw/contours';
export { levels } from '../../www/learn/draw/levels';
export { Survey } from '../../www/learn/draw/landscape';
export { acrossOf, distance, innerEdges, lengthOf, nearestEdge, sumOf, triangleAt } from '../../www/learn/figures/joined';
export { edgesOf, neighbourAt, reachesEdge, restsAt } from '../../www/learn/figures/neighbour';
export { isCrowded, looksOf, marksAt, restless } from '../../www/learn/figures/population';
export { asSquare, degreesOf, placesOn, unitAt } from '../../www/learn/figures/directions';
export { force } from '../../www/learn/draw/force';
export { hatched } from '../../www/learn/draw/hatching';
export { mesh } from '../../www/learn/draw/mesh';
