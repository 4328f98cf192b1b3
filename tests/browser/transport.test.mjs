import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, frames, get, set, SMALL, steps } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Pauses the packing at its very start. */
async function held() {
  const opened = await site.newPage(SMALL);
  await digest(opened.page);
  await click(opened.page, '#step');
  await opened.page.waitForFunction(() => document.documentElement.dataset.stage === 'packing', { timeout: 60_000 });
  return opened;
}

test('a pause holds the packing, and a step is one step', sameEverywhere, async () => {
  const { page, problems, close } = await held();
  const first = await steps(page);
  await frames(page, 10);
  assert.equal(await steps(page), first);
  for (let taken = 1; taken <= 3; taken += 1) {
    const before = await canvas(page);
    await click(page, '#step');
    // The number appears with the drawing, which may take some frames.
    await page.waitForFunction((count) => Number(document.querySelector('#count-steps').textContent) === count, {}, first + taken);
    assert.equal(await steps(page), first + taken);
    assert.notEqual((await canvas(page)).hash, before.hash, 'the step is not to be seen');
  }
  assert.equal(await page.$eval('#play', (button) => button.textContent.trim()), 'Play');
  assert.deepEqual(problems, []);
  await close();
});

test('playing on after steps gives the same planes as never stopping', sameEverywhere, async () => {
  const opened = await site.newPage(SMALL);
  const straight = await digest(opened.page);
  await opened.close();
  const { page, close } = await held();
  await click(page, '#step');
  await click(page, '#step');
  await click(page, '#play');
  assert.equal(await digest(page), straight);
  await close();
});

test('any speed gives the same planes', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  const slow = await digest(page);
  for (const speed of await page.$$('#speed input')) {
    await speed.evaluate((radio) => radio.click());
    await click(page, '#play');
    assert.equal(await digest(page), slow);
  }
  await close();
});

test('the dice throw another seed, and typing the old one brings the old pavement back', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  const [planes, seed] = [await digest(page), await get(page, 'seed')];
  await click(page, '#dice');
  assert.notEqual(await get(page, 'seed'), seed);
  assert.equal(await page.$eval('#seed', (box) => box.value), await get(page, 'seed'));
  assert.notEqual(await digest(page), planes);
  await set(page, 'seed', seed);
  assert.equal(await digest(page), planes);
  await close();
});

test('a change of the light ends the watching, and a pause holds one forming only', sameEverywhere, async () => {
  const { page, close } = await held();
  const taken = await steps(page);
  await set(page, 'el', '15');
  await frames(page, 10);
  assert.equal(await steps(page), taken);
  await click(page, '#play');
  const planes = await digest(page);
  assert.ok((await steps(page)) > taken);
  const before = await canvas(page);
  await set(page, 'el', '50');
  assert.equal(await digest(page), planes);
  assert.notEqual((await canvas(page)).hash, before.hash);
  await set(page, 'seed', '5');
  assert.notEqual(await digest(page), planes);
  await close();
});
