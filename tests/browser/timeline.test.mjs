// The timeline: a slider through the steps of a forming, on and back.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { BALL, BRICKS, canvas, click, digest, done, frames, PILE, SMALL, steps } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** The step that the timeline shows, and the number of all steps. @param {Page} page */
function shown(page) {
  return page.$eval('#moment', (slider) => [Number(slider.value), Number(slider.max)]);
}

/** Waits until the forming pauses at a step that `is` accepts, and is drawn. @param {Page} page @param {(step: number) => boolean} is */
async function paused(page, is) {
  await page.waitForFunction(() => document.querySelector('#play')?.getAttribute('data-does') === 'play');
  await frames(page, 3);
  const [step] = await shown(page);
  assert.ok(is(step), `paused at ${step}`);
  assert.equal(await steps(page), step);
  return step;
}

/** Moves the slider to a step. @param {Page} page @param {number} step */
async function seek(page, step) {
  await page.$eval(
    '#moment',
    (slider, to) => {
      slider.value = String(to);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    },
    step,
  );
}

/** A finished page with its timeline. @param {string} fragment @param {import('./harness.mjs').PageOptions} [options] */
async function formed(fragment, options = {}) {
  const opened = await site.newPage(fragment, options);
  const planes = await digest(opened.page);
  await opened.page.waitForSelector('#moment:enabled');
  return { ...opened, planes };
}

test('the slider goes to any step, on and back, and each step has one picture', async () => {
  const { page, planes, problems, close } = await formed(SMALL);
  const [end, all] = await shown(page);
  assert.ok(end === all && all > 8, `${end} of ${all}`);
  assert.equal(await page.$eval('#timeline output', (text) => text.textContent), `Step ${all} of ${all}`);
  await seek(page, 5);
  await paused(page, (step) => step === 5);
  const fifth = await canvas(page);
  await seek(page, 8);
  await paused(page, (step) => step === 8);
  const eighth = await canvas(page);
  assert.notEqual(eighth.hash, fifth.hash);
  await seek(page, 5);
  await paused(page, (step) => step === 5);
  assert.equal((await canvas(page)).hash, fifth.hash);
  // By keys, and by the button that goes back.
  await page.focus('#moment');
  await page.keyboard.press('ArrowRight');
  await paused(page, (step) => step === 6);
  await click(page, '#step-back');
  await paused(page, (step) => step === 5);
  assert.equal((await canvas(page)).hash, fifth.hash);
  await page.focus('#moment');
  await page.keyboard.press('Home');
  await paused(page, (step) => step === 0);
  await page.keyboard.press('End');
  assert.equal(await digest(page), planes);
  assert.deepEqual(problems, []);
  await close();
});

test('on a surface the slider goes back and on, and the bodies at the end are the same', sameEverywhere, async () => {
  const { page, planes, problems, close } = await formed(BALL, { viewport: low });
  const [, all] = await shown(page);
  for (const step of [12, 9, 10]) {
    await seek(page, step);
    await paused(page, (now) => now === step);
  }
  await page.focus('#moment');
  await page.keyboard.press('End');
  assert.equal(await digest(page), planes);
  assert.deepEqual(await shown(page), [all, all]);
  assert.deepEqual(problems, []);
  await close();
});

test('a pause on the way to a step leaves it, and playing on ends with the same picture', async () => {
  const { page, planes, problems, close } = await formed(SMALL);
  const [, all] = await shown(page);
  await seek(page, 8);
  await paused(page, (step) => step === 8);
  // The slider and the button in one task: no step is made in between.
  await page.evaluate(() => {
    const slider = document.querySelector('#moment');
    slider.value = '5';
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    document.querySelector('#play').click();
  });
  await page.waitForSelector('#play[data-does="play"]');
  await click(page, '#speed [value="100000"]');
  await click(page, '#play');
  await done(page);
  assert.equal(await digest(page), planes);
  assert.equal(await steps(page), all);
  assert.deepEqual(await shown(page), [all, all]);
  assert.deepEqual(problems, []);
  await close();
});

test('a step back in a wall or a pile takes away what the last step brought', sameEverywhere, async () => {
  for (const fragment of [BRICKS, PILE]) {
    const { page, planes, problems, close } = await formed(fragment, { viewport: low });
    const [, all] = await shown(page);
    await seek(page, Math.round(all / 2));
    const middle = await paused(page, (step) => step >= all / 2 && step < all);
    await click(page, '#step-back');
    await page.waitForFunction((before) => Number(document.querySelector('#moment')?.value) < before, {}, middle);
    const before = await paused(page, (step) => step > 0 && step < middle);
    await click(page, '#step');
    await page.waitForFunction((step) => Number(document.querySelector('#moment')?.value) === step, {}, middle);
    assert.ok(before < middle);
    await click(page, '#speed [value="100000"]');
    await click(page, '#play');
    await done(page);
    assert.equal(await digest(page), planes);
    assert.deepEqual(problems, []);
    await close();
  }
});

test('nothing is to be gone through before the first steps, nor while two pictures are compared', sameEverywhere, async () => {
  const { page, problems, close } = await formed(SMALL);
  await click(page, '#compare-button');
  await page.waitForSelector('#moment:disabled');
  assert.equal(await page.$eval('#timeline output', (text) => text.textContent), '');
  await click(page, '#compare-button');
  await page.waitForSelector('#moment:enabled');
  assert.deepEqual(problems, []);
  await close();
});
