import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, frames, get, message, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('a copied link, reopened, gives the same planes and the same picture', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await site.allowClipboard(page);
  await set(page, 'palette', 'terracotta');
  await set(page, 'stone', 'flag');
  await set(page, 'dr', '0.55');
  await set(page, 'seed', '4000000000');
  const here = { planes: await digest(page), ...(await canvas(page)) };
  await page.bringToFront();
  await page.keyboard.press('c');
  await message(page, 'status', /copied/);
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.ok(link.startsWith(`${site.address}#`), link);
  const again = await site.newPage(link.slice(site.address.length));
  assert.deepEqual({ planes: await digest(again.page), ...(await canvas(again.page)) }, here);
  assert.deepEqual(await again.page.$$eval('.message', (notes) => notes.length), 0);
  assert.deepEqual([...problems, ...again.problems], []);
  await again.close();
  await close();
});

test('the address follows the controls, and is not written for each move of a slider', async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        window.written = 0;
        const replace = history.replaceState;
        history.replaceState = function (...given) {
          window.written += 1;
          return replace.apply(this, given);
        };
      }),
  });
  await digest(page);
  const before = await page.evaluate(() => window.written);
  const spent = await page.$eval('[data-key=el] [type=range]', async (slider) => {
    const begin = performance.now();
    for (let place = 200; place <= 900; place += 25) {
      slider.value = String(place);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
      await new Promise(requestAnimationFrame);
    }
    return performance.now() - begin;
  });
  const value = await get(page, 'el');
  await page.waitForFunction((text) => location.hash.includes(`el=${text}`), { timeout: 60_000 }, value);
  // The address is written at most every half second, and at the end.
  const written = (await page.evaluate(() => window.written)) - before;
  assert.ok(written <= spent / 500 + 3, `${written} times in ${spent} ms`);
  await close();
});

test('the way back leads to the pavement before', async () => {
  const { page, close } = await site.newPage(SMALL);
  const first = await digest(page);
  await click(page, '#dice');
  const second = await digest(page);
  assert.notEqual(second, first);
  await page.goBack();
  await frames(page, 2);
  assert.equal(await digest(page), first);
  await page.goForward();
  await frames(page, 2);
  assert.equal(await digest(page), second);
  await close();
});

test('an address typed over opens', async () => {
  const { page, close } = await site.newPage(SMALL);
  const first = await digest(page);
  await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&stone=flag`);
  await frames(page, 2);
  assert.equal(await get(page, 'stone'), 'flag');
  assert.notEqual(await digest(page), first);
  await close();
});

for (const [junk, words] of [
  ['&cs=banana', /cs|cell size/i],
  ['&dr=99', /dr|distortion/i],
  ['&nonsense=1', /nonsense/],
  ['&make=nonsense', /pavement, surface, pile or masonry/],
  ['&outline=moon', /outline|moon/i],
  ['&outline=polygon&poly=!!!', /poly|outline/i],
]) {
  test(`a link with ${junk} opens, and the page says what was left out`, sameEverywhere, async () => {
    const { page, problems, close } = await site.newPage(`${SMALL}${junk}`);
    await digest(page);
    await message(page, 'status', words);
    assert.ok((await canvas(page)).colours > 100);
    assert.deepEqual(problems, []);
    await click(page, '.message .close');
    assert.equal((await page.$$('.message')).length, 0);
    await close();
  });
}
