// The population in the figures of the chapter "How many?": who is marked, and who comes and goes, by the shipped module.
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

/** The packings of a figure with other values. @param {string} name @param {Record<string, string>} [values] @returns {any[]} */
function readings(name, values = {}) {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
  return figure.packings.map((/** @type {any} */ own) => {
    const made = new code.Reading(module, figure, figure.recipe, own);
    for (const [key, text] of Object.entries(values)) made.change(key, text);
    while (!made.advance(1000));
    return made;
  });
}

/** The number of cells at the end. @param {any} trace */
const endOf = (trace) => code.marksAt(trace, Infinity).cells.length;

test('the marks before a look are what the look does', () => {
  for (const trace of readings('crowded')) {
    for (const { step, came, went } of code.looksOf(trace)) {
      const [before, after] = [code.marksAt(trace, step - 1), code.marksAt(trace, step)];
      assert.deepEqual([...before.leaving], went.map((/** @type {any} */ { id }) => id));
      assert.equal(after.cells.length, before.cells.length + came.length - went.length);
      assert.ok(after.cells.every((/** @type {any} */ { id }) => !before.leaving.has(id)));
      assert.equal(after.cells.filter((/** @type {any} */ { id }) => after.fresh.has(id)).length, came.length);
      assert.equal(before.empty.length, came.length);
    }
    assert.ok(code.marksAt(trace, Infinity).cells.every((/** @type {any} */ cell) => !code.isCrowded(trace, cell)));
  }
});

test('from too few and from too many the same number is reached', () => {
  assert.deepEqual(readings('crowded').map((trace) => [trace.isOver, endOf(trace)]), [[true, 34], [true, 34]]);
});

test('a hole: the papers’ rule leaves it at its own threshold and overfills at a lower one', () => {
  assert.deepEqual(readings('hole').map(endOf), [36, 37]);
  const [papers, ours] = readings('hole', { room: '0.97' });
  assert.equal(code.looksOf(papers)[0].came.length, 4);
  assert.deepEqual([papers.isOver, ours.isOver, endOf(ours)], [false, true, 37]);
});

test('a run is restless only if cells came and went at three looks in a row, all of which are seen', () => {
  const [calm] = readings('never');
  assert.equal(code.restless(calm, 100), undefined);
  const [crossed] = readings('never', { crowd: '0.95', room: '0.85' });
  assert.equal(code.restless(crossed, 29), undefined);
  assert.deepEqual(code.restless(crossed, 30).map((/** @type {any} */ { step }) => step), [10, 20, 30]);
  assert.equal(crossed.isOver, false);
});

test('equal areas hold different numbers, and which holds more depends on the size', () => {
  const held = (/** @type {string} */ cs) => readings('count', { cs }).map(endOf);
  assert.deepEqual([held('34'), held('28')], [[13, 19], [30, 29]]);
});

test('one number at the start needs no correction', () => {
  const changes = (/** @type {string} */ count) => readings('right-number', { count })[0].comings.map((/** @type {any} */ { came }) => came);
  assert.deepEqual(changes('36'), []);
  assert.ok(changes('30').every(Boolean) && changes('30').length > 0);
  assert.ok(changes('40').length > 0 && !changes('40').some(Boolean));
});
