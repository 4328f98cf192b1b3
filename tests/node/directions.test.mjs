// Directions, as the figures read them from the shipped module: sums of a road's sides, walks that count quarter turns, strokes.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleIn } from '../../scripts/lib/headless.mjs';
import { pageModule } from '../../scripts/lib/wasm.mjs';
import { figuresCode } from '../common/figures.mjs';

/** @type {any} */
let module;
/** @type {any} */
let code;

before(async () => {
  module = await moduleIn(pageModule);
  code = await figuresCode();
});

/** A figure with its packings after changes. @param {string} name @param {Record<string, string>} [values] */
function opened(name, values = {}) {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
  const traces = figure.packings.map((/** @type {any} */ own) => {
    const made = new code.Reading(module, figure, figure.recipe, own);
    for (const [key, text] of Object.entries(values)) made.change(key, text);
    while (!made.advance(1000));
    return made;
  });
  return { figure, traces, directions: traces[0].directions };
}

/**
 * The sentence that answers a figure's first question in a state; undefined if it is not answered. @param {any} opened
 * @param {number[]} at @param {number} [step]
 */
const asked = ({ figure, traces }, at, step = figure.last) => figure.asks[0].seen({ traces, step, trials: [], at, zero: 0.718, isStill: true }, 'en');

test('in the middle of a road the printed sum vanishes, and the four-fold one is certain', () => {
  const { directions, traces } = opened('road');
  assert.ok(Math.hypot(...directions.terms([0.5, 0.5]).printed) < 1e-12 && directions.terms([0.5, 0.5]).share < 1e-12);
  for (let x = 0.275; x <= 0.7251; x += 0.0125) {
    const { list, printed, share } = directions.terms([x, 0.5]);
    assert.equal(list.length, 4);
    assert.ok(share < 0.02, `${x}: ${share}`);
    const sum = list.reduce((/** @type {number[]} */ [u = 0, v = 0], /** @type {any} */ term) => [u + term.printed[0], v + term.printed[1]], [0, 0]);
    assert.ok(Math.hypot(sum[0] - printed[0], sum[1] - printed[1]) < 1e-12 && Math.abs(Math.hypot(...printed) - share) < 1e-12);
    const { along, certainty } = directions.at([x, 0.5]);
    assert.ok(Math.abs(code.asSquare(code.degreesOf(along))) < 1e-9 && certainty > 1 - 1e-9);
  }
  // Off the centre, the sum that is left points across the road.
  const [across = 0, down = 0] = directions.terms([0.7, 0.5]).printed;
  assert.ok(Math.abs(down) > 100 * Math.abs(across));
  traces[0].free();
});

test('cutting a side changes the printed sum, and not our direction', () => {
  for (const at of [[0.5, 0.5], [0.35, 0.5], [0.7, 0.49]]) {
    const [whole, cut] = [opened('pieces'), opened('pieces', { pieces: '10' })];
    assert.deepEqual([whole.traces[0].value('pieces'), cut.traces[0].value('pieces')], ['1', '10']);
    assert.equal(cut.directions.terms(at).list.length, 13);
    const [before, after] = [whole, cut].map(({ directions }) => directions.at(at));
    const turn = code.asSquare(code.degreesOf(after.along) - code.degreesOf(before.along));
    assert.ok(Math.abs(turn) < 0.5 && Math.abs(after.certainty - before.certainty) < 1e-3, `${turn}`);
    const [[u, v], [p, q]] = [whole, cut].map(({ directions }) => directions.terms(at).printed);
    assert.ok(Math.hypot(p - u, q - v) > 0.1);
  }
});

test('the questions of the road are answered by a point in the middle, and by ten pieces', () => {
  const road = opened('road');
  for (const at of [[0.5, 0.455], [0.8, 0.5], [0.5, 0.49]]) assert.equal(asked(road, at), undefined);
  assert.match(asked(road, [0.5, 0.5]), /In the middle 0\.000 .* certainty 1\.00/);
  assert.doesNotMatch(asked(road, [0.5, 0.5]), /across/);
  assert.match(asked(road, [0.7, 0.5]), /0\.011 .*The small rest comes from the ends and points across/);
  assert.equal(asked(opened('pieces', { pieces: '9' }), [0.5, 0.5]), undefined);
  const ten = opened('pieces', { pieces: '10' });
  assert.equal(asked(ten, [0.9, 0.5]), undefined);
  assert.match(asked(ten, [0.5, 0.5]), /from 0\.00 to 0\.45 of its arrows’ lengths: it points along the road\. The four-fold direction changed by 0\.0°/);
});

/** The quarter turns of a whole walk. @param {any} directions @param {number[]} circle */
const count = (directions, circle) => directions.walk(circle).at(-1)?.quarters;

test('a walk counts four in a disc and round the hole of a ring, none in a square, and minus two in a fork', () => {
  const disc = opened('walk').directions;
  assert.deepEqual([[0.5, 0.5, 0.2], [0.5, 0.5, 0.35], [0.6, 0.55, 0.3], [0.7, 0.5, 0.1]].map((circle) => Math.abs(count(disc, circle))), [4, 4, 4, 0]);
  assert.equal(disc.singular().reduce((/** @type {number} */ sum, /** @type {any} */ { quarters }) => sum + quarters, 0), 4);
  const ring = opened('walk', { outline: 'annulus' }).directions;
  assert.deepEqual([[0.5, 0.5, 0.35], [0.5, 0.17, 0.06]].map((circle) => Math.abs(count(ring, circle))), [4, 0]);
  assert.deepEqual(ring.singular(), []);
  const square = opened('walk', { outline: 'square' }).directions;
  for (const circle of [[0.5, 0.5, 0.3], [0.3, 0.3, 0.1]]) assert.equal(Math.abs(count(square, circle)), 0);
  const fork = opened('fork').directions;
  assert.deepEqual([count(fork, [0.5, 0.43, 0.1]), Math.abs(count(fork, [0.5, 0.72, 0.08]))], [-2, 0]);
});

test('a walk has a place for each step, and none if it leaves the outline', () => {
  const { directions } = opened('walk');
  const way = directions.walk([0.5, 0.5, 0.3]);
  assert.equal(way.length, 73);
  assert.equal(way[0].quarters, 0);
  // In a disc the cross turns evenly.
  for (const [k, { quarters, place }] of way.entries()) {
    assert.ok(Math.abs(quarters - k / 18) < 0.02);
    assert.ok(Math.abs(Math.hypot(place[0] - 0.5, place[1] - 0.5) - 0.3) < 1e-12);
  }
  assert.deepEqual(way[72].place, way[0].place);
  assert.deepEqual(directions.walk([0.8, 0.5, 0.2]), []);
  for (const { place } of directions.field) assert.ok(Math.hypot(place[0] - 0.5, place[1] - 0.5) < 0.44);
});

test('an oval pulls the four singular points apart, and a walk round one of them counts one', () => {
  const { directions, traces } = opened('walk', { outline: 'square', height: '0.85' });
  assert.deepEqual([traces[0].value('outline'), traces[0].value('height')], ['polygon', '0.85']);
  const singular = directions.singular();
  assert.deepEqual(singular.map((/** @type {any} */ { quarters }) => quarters), [1, 1, 1, 1]);
  const [x, y] = singular.find((/** @type {any} */ { place }) => place[0] > 0.57 && place[0] < 0.65).place;
  assert.deepEqual([count(directions, [x, y, 0.04]), count(directions, [0.5, 0.5, 0.3])], [1, 4]);
});

test('the questions of the walks are answered by a whole walk that counts', () => {
  const walk = opened('walk');
  assert.equal(asked(walk, [0.7, 0.5, 0.1]), undefined);
  assert.equal(asked(walk, [0.5, 0.5, 0.35], 71), undefined);
  assert.equal(asked(walk, [0.8, 0.5, 0.3]), undefined);
  assert.match(asked(walk, [0.5, 0.5, 0.35]), /turned by 360°: four quarter turns/);
  assert.equal(asked(opened('walk', { outline: 'annulus' }), [0.5, 0.5, 0.35]), undefined);
  const fork = opened('fork');
  assert.equal(asked(fork, [0.5, 0.72, 0.08]), undefined);
  assert.match(asked(fork, [0.5, 0.43, 0.1]), /^Done: −2, two quarter turns against the walk\. 4 − 6 = −2/);
});

test('halfway between two strokes squares stand at the mean of their four-fold angles', () => {
  for (const [one, other, halfway, certainty] of [[10, 30, 19.7, 0.77], [10, 80, 0, 0.77], [30, 60, 45, 0.5]]) {
    const { directions, traces } = opened('halfway', { 'stroke-1': String(one), 'stroke-2': String(other) });
    assert.deepEqual([traces[0].value('stroke-1'), traces[0].value('stroke-2')], [String(one), String(other)]);
    const there = directions.at([0.5, 0.5]);
    assert.ok(Math.abs(code.asSquare(code.degreesOf(there.along) - Number(halfway))) < 0.05, `${one}, ${other}`);
    assert.ok(Math.abs(there.certainty - Number(certainty)) < 0.005);
  }
  const halfway = (/** @type {number} */ one, /** @type {number} */ other) => asked(opened('halfway', { 'stroke-1': String(one), 'stroke-2': String(other) }), []);
  for (const [one, other] of [[10, 30], [30, 60], [10, 55]]) assert.equal(halfway(Number(one), Number(other)), undefined);
  assert.match(halfway(10, 80), /To a square 80° is −10°, and the mean of 10° and −10° is 0°\. So halfway squares stand at 0\.0°, with certainty 0\.77/);
});

test('whole degrees have the unit vectors of cosine and sine, and right angles exact ones', () => {
  for (let degrees = -180; degrees <= 720; degrees += 7) {
    const [x, y] = code.unitAt(degrees);
    const angle = (degrees * Math.PI) / 180;
    assert.ok(Math.hypot(x - Math.cos(angle), y - Math.sin(angle)) < 1e-13, `${degrees}`);
  }
  assert.deepEqual([90, 180, 360].map((degrees) => code.unitAt(degrees).map((/** @type {number} */ value) => value + 0)), [[0, 1], [-1, 0], [1, 0]]);
});

test('figures without steps have no timeline, and none reads a step of a packing', () => {
  for (const name of ['quarter', 'road', 'pieces', 'halfway', 'walk', 'fork']) {
    const { figure, traces } = opened(name);
    const html = code.stillOf(module, name, 'en');
    assert.equal(html.includes('class="time"'), figure.last > 0, name);
    assert.ok(html.includes('data-do="again"'));
    for (const trace of traces) assert.equal(trace.steps.length, 0);
  }
});
