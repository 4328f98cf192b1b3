// Several generators on one page: the site of these tests has a specimen in its second module.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { specimenSite } from '../../scripts/lib/site.mjs';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, frames, get, message, reloading, SMALL } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ files: specimenSite });
});

after(() => site?.close());

const SQUARES = '#v=1&make=specimen&size=192&across=5';

/** Waits until this generator is at work, and its picture done. @param {Page} page @param {string} word */
async function made(page, word) {
  await page.waitForSelector(`.make[data-make=${word}][aria-current]`);
  return digest(page);
}

/** Waits until the page says that it works offline. @param {Page} page */
const stored = (page) => page.waitForFunction(() => document.documentElement.dataset['offline'] === 'stored', { timeout: 60_000 });

/** @param {Page} page */
const stages = (page) => page.$$eval('#pipeline li', (items) => items.map((item) => item.dataset['word']));

test('another generator is chosen at the top, and seed, light and weather go along', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&seed=7&az=30&moss=0.5&stone=flag`);
  const pavement = await digest(page);
  assert.deepEqual(await page.$$eval('.make', (buttons) => buttons.map((button) => button.textContent)), ['Pavements and hides', 'Squares']);
  await click(page, '.make[data-make=specimen]');
  await made(page, 'specimen');
  assert.equal(await page.evaluate(() => window.bubblestone.link()), 'v=1&make=specimen&seed=7&moss=0.5&az=30');
  assert.deepEqual(await stages(page), ['grid', 'planes', 'weather', 'shading']);
  await page.waitForSelector('#p-across');
  assert.equal(await page.$('#p-cs'), null);
  assert.deepEqual(await page.$$eval('#view option', (options) => options.map((option) => option.value)), ['auto', 'picture', 'albedo']);
  assert.equal(await page.$eval('#edit-tools', (tools) => tools.hidden), true);
  assert.deepEqual(await page.$$eval('[data-preset]', (buttons) => buttons.map((button) => button.dataset['preset'])), ['squares', 'few-squares']);
  assert.deepEqual(await page.$$eval('.counts dd', (counts) => counts.filter((count) => count.checkVisibility()).map((count) => count.id)), ['count-cells']);
  const squares = await canvas(page);
  await click(page, '#save');
  await page.waitForSelector('#save-dialog[open]');
  assert.deepEqual(await page.$$eval('#save-dialog section', (rows) => rows.map((row) => row.getAttribute('aria-label'))), ['Picture', 'Maps', 'Recipe']);
  await click(page, '#save-dialog [data-close]');
  // Back again, as it was but for what went along.
  await click(page, '.make[data-make=pavement]');
  assert.equal(await made(page, 'pavement'), pavement);
  assert.equal(await get(page, 'stone'), 'flag');
  assert.notDeepEqual(await canvas(page), squares);
  await page.waitForSelector('#p-cs');
  assert.deepEqual(problems, []);
  await close();
});

test('undo, redo, presets, chance and links go from one generator to another', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const pavement = await digest(page);
  await click(page, '.make[data-make=specimen]');
  const squares = await made(page, 'specimen');
  await click(page, '#undo');
  assert.equal(await made(page, 'pavement'), pavement);
  await click(page, '#redo');
  assert.equal(await made(page, 'specimen'), squares);
  await page.waitForSelector('[data-preset=few-squares]');
  await click(page, '[data-preset=few-squares]');
  await page.waitForFunction(() => window.bubblestone.get('across') === '3');
  await made(page, 'specimen');
  await click(page, '#throw');
  await page.waitForFunction(() => window.bubblestone.get('across') !== '3');
  await made(page, 'specimen');
  await page.evaluate((link) => (location.hash = link), SMALL);
  assert.equal(await made(page, 'pavement'), pavement);
  await page.goBack();
  await made(page, 'specimen');
  assert.deepEqual(problems, []);
  await close();
});

test('a link of another generator opens it, and again after a reload', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARES);
  const squares = await made(page, 'specimen');
  assert.equal(await page.evaluate(() => window.bubblestone.status().cells), 25);
  await reloading(page, () => page.reload());
  assert.equal(await made(page, 'specimen'), squares);
  assert.deepEqual(problems, []);
  await close();
  const embedded = await site.newPage(`?embed${SQUARES}`);
  assert.equal(await digest(embedded.page), squares);
  assert.deepEqual(embedded.problems, []);
  await embedded.close();
});

test('all generators work without a host once the site is stored', async (t) => {
  const own = await open({ files: specimenSite });
  t.after(() => own.close());
  const { page, external, close } = await own.newPage(SMALL, { stores: true });
  const pavement = await digest(page);
  await stored(page);
  own.stop();
  await click(page, '.make[data-make=specimen]');
  const squares = await made(page, 'specimen');
  await reloading(page, () => page.reload());
  assert.equal(await made(page, 'specimen'), squares);
  await click(page, '.make[data-make=pavement]');
  // The recipe that comes first, as the page was left.
  assert.notEqual(await made(page, 'pavement'), '');
  await page.evaluate((link) => (location.hash = link), SMALL);
  assert.equal(await made(page, 'pavement'), pavement);
  assert.deepEqual(external, []);
  await close();
});

test('a generator that does not arrive leaves the picture, and is tried again', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        const real = window.fetch;
        window.fetch = (input, init) => (window.isUp || !/house/.test(String(input)) ? real(input, init) : Promise.reject(new TypeError('no way there')));
      }),
  });
  const pavement = await digest(page);
  const shown = await canvas(page);
  await click(page, '.make[data-make=specimen]');
  await message(page, 'alert', /could not be loaded/);
  await frames(page, 5);
  assert.deepEqual(await canvas(page), shown);
  assert.equal(await digest(page), pavement);
  assert.equal(await page.evaluate(() => window.bubblestone.link()), SMALL.slice(1).replace(/^(?!v=1)/, 'v=1&'));
  await page.evaluate(() => (window.isUp = true));
  await click(page, '[role=alert] .actions button');
  await made(page, 'specimen');
  assert.equal(await page.$('[role=alert] .message'), null);
  await close();
});

test('a panic becomes a message with the recipe, and the page can start afresh', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARES);
  await made(page, 'specimen');
  await page.evaluate((link) => (location.hash = link), `${SQUARES}&seed=4294967295`);
  await message(page, 'alert', /mistake/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
  assert.match(await page.$eval('[role=alert] a', (anchor) => anchor.href), /make=specimen.*seed=4294967295/);
  await reloading(page, () => click(page, '[role=alert] .actions button'));
  await made(page, 'pavement');
  await close();
});
