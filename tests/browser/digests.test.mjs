// The page's digests in this browser. The digests of all presets are compared natively and, with the shipped module, under
// Node.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { digests, frames, varied } from '../common/golden.mjs';
import { open } from './harness.mjs';
import { digest, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('ten presets of many kinds have the same planes in the browser as natively', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await page.$eval('#speed label:last-child input', (radio) => radio.click());
  const presets = await page.evaluate(() => window.bubblestone.presets);
  assert.deepEqual(presets.map(({ name }) => name), digests.map(([name]) => name));
  const chosen = varied(presets);
  const wanted = digests.filter(([name]) => chosen.has(name));
  const found = [];
  for (const [name] of wanted) {
    await page.$eval(`[data-preset="${name}"]`, (button) => button.click());
    found.push([name, await digest(page)]);
  }
  assert.deepEqual(found, wanted);
  assert.deepEqual(problems, []);
  await close();
});

test('frames of a tile by a lamp, of stones from near and of a surface are those that are made natively', async () => {
  const chosen = frames.filter(({ link }) => /light=point|outline=square$|form=vase/.test(link));
  assert.equal(chosen.length, 3);
  for (const { hash, camera, link } of chosen) {
    const { page, problems, close } = await site.newPage(`#${link}`);
    await digest(page);
    const found = await page.evaluate((from) => /** @type {any} */ (window).bubblestone.frame(from), camera);
    assert.equal(found, hash, link);
    assert.deepEqual(problems, []);
    await close();
  }
});
