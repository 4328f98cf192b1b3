// Joined cells as the figures read them, by the numbers of the shipped module: triangles, circles, facing angles, flips.
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

const figureOf = (/** @type {string} */ name) => code.FIGURES.find((/** @type {any} */ one) => one.name === name);

/** A packing of a figure, read to its end. @param {string} name @param {number} [packing] @param {Record<string, string>} [values] */
function reading(name, packing = 0, values = {}) {
  const figure = figureOf(name);
  const made = new code.Reading(module, figure, figure.recipe, figure.packings[packing]);
  for (const [key, text] of Object.entries(values)) made.change(key, text);
  return read(made);
}

/** @param {any} made */
function read(made) {
  while (!made.advance(1000));
  return made;
}

const RADIANS = Math.PI / 180;

test('the sine of the smallest angle is the shortest side over the circle’s diameter, and circles are empty', () => {
  for (const name of ['flip', 'close', 'place']) {
    const { points, triangles } = reading(name).joined(0);
    for (const { ids, angles, shortest, centre, radius } of triangles) {
      assert.ok(Math.abs(Math.sin(Math.min(...angles) * RADIANS) - shortest / (2 * radius)) < 1e-12);
      for (const [id, place] of points) {
        const apart = code.distance(place, centre) - radius;
        assert.ok(ids.includes(id) ? Math.abs(apart) < 1e-9 : apart > -1e-9);
      }
    }
  }
});

test('the angles that face an inner edge make at most half a turn', () => {
  for (const joined of [reading('flip').joined(0), reading('three').joined(0), reading('three', 1).joined(0)]) {
    const sums = code.innerEdges(joined).map(code.sumOf);
    assert.ok(sums.length > 10 && Math.max(...sums) <= 180 + 1e-9);
  }
});

test('the figures open with the angles that the text names', () => {
  const least = (/** @type {string} */ name) => Math.min(...reading(name).joined(0).triangles.flatMap((/** @type {any} */ { angles }) => angles));
  assert.ok(least('close') > 44);
  assert.equal(least('place').toFixed(0), '8');
  assert.equal(reading('close').joined(0).triangles.length, 13);
});

test('Lloyd’s rounds and the packing raise the median of the smallest angles', () => {
  const packed = reading('three');
  const after = (/** @type {number} */ rounds) => reading('three', 1, { rounds: String(rounds) }).joined(0).median.toFixed(0);
  const rest = packed.steps.length - 1;
  assert.ok(packed.isOver);
  assert.deepEqual([packed.joined(0).median.toFixed(0), after(4), after(20), packed.joined(5).median.toFixed(0), packed.joined(rest).median.toFixed(0)], ['32', '46', '48', '44', '56']);
  const { counts, faces } = packed.joined(rest);
  assert.equal(counts.length, 30);
  assert.equal(counts.reduce((/** @type {number} */ sum, /** @type {number} */ one) => sum + one, 0), faces.length);
});

test('the cell of a bubble inside has a side for each edge of it', () => {
  const made = reading('dual');
  const { told, at } = figureOf('dual');
  assert.match(told({ traces: [made], step: 4, at }, 'en'), /^41 bubbles and 41 cells\. Shown are all cells\. The marked bubble has 6 edges, and its cell 6 sides\. Of the 23 bubbles inside, 19 have six edges\./);
  const layers = [0, 1, 2, 3, 4].map((step) => told({ traces: [made], step, at }, 'en'));
  assert.equal(new Set(layers).size, 5, 'each layer has its text');
  made.change('cs', '44');
  const { points, cells } = read(made).joined(4);
  assert.equal(points.size, made.cells.length);
  assert.equal(cells.size, points.size);
});

/** Moves a point and reads what follows. @param {any} made @param {number} row @param {[number, number]} to */
function moved(made, row, to) {
  made.move('given', row, to, 0);
  return read(made);
}

test('the moment of a flip is found on the way of the point, and is kept while the new edge stays', () => {
  const made = reading('flip');
  assert.equal(made.flip, undefined);
  assert.equal(moved(made, 8, [0.42, 0.43]).flip, undefined);
  const { sum, before: old, points } = moved(made, 8, [0.42, 0.46]).flip;
  assert.ok(Math.abs(sum - 180) < 0.05);
  assert.deepEqual(old.ends, [6, 8]);
  assert.ok(Math.abs(points.get(8)[1] - 0.4453) < 1e-3);
  assert.ok(code.lengthOf(points, code.acrossOf(old)) > code.lengthOf(points, old.ends));
  assert.equal(moved(made, 8, [0.42, 0.47]).flip.sum, sum);
  assert.equal(moved(made, 6, [0.61, 0.13]).flip, undefined);
});

test('a change at the rim is no flip, and a long way has its first flip', () => {
  const made = reading('flip');
  const rim = () => made.joined(0).triangles.length;
  const before = rim();
  assert.equal(moved(made, 4, [0.31, 0.45]).flip, undefined);
  assert.notEqual(rim(), before);
  const { flip } = moved(reading('flip'), 8, [0.8, 0.85]);
  assert.ok(Math.abs(flip.sum - 180) < 0.05);
  assert.deepEqual(flip.before.ends, [6, 8]);
});

test('the edge and the triangle that are looked at', () => {
  const joined = reading('flip').joined(0);
  const edge = code.nearestEdge(joined, [0.515, 0.3]);
  assert.deepEqual(edge.ends, [6, 8]);
  assert.deepEqual([...code.triangleAt(joined, edge, [0.515, 0.3]).ids].sort(), [6, 8, 9]);
  assert.deepEqual([...code.triangleAt(joined, edge, [0.45, 0.26]).ids].sort(), [5, 6, 8]);
});
