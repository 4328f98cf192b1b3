// The forming as a new visitor sees it, and as it is watched again.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, get, link, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Records each change that is announced or visible, frame by frame. */
function watchFrames() {
  window.film = [];
  const look = () => {
    const now = {
      told: document.documentElement.dataset.stage,
      seen: document.querySelector('[data-state=now]')?.dataset.word,
      words: document.querySelectorAll('#subtitle[data-on] [data-shown]').length,
      main: document.querySelector('#play')?.dataset.does,
      steps: Number(document.querySelector('#count-steps')?.textContent),
    };
    const last = window.film.at(-1);
    if (JSON.stringify(now) !== JSON.stringify(last?.now)) window.film.push({ at: performance.now(), now });
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/** @param {string} fragment */
const visit = (fragment) => site.newPage(fragment, { before: (fresh) => fresh.evaluateOnNewDocument(watchFrames) });

const film = (page) => page.evaluate(() => window.film);

/** Waits for the visible end, and until the record has it, which takes one more frame. */
const rested = (page) => page.waitForFunction(() => window.film.at(-1)?.now.main === 'again', { timeout: 60_000 });

/** Waits until the packing is visible. */
const forms = (page) => page.waitForSelector('[data-word=packing][data-state=now]', { timeout: 60_000 });

/** The number of steps once it stays the same. A drawing, and the number with it, may take some frames. */
const count = (page) =>
  page.evaluate(async () => {
    const told = () => Number(document.querySelector('#count-steps').textContent);
    for (let [same, last] = [0, told()]; same < 60; same = told() === last ? same + 1 : 0) {
      last = told();
      await new Promise(requestAnimationFrame);
    }
    return told();
  });

test('on a first visit the forming takes its time, and scripts need not wait for it', async () => {
  const { page, problems, close } = await visit('');
  const planes = await digest(page);
  const { cells, steps } = await page.evaluate(() => window.bubblestone.status());
  await rested(page);
  const seen = await film(page);
  const told = seen.slice(seen.findIndex(({ now }) => now.told === 'done')).map(({ now }) => now);
  assert.equal(told[0].main, 'pause', 'told when the forming was over');
  assert.ok(told.every((now) => now.told === 'done'), 'told, and taken back');
  const words = seen.map(({ now }) => now.words);
  assert.deepEqual([...new Set(words)], [0, 1, 2, 3], String(words));
  const begin = seen.find(({ now }) => now.seen === 'packing').at;
  const end = seen.find(({ now }) => now.main === 'again').at;
  assert.ok(end - begin > 2500, `${end - begin} ms`);
  assert.equal(await page.$eval('#subtitle .said', (text) => text.textContent), 'Bubbles push each other into place, settle, and turn to stone.');
  assert.equal(await page.$eval('#play', (button) => button.textContent.trim()), 'Watch again');
  // The final picture is the one whose digest scripts received, and the same as that of the link elsewhere.
  assert.deepEqual(await page.evaluate(() => [window.bubblestone.status().cells, window.bubblestone.status().steps]), [cells, steps]);
  assert.equal(await digest(page), planes);
  const shown = await canvas(page);
  const recipe = await page.evaluate(() => window.bubblestone.link());
  assert.deepEqual(problems, []);
  await close();
  const linked = await visit(`#${recipe}`);
  assert.equal(await digest(linked.page), planes);
  assert.deepEqual(await canvas(linked.page), shown);
  assert.ok((await film(linked.page)).every(({ now }) => now.words === 0), 'a link has words');
  await linked.close();
});

test('a second visit does not wait, and what is done meanwhile ends the watching', sameEverywhere, async () => {
  const { page, problems, close } = await visit('');
  await forms(page);
  await page.waitForSelector('#subtitle[data-on]');
  await page.waitForSelector('[data-key=size] [type=number]');
  const first = await link(page);
  await set(page, 'size', '192');
  await page.waitForSelector('#subtitle:not([data-on])');
  const planes = await digest(page);
  assert.equal(await get(page, 'size'), '192');
  assert.equal(await page.$eval('#play', (button) => button.dataset.does), 'again');
  await click(page, '#undo');
  assert.notEqual(await digest(page), planes);
  assert.equal(await link(page), first);
  await page.reload({ waitUntil: 'load' });
  await digest(page);
  assert.equal(await page.$eval('#play', (button) => button.dataset.does), 'again');
  assert.ok((await film(page)).every(({ now }) => now.words === 0), 'words on the second visit');
  assert.deepEqual(problems, []);
  await close();
});

test('the forming can be held, stepped and hurried on a first visit, while scripts have their answer', sameEverywhere, async () => {
  const { page, problems, close } = await visit('');
  await forms(page);
  await page.keyboard.press(' ');
  await page.waitForSelector('#play[data-does=play]');
  const planes = await digest(page);
  const taken = await count(page);
  await page.keyboard.press('s');
  await page.waitForFunction((before) => Number(document.querySelector('#count-steps').textContent) > before, {}, taken);
  assert.equal(await count(page), taken + 1);
  await page.keyboard.press(' ');
  await page.waitForFunction((before) => Number(document.querySelector('#count-steps').textContent) > before + 1, {}, taken);
  await page.$$eval('#speed input', (radios) => radios.at(-1).click());
  await page.waitForSelector('#subtitle:not([data-on])');
  await rested(page);
  assert.equal(await digest(page), planes);
  assert.deepEqual(problems, []);
  await close();
});

test('any picture is watched again, from its start', sameEverywhere, async () => {
  const { page, problems, close } = await visit(`${SMALL}&stone=skin`);
  const planes = await digest(page);
  const shown = await canvas(page);
  for (const again of [() => click(page, '#play'), () => page.keyboard.press('r')]) {
    await page.evaluate(() => (window.film = []));
    await again();
    await forms(page);
    assert.equal(await page.$eval('#subtitle .said', (text) => text.textContent), 'Bubbles push each other into place, settle, and turn to scales.');
    assert.equal(await digest(page), planes);
    assert.deepEqual(await canvas(page), shown);
    const words = new Set((await film(page)).map(({ now }) => now.words));
    for (const number of [1, 2, 3]) assert.ok(words.has(number), `${number} of the words are not seen`);
  }
  // Start again midway. The record shows the first few steps, which are over before a test could look.
  await page.evaluate(() => (window.film = []));
  await page.keyboard.press('r');
  await page.waitForFunction(() => window.film.some(({ now }) => now.seen === 'packing' && now.steps > 5));
  const last = (await film(page)).length - 1;
  await page.keyboard.press('r');
  await page.waitForFunction((from) => window.film.slice(from).some(({ now }, k, then) => k > 0 && now.steps < then[k - 1].now.steps), {}, last);
  assert.equal(await digest(page), planes);
  assert.deepEqual(problems, []);
  await close();
});

test('who asks for less motion is shown it when it is asked for', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL, { still: true });
  await digest(page);
  const shown = await canvas(page);
  await click(page, '#play');
  await forms(page);
  await page.waitForFunction(
    (colours) => {
      const canvas = document.querySelector('#canvas');
      return new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size < colours / 2;
    },
    {},
    shown.colours,
  );
  await digest(page);
  assert.deepEqual(await canvas(page), shown);
  await close();
});
