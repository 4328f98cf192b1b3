// The figures of the chapter on squares: the landscape around one, squares that slide, questions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { answer, answered, at, boxHas, changed, chapterPages, hasGoldenStates, isSoundOnPhone, shown, toEnd, type } from './lesson.mjs';
import { inSight, phone } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const FIGURES = ['nine', 'wells', 'sixty', 'bump', 'slide'];

const chapter = chapterPages('squares');

/** A place on a map in pixels of the page, from its middle in stable distances, y up. @param {Page} page @param {string} figure @param {number} x @param {number} y */
async function onMap(page, figure, x, y) {
  const plate = `${figure} .plate-box[data-plate="0"]`;
  const box = await inSight(page, plate);
  return /** @type {const} */ ([box.x + box.width * (0.5 + x / 4), box.y + box.width * (0.5 - y / 4)]);
}

/** Waits until the boxes show a place. @param {Page} page @param {string} figure @param {number} x @param {number} y y up */
async function stands(page, figure, x, y) {
  const boxes = `${figure} .handle[data-key="given"] input`;
  await page.waitForFunction(
    (selector, wanted) => [...document.querySelectorAll(selector)].every((box, axis) => Math.abs(Number(box.value) - wanted[axis]) < 0.03),
    {},
    boxes,
    [x, -y],
  );
}

/** Drops the second square by a tap. @param {Page} page @param {string} figure @param {number} x @param {number} y y up */
async function drop(page, figure, x, y) {
  const { hash } = await shown(page, figure);
  await page.mouse.click(...(await onMap(page, figure, x, y)));
  await changed(page, figure, hash);
  await stands(page, figure, x, y);
}

test('each stop has the golden state', sameEverywhere, () => hasGoldenStates(chapter, FIGURES));

test('wells: a square at 45 degrees stays at weight 0 and slides at 0.05, which answers the question', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'wells');
  assert.equal(await answer(page, 'from'), '');
  await page.$eval('[data-ask="from"] input[value="a"]', (button) => button.click());
  const { hash, picture } = await shown(page, figure);
  await page.focus(`${figure} .handle[data-key="cw"] input[type="range"]`);
  await page.keyboard.press('Home');
  await boxHas(page, figure, 'cw', 0);
  await changed(page, figure, hash);
  await toEnd(page, figure);
  assert.match((await shown(page, figure)).told, /a ring, 0\.0482 k₀ deep.*4\d° from the middle of the nearest edge\. At weight 0 it stayed near 45°, at 0\.41 it slid to an edge\. Try a smaller weight/);
  assert.equal(await answer(page, 'from'), '');

  await page.focus(`${figure} .handle[data-key="cw"] input[type="range"]`);
  await page.keyboard.press('ArrowRight');
  await boxHas(page, figure, 'cw', 0.05);
  await page.waitForFunction((selector) => document.querySelector(`${selector} .figure-told`).textContent?.includes('0.0090'), {}, figure);
  await toEnd(page, figure);
  await answered(page, 'from');
  assert.match(await answer(page, 'from'), /^You expected that there are four wells from 0\.41 on\. At weight 0 it stayed.*only 0\.0090 k₀ higher/);
  assert.notEqual((await shown(page, figure)).picture, picture);

  const state = await shown(page, figure);
  // The address is rewritten a short time after the step.
  await page.waitForFunction(() => location.hash.includes('&cw=0.05&'));
  const fragment = await page.evaluate(() => location.hash);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-hash="${hash}"]`);
  await boxHas(page, figure, 'cw', Math.SQRT2 - 1);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-step="${state.step}"][data-hash="${state.hash}"]`);
  assert.equal((await shown(other.page, figure)).told, state.told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('the second square is dropped by mouse, tap and keys, and its ground stays while it slides', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'wells');
  await drop(page, figure, -0.9, 0.7);
  assert.equal((await shown(page, figure)).step, 0);
  await page.$eval(`${figure} .plate-svg`, (plate) => plate.firstElementChild?.setAttribute('data-kept', ''));
  await toEnd(page, figure);
  await stands(page, figure, -1, 0);
  assert.equal((await page.$$(`${figure} .plate-svg [data-kept]`)).length, 1);

  const before = (await shown(page, figure)).hash;
  await page.mouse.move(...(await onMap(page, figure, -1, 0)));
  await page.mouse.down();
  await page.mouse.move(...(await onMap(page, figure, 0.2, 1.3)), { steps: 4 });
  await page.mouse.up();
  await changed(page, figure, before);
  await stands(page, figure, 0.2, 1.3);

  await page.focus(`${figure} .grip-given`);
  const [x, y] = await page.$$eval(`${figure} .handle[data-key="given"] input`, (boxes) => boxes.map((box) => Number(box.value)));
  const strides = /** @type {const} */ ([['ArrowRight', 0.05], ['Shift+ArrowRight', 0.01], ['End', 0.5]]);
  let wanted = x ?? 0;
  for (const [keys, stride] of strides) {
    const [key = '', modifier] = keys.split('+').reverse();
    if (modifier) await page.keyboard.down(/** @type {any} */ (modifier));
    await page.keyboard.press(/** @type {any} */ (key));
    if (modifier) await page.keyboard.up(/** @type {any} */ (modifier));
    wanted += stride;
    await page.waitForFunction((selector, value) => Math.abs(Number(document.querySelector(selector).value) - value) < 0.006, {}, `${figure} .handle[data-key="given"] input[data-axis="0"]`, wanted);
  }
  await stands(page, figure, wanted, -(y ?? 0));
  assert.deepEqual(problems, []);
  await close();
});

test('bump: the weight leaves the well where it is, and the radius moves it', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'bump');
  const { hash } = await shown(page, figure);
  assert.equal(await answer(page, 'bump'), '');
  await page.$eval('[data-ask="bump"] input[value="c"]', (button) => button.click());
  await type(page, figure, 'cw', 1);
  await changed(page, figure, hash);
  await toEnd(page, figure);
  await answered(page, 'bump');
  assert.match(await answer(page, 'bump'), /^You expected that it rests at w = 1, as before\. With a weight of 1\.00 it rests at w = 1\.000/);

  const heavy = (await shown(page, figure)).hash;
  await page.click(`${figure} .handle[data-key="cw"] .mark-key`);
  await changed(page, figure, heavy);
  assert.match((await shown(page, figure)).told, /four wells at w = 1\.00, 0\.0764 k₀ deep, and a barrier of 0\.0460/);
  const papers = (await shown(page, figure)).hash;
  await type(page, figure, 'cr', 0.7);
  await changed(page, figure, papers);
  await toEnd(page, figure);
  assert.match((await shown(page, figure)).told, /four wells at w = 1\.08/);
  assert.deepEqual(problems, []);
  await close();
});

test('slide: the exercise is done by a square that slides into the left well', async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  const figure = await at(page, 'slide');
  for (const [x, y] of [[0.9, 0.6], [-0.9, -0.7]]) {
    assert.equal(await answer(page, 'slide'), '');
    await drop(page, figure, x ?? 0, y ?? 0);
    await toEnd(page, figure);
  }
  await answered(page, 'slide');
  assert.match(await answer(page, 'slide'), /^Done: from x = −0\.\d\d, y = 0\.\d\d it slid/);
  assert.deepEqual(problems, []);
  await close();
});

test('on a dark phone, in Japanese, axe finds nothing in the figures, and nothing is wider than the page', sameEverywhere, () => isSoundOnPhone(chapter, FIGURES, /正方形/));
