// The numbers of the chapters' figures, measured by a module: in Node, and in a browser.
import { FIGURES } from '../../www/learn/draw/chapters';
import { stopsOf } from '../../www/learn/draw/picture';
import { Reading } from '../../www/learn/draw/reading';
import { countOf, crowdAt } from '../../www/learn/figures/crowds';

/** Plates that show joined cells. */
const JOINED = new Set(['dual', 'mesh', 'delaunay']);

/**
 * A line for each stop of each figure, or for its opening if it has none: its name, the stop, its step, the hashes of the states, and the numbers of all bits.
 * @param {any} module
 * @returns {string[]}
 */
export function measured(module) {
  return FIGURES.flatMap((/** @type {any} */ figure) => {
    const readings = figure.packings.map((/** @type {any} */ own) => new Reading(module, figure, figure.recipe, own));
    for (const reading of readings) while (!reading.advance(1000));
    const stops = stopsOf(figure, readings);
    const lines = (stops.length ? stops : [{ key: 'opens', step: figure.opens }]).map((/** @type {any} */ { key, step }) => {
      const states = readings.flatMap((/** @type {any} */ reading) => {
        if (figure.steps === 'walk') return [reading.hashAt(step), ...directionsIn(reading, figure.at, step)];
        const { w, force, energy, motion } = reading.moments[step] ?? {};
        const crowd = crowdAt(reading, step);
        const ofCrowd = crowd ? [countOf(crowd), crowd.pairs, crowd.walls, crowd.motion, crowd.move] : [reading.cells.length];
        const ofJoined = figure.plates.some(({ draw }) => JOINED.has(draw)) ? joinedIn(reading, step) : [];
        return [reading.hashAt(step), ...(w === undefined ? ofCrowd : [w, force, energy, motion]), ...ofJoined];
      });
      return [figure.name, key, step, ...states].join(' ');
    });
    for (const reading of readings) reading.free();
    return lines;
  });
}

/**
 * A line for each packing of each figure, for the native test of the same list: its name, what its steps are, the place that is
 * looked at, and its link.
 * @param {any} module
 * @returns {string[]}
 */
export function linked(module) {
  return FIGURES.flatMap((/** @type {any} */ figure) =>
    figure.packings.map((/** @type {any} */ own) => {
      const reading = new Reading(module, figure, figure.recipe, own);
      const { link } = reading;
      reading.free();
      return [figure.name, figure.steps, placeOf(figure.at).join(','), link].join(' ');
    }),
  );
}

/** The place that is looked at, or else the middle, in sides of the picture. @param {number[]} at */
const placeOf = ([x = 0.5, y = 0.5]) => [x, y];

/** The number of Delaunay's triangles, the median of the mesh's smallest angles, and the smallest angle. @param {any} reading @param {number} step */
function joinedIn(reading, step) {
  const { triangles, median } = reading.joined(Math.min(step, Math.max(0, reading.steps.length - 1)));
  return [triangles.length, median, Math.min(...triangles.flatMap((/** @type {any} */ { angles }) => angles))];
}

/**
 * The direction at the place that is looked at, or else in the middle, with its certainty; how much is left of the printed sum,
 * or the quarter turns of a walk up to a step.
 * @param {any} reading @param {number[]} at @param {number} step
 * @returns {number[]}
 */
function directionsIn({ directions }, at, step) {
  const place = placeOf(at);
  const { along, certainty } = directions.at(place);
  return [...along, certainty, at.length > 2 ? directions.walk(at)[step].quarters : directions.terms(place).share];
}
