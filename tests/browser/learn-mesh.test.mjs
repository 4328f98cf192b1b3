// The figures of the chapter on meshes: layers, counts with marks, points moved by hand, questions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { goldenStops } from '../common/figures.mjs';
import { sameEverywhere } from './browsers.mjs';
import { answer, answered, at, boxHas, changed, chapterPages, follow, hasGoldenStates, isSoundOnPhone, middle, shown, toEnd, type } from './lesson.mjs';
import { frames, inSight, phone } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const FIGURES = ['dual', 'three', 'flip', 'close', 'place'];

const chapter = chapterPages('mesh');

/** A place on a plate in pixels of the page, in shares of its width and height. @param {Page} page @param {string} figure @param {number} plate @param {number} x @param {number} y */
async function placeOn(page, figure, plate, x, y) {
  const selector = `${figure} .plate-box[data-plate="${plate}"]`;
  const box = await inSight(page, selector);
  return /** @type {const} */ ([box.x + box.width * x, box.y + box.height * y]);
}

/** Waits until the boxes of a point have a place. @param {Page} page @param {string} figure @param {string} key @param {number} x @param {number} y @param {number} [by] */
async function stands(page, figure, key, x, y, by = 0.0015) {
  await page.waitForFunction(
    (selector, wanted, apart) => [...document.querySelectorAll(selector)].every((box, axis) => Math.abs(Number(box.value) - wanted[axis]) < apart),
    {},
    `${figure} .handle[data-key="${key}"] input`,
    [x, y],
    by,
  );
}

/** Presses a key with or without Shift. @param {Page} page @param {string} keys */
async function press(page, keys) {
  const [key = '', modifier] = keys.split('+').reverse();
  if (modifier) await page.keyboard.down(/** @type {any} */ (modifier));
  await page.keyboard.press(/** @type {any} */ (key));
  if (modifier) await page.keyboard.up(/** @type {any} */ (modifier));
}

/** Chooses a point of the list. @param {Page} page @param {string} figure @param {number} row */
const choose = (page, figure, row) => page.select(`${figure} .handle[data-key="given"] select`, String(row));

/** Writes a point's boxes, and waits for the new state after each. @param {Page} page @param {string} figure @param {number} x @param {number} y */
async function write(page, figure, x, y) {
  for (const [axis, value] of [x, y].entries()) {
    const { hash } = await shown(page, figure);
    await page.$eval(
      `${figure} .handle[data-key="given"] input[data-axis="${axis}"]`,
      (box, text) => {
        box.value = text;
        box.dispatchEvent(new Event('change', { bubbles: true }));
      },
      String(value),
    );
    await changed(page, figure, hash);
  }
}

test('each stop has the golden state', sameEverywhere, () => hasGoldenStates(chapter, FIGURES));

test('dual: the layers come one after another, and the cell that is looked at follows mouse, tap, keys and boxes', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'dual');
  const count = (/** @type {string} */ parts) => page.$$eval(`${figure} .plate ${parts}`, (all) => all.length);
  for (const [stop, edges, cells] of /** @type {const} */ ([['bubbles', 0, 0], ['mesh', 1, 0], ['one', 2, 1], ['around', 2, 7], ['all', 2, 41]])) {
    await page.click(`${figure} [data-stop="${stop}"]`);
    await page.waitForSelector(`${figure} [data-stop="${stop}"][aria-current]`);
    assert.deepEqual([await count('.bubble'), await count('.mesh-edge'), await count('.dual-cell')], [41, edges, cells]);
  }
  const first = await shown(page, figure);
  await page.mouse.click(...(await placeOn(page, figure, 0, 0.4, 0.6)));
  await stands(page, figure, 'at', 0.4, 0.6, 0.01);
  await page.mouse.move(...(await placeOn(page, figure, 0, 0.4, 0.6)));
  await page.mouse.down();
  await page.mouse.move(...(await placeOn(page, figure, 0, 0.1, 0.3)), { steps: 4 });
  await page.mouse.up();
  await stands(page, figure, 'at', 0.1, 0.3, 0.01);
  const border = await shown(page, figure);
  assert.equal(border.hash, first.hash);
  assert.match(border.told, /at the border/);
  assert.notEqual(border.picture, first.picture);

  await page.$$eval(`${figure} .handle[data-key="at"] input`, (boxes) => {
    for (const box of boxes) {
      box.value = '0.4';
      box.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await stands(page, figure, 'at', 0.4, 0.4);
  await page.focus(`${figure} .grip-at`);
  for (const [keys, x] of /** @type {const} */ ([['ArrowRight', 0.41], ['Shift+ArrowRight', 0.412], ['End', 0.512]])) {
    await press(page, keys);
    await stands(page, figure, 'at', x, 0.4);
  }
  await type(page, figure, 'cs', 48);
  await page.waitForFunction((selector) => /^2\d bubbles and 2\d cells/.test(document.querySelector(selector).textContent), {}, `${figure} .figure-told`);
  assert.deepEqual(problems, []);
  await close();
});

test('three: the question is answered after twenty rounds and at rest, beside the marks; a link and start again', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'three');
  const first = await shown(page, figure);
  assert.match(first.told, /32\.0° at random, below 46\.0° after 4 .* 43\.8° in the packing at step 5/);

  // A tap sets the mark of its row; a grip, keys and a box set it, too.
  await page.mouse.click(...(await placeOn(page, figure, 3, 0.6, 0.42)));
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 20, {}, `${figure} .handle[data-key="mark-1"] input[type="number"]`);
  await boxHas(page, figure, 'mark', 0);
  const flag = await middle(page, `${figure} .grip-mark`);
  await page.mouse.move(flag.x, flag.y);
  await page.mouse.down();
  await page.mouse.move(flag.x + 120, flag.y, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 10, {}, `${figure} .handle[data-key="mark"] input[type="number"]`);
  await type(page, figure, 'mark', 45);
  await page.focus(`${figure} .grip-mark-2`);
  for (const [keys, value] of /** @type {const} */ ([['PageUp', 10], ['ArrowRight', 11], ['Shift+ArrowRight', 11.5], ['End', 60]])) {
    await press(page, keys);
    await boxHas(page, figure, 'mark-2', value);
  }
  await type(page, figure, 'mark-1', 45);
  assert.notEqual((await shown(page, figure)).picture, first.picture);
  assert.equal((await shown(page, figure)).hash, first.hash);

  await toEnd(page, figure);
  assert.equal(await answer(page, 'middles'), '');
  await type(page, figure, 'rounds', 20);
  await answered(page, 'middles');
  assert.equal(await answer(page, 'middles'), 'The middles: random 32°, Lloyd 48°, packed 56°. You marked 45, 45, 60. The same rule joined all three: only the places differ.');

  const state = await shown(page, figure);
  await page.waitForFunction(() => location.hash.includes('rounds=20') && location.hash.includes('at=45.000,45.000,60.000'));
  const fragment = await page.evaluate(() => location.hash);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-step="5"][data-hash="${first.hash}"]`);
  await boxHas(page, figure, 'rounds', 4);
  await boxHas(page, figure, 'mark-2', 0);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-step="${state.step}"][data-hash="${state.hash}"]`);
  assert.deepEqual(await shown(other.page, figure), state);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('flip: an edge flips while a point is moved by keys, at the moment when four corners lie on one circle', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'flip');
  const first = await shown(page, figure);
  assert.match(first.told, /joins points 7 and 9.*69\.3° and 101\.7°, together 171\.0°/);
  await page.$eval('[data-ask="flip"] input[value="a"]', (button) => button.click());
  const [ninth] = (await page.$$(`${figure} .grip-given`)).slice(8);
  await ninth?.focus();
  let { hash } = first;
  for (const [keys, y] of /** @type {const} */ ([['ArrowDown', 0.43], ['Shift+ArrowDown', 0.431], ['ArrowDown', 0.441]])) {
    await press(page, keys);
    await changed(page, figure, hash);
    await stands(page, figure, 'given', 0.42, y);
    hash = (await shown(page, figure)).hash;
  }
  assert.equal(await answer(page, 'flip'), '');
  await press(page, 'ArrowDown');
  await answered(page, 'flip');
  assert.equal(await answer(page, 'flip'), 'You expected that it flips when the other diagonal is the shorter one. The edge flipped where its facing angles reached 180.0°: all four corners lay on one circle. The new edge is 0.380 long, the old one 0.363: the longer one won.');
  assert.match((await shown(page, figure)).told, /joins points 6 and 10/);
  assert.equal((await page.$$(`${figure} .plate .of-flip`)).length, 1);
  assert.equal((await page.$$(`${figure} .plate .of-four`)).length, 4);

  // A tap looks at another edge; the points stay.
  const state = await shown(page, figure);
  await page.mouse.click(...(await placeOn(page, figure, 0, 0.52, 0.64)));
  await stands(page, figure, 'at', 0.52, 0.64, 0.01);
  assert.match((await shown(page, figure)).told, /joins points 3 and 12|joins points 11 and 12/);
  assert.equal((await shown(page, figure)).hash, state.hash);
  await page.waitForFunction(() => /at=0\.5\d\d,0\.6\d\d/.test(location.hash));
  const fragment = await page.evaluate(() => location.hash);
  const { told } = await shown(page, figure);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-hash="${first.hash}"]`);
  assert.deepEqual(await shown(page, figure), first);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-hash="${state.hash}"]`);
  assert.equal((await shown(other.page, figure)).told, told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('close: two points pushed together make thin triangles, by mouse and by boxes', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'close');
  const first = await shown(page, figure);
  assert.match(first.told, /^12 points, 13 triangles\. The smallest angle of all is 44\.9°/);
  await page.$eval('[data-ask="good"] input[value="a"]', (button) => button.click());
  const from = await middle(page, `${figure} .grip-given:not([hidden])`);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x - 30, from.y, { steps: 4 });
  await page.mouse.up();
  await changed(page, figure, first.hash);
  assert.equal(await answer(page, 'good'), '');
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-hash="${first.hash}"]`);
  await choose(page, figure, 9);
  await write(page, figure, 0.378, 0.54);
  await answered(page, 'good');
  assert.match(await answer(page, 'good'), /^You expected that it stays above 30°\. 0\.0\d\d apart, and the smallest angle is [234]\.\d°\. Delaunay’s edges are the best/);
  assert.ok((await page.$$(`${figure} .plate .tint-0`)).length > 0);
  assert.deepEqual(problems, []);
  await close();
});

test('place: a tap puts the one point that can be moved where no angle is small, and a finger moves it on', async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  const figure = await at(page, 'place');
  const first = await shown(page, figure);
  assert.equal((await page.$$(`${figure} .grip-given`)).length, 1);
  assert.equal(await answer(page, 'place'), '');
  await page.touchscreen.tap(...(await placeOn(page, figure, 0, 0.52, 0.68)));
  await answered(page, 'place');
  assert.match(await answer(page, 'place'), /^Done: the smallest angle is (39|40|41)\.\d° now\./);
  const { hash, picture } = await shown(page, figure);
  assert.notEqual(picture, first.picture);

  const from = await middle(page, `${figure} .grip-given`);
  const top = await page.evaluate(() => scrollY);
  await page.touchscreen.touchStart(from.x, from.y);
  for (let k = 1; k <= 5; k += 1) await page.touchscreen.touchMove(from.x - 8 * k, from.y - 6 * k);
  await page.touchscreen.touchEnd();
  await changed(page, figure, hash);
  assert.equal(await page.evaluate(() => scrollY), top);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) < 0.45, {}, `${figure} .handle[data-key="given"] input`);
  assert.deepEqual(problems, []);
  await close();
});

test('an address that does not fit opens the figure’s own points', sameEverywhere, async () => {
  const own = (/** @type {string} */ name) => goldenStops().find(({ figure }) => figure === name)?.hash;
  const { page, problems, close } = await chapter('#fig=dual&outline=square&size=256&kind=circle&cs=5');
  await page.waitForSelector(`#fig-dual[data-hash="${own('dual')}"]`);
  for (const [name = '', words] of [['flip', 'outline=square&kind=circle&pop=off&edge=open&given=0.2,0.2,0;0.8,0.8,0'], ['close', 'kind=square']]) {
    await follow(page, `#fig=${name}&${words}`);
    await page.waitForSelector(`#fig-${name}[data-hash="${own(name)}"]`);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('the numbers of angles stay on their plates when points and looks are at the border', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  for (const [name, key] of /** @type {const} */ ([['flip', 'at'], ['flip', 'given'], ['close', 'given']])) {
    const figure = await at(page, name);
    for (const [x, y] of /** @type {const} */ ([[0.05, 0.06], [0.95, 0.05], [0.94, 0.95], [0.05, 0.94]])) {
      if (key === 'given') await write(page, figure, x, y);
      else await page.mouse.click(...(await placeOn(page, figure, 0, x, y)));
      await stands(page, figure, key, x, y, 0.01);
      await frames(page, 3);
      const outside = await page.$$eval(`${figure} svg.plate`, (plates) =>
        plates.flatMap((plate) => {
          const own = plate.getBoundingClientRect();
          const words = [...plate.querySelectorAll('.angle-name, .letter-of')].map((text) => [text.textContent, text.getBoundingClientRect()]);
          return words.filter(([, { left, right, top, bottom }]) => left < own.left || right > own.right || top < own.top - 1 || bottom > own.bottom + 1).map(([text]) => text);
        }),
      );
      assert.deepEqual(outside, [], `${name} ${key} ${x}, ${y}`);
    }
  }
  assert.deepEqual(problems, []);
  await close();
});

test('on a dark phone, in Japanese, axe finds nothing in the figures, and nothing is wider than the page', sameEverywhere, () => isSoundOnPhone(chapter, FIGURES, /個/));
