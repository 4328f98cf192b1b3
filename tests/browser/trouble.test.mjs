import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, frames, get, message, reloading, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('a break inside becomes a message with the recipe, and the page can start afresh', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&seed=77`);
  await digest(page);
  await page.evaluate(() => {
    performance.now = () => {
      throw new Error('The clock is broken.');
    };
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
  await assert.rejects(page.evaluate(() => window.bubblestone.digest()));
  assert.match(await page.$eval('[role=alert] a', (anchor) => anchor.href), /seed=77/);
  await reloading(page, () => click(page, '[role=alert] a'));
  await digest(page);
  assert.equal(await get(page, 'seed'), '77');
  await page.evaluate(() => {
    performance.now = () => {
      throw new Error('The clock is broken.');
    };
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  await reloading(page, () => click(page, '[role=alert] .actions button'));
  await digest(page);
  assert.match(await page.evaluate(() => window.bubblestone.link()), /palette=mossy/, 'the first picture of a visit');
  await close();
});

test('a trap in the module as it is sent becomes the same message', async () => {
  const { page, close } = await site.newPage(`${SMALL}&seed=77`);
  await digest(page);
  await page.evaluate(() => {
    // Nothing may call the studio while one of its calls runs, but this clock does, and such a call reads it.
    performance.now = () => Number(window.bubblestone.link());
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  assert.match(await page.$eval('[role=alert] a', (anchor) => anchor.href), /seed=77/);
  await reloading(page, () => click(page, '[role=alert] a'));
  await digest(page);
  await close();
});

test('a browser without WebAssembly gets a sentence', async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: (fresh) => fresh.evaluateOnNewDocument(() => Object.defineProperty(window, 'WebAssembly', { value: undefined })),
  });
  await message(page, 'alert', /no WebAssembly/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
  await close();
});

test('a page that cannot be stored works, and says nothing of it', async () => {
  /** @type {string[]} */
  const errors = [];
  let asked = () => {};
  const refused = new Promise((resolve) => (asked = () => resolve(undefined)));
  const { page, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      fresh.on('pageerror', (error) => errors.push(String(error)));
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (/offline/.test(request.url()) ? request.abort() : request.continue()));
      fresh.on('requestfailed', (request) => /offline/.test(request.url()) && asked());
    },
  });
  await refused;
  await digest(page);
  await frames(page, 5);
  assert.deepEqual(errors, []);
  assert.equal(await page.$('.message'), null);
  await close();
});

test('words that do not arrive leave the page in English, which says so once', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      await fresh.evaluateOnNewDocument(() => localStorage.setItem('bubblestone.language', 'ja'));
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (/\bja-.*\.js$/.test(request.url()) ? request.abort() : request.continue()));
    },
  });
  await digest(page);
  await message(page, 'status', /in English until it is loaded again/);
  assert.equal(await page.$$eval('.message', (notes) => notes.length), 1);
  assert.equal(await page.$eval('html', (html) => html.lang), 'en');
  assert.equal(await page.$eval('#share', (button) => button.checkVisibility({ visibilityProperty: true }) && button.textContent.trim()), 'Share');
  await close();
});

test('a module that does not arrive gets a sentence', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (request.url().endsWith('.wasm') ? request.abort() : request.continue()));
    },
  });
  await message(page, 'alert', /could not be loaded/);
  await close();
});
