// The figures of the chapter on directions: a square that is turned, a road and its pieces, walks, strokes, questions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { answer, answered, at, boxHas, changed, chapterPages, hasGoldenStates, isSoundOnPhone, middle, shown, type } from './lesson.mjs';
import { inSight, phone } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const FIGURES = ['quarter', 'road', 'pieces', 'walk', 'halfway', 'fork'];

const chapter = chapterPages('which-way');

/** Waits for these words below a figure. @param {Page} page @param {string} figure @param {string} words */
const tells = (page, figure, words) => page.waitForFunction((selector, wanted) => document.querySelector(`${selector} .figure-told`).textContent?.includes(wanted), {}, figure, words);

/** The place of a plate at shares of its width and of its height. @param {Page} page @param {string} figure @param {number} x @param {number} y */
async function onPlate(page, figure, x, y) {
  const plate = `${figure} .plate-box[data-plate="0"]`;
  const box = await inSight(page, plate);
  return { x: box.x + box.width * x, y: box.y + box.height * y };
}

/** Waits until the boxes of a point show a place. @param {Page} page @param {string} figure @param {number} x @param {number} y @param {number} [by] */
const stands = (page, figure, x, y, by = 0.012) =>
  page.waitForFunction(
    (selector, wanted, apart) => [...document.querySelectorAll(selector)].every((box, axis) => Math.abs(Number(box.value) - wanted[axis]) < apart),
    {},
    `${figure} .handle[data-key="at"] input`,
    [x, y],
    by,
  );

/** Drags the grip of a handle by some pixels. @param {Page} page @param {string} grip @param {number} dx @param {number} dy */
async function drag(page, grip, dx, dy) {
  const { x, y } = await middle(page, grip);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 4 });
  await page.mouse.up();
}

/** Types into one of the boxes of a point. @param {Page} page @param {string} figure @param {0 | 1} axis @param {number} value */
const put = (page, figure, axis, value) =>
  page.$eval(
    `${figure} .handle[data-key="at"] input[data-axis="${axis}"]`,
    (box, text) => {
      box.value = text;
      box.dispatchEvent(new Event('change', { bubbles: true }));
    },
    String(value),
  );

/** The first new address with these words. @param {Page} page @param {string} words @param {string} [before] */
async function addressWith(page, words, before = '') {
  await page.waitForFunction((part, old) => location.hash.includes(part) && location.hash !== old, {}, words, before);
  return page.evaluate(() => location.hash);
}

test('each figure opens, and stops, at its golden state', sameEverywhere, () =>
  hasGoldenStates(chapter, FIGURES, async (page, figure, { stop }) => {
    assert.equal((await page.$(`${figure} input.time`)) === null, stop === 'opens');
  }));

test('quarter: the square is turned by keys, box, tap and hand, and is alike at 90°', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'quarter');
  const first = await shown(page, figure);
  await page.focus(`${figure} .handle[data-key="angle"] input[type="range"]`);
  await page.keyboard.press('ArrowRight');
  await boxHas(page, figure, 'angle', 35);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.up('Shift');
  await boxHas(page, figure, 'angle', 36);
  await page.keyboard.press('PageUp');
  await boxHas(page, figure, 'angle', 81);
  await tells(page, figure, 'four-fold arrow by 324°');
  await type(page, figure, 'angle', 90);
  await tells(page, figure, 'looks as at 0°, wells and all');
  const below = await onPlate(page, figure, 0.7, 0.7);
  await page.mouse.click(below.x, below.y);
  await boxHas(page, figure, 'angle', 45);
  await drag(page, `${figure} .grip-angle`, 0, -400);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) < -50, {}, `${figure} .handle[data-key="angle"] input[type="number"]`);
  assert.notEqual((await shown(page, figure)).picture, first.picture);
  await page.click(`${figure} [data-do="again"]`);
  await boxHas(page, figure, 'angle', 30);
  await page.waitForSelector(`${figure}[data-hash="${first.hash}"]`);
  assert.equal((await shown(page, figure)).picture, first.picture);
  assert.deepEqual(problems, []);
  await close();
});

test('road: the point in the middle answers the question, and a link opens there', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'road');
  const first = await shown(page, figure);
  await page.$eval('[data-ask="middle"] input[value="a"]', (button) => button.click());
  await page.focus(`${figure} .plate-box[data-plate="0"] .grip-at`);
  await page.keyboard.press('ArrowRight');
  await stands(page, figure, 0.515, 0.455, 0.001);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.up('Shift');
  await stands(page, figure, 0.515, 0.46, 0.001);
  await page.keyboard.press('End');
  await stands(page, figure, 0.615, 0.46, 0.001);
  assert.equal(await answer(page, 'middle'), '');
  await tells(page, figure, 'it points along the road');
  await put(page, figure, 1, 0.5);
  await answered(page, 'middle');
  assert.match(await answer(page, 'middle'), /^You expected that it points along the road\. In the middle 0\.00\d .*The small rest .*certainty 1\.00/);
  await tells(page, figure, 'it points across the road');

  // A tap below the road changes nothing, and a point that is dragged away stays on the road.
  const rows = await onPlate(page, figure, 0.3, 0.8);
  await page.mouse.click(rows.x, rows.y);
  await drag(page, `${figure} .plate-box[data-plate="1"] .grip-at`, -40, -60);
  await stands(page, figure, 0.54, 0.43, 0.02);
  const far = await shown(page, figure);
  await type(page, figure, 'dp', 2);
  await changed(page, figure, far.hash);
  assert.notEqual((await shown(page, figure)).picture, far.picture);
  const road = await onPlate(page, figure, 0.5, 62 / 300);
  await page.mouse.click(road.x, road.y);
  await stands(page, figure, 0.5, 0.5, 0.006);
  await put(page, figure, 0, 0.7);
  await put(page, figure, 1, 0.5);
  await stands(page, figure, 0.7, 0.5, 0.001);
  const state = await shown(page, figure);
  const fragment = await addressWith(page, 'at=0.700,0.500');
  assert.match(fragment, /dp=2/);
  await page.click(`${figure} [data-do="again"]`);
  await stands(page, figure, 0.5, 0.455, 0.001);
  await page.waitForFunction((selector, picture) => [...document.querySelectorAll(`${selector} .plate-svg`)].map((plate) => plate.innerHTML).join('') === picture, {}, figure, first.picture);

  // The arrow keys reach the middle, and so does a drag that ends a little beside it.
  await page.focus(`${figure} .plate-box[data-plate="0"] .grip-at`);
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowDown');
  await stands(page, figure, 0.5, 0.5, 0.001);
  await page.keyboard.press('PageUp');
  await stands(page, figure, 0.5, 0.43, 0.001);
  const { width } = await inSight(page, `${figure} .plate-box[data-plate="0"]`);
  await drag(page, `${figure} .plate-box[data-plate="0"] .grip-at`, 0, 0.0625 * width);
  await stands(page, figure, 0.5, 0.5, 0.001);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-hash="${state.hash}"]`);
  const opened = await shown(other.page, figure);
  assert.deepEqual([opened.told, opened.picture], [state.told, state.picture]);
  await answered(other.page, 'middle');
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('each handle has one line at a desk', async () => {
  const { page, close } = await chapter();
  for (const name of FIGURES) {
    const figure = await at(page, name);
    const tall = await page.$$eval(`${figure} .handle`, (all) =>
      all.filter((one) => one.checkVisibility() && one.getBoundingClientRect().height > 40).map(({ textContent }) => textContent),
    );
    assert.deepEqual(tall, [], name);
  }
  await close();
});

test('pieces: ten of them change the printed sum alone', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'pieces');
  const { hash } = await shown(page, figure);
  await page.focus(`${figure} .handle[data-key="pieces"] input[type="range"]`);
  await page.keyboard.press('PageUp');
  await boxHas(page, figure, 'pieces', 4);
  await tells(page, figure, 'cut into 4 pieces');
  const before = await addressWith(page, 'fig=pieces');
  assert.equal(await answer(page, 'pieces'), '');
  await type(page, figure, 'pieces', 10);
  await answered(page, 'pieces');
  assert.match(await answer(page, 'pieces'), /from 0\.00 to 0\.45 .*it points along the road\. The four-fold direction changed by 0\.0°/);
  const state = await shown(page, figure);
  const fragment = await addressWith(page, 'fig=pieces', before);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-hash="${hash}"]`);
  await boxHas(page, figure, 'pieces', 1);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-hash="${state.hash}"]`);
  await boxHas(other.page, figure, 'pieces', 10);
  assert.equal((await shown(other.page, figure)).told, state.told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

/** Checks that the middle of a walk and its radius have working grips. @param {Page} page @param {string} figure */
async function gripsOf(page, figure) {
  await drag(page, `${figure} .grip-at`, -60, 0);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) < 0.65, {}, `${figure} .handle[data-key="at"] input`);
  await boxHas(page, figure, 'mark-2', 0.1);
  await drag(page, `${figure} .grip-mark-2`, 40, -40);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 0.15, {}, `${figure} .handle[data-key="mark-2"] input[type="number"]`);
  await type(page, figure, 'mark-2', 0.2);
  await page.focus(`${figure} .grip-mark-2`);
  await page.keyboard.press('ArrowRight');
  await boxHas(page, figure, 'mark-2', 0.22);
  await page.keyboard.press('PageUp');
  await boxHas(page, figure, 'mark-2', 0.32);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.up('Shift');
  await boxHas(page, figure, 'mark-2', 0.315);
}

test('walk: around all singular points of the round place it counts four; its middle and its radius have grips', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'walk');
  const first = await shown(page, figure);
  const outline = await page.$(`${figure} .handle[data-key="outline"] input[value="annulus"]`);
  await outline?.click();
  await changed(page, figure, first.hash);
  // Singular points would give the answer away.
  const points = () => page.$eval(figure, (place) => ({ marks: place.querySelectorAll('.singular').length, note: place.querySelector('.plate-note')?.textContent }));
  assert.deepEqual(await points(), { marks: 0, note: '' });
  await type(page, figure, 'mark-2', 0.35);
  await tells(page, figure, 'It leaves the outline');
  const centre = await onPlate(page, figure, 0.5, 0.5);
  await page.mouse.click(centre.x, centre.y);
  await stands(page, figure, 0.5, 0.5);
  await tells(page, figure, 'turned by 360°, 4 quarter turns');
  // In a ring they are those of the hole.
  assert.equal(await answer(page, 'turns'), '');
  await page.$eval(`${figure} .handle[data-key="outline"] input[value="polygon"]`, (button) => button.click());
  await answered(page, 'turns');
  assert.match(await answer(page, 'turns'), /four quarter turns\. All singular points together count four: index 1/);
  const { marks, note } = await points();
  assert.ok(marks > 0);
  assert.equal(note, `${marks} singular ${marks === 1 ? 'point' : 'points'} ◆`);

  await page.click(`${figure} [data-stop="quarter"]`);
  await tells(page, figure, 'After 90° the cross has turned by 90°, 1 quarter turn.');
  await page.click(`${figure} [data-do="on"]`);
  await page.waitForSelector(`${figure}[data-step="19"]`);
  const fragment = await addressWith(page, 'step=19');
  const state = await shown(page, figure);
  assert.match(state.said ?? '', /95° of 360°/);
  await type(page, figure, 'height', 0.85);
  await changed(page, figure, state.hash);
  assert.notEqual((await shown(page, figure)).picture, state.picture);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-step="72"][data-hash="${first.hash}"]`);
  assert.equal((await shown(page, figure)).told, first.told);
  await gripsOf(page, figure);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-step="19"][data-hash="${state.hash}"]`);
  assert.equal((await shown(other.page, figure)).told, state.told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('halfway: strokes at 10° and 80° have squares at 0° between them', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'halfway');
  const { hash } = await shown(page, figure);
  await tells(page, figure, 'Halfway squares stand at 19.7°');
  await page.$eval('[data-ask="halfway"] input[value="a"]', (button) => button.click());
  await page.focus(`${figure} .grip-stroke-2`);
  await page.keyboard.press('PageUp');
  await boxHas(page, figure, 'stroke-2', 75);
  const before = await addressWith(page, 'fig=halfway');
  await page.keyboard.press('ArrowUp');
  await boxHas(page, figure, 'stroke-2', 80);
  await answered(page, 'halfway');
  // The angle before was answered, too.
  await page.waitForFunction(() => /stand at 0\.0°/.test(document.querySelector('[data-seen="halfway"]')?.textContent ?? ''));
  assert.match(await answer(page, 'halfway'), /^You expected that squares stand at 45°\. To a square 80° is −10°, and the mean of 10° and −10° is 0°\. So halfway squares stand at 0\.0°, with certainty 0\.77/);
  const state = await shown(page, figure);
  const fragment = await addressWith(page, 'fig=halfway', before);
  await drag(page, `${figure} .grip-stroke-1`, -20, 60);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 40, {}, `${figure} .handle[data-key="stroke-1"] input[type="number"]`);
  await boxHas(page, figure, 'stroke-2', 80);
  await type(page, figure, 'stroke-1', 30);
  await type(page, figure, 'stroke-2', 60);
  await tells(page, figure, 'Halfway squares stand at 45.0°');
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-hash="${hash}"]`);
  await close();

  const other = await chapter(fragment);
  await other.page.waitForSelector(`${figure}[data-hash="${state.hash}"]`);
  assert.equal((await shown(other.page, figure)).told, state.told);
  assert.deepEqual([...problems, ...other.problems], []);
  await other.close();
});

test('fork: the exercise is done by a finger that puts the walk where three roads meet', async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  const figure = await at(page, 'fork');
  const there = await onPlate(page, figure, 0.5, 0.6);
  await page.touchscreen.tap(there.x, there.y);
  await stands(page, figure, 0.5, 0.6, 0.03);
  assert.equal(await answer(page, 'fork'), '');
  const from = await middle(page, `${figure} .grip-at`);
  const { width } = await page.$eval(`${figure} .plate-box`, (box) => box.getBoundingClientRect().toJSON());
  const top = await page.evaluate(() => scrollY);
  await page.touchscreen.touchStart(from.x, from.y);
  for (let k = 1; k <= 5; k += 1) await page.touchscreen.touchMove(from.x, from.y - (0.17 * width * k) / 5);
  await page.touchscreen.touchEnd();
  await stands(page, figure, 0.5, 0.43, 0.03);
  assert.equal(await page.evaluate(() => scrollY), top);
  await answered(page, 'fork');
  assert.match(await answer(page, 'fork'), /^Done: −2, two quarter turns against the walk/);
  const studio = await page.$eval(`a.into-studio[data-figure="fork"]`, (link) => link.hash);
  assert.match(studio, /outline=y_fork.*view=direction$/);
  assert.deepEqual(problems, []);
  await close();
});

test('on a dark phone, in Japanese, axe finds nothing in the figures, and nothing is wider than the page', sameEverywhere, () => isSoundOnPhone(chapter, FIGURES, /向き|°/));
