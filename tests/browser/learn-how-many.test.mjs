// The figures of the chapter on the number of cells: marks, thresholds, questions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { answer, answered, at, boxHas, changed, chapterPages, hasGoldenStates, isSoundOnPhone, seek, shown, toEnd, type } from './lesson.mjs';
import { inSight } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const FIGURES = ['crowded', 'hole', 'never', 'count', 'right-number'];

const chapter = chapterPages('how-many');

/** How often parts of a plate are drawn. @param {Page} page @param {string} figure @param {number} plate @param {string} selector */
const drawn = (page, figure, plate, selector) => page.$$eval(`${figure} .plate-box[data-plate="${plate}"] svg ${selector}`, (all) => all.length);

test('each stop has the golden state', sameEverywhere, () => hasGoldenStates(chapter, FIGURES));

test('crosses and empty places say who goes and who comes at the next look', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'crowded');
  await seek(page, figure, 9);
  const [crosses, places] = [await drawn(page, figure, 1, 'g .goes'), await drawn(page, figure, 1, 'g .empty')];
  assert.ok(await drawn(page, figure, 1, 'g .crowded') >= crosses && await drawn(page, figure, 1, 'g .crowded + .hatch') >= crosses);
  assert.equal(await drawn(page, figure, 0, 'g .goes'), 0);
  await seek(page, figure, 10);
  assert.match((await shown(page, figure)).told, new RegExp(`Second: 60 at the start, ${places} came, ${crosses} went: ${60 + places - crosses} now`));
  assert.equal(await drawn(page, figure, 1, 'g .fresh'), places);

  // Only cells that are nearer to others than the threshold are hatched: with a low one hardly any is.
  const { hash } = await shown(page, figure);
  await type(page, figure, 'crowd', 0.5);
  await changed(page, figure, hash);
  assert.ok(await drawn(page, figure, 1, 'g .hatch') < 10);
  await toEnd(page, figure);
  assert.match((await shown(page, figure)).told, /Second: 60 at the start/);
  assert.deepEqual(problems, []);
  await close();
});

test('a hole: the papers’ rule brings none, ours brings one', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'hole');
  assert.equal(await answer(page, 'hole'), '');
  await page.$eval('[data-ask="hole"] input[value="a"]', (button) => button.click());
  await toEnd(page, figure);
  await answered(page, 'hole');
  assert.match(await answer(page, 'hole'), /^You expected that one comes\. Both are at rest: 36 cells by the papers’ rule, 37 by ours/);
  const { hash } = await shown(page, figure);
  await type(page, figure, 'room', 0.97);
  await changed(page, figure, hash);
  await seek(page, figure, 10);
  // Our rule has a threshold of its own, so the box of the papers' rule leaves its 37 cells.
  assert.match((await shown(page, figure)).told, /The papers’ rule: 40 cells.*Our rule: 37 cells/);
  assert.deepEqual(problems, []);
  await close();
});

test('cells without neighbours have no smallest w, and the numbers of the looks stand apart', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  for (const name of ['never', 'crowded', 'right-number']) {
    const figure = await at(page, name);
    const { hash } = await shown(page, figure);
    await type(page, figure, 'count', 4);
    await changed(page, figure, hash);
    await toEnd(page, figure);
    const rows = await page.$$eval(`${figure} svg.plate`, (plates) => plates.flatMap((plate) => ['.came', '.went'].map((way) => [...plate.querySelectorAll(`.change${way}`)].map((words) => words.getBoundingClientRect()).map(({ left, right }) => [left, right]))));
    assert.ok(rows.some((row) => row.length > 2), name);
    for (const row of rows) assert.ok(row.every(([left], k) => k === 0 || left >= row[k - 1][1]), `${name}: ${JSON.stringify(row)}`);
    await seek(page, figure, 0);
    assert.doesNotMatch((await shown(page, figure)).told, /Infinity|NaN|undefined/);
  }
  assert.match((await shown(page, '#fig-never')).told, /now none has a neighbour/);
  assert.deepEqual(problems, []);
  await close();
});

test('thresholds that cross: it never rests, whichever way they are moved', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'never');
  assert.equal(await answer(page, 'never'), '');
  assert.equal(await drawn(page, figure, 1, '.cell-dot'), 31);

  // By the mouse on the flag ...
  const plate = `${figure} .plate-box[data-plate="1"]`;
  await inSight(page, plate);
  const { x, y, width } = await page.$eval(`${plate} .grip-crowd`, (grip) => {
    const own = grip.getBoundingClientRect();
    return { x: own.x + own.width / 2, y: own.y + own.height / 2, width: grip.closest('.plate-box').getBoundingClientRect().width };
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + (width * 81) / 400, y, { steps: 4 });
  await page.mouse.up();
  await boxHas(page, figure, 'crowd', 0.95, 0.011);
  // ... and by keys on the other flag.
  await page.focus(`${plate} .grip-room`);
  for (const wanted of [0.95, 0.85]) {
    await page.keyboard.press('PageDown');
    await boxHas(page, figure, 'room', wanted);
  }
  await page.waitForSelector(`${plate} svg .both`);
  // The box shows a number before the run with it has begun.
  await page.waitForFunction((selector) => document.querySelector(selector)?.textContent?.includes('The thresholds cross'), {}, `${figure} .figure-told`);
  await toEnd(page, figure);
  await answered(page, 'never');
  assert.match(await answer(page, 'never'), /It never rests: \d came and \d went at step 10, \d came and \d went at step 20, \d came and \d went at step 30\./);
  assert.match((await shown(page, figure)).told, /The thresholds cross/);
  const state = await shown(page, figure);
  await page.waitForFunction((step) => ['pop=opposite', 'room=0.85', `step=${step}`].every((word) => location.hash.includes(word)), {}, state.step);
  const fragment = await page.evaluate(() => location.hash);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-step="${state.step}"][data-hash="${state.hash}"]`);
  assert.equal((await shown(other.page, figure)).told, state.told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

/**
 * Words of the thresholds' flags that are cut, or stand on the pole that passes them. The plate is found in the page, as it
 * is drawn anew at any time. @param {Page} page @param {string} figure @returns {Promise<string[]>}
 */
const badFlags = (page, figure) =>
  page.evaluate((selector) => {
    const own = (/** @type {string} */ part) => /** @type {SVGGraphicsElement[]} */ ([...document.querySelectorAll(`${selector} .threshold${part}`)]);
    const pole = own('.crowd .pole')[0]?.getBBox().x ?? 0;
    return own(' text').flatMap((text) => {
      const { x, width } = text.getBBox();
      const isCut = x < 0 || width === 0 || x + width > 400;
      const isOnPole = text.closest('.room') && pole > x - 4 && pole < x + width + 4;
      return isCut || isOnPole ? [`${text.textContent}: ${Math.round(x)} to ${Math.round(x + width)}, the pole at ${Math.round(pole)}`] : [];
    });
  }, figure);

test('the words of a flag are whole, and stand on no pole, wherever the thresholds are', sameEverywhere, async () => {
  for (const language of /** @type {const} */ (['en', 'ja'])) {
    const { page, problems, close } = await chapter('', { language });
    const figure = await at(page, 'never');
    assert.deepEqual(await badFlags(page, figure), []);
    for (const [crowd, room] of [[0.95, 0.85], [0.75, 0.65], [0.95, 1.1], [1, 1.2], [1, 0.6], [0.5, 0.5]]) {
      await type(page, figure, 'crowd', crowd);
      await type(page, figure, 'room', room);
      const words = [crowd, room].map((value) => `= ${value.toFixed(2)}`);
      await page.waitForFunction((selector, all) => all.every((one, k) => document.querySelectorAll(`${selector} .threshold`)[k]?.textContent?.includes(one)), {}, figure, words);
      assert.deepEqual(await badFlags(page, figure), [], `${language}: ${crowd} and ${room}`);
    }
    assert.deepEqual(problems, []);
    await close();
  }
});

test('outlines of the same area: a smaller size turns the order round; the right number needs no correction', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'count');
  assert.equal(await answer(page, 'count'), '');
  assert.match((await shown(page, figure)).told, /The outline holds 13 cells, the square 19; area over size squared is 17\.3/);
  await type(page, figure, 'cs', 28);
  await answered(page, 'count');
  assert.match(await answer(page, 'count'), /At size 28 the U holds 30, the square 29; the formula says 25\.5/);
  const { hash } = await shown(page, figure);
  await page.$$eval(`${figure} .handle[data-key="poly"] input`, (buttons) => buttons[1]?.click());
  await changed(page, figure, hash);
  assert.match((await shown(page, figure)).told, /the square 29;/);

  const exercise = await at(page, 'right-number');
  for (const count of [34, 37, 36]) {
    assert.equal(await answer(page, 'right'), '');
    const before = (await shown(page, exercise)).hash;
    await type(page, exercise, 'count', count);
    await changed(page, exercise, before);
    await toEnd(page, exercise);
  }
  await answered(page, 'right');
  assert.match(await answer(page, 'right'), /^Done: from 36 cells/);
  await page.waitForFunction(() => location.hash.includes('fig=right-number') && location.hash.includes('count=36'));
  const fragment = await page.evaluate(() => location.hash);
  assert.deepEqual(problems, []);
  await close();

  // Thresholds that a link has changed do not answer the question on the number, though nobody comes or goes.
  for (const [from, to] of [['crowd=0.7', 'crowd=0.1'], ['room=0.7', 'room=0.9']]) {
    assert.ok(fragment.includes(from), fragment);
    const other = await chapter(fragment.replace(from, to));
    await other.page.waitForSelector(`${exercise}[data-hash]`);
    assert.match((await shown(other.page, exercise)).told, /^36/);
    assert.equal(await answer(other.page, 'right'), '');
    await other.close();
  }
});

test('on a dark phone, in Japanese, axe finds nothing in the figures, and nothing is wider than the page', sameEverywhere, () => isSoundOnPhone(chapter, FIGURES, /個/));
