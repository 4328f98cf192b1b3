// The figures of the chapter on many bubbles: points as handles, runs that end, stops, questions.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { goldenStops } from '../common/figures.mjs';
import { sameEverywhere } from './browsers.mjs';
import { answer, answered, at, changed, chapterPages, follow, hasGoldenStates, isSoundOnPhone, middle, seek, shown, toEnd, type } from './lesson.mjs';
import { phone } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const FIGURES = ['crowd', 'two-starts', 'energy', 'best', 'quiet'];

const chapter = chapterPages('many-bubbles');

/** The coordinates in the boxes of a point. @param {Page} page @param {string} figure @param {string} key */
const pointOf = (page, figure, key) => page.$$eval(`${figure} .handle[data-key="${key}"] input`, (boxes) => boxes.map((box) => Number(box.value)));

/** Waits until the boxes of a point have these coordinates. @param {Page} page @param {string} figure @param {string} key @param {number[]} wanted @param {number} [by] */
async function pointHas(page, figure, key, wanted, by = 0.0015) {
  await page.waitForFunction(
    (selector, values, apart) => [...document.querySelectorAll(selector)].every((box, k) => Math.abs(Number(box.value) - values[k]) < apart),
    {},
    `${figure} .handle[data-key="${key}"] input`,
    wanted,
    by,
  );
}

/** A place of a plate in the window, by shares of the plate. @param {Page} page @param {string} figure @param {number} x @param {number} y */
async function placeOn(page, figure, x, y) {
  const plate = `${figure} .plate-box[data-plate="0"]`;
  await middle(page, plate);
  return page.$eval(
    plate,
    (box, across, down) => {
      const { left, top, width, height } = box.getBoundingClientRect();
      return { x: left + across * width, y: top + down * height };
    },
    x,
    y,
  );
}

/** The grip of a corner of the outline. @param {string} figure @param {number} corner from 0 */
const corner = (figure, corner) => `${figure} .grip-carrier:nth-child(${corner + 3}) .grip-poly`;

/** The walls as they are drawn. @param {Page} page @param {string} figure */
const walls = (page, figure) => page.$eval(`${figure} .plate .outline`, (path) => path.getAttribute('d') ?? '');

test('each stop has the golden state, and a run ends where it is at rest', sameEverywhere, () =>
  hasGoldenStates(chapter, FIGURES, async (page, figure, { stop, step }) => {
    if (stop === 'rest') assert.equal((await shown(page, figure)).said, `step ${step} of ${step}`);
  }));

test('a corner follows the mouse, the keys, taps and its boxes; walls, bubbles and text follow it', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'crowd');
  await toEnd(page, figure);
  const first = await shown(page, figure);
  const drawn = await walls(page, figure);

  const from = await middle(page, corner(figure, 0));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 30, from.y + 24, { steps: 4 });
  await page.mouse.up();
  await changed(page, figure, first.hash);
  const [x = 0, y = 0] = await pointOf(page, figure, 'poly');
  assert.ok(x > 0.12 && y > 0.22, `${x} ${y}`);
  assert.notEqual(await walls(page, figure), drawn);
  assert.notEqual((await shown(page, figure)).told, first.told);

  await page.focus(corner(figure, 0));
  for (const [key, shift, by] of /** @type {const} */ ([['ArrowRight', false, [0.01, 0]], ['ArrowUp', false, [0, -0.01]], ['ArrowLeft', true, [-0.002, 0]], ['ArrowDown', true, [0, 0.002]], ['PageDown', false, [0, 0.1]], ['End', false, [0.1, 0]], ['Home', false, [-0.1, 0]], ['PageUp', false, [0, -0.1]]])) {
    const [now = 0, below = 0] = await pointOf(page, figure, 'poly');
    if (shift) await page.keyboard.down('Shift');
    await page.keyboard.press(key);
    if (shift) await page.keyboard.up('Shift');
    await pointHas(page, figure, 'poly', [now + by[0], below + by[1]]);
  }
  assert.match((await page.$eval(corner(figure, 0), (grip) => grip.ariaValueText)) ?? '', /^x 0\.\d{3}, y 0\.\d{3} picture sides$/);

  // A corner that was tapped goes to the next tap.
  const third = await middle(page, corner(figure, 2));
  await page.mouse.click(third.x, third.y);
  await page.waitForSelector(`${corner(figure, 2)}.chosen`);
  const there = await placeOn(page, figure, 0.8, 0.25);
  await page.mouse.click(there.x, there.y);
  await pointHas(page, figure, 'poly', [0.8, 0.25], 0.01);

  await page.select(`${figure} .handle[data-key="poly"] select`, '4');
  await pointHas(page, figure, 'poly', [0.66, 0.94]);
  const before = (await shown(page, figure)).hash;
  await page.$$eval(`${figure} .handle[data-key="poly"] input`, ([box]) => {
    box.value = '0.6';
    box.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await changed(page, figure, before);
  await pointHas(page, figure, 'poly', [0.6, 0.94]);
  assert.deepEqual(problems, []);
  await close();
});

test('a tap looks at a bubble, and the forces on it are those of the module', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'crowd');
  const { hash, told } = await shown(page, figure);
  const there = await placeOn(page, figure, 0.25, 0.7);
  await page.mouse.click(there.x, there.y);
  await pointHas(page, figure, 'at', [0.25, 0.7], 0.01);
  const now = await shown(page, figure);
  assert.equal(now.hash, hash);
  assert.notEqual(now.told, told);
  const [pushes = 0, pulls = 0] = (/(\d+) neighbours? that push(?:es)? and (\d+) that/.exec(now.told) ?? []).slice(1).map(Number);
  const count = (/** @type {string} */ kind) => page.$$eval(`${figure} .plate-box[data-plate="1"] .near-name${kind}`, (names) => names.length);
  assert.equal(await count(''), pushes + pulls);
  assert.ok((await count('.push')) <= pushes && (await count('.pull')) <= pulls);
  await page.focus(`${figure} .grip-at`);
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => /at=0\.2[56]\d,0\.[67]\d\d/.test(location.hash));
  assert.deepEqual(problems, []);
  await close();
});

test('a finger on a corner moves it and not the page; a tap looks', sameEverywhere, async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  const figure = await at(page, 'crowd');
  const there = await placeOn(page, figure, 0.6, 0.4);
  await page.touchscreen.tap(there.x, there.y);
  await pointHas(page, figure, 'at', [0.6, 0.4], 0.02);
  const { hash } = await shown(page, figure);
  const from = await middle(page, corner(figure, 4));
  const top = await page.evaluate(() => scrollY);
  await page.touchscreen.touchStart(from.x, from.y);
  for (let k = 1; k <= 5; k += 1) await page.touchscreen.touchMove(from.x - 6 * k, from.y - 8 * k);
  await page.touchscreen.touchEnd();
  await changed(page, figure, hash);
  assert.equal(await page.evaluate(() => scrollY), top);
  await page.select(`${figure} .handle[data-key="poly"] select`, '4');
  const [, y = 1] = await pointOf(page, figure, 'poly');
  assert.ok(y < 0.9, String(y));
  assert.deepEqual(problems, []);
  await close();
});

test('stops are offered as far as a run was seen', sameEverywhere, async () => {
  const { page, close } = await chapter();
  const figure = await at(page, 'two-starts');
  const offered = () => page.$$eval(`${figure} [data-stop]:not(:disabled)`, (stops) => stops.map((stop) => stop.dataset.stop));
  const marks = () => page.$$eval(`${figure} .time-marks span`, (all) => all.length);
  assert.deepEqual([await offered(), await marks()], [['start', 'end'], 1]);
  await page.click(`${figure} [data-stop="end"]`);
  // The run ends at rest: one mark with one name.
  await page.waitForSelector(`${figure} [data-stop="rest"][aria-current]`);
  assert.equal(await page.$$eval(`${figure} [data-stop][aria-current]`, (all) => all.length), 1);
  assert.deepEqual([await offered(), await marks()], [['start', 'one', 'rest', 'end'], 3]);
  await seek(page, figure, 20);
  assert.deepEqual(await offered(), ['start', 'one', 'rest', 'end']);
  const { hash } = await shown(page, figure);
  await type(page, figure, 'seed', 4);
  await changed(page, figure, hash);
  assert.deepEqual(await offered(), ['start', 'end']);
  const ends = () => page.$$eval(`${figure} .plate .line-0`, ([line]) => line?.getAttribute('d')?.split('L').length);
  assert.equal(await ends(), 21);
  await close();
});

test('each question is answered by doing what it asks', async () => {
  const { page, problems, close } = await chapter();
  for (const name of FIGURES) await at(page, name);
  for (const key of ['same', 'falls', 'best', 'quiet']) assert.equal(await answer(page, key), '', key);

  await at(page, 'two-starts');
  await page.$eval('[data-ask="same"] input[value="a"]', (button) => button.click());
  await seek(page, '#fig-two-starts', 119);
  assert.equal(await answer(page, 'same'), '');
  await toEnd(page, '#fig-two-starts');
  await answered(page, 'same');
  assert.match(await answer(page, 'same'), /^You expected that both end as the same picture\. Both are at rest\. .*−5\.059 on the left, −5\.452 on the right/);

  await at(page, 'energy');
  // The figure opens before the pairs gain for the first time.
  const pairs = await page.$eval('#fig-energy .plate .line-1', (path) => (path.getAttribute('d') ?? '').split('L').map((place) => Number(place.split(' ')[1])));
  assert.ok(pairs.length > 3 && pairs.every((y, k) => k === 0 || y > (pairs[k - 1] ?? Infinity)), String(pairs));
  await seek(page, '#fig-energy', 3);
  assert.equal(await answer(page, 'falls'), '');
  // At the end of the run the gains lie behind: the sentence names the last one.
  await toEnd(page, '#fig-energy');
  await answered(page, 'falls');
  assert.match(await answer(page, 'falls'), /^At step \d+ the energy of the pairs changed by \+0\.\d{4}, the sum by −0\.\d{4}/);
  await seek(page, '#fig-energy', 8);
  await page.waitForFunction(() => document.querySelector('[data-seen=falls]')?.textContent?.startsWith('At step 8 '));
  assert.match(await answer(page, 'falls'), /^At step 8 the energy of the pairs changed by \+0\.\d{4}, the sum by −0\.\d{4}/);

  await at(page, 'best');
  await type(page, '#fig-best', 'seed', 4);
  await page.waitForFunction(() => document.querySelectorAll('#fig-best .basin').length === 3);
  assert.equal(await answer(page, 'best'), '');
  await type(page, '#fig-best', 'seed', 6);
  await answered(page, 'best');
  assert.match(await answer(page, 'best'), /−5\.167, .*−5\.452|had −5\.167, another one −5\.452/);

  await at(page, 'quiet');
  await type(page, '#fig-quiet', 'damp', 4);
  await page.waitForFunction(() => document.querySelector('#fig-quiet .time-said').textContent === 'step 85 of 85');
  assert.equal(await answer(page, 'quiet'), '');
  await type(page, '#fig-quiet', 'damp', 1.2);
  await answered(page, 'quiet');
  assert.match(await answer(page, 'quiet'), /c = 1\.2 .* 30 steps/);
  assert.deepEqual(problems, []);
  await close();
});

test('a figure that was far away shows again the starts that were tried, and what was seen of their run', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'best');
  const { hash } = await shown(page, figure);
  await type(page, figure, 'seed', 6);
  await changed(page, figure, hash);
  await toEnd(page, figure);
  await page.waitForSelector('[data-seen="best"]:not([hidden])');
  await seek(page, figure, 4);
  const before = await shown(page, figure);
  const offered = () => page.$$eval(`${figure} [data-stop]`, (all) => all.map((stop) => stop.disabled));
  const stops = await offered();
  assert.ok(stops.every((isOff) => !isOff), `${stops}`);

  await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }));
  await page.waitForSelector(`${figure}:not([data-live])`);
  await at(page, 'best');
  assert.deepEqual(await shown(page, figure), before);
  assert.deepEqual(await offered(), stops);
  assert.deepEqual(problems, []);
  await close();
});

test('an address opens the same state in a fresh page, in both languages', async () => {
  const one = await chapter();
  const figure = await at(one.page, 'crowd');
  const from = await middle(one.page, corner(figure, 3));
  await one.page.mouse.move(from.x, from.y);
  await one.page.mouse.down();
  await one.page.mouse.move(from.x - 25, from.y - 10, { steps: 3 });
  await one.page.mouse.up();
  await type(one.page, figure, 'seed', 7);
  await seek(one.page, figure, 23);
  const first = await shown(one.page, figure);
  await one.page.waitForFunction(() => location.hash.includes('step=23') && location.hash.includes('seed=7'));
  const fragment = await one.page.evaluate(() => location.hash);
  await one.close();
  for (const language of /** @type {const} */ (['en', 'ja'])) {
    const { page, problems, close } = await chapter(fragment, { language });
    await page.waitForSelector(`${figure}[data-step="23"][data-hash="${first.hash}"]`);
    if (language === 'en') assert.deepEqual(await shown(page, figure), first);
    assert.deepEqual(problems, []);
    await close();
  }
});

test('an address that fits no crowd opens the crowd of the figure', sameEverywhere, async () => {
  const own = goldenStops().find(({ figure, stop }) => figure === 'crowd' && stop === 'start')?.hash;
  const { page, problems, close } = await chapter('#fig=crowd&outline=annulus&cs=5&step=0');
  await page.waitForSelector(`#fig-crowd[data-step="0"][data-hash="${own}"]`);
  for (const words of ['kind=square&given=0.1,0.5,0&step=0&at=x,y', 'outline=polygon&poly=0.1,0.1,0.9,0.1,0.5,0.9&kind=circle&pop=off&size=256&cs=40&step=0']) {
    // A figure that follows a link begins anew.
    await follow(page, `#fig=crowd&${words}`);
    await page.waitForSelector(`#fig-crowd[data-step="0"][data-hash="${own}"]`);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('on a dark phone, in Japanese, axe finds nothing in the figures, and nothing is wider than the page', sameEverywhere, () => isSoundOnPhone(chapter, FIGURES, /バブル|エネルギー/));
