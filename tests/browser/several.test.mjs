// Several generators on one page: the choice between them, and the keys and parts of each.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { BALL, click, digest, frames, phone, SMALL } from './page.mjs';
import { turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

/** The keys in the page's list. @param {Page} page */
async function listed(page) {
  await page.keyboard.press('?');
  await page.waitForSelector('#keys[open]');
  const keys = await page.$$eval('#keys-list div', (rows) => rows.map((row) => row.textContent));
  await page.keyboard.press('Escape');
  await page.waitForSelector('#keys:not([open])');
  return keys;
}

test('a generator without a part of the page has no keys of it, and what was open of it is closed', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const all = await listed(page);
  await page.keyboard.press('o');
  await page.waitForSelector('#layers', { visible: true });
  await page.evaluate((fragment) => (location.hash = fragment), BALL);
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  await turned(page);
  await page.waitForSelector('#layers', { hidden: true });
  for (const key of ['e', 't', 'p']) await page.keyboard.press(key);
  // If the light appears, the keys before it have been handled, too.
  await page.keyboard.press('l');
  await page.waitForSelector('#light-sun', { visible: true });
  await frames(page, 5);
  assert.equal(await page.$('.handle, #divider'), null);
  assert.deepEqual(await page.$$eval('#editor, #layers, .tiles, #plots', (parts) => parts.filter((part) => part.checkVisibility()).map(({ id }) => id)), []);
  assert.equal(await page.$eval('#cells', (cells) => cells.checkVisibility()), false, 'a stop for Tab where there are no cells');
  const few = await listed(page);
  const gone = all.filter((row) => !few.includes(row));
  assert.equal(gone.length, 15, String(gone));
  for (const row of few) assert.ok(all.includes(row), row);
  await click(page, '.make[data-make=pavement]');
  await page.waitForSelector('.make[data-make=pavement][aria-current]');
  await digest(page);
  assert.equal(await page.$eval('#cells', (cells) => cells.checkVisibility()), true);
  assert.deepEqual(await listed(page), all);
  assert.deepEqual(problems, []);
  await close();
});

test('a link of a generator without cells opens with no stop for Tab on them', sameEverywhere, async () => {
  const { page, close } = await site.newPage(BALL);
  await turned(page);
  assert.equal(await page.$eval('#cells', (cells) => cells.checkVisibility()), false);
  const { x, y, width } = await page.$eval('#turn', (turn) => turn.getBoundingClientRect().toJSON());
  await page.mouse.move(x + width / 2, y + width / 2);
  await page.waitForSelector('.turn-card');
  assert.equal(await page.$eval('#cells', (cells) => cells.checkVisibility()), false, 'nor once the picture listens');
  await close();
});

/** The largest number of generators, with names of usual length. */
const FIVE = {
  en: ['Pavements and hides', 'Surfaces', 'Piles', 'Masonry', 'Chapters'],
  ja: ['舗装と皮', '曲面', '積み石', '石積み', '各章'],
};

for (const [language, words] of Object.entries(FIVE)) {
  test(`five generators have room for their words on every screen: ${language}`, async () => {
    const { page, close } = await site.newPage(SMALL, {
      viewport: phone,
      before: (fresh) => fresh.evaluateOnNewDocument((code) => localStorage.setItem('bubblestone.language', code), language),
    });
    await digest(page);
    const look = async (width, height) => {
      await page.setViewport({ ...phone, width, height });
      return page.evaluate(
        async (side, up) => {
          // Layout follows a little later.
          for (let left = 100; left > 0 && (innerWidth !== side || innerHeight !== up); left -= 1) await new Promise(requestAnimationFrame);
          const boxes = [...document.querySelectorAll('.make')].map((button) => ({ ...button.getBoundingClientRect().toJSON(), cut: button.scrollWidth > button.clientWidth + 1 }));
          const heads = [...document.querySelectorAll('.head :is(button, select, h1)')].filter((element) => element.checkVisibility());
          return {
            sides: [innerWidth, innerHeight, document.documentElement.scrollWidth],
            outside: heads.filter((element) => element.getBoundingClientRect().right > side + 0.5 || element.getBoundingClientRect().left < 0).map((element) => element.id || element.textContent),
            cut: boxes.some(({ cut }) => cut),
            small: boxes.some(({ width, height }) => Math.min(width, height) < 43.5),
            rows: new Set(boxes.map(({ top }) => Math.round(top))).size,
          };
        },
        width,
        height,
      );
    };
    const sides = [[320, 640], [360, 640], [390, 844], [640, 900], [700, 900], [820, 1180], [844, 390], [959, 800], [961, 800], [1024, 700], [1280, 800], [1680, 1000]];
    for (const count of [2, 5]) {
      await page.evaluate(
        (texts) => {
          const nav = document.querySelector('#makes');
          for (const [k, text] of texts.entries()) {
            const button = nav.children[k] ?? nav.appendChild(nav.children[1].cloneNode(true));
            button.querySelector('span').textContent = text;
          }
        },
        words.slice(0, count),
      );
      for (const [width, height] of sides) {
        const fits = { sides: [width, height, width], outside: [], cut: false, small: false, rows: 1 };
        assert.deepEqual(await look(width, height), fits, `${count} on ${width} × ${height}`);
      }
    }
    // Large letters take more rows, but the page is no wider.
    await page.evaluate(() => document.documentElement.style.setProperty('font-size', '200%'));
    for (const width of [390, 820]) {
      const { rows, ...others } = await look(width, phone.height);
      assert.deepEqual(others, { sides: [width, phone.height, width], outside: [], cut: false, small: false }, `${width}, large letters in ${rows} rows`);
    }
    await close();
  });
}
