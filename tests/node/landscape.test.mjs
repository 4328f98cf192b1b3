// The potential around a square, as the figures read it from the shipped module, and its bands.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleIn } from '../../scripts/lib/headless.mjs';
import { pageModule } from '../../scripts/lib/wasm.mjs';
import { figuresCode } from '../common/figures.mjs';

const PAPERS = String(Math.SQRT2 - 1);

/** Points of the grid for one stable distance. */
const FINE = 32;

/** @type {any} */
let module;
/** @type {any} */
let code;
/** @type {any} */
let survey;

before(async () => {
  module = await moduleIn(pageModule);
  code = await figuresCode();
  survey = new code.Survey(module);
});

/** The landscape for a weight and a radius, read in slices of some milliseconds. */
function landscape(weight = PAPERS, radius = PAPERS, budget = 1000, from = survey) {
  while (!from.advance(weight, radius, budget));
  return from.of(weight, radius);
}

/** The energy of two squares alone, the second one at a place from the first in stable distances. */
function alone(/** @type {string} */ weight, /** @type {string} */ radius, /** @type {number} */ x, /** @type {number} */ y) {
  const own = `cw=${weight}&cr=${radius}&given=0.5,0.5,1;${0.5 + x / 4},${0.5 + y / 4},0`;
  const studio = new module.Bubblestone(`outline=square&size=256&kind=square&cs=64&dir=constant&edge=open&pop=off&${own}`);
  studio.hold(0);
  while (['domain', 'fields'].includes(studio.stage())) studio.tick(100, 0);
  while (!studio.reach(100));
  const [energy] = studio.energyParts();
  studio.free();
  return energy;
}

/** The numbers of a figure with other values, and with its square dropped at a place, if one is given. */
function reading(/** @type {string} */ name, /** @type {Record<string, string>} */ values = {}, /** @type {[number, number] | undefined} */ place = undefined) {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
  const made = new code.Reading(module, figure, figure.recipe, {});
  for (const [key, text] of Object.entries(values)) made.change(key, text);
  if (place) made.move('given', 1, [0.5 + place[0] / 4, 0.5 - place[1] / 4], 0);
  while (!made.advance(1000));
  return { figure, made };
}

test('the wells lie at w = 1 for all weights, and the barrier between two is known', () => {
  for (const [weight, barrier] of [['0', 0], ['0.05', 0.009], [PAPERS, 0.046], ['0.2', undefined], ['1', undefined]]) {
    const { well, pass } = landscape(String(weight));
    assert.ok(Math.abs(well.w - 1) < 0.003, `${weight}: ${well.w}`);
    if (barrier !== undefined) assert.ok(Math.abs(pass.energy - well.energy - Number(barrier)) < 1e-4, `${weight}: ${pass.energy - well.energy}`);
    assert.ok(weight === '0' || pass.energy - well.energy > 0.008);
  }
});

test('many pairs in one packing have the potential of a pair alone', () => {
  for (const [weight, radius] of [[PAPERS, PAPERS], ['1', '0.8']]) {
    const { at } = landscape(weight, radius);
    for (const [x, y] of [[1, 0], [1.25, 0.5], [0.75, 0.75], [1.5, 1.25], [1.75, 0]]) {
      const energy = alone(String(weight), String(radius), x ?? 0, y ?? 0);
      assert.ok(Math.abs(at((x ?? 0) * FINE, (y ?? 0) * FINE) - energy) < 1e-12, `${x}, ${y}`);
      assert.equal(at((x ?? 0) * FINE, (y ?? 0) * FINE), at(-(y ?? 0) * FINE, (x ?? 0) * FINE));
    }
  }
});

test('a larger radius of the corner bubbles puts the wells farther away, a smaller one nearer', () => {
  for (const weight of ['0.2', PAPERS, '1']) {
    assert.ok(landscape(weight, '0.8').well.w > 1.04);
    assert.ok(landscape(weight, '0.2').well.w < 0.98);
  }
});

test('slices of any length make the same landscape, and another one may be asked for meanwhile', () => {
  const whole = landscape('0.3');
  const other = new code.Survey(module);
  assert.equal(other.advance('0.7', PAPERS, 0), false);
  const sliced = landscape('0.3', PAPERS, 0, other);
  for (let i = 0; i <= 64; i += 7) for (let j = -64; j <= 64; j += 9) assert.equal(sliced.at(i, j), whole.at(i, j));
  assert.deepEqual([sliced.well, sliced.pass], [whole.well, whole.pass]);
  other.free();
});

test('a machine so slow that each slice ends at once makes the same landscape', (context) => {
  const whole = landscape();
  let time = 0;
  context.mock.method(performance, 'now', () => (time += 100));
  const slow = new code.Survey(module);
  const sliced = landscape(PAPERS, PAPERS, 0, slow);
  slow.free();
  assert.deepEqual([sliced.ground, sliced.well, sliced.pass], [whole.ground, whole.well, whole.pass]);
});

test('a square that is dropped at 45 degrees stays without corner bubbles, and slides to an edge at little weight', () => {
  for (const [weight, slides] of [['0', false], ['0.05', true], [PAPERS, true]]) {
    const { made } = reading('wells', { cw: String(weight) }, [0.72, 0.69]);
    const end = code.neighbourAt(made, made.steps.length - 1);
    assert.ok(slides ? end.aside < 1 : end.aside > 42, `${weight}: ${end.aside}`);
    assert.ok(Math.abs(end.w - 1) < 0.01 && code.restsAt(made) !== undefined);
    assert.equal(code.reachesEdge(made) !== undefined, slides);
    made.free();
  }
});

test('the questions of the squares are answered by what they ask for', () => {
  const trial = (/** @type {string} */ weight) => {
    const { figure, made } = reading('wells', { cw: weight });
    return { figure, made, found: figure.trial(made, made.steps.length - 1) };
  };
  const [ring, little, papers] = ['0', '0.05', PAPERS].map(trial);
  const seen = (/** @type {any[]} */ trials) => ring?.figure.asks[0].seen({ traces: [little?.made], step: 200, trials, at: [] }, 'en');
  assert.equal(seen([ring?.found]), undefined);
  assert.equal(seen([ring?.found, papers?.found]), undefined);
  assert.match(seen([ring?.found, little?.found]), /at 0\.05 it slid to an edge.*0\.0090 k₀/);

  const ask = (/** @type {string} */ name, /** @type {Record<string, string>} */ values, /** @type {[number, number] | undefined} */ place = undefined) => {
    const { figure, made } = reading(name, values, place);
    return figure.asks[0].seen({ traces: [made], step: made.steps.length - 1, trials: [], at: [] }, 'en');
  };
  assert.match(ask('bump', { cw: '1' }), /rests at w = 1\.000/);
  assert.equal(ask('bump', { cw: '1', cr: '0.6' }), undefined);
  assert.equal(ask('slide', {}, [1.1, 0.6]), undefined);
  assert.match(ask('slide', {}, [-1.1, 0.6]), /the well on the left/);
  // A square that is put into the well has not slid.
  assert.equal(ask('slide', {}, [-1.05, 0.1]), undefined);
});

test('with corner bubbles nine squares share all their edges, without them they do not', () => {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === 'nine');
  const [without, corners] = figure.packings.map((/** @type {any} */ own) => {
    const made = new code.Reading(module, figure, figure.recipe, own);
    while (!made.advance(1000));
    return code.edgesOf(made.steps.at(-1) ? code.packedOf(made.steps.at(-1), made.side) : []);
  });
  assert.deepEqual([corners.edges.length, corners.neighbours], [12, 12]);
  assert.ok(without.edges.length < 8 && without.neighbours > 12);
});

test('the regions of a cone are circles, closed, and cut where the grid ends', () => {
  const cone = (/** @type {number} */ x, /** @type {number} */ y) => 10 - Math.hypot(x, y);
  const [low, high, none] = code.regions(cone, [-1, 20], [4, 7.5, 11]);
  assert.deepEqual([low.length, high.length, none.length], [1, 1, 0]);
  for (const [x, y] of high[0]) if (Math.min(x, y) >= 0) assert.ok(Math.abs(Math.hypot(x, y) - 2.5) < 0.1);
  const [quarter] = code.inside(low[0], [0, 20]);
  const [[x, y], [u, v]] = [quarter[0], quarter.at(-1)];
  assert.ok(Math.abs(Math.min(x, y)) < 1e-9 && Math.abs(Math.min(u, v)) < 1e-9);
  assert.ok(Math.abs(Math.hypot(x - u, y - v) - 6 * Math.SQRT2) < 0.1);
  const few = code.simplified(quarter, 0.05);
  assert.ok(few.length < quarter.length && few.length > 4);
  for (const [p, q] of few) assert.ok(Math.abs(Math.hypot(p, q) - 6) < 0.1);
});
