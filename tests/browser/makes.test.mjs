// Several generators on one page: pavements, and surfaces, which need the second module.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { kind, sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { BALL, canvas, click, digest, frames, get, link, message, reloading, set, SMALL } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

/** Waits until this generator has finished its picture. @param {Page} page @param {string} word */
async function made(page, word) {
  await page.waitForSelector(`.make[data-make=${word}][aria-current]`);
  return digest(page);
}

/** Waits until the page says that it works offline. @param {Page} page */
const stored = (page) => page.waitForFunction(() => document.documentElement.dataset['offline'] === 'stored', { timeout: 60_000 });

/** @param {Page} page */
const stages = (page) => page.$$eval('#pipeline li', (items) => items.map((item) => item.dataset['word']));

test('another generator is chosen at the top, comes as its small picture promises, and goes without a trace', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&seed=7&az=30&moss=0.5&stone=flag`);
  const pavement = await digest(page);
  assert.deepEqual(await page.$$eval('.make', (buttons) => buttons.map((button) => button.textContent?.trim())), ['Pavements and hides', 'Surfaces in space', 'Piles', 'Masonry', 'Your model']);
  await click(page, '.make[data-make=surface]');
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  const picture = await page.$eval('.make[data-make=surface] img', (image) => image.getAttribute('src') ?? '');
  const [, shown = ''] = /([^/]+)\.avif$/.exec(picture) ?? [];
  // The presets of the pavement stay until those of surfaces are listed.
  await page.waitForFunction((name) => document.querySelector('[data-preset]')?.getAttribute('data-preset') === name, {}, shown);
  // It has its own light and seed, not those of the pavement.
  assert.deepEqual(await Promise.all(['seed', 'moss', 'az'].map((key) => get(page, key))).then((own) => own.map((value, k) => value === ['7', '0.5', '30'][k])), [false, false, false]);
  await page.waitForSelector(`[data-preset="${shown}"][aria-current], [data-preset="${shown}"][aria-pressed=true]`);
  assert.deepEqual(await stages(page), ['surface', 'fields', 'packing', 'mesh', 'cells', 'stones', 'light']);
  await page.waitForSelector('#p-cn');
  assert.equal(await page.$('#p-cs'), null);
  assert.equal(await page.$eval('#edit-tools', (tools) => tools.hidden), true);
  assert.deepEqual(await page.$$eval('#view option', (options) => options.slice(0, 3).map((option) => option.value)), ['auto', 'picture', 'packed']);
  assert.equal(await page.$eval('[data-preset]', (button) => button.dataset['preset']), 'dragon-egg');
  // Back at the pavement, all is as before.
  await click(page, '.make[data-make=pavement]');
  assert.equal(await made(page, 'pavement'), pavement);
  assert.deepEqual(await Promise.all(['stone', 'seed', 'az'].map((key) => get(page, key))), ['flag', '7', '30']);
  await page.waitForSelector('#p-cs');
  assert.deepEqual(problems, []);
  await close();
});

test('undo, redo, presets, chance and links go from one generator to another', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const pavement = await digest(page);
  const surface = () => page.waitForSelector('.make[data-make=surface][aria-current]');
  await click(page, '.make[data-make=surface]');
  await surface();
  await click(page, '#undo');
  assert.equal(await made(page, 'pavement'), pavement);
  await click(page, '#redo');
  await surface();
  await page.waitForSelector('[data-preset=dragon-tail]');
  await click(page, '[data-preset=dragon-tail]');
  await page.waitForFunction(() => window.bubblestone.get('form') === 'tail');
  const preset = await link(page);
  await click(page, '#throw');
  await page.waitForFunction((before) => window.bubblestone.link() !== before, {}, preset);
  assert.match(await link(page), /make=surface/);
  await page.evaluate((fragment) => (location.hash = fragment), SMALL);
  assert.equal(await made(page, 'pavement'), pavement);
  await page.goBack();
  await surface();
  assert.deepEqual(problems, []);
  await close();
});

test('all generators work without a host once the site is stored', sameEverywhere, async (t) => {
  const own = await open({ viewport: low });
  t.after(() => own.close());
  const { page, external, close } = await own.newPage(SMALL, { stores: true });
  const pavement = await digest(page);
  await stored(page);
  own.stop();
  await page.evaluate((fragment) => (location.hash = fragment), BALL);
  const ball = await made(page, 'surface');
  await reloading(page, () => page.reload());
  assert.equal(await made(page, 'surface'), ball);
  await click(page, '.make[data-make=pavement]');
  // This is the recipe of the pavement that was open when the page was left.
  assert.notEqual(await made(page, 'pavement'), '');
  await page.evaluate((link) => (location.hash = link), SMALL);
  assert.equal(await made(page, 'pavement'), pavement);
  assert.deepEqual(external, []);
  await close();
});

/**
 * Keeps the second module, and its script, from this page until `isUp`. While `isSlow`, requests wait. With `up`, it
 * can be loaded from the start, until the session's storage has `cut`.
 * @param {Page} fresh
 * @param {boolean} [up]
 */
const cutOff = (fresh, up = false) =>
  fresh.evaluateOnNewDocument((comes) => {
    window.isUp = comes && !sessionStorage.getItem('cut');
    const real = window.fetch;
    const up = async () => {
      while (window.isSlow) await new Promise((resolve) => setTimeout(resolve, 20));
      if (!window.isUp) throw new TypeError('no way there');
    };
    window.fetch = async (input, init) => {
      if (/house|bubblestone-[^/]*\.js/.test(String(input))) await up();
      return real(input, init);
    };
  }, up);

/** The address, the shown recipe, and the length of the history. @param {Page} page */
const state = (page) =>
  page.evaluate(() => ({
    hash: location.hash.slice(1),
    link: window.bubblestone.link(),
    undo: !document.querySelector('#undo').disabled,
    redo: !document.querySelector('#redo').disabled,
  }));

test('a generator that does not arrive leaves the picture, and is tried again', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL, { before: cutOff });
  const pavement = await digest(page);
  const shown = await canvas(page);
  const before = await state(page);
  await click(page, '.make[data-make=surface]');
  await message(page, 'alert', /could not be loaded/);
  await frames(page, 5);
  assert.deepEqual(await canvas(page), shown);
  assert.equal(await digest(page), pavement);
  assert.deepEqual(await state(page), before);
  await page.evaluate(() => (window.isUp = true));
  await click(page, '[role=alert] .actions button');
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  assert.equal(await page.$('[role=alert] .message'), null);
  assert.deepEqual(problems, []);
  await close();
});

test('a step back to a generator that does not arrive loses no step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BALL, { before: (fresh) => cutOff(fresh, true) });
  const ball = await made(page, 'surface');
  await click(page, '.make[data-make=pavement]');
  await made(page, 'pavement');
  await set(page, 'seed', '5');
  await set(page, 'seed', '6');
  await click(page, '#undo');
  await page.waitForFunction(() => document.querySelector('#stored').textContent !== '');
  // A page loaded anew has the first module only.
  await page.evaluate(() => sessionStorage.setItem('cut', 'yes'));
  await reloading(page, () => page.reload());
  await digest(page);
  for (const text of ['5', '1']) {
    assert.equal(await get(page, 'seed'), text);
    await click(page, '#undo');
  }
  await message(page, 'alert', /could not be loaded/);
  const { link, hash, undo, redo } = await state(page);
  assert.deepEqual({ hash, undo, redo }, { hash: link, undo: true, redo: true });
  await page.evaluate(() => (window.isUp = true));
  await click(page, '[role=alert] .actions button');
  assert.equal(await made(page, 'surface'), ball);
  for (let step = 0; step < 3; step += 1) await click(page, '#redo');
  await made(page, 'pavement');
  assert.equal(await get(page, 'seed'), '6');
  assert.deepEqual(problems, []);
  await close();
});

test('while a generator is on its way the page goes on, and what the visitor does then comes first', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL, { before: cutOff });
  await digest(page);
  await page.evaluate(() => Object.assign(window, { isSlow: true, isUp: true }));
  const before = await state(page);
  await click(page, '.make[data-make=surface]');
  await page.waitForSelector('.make[data-make=surface][aria-busy=true]');
  await message(page, 'status', /is being loaded/);
  assert.deepEqual(await state(page), before);
  // Choosing the present generator again cancels the wait.
  await click(page, '.make[data-make=pavement]');
  await page.waitForSelector('.make[data-make=surface][aria-busy=false]');
  await click(page, '.make[data-make=surface]');
  await message(page, 'status', /is being loaded/);
  await set(page, 'seed', '5');
  await page.waitForSelector('.make[data-make=surface][aria-busy=false]');
  await page.evaluate(() => (window.isSlow = false));
  await digest(page);
  assert.equal(await get(page, 'seed'), '5');
  // A typed address stays until its recipe can be opened. One step back leads to the previous recipe.
  await page.evaluate((link) => (location.hash = link), BALL);
  await made(page, 'surface');
  assert.equal((await state(page)).hash, BALL.slice(1));
  await click(page, '#undo');
  await made(page, 'pavement');
  assert.equal(await get(page, 'seed'), '5');
  assert.deepEqual(problems, []);
  await close();
});

test('what is compared with may be of another generator', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const pavement = await digest(page);
  await click(page, '#compare-button');
  await page.waitForSelector('#compare-with');
  await page.select('#compare-with', 'link');
  await page.type('#compare-link', `https://example.org/${BALL}`);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('.other') && document.querySelector('.compare-progress').textContent === '');
  assert.equal(await get(page, 'seed'), '1');
  await set(page, 'seed', '2');
  assert.notEqual(await digest(page), pavement);
  await click(page, '#undo');
  assert.equal(await digest(page), pavement);
  await click(page, '.make[data-make=surface]');
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  assert.deepEqual(problems, []);
  await close();
});

test('a module that nobody uses any more goes, with its memory', { skip: kind === 'firefox' && 'only Chromium counts its objects' }, async () => {
  const { page, close } = await site.newPage(SMALL);
  const memories = async () => {
    const kinds = await page.evaluateHandle(() => WebAssembly.Memory.prototype);
    const found = await page.queryObjects(kinds);
    const count = await found.evaluate((all) => all.length);
    // A handle that is kept would keep the memory.
    await found.dispose();
    return count;
  };
  await digest(page);
  assert.equal(await memories(), 1);
  await page.evaluate((fragment) => (location.hash = fragment), BALL);
  await made(page, 'surface');
  assert.equal(await memories(), 1);
  await close();
});

test('a generator chosen while the panel is being built has its own panel', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        const choose = () => {
          const button = document.querySelector('.make[data-make=pavement]');
          if (button) button.click();
          else requestAnimationFrame(choose);
        };
        requestAnimationFrame(choose);
      }),
  });
  await made(page, 'pavement');
  await page.waitForSelector('#p-cs');
  assert.equal(await page.$('#p-cn'), null);
  assert.deepEqual(problems, []);
  await close();
});
