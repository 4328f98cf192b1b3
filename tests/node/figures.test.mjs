// The figures of the chapters, by the numbers of the shipped module. After an intended change:
// `BUBBLESTONE_UPDATE=1 node --test tests/node/figures.test.mjs`.
import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { moduleIn } from '../../scripts/lib/headless.mjs';
import { pageModule } from '../../scripts/lib/wasm.mjs';
import { figuresCode, golden, goldenLinks, writeGolden } from '../common/figures.mjs';

/** @type {any} */
let module;
/** @type {any} */
let code;

before(async () => {
  module = await moduleIn(pageModule);
  code = await figuresCode();
});

/** The numbers of a figure with other values. @param {string} name @param {Record<string, string>} [values] */
function reading(name, values = {}) {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
  const [made] = figure.packings.map((/** @type {any} */ own) => new code.Reading(module, figure, figure.recipe, own));
  for (const [key, text] of Object.entries(values)) made.change(key, text);
  while (!made.advance(1000));
  return made;
}

test('each figure has the golden numbers at each stop, on a machine so slow that each slice ends at once', async (context) => {
  let time = 0;
  context.mock.method(performance, 'now', () => (time += 100));
  const [lines, links] = [code.measured(module), code.linked(module)];
  if (process.env.BUBBLESTONE_UPDATE) writeGolden(lines, links);
  assert.deepEqual(lines, golden());
  assert.deepEqual(links, goldenLinks());
  assert.equal(new Set(lines.map((line) => line.split(' ')[0])).size, code.FIGURES.length);
});

test('a start beyond 1.5 stays, and one at 0.6 with damping comes to rest', () => {
  const far = reading('let-go', { w: '1.6' });
  assert.ok(far.moments.every((/** @type {any} */ { w, force }) => Math.abs(w - 1.6) < 1e-4 && force === 0));
  const { moments } = reading('let-go');
  assert.ok(code.rest(moments) > code.turn(moments) && code.turn(moments) > code.touch(moments));
});

test('without damping the border between parting and coming back is where the potential is 0', () => {
  const trial = (/** @type {number} */ w, values = {}) => code.trialOf(reading('let-go', { damp: '0', w: String(w), ...values }), 200);
  const [parts, stays] = [trial(0.71), trial(0.725)];
  assert.ok(parts.parted && !stays.parted);
  assert.deepEqual(code.between([parts, stays], 0.02), [parts.value, stays.value]);
  assert.equal(code.between([parts, trial(0.8)], 0.02), undefined);
  // Explicit Euler gains energy, and damping takes it: neither tells where the border is.
  for (const values of [{ move: 'euler' }, { dt: '0.5' }, { damp: '0.1' }]) assert.equal(trial(0.7, values), undefined);
});

test('hands change the recipe: held or free, mass, stiffness', () => {
  const free = reading('pair', { held: '0' });
  assert.equal(free.value('held'), '0');
  assert.ok(free.moments[20].left < -0.01);
  const held = reading('pair');
  assert.ok(held.moments.every((/** @type {any} */ { left }) => left === 0));
  const heavy = reading('pair', { mass: '4' });
  assert.ok(heavy.moments[10].w < held.moments[10].w);
  assert.ok(reading('pair', { stiff: '4' }).moments[10].w > held.moments[10].w);
});

test('each handle acts up to both ends of its range, and its choices are those of the recipe', () => {
  for (const figure of code.FIGURES) {
    for (const { kind, key, from, to, digits, listed, choices = [] } of [...figure.handles, ...figure.more]) {
      const made = new code.Reading(module, figure, figure.recipe, figure.packings[0]);
      const ends = kind === 'number' && !key.startsWith('mark') ? [from, to] : [];
      for (const end of ends) {
        made.change(key, String(end));
        const value = listed ? listed.read(made.points(listed.list)) : key === 'w' ? made.distance : Number(made.value(key));
        assert.ok(Math.abs(value - end) < 10 ** -digits / 2, `${figure.name} ${key}: ${end} gives ${value}`);
      }
      for (const { word } of choices) {
        made.change(key, word);
        assert.equal(made.value(key), word);
        assert.ok(figure.fits(made), `${figure.name} ${key}: ${word}`);
      }
      made.free();
    }
  }
});

test('points by hand stay in the mesh wherever their handles put them', () => {
  for (const name of ['flip', 'close', 'place']) {
    const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
    const handle = figure.handles.find((/** @type {any} */ one) => one.key === 'given');
    for (const corner of [[handle.from, handle.from], [handle.to, handle.from], [handle.to, handle.to], [handle.from, handle.to]]) {
      const made = new code.Reading(module, figure, figure.recipe, {});
      made.move('given', 9, corner, 0);
      while (!made.advance(1000));
      assert.equal(made.joined(0).points.size, 12, `${name} ${corner}`);
      made.free();
    }
  }
});

/** A run at its end, as questions and sentences see it. @param {string} name @param {Record<string, string>} values */
function atEnd(name, values) {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === name);
  const traces = figure.packings.map((/** @type {any} */ own) => {
    const made = new code.Reading(module, figure, figure.recipe, own);
    for (const [key, text] of Object.entries(values)) made.change(key, text);
    while (!made.advance(1000));
    return made;
  });
  return { figure, seen: { traces, step: code.lastStepOf(figure, traces), trials: [], at: figure.at, zero: 0.718, isStill: true, answered: new Set() } };
}

test('a question on the U is answered by the U alone', () => {
  const outlines = code.FIGURES.find((/** @type {any} */ one) => one.name === 'count').handles.find((/** @type {any} */ one) => one.key === 'poly').choices;
  const answers = outlines.map((/** @type {any} */ { word }, /** @type {number} */ k) => {
    const { figure, seen } = atEnd('count', { poly: word, cs: k ? '34' : '28' });
    return figure.asks[0].seen(seen, 'en');
  });
  assert.match(answers[0], /^At size 28 the U holds 30, the square 29;/);
  assert.deepEqual(answers.slice(1), [undefined, undefined]);
});

test('what a figure tells at the end of a run is true: still far apart, still restless', () => {
  const told = (/** @type {string} */ name, /** @type {Record<string, string>} */ values) => {
    const { figure, seen } = atEnd(name, values);
    return figure.told(seen, 'en');
  };
  assert.match(told('let-go', { w: '1.6' }), /too far apart: no force\. They are at rest\./);
  assert.match(told('let-go', {}), /So little force is left that they are at rest\./);
  assert.match(told('never', { crowd: '0.9', room: '0.95' }), /It has not come to rest\.$/);
  assert.match(told('crowded', { crowd: '1' }), /They have not come to rest\./);
});

test('of many levels the first, the lowest and the last ones have room', () => {
  const bars = [-5.1, -5.4, -5, -5.2, -5.3, -5.15, -5.05, -5.25].map((value, k) => ({ name: String(k + 1), value, isMarked: value === -5.4 }));
  const picture = code.levels({ language: 'en' }, { bars: () => bars, digits: 3 });
  assert.deepEqual([...picture.matchAll(/>(\d+)<\/text>/g)].map(([, name]) => name), ['1', '2', '6', '7', '8']);
  assert.match(picture, /marked">−5\.400</);
});

test('no question is answered by the state that a figure opens with', () => {
  for (const figure of code.FIGURES) {
    const traces = figure.packings.map((/** @type {any} */ own) => {
      const made = new code.Reading(module, figure, figure.recipe, own);
      while (!made.advance(1000));
      return made;
    });
    const seen = { traces, step: Math.min(figure.opens, code.lastStepOf(figure, traces)), trials: [], at: figure.at, zero: 0.718 };
    for (const ask of figure.asks) assert.equal(ask.seen(seen, 'en'), undefined, ask.key);
    for (const language of ['en', 'ja']) assert.ok(figure.told(seen, language).length > 10);
  }
});

test('two starts open while both run downhill, with energies so near that either may end lower', () => {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === 'two-starts');
  const apart = (/** @type {number} */ step) => {
    const [left, right] = figure.packings.map((/** @type {any} */ own) => {
      const made = new code.Reading(module, figure, figure.recipe, own);
      while (!made.advance(1000));
      const { pairs, walls, motion } = code.crowdAt(made, step);
      made.free();
      return pairs + walls + motion;
    });
    return left - right;
  };
  assert.ok(Math.abs(apart(figure.opens)) < 0.05);
  assert.ok(apart(figure.opens - 4) < -0.1 && apart(figure.opens + 4) > 0.1);
});

test('one stop is marked where two fall on the same step', () => {
  const stops = [{ key: 'start', step: 0 }, { key: 'rest', step: 129 }];
  const marked = [[0, 129], [7, 129], [129, 129], [129, 200], [200, 200]].map(([step, last]) => code.markedAt(stops, step, last));
  assert.deepEqual(marked, ['start', undefined, 'rest', 'rest', 'end']);
});

test('the number of the strongest pull stands free of the line down from the bubble at all distances', () => {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === 'pair');
  const made = new code.Reading(module, figure, figure.recipe, {});
  for (let w = 1; w < 1.6; w += 0.01) {
    made.change('w', String(w));
    while (!made.advance(1000));
    const picture = code.force({ traces: [made], step: 0, curve: code.curveOf(module), language: 'en' }, 0);
    const [, x, anchor] = /<text x="([\d.]+)"[^>]*text-anchor="(\w+)"[^>]*>\u22120\.145</.exec(picture) ?? [];
    const stem = Number(/class="bar \w+" d="M([\d.]+)/.exec(picture)?.[1]);
    // A letter is at most 7 units wide, the point of the pair 5.5.
    const [left, right] = anchor === 'end' ? [Number(x) - 42, Number(x)] : [Number(x), Number(x) + 42];
    assert.ok(stem + 5.5 < left || stem - 5.5 > right, `w = ${w.toFixed(2)}: ${stem} in ${left} to ${right}`);
  }
  made.free();
});

test('the answer on halfway says why, with true means', () => {
  const figure = code.FIGURES.find((/** @type {any} */ one) => one.name === 'halfway');
  const said = (/** @type {number} */ lower, /** @type {number} */ upper, language = 'en') => {
    const made = new code.Reading(module, figure, figure.recipe, {});
    made.change('stroke-1', String(lower));
    made.change('stroke-2', String(upper));
    while (!made.advance(1000));
    return figure.asks[0].seen({ traces: [made] }, language);
  };
  assert.match(said(10, 80), /^To a square 80° is −10°, and the mean of 10° and −10° is 0°\. So halfway squares stand at 0\.0°, with certainty 0\.\d\d\.$/);
  assert.match(said(81, 10), /81° is −9°, and the mean of 10° and −9° is 0\.5°\. So halfway squares stand at 0\.[4-6]°/);
  assert.match(said(10, 80, 'ja'), /10°と−10°の平均は0°です。/);
  assert.equal(said(10, 30), undefined);
});

test('whether a start has too few or too many cells is told by the end of its run, at every number', () => {
  const notes = (/** @type {Record<string, string>} */ values, language = 'en') => {
    const { figure, seen } = atEnd('crowded', values);
    return figure.plates.map((/** @type {any} */ { note }) => note(seen, language));
  };
  assert.match(notes({})[0], /^12 at first, too few; now \d+$/);
  assert.match(notes({})[1], /^60 at first, too many; now \d+$/);
  for (const count of ['4', '20', '30', '33', '36', '50', '80']) {
    const [, first, verdict, now] = /^(\d+) at first, ([a-z ]+); now (\d+)$/.exec(notes({ count })[0]) ?? [];
    assert.equal(first, count);
    assert.equal(verdict, Number(now) > Number(first) ? 'too few' : Number(now) < Number(first) ? 'too many' : 'just right');
  }
  // A run that never rests, and where cells come as well as go, has no right number.
  assert.match(notes({ crowd: '1' })[0], /^12 at first; now \d+$/);
  assert.match(notes({}, 'ja')[1], /^初め60個、多すぎる。いま\d+個$/);
});

test('thin triangles are told without colour: lines cross them, inside their edges', () => {
  const picture = code.hatched([[[0, 0], [30, 0], [0, 30]], [[100, 100], [101, 100], [100, 101]]]);
  const lines = [...picture.matchAll(/M([\d.]+) ([\d.]+)l(-?[\d.]+) (-?[\d.]+)/g)].map(([, ...numbers]) => numbers.map(Number));
  assert.ok(lines.length >= 4);
  for (const [x, y, right, down] of lines) for (const [u, v] of [[x, y], [x + right, y + down]]) assert.ok(u >= 0 && v >= 0 && (u < 1 || v < 1) && u + v <= 30, `${u} ${v}`);
  assert.equal(code.hatched([[[100, 100], [101, 100], [100, 101]]]), '');
  const { figure, seen } = atEnd('three', {});
  const drawn = figure.plates.filter(({ draw }) => draw === 'mesh').map((/** @type {any} */ plate) => code.mesh({ ...seen, language: 'en' }, plate));
  const counts = drawn.map((/** @type {string} */ text) => (/by-tint" d="([^"]*)"/.exec(text)?.[1] ?? '').split('M').length - 1);
  // Random points have many more thin triangles than those by Lloyd and those by packing.
  assert.ok(counts[0] > 40 && counts.slice(1).every((count) => count < counts[0] / 3), counts.join(' '));
});

/** The sentence of an exercise on what happened, with other values and another place to look at. @param {string} name @param {Record<string, string>} values @param {number[]} [at] */
function done(name, values, at) {
  const { figure, seen } = atEnd(name, values);
  return figure.asks[0].seen({ ...seen, at: at ?? seen.at }, 'en');
}

test('the exercises say what happened, wherever they are done', () => {
  const places = code.FIGURES.find((/** @type {any} */ { name }) => name === 'place').recipe.match(/given=([^&]*)/)[1].split(';');
  const moved = (/** @type {string} */ place) => done('place', { given: places.with(9, `${place},0`).join(';') });
  assert.match(moved('0.61,0.6'), /^Done: the smallest angle is 40\.5° now\. The point has gone into the hole/);
  // Eleven points have no angle below 30° of their own, and there is room for one more at the border.
  assert.match(moved('0.92,0.34'), /^Done: the smallest angle is 30\.7° now\. In the hole, where a bubble would come, it would be larger/);
  assert.equal(moved('0.02,0.5'), undefined, 'a point outside of the outline is gone');

  assert.match(done('fork', {}, [0.5, 0.44, 0.12]), /^Done: −2, two quarter turns against the walk/);
  assert.match(done('fork', {}, [0.425, 0.375, 0.1]), /^Done: −1, as the walk divides/);

  const dropped = (/** @type {string} */ cw) => done('slide', { cw, given: '0.5,0.5,1;0.3875,0.5,0' });
  assert.match(dropped('0.2'), /slid into the well on the left/);
  assert.equal(dropped('0'), undefined, 'without corner bubbles there is no well');
});
