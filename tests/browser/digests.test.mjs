import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { digest, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

// The same file that the native tests and those under Node compare with.
const golden = readFileSync(new URL('../digests.txt', import.meta.url), 'utf8')
  .trim()
  .split('\n')
  .map((line) => line.split(' '));

test('every preset has the same planes in the browser as natively', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await page.$eval('#speed label:last-child input', (radio) => radio.click());
  const found = [];
  for (const [name] of golden) {
    await page.$eval(`[data-preset="${name}"]`, (button) => button.click());
    found.push([name, await digest(page)]);
  }
  assert.deepEqual(found, golden);
  assert.equal((await page.$$('[data-preset]')).length, golden.length);
  assert.deepEqual(problems, []);
  await close();
});

test('frames from a slant are those that are made natively', async () => {
  const frames = readFileSync(new URL('../frames.txt', import.meta.url), 'utf8').trim().split('\n');
  for (const line of frames) {
    const [hash, camera, link] = /** @type {[string, string, string]} */ (line.split(' '));
    const { page, problems, close } = await site.newPage(`#${link}`);
    await digest(page);
    const found = await page.evaluate((from) => /** @type {any} */ (window).bubblestone.frame(from), camera === '-' ? '' : camera);
    assert.equal(found, hash, line);
    assert.deepEqual(problems, []);
    await close();
  }
});
