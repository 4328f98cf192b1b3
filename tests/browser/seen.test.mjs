// Links with a view: overlays, speed, the step to pause at, and zoom.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, done, link, message, messages, phone, reloading, SMALL, steps } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

const VIEW = 'view=packed+forces&pace=0.25&step=7&zoom=2.5,0.31,0.62';

/** Waits until the packing pauses at a step, the step is drawn, and the page has its functions for scripts. */
const held = (page, step) =>
  page.waitForFunction((count) => 'bubblestone' in window && document.querySelector('#play')?.dataset.does === 'play' && Number(document.querySelector('#count-steps')?.textContent) === count, { timeout: 60_000 }, step);

/** Waits until the address has these words of the view; '' for none. */
const addressed = (page, words) =>
  page.waitForFunction((wanted) => (/(view|pace|step|zoom)=.*/.exec(location.hash)?.[0] ?? '') === wanted, { timeout: 60_000 }, words);

const zoom = (page) => page.$eval('#sheet', (sheet) => ['--zoom', '--pan-x', '--pan-y'].map((name) => Number(sheet.style.getPropertyValue(name))));

/** The visible state, for comparison. */
const shown = (page) =>
  page.evaluate(() => ({
    view: document.querySelector('#view').value,
    picture: document.querySelector('#canvas').toDataURL(),
    zoom: document.querySelector('#zoom-now').textContent,
  }));

test('a link opens at its step, in its view, again when it is loaded anew, and plays on to the same planes', sameEverywhere, async () => {
  const plain = await site.newPage(SMALL);
  const planes = await digest(plain.page);
  await plain.close();
  const { page, problems, close } = await site.newPage(`${SMALL}&${VIEW}`);
  await held(page, 7);
  await page.waitForSelector('.sheet[data-zoomed]');
  await addressed(page, VIEW);
  assert.deepEqual(await zoom(page), [2.5, 0.5 - 0.31 * 2.5, 0.5 - 0.62 * 2.5]);
  assert.equal(await link(page), 'v=1&size=192&cs=16');
  assert.equal(await page.$eval('#undo', (button) => button.disabled), true);
  const first = await shown(page);
  assert.deepEqual([first.view, first.zoom], ['packed', '2.5×']);
  await reloading(page, () => page.reload());
  await held(page, 7);
  await page.waitForSelector('.sheet[data-zoomed]');
  assert.deepEqual(await shown(page), first);
  await click(page, '#step');
  await held(page, 8);
  await addressed(page, '');
  await click(page, '#play');
  assert.equal(await digest(page), planes);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('a link to a step comes with its timeline, though nothing is finished', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&step=6`);
  await page.waitForFunction(() => /Step 6/.test(document.querySelector('#timeline output')?.textContent ?? ''));
  assert.notEqual(await page.evaluate(() => document.documentElement.dataset.stage), 'done');
  assert.deepEqual(problems, []);
  await close();
});

test('a packing that ends before the step is held at its end, and what cannot be shown is told', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&step=9999&view=cells+moon&zoom=40&pace=x`, { viewport: phone });
  await message(page, 'status', /ends after \d+ steps, before step 9999/);
  await message(page, 'status', /“moon” is no layer.*“40” was given\. Kept 16.*“x” was given/s);
  const ended = await steps(page);
  await addressed(page, 'view=cells&step=9999&zoom=16,0.5,0.5');
  assert.equal(await page.$eval('#play', (button) => button.dataset.does), 'play');
  assert.notEqual(await page.evaluate(() => document.documentElement.dataset.stage), 'done');
  await click(page, '#play');
  await done(page);
  assert.equal(await steps(page), ended);
  await addressed(page, '');
  assert.deepEqual(problems, []);
  await close();
});

test('the view leaves the address when the visitor goes on from it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&${VIEW}`);
  for (const [at, act] of [
    () => page.select('#view', 'cells'),
    () => page.$eval('#speed [value="3"]', (radio) => radio.click()),
    () => click(page, '#zoom-in'),
    () => click(page, '#play'),
    () => click(page, '#seed-next'),
  ].entries()) {
    if (at) await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&${VIEW}`);
    await held(page, 7);
    await page.waitForFunction(() => document.querySelector('#zoom-now').textContent === '2.5×');
    await addressed(page, VIEW);
    await act();
    await addressed(page, '');
  }
  assert.deepEqual(problems, []);
  await close();
});

test('an address typed over opens in its view, from the start up to its step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const planes = await digest(page);
  const before = await link(page);
  for (const step of [3, 5]) {
    await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&view=mesh+size&step=${step}`);
    await held(page, step);
    assert.equal(await page.$eval('#view', (select) => select.value), 'mesh');
  }
  await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&view=moon`);
  await message(page, 'status', /“moon” is no view\. There are auto, .*Kept auto/);
  assert.equal(await link(page), before);
  await click(page, '#play');
  assert.equal(await digest(page), planes);
  assert.deepEqual(problems, []);
  await close();
});

test('the dialog puts what is seen into link, code and frame, and the frame shows it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&${VIEW}`);
  await held(page, 7);
  await page.waitForSelector('.sheet[data-zoomed]');
  await click(page, '#share');
  await page.waitForSelector('#share-dialog[open]');
  const texts = () => page.evaluate(() => ['#share-link', '#embed-code'].map((box) => document.querySelector(box).value));
  const code = () => page.$eval('.qr', (svg) => svg.innerHTML);
  const [plain, plainCode] = [await texts(), await code()];
  for (const text of plain) assert.doesNotMatch(text, /view|step/);
  await page.focus('#share-seen');
  await page.keyboard.press('Space');
  const [asSeen, frame] = await texts();
  assert.ok(asSeen.endsWith(`#v=1&size=192&cs=16&${VIEW}`), asSeen);
  assert.ok(frame.includes(`?embed#v=1&amp;size=192&amp;cs=16&amp;${VIEW.replaceAll('&', '&amp;')}"`), frame);
  assert.notEqual(await code(), plainCode);
  assert.equal(await page.$eval('#share-sees', (note) => note.textContent), 'The link then shows: Packing + Forces, 0.25 steps a frame, paused at step 7, 2.5×.');
  await page.keyboard.press('Space');
  assert.deepEqual(await texts(), plain);
  await page.keyboard.press('Escape');
  const { picture } = await shown(page);
  const embedded = await site.newPage(`?embed${new URL(asSeen).hash}`);
  await embedded.page.waitForFunction(() => document.querySelector('.embed-play')?.title === 'Play', { timeout: 60_000 });
  await embedded.page.waitForFunction((wanted) => document.querySelector('#canvas').toDataURL() === wanted, { timeout: 60_000 }, picture);
  assert.deepEqual(await zoom(embedded.page), await zoom(page));
  assert.equal(await embedded.page.$eval('.embed-home', (a) => a.href), asSeen);
  await click(embedded.page, '.embed-play');
  await done(embedded.page);
  assert.deepEqual([...problems, ...embedded.problems], []);
  await embedded.close();
  await close();
});

test('where nothing differs from what all see there is nothing to choose', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL, { still: true });
  await digest(page);
  await click(page, '#share');
  await page.waitForSelector('#share-dialog[open]');
  assert.equal(await page.$eval('#share-seen', (box) => box.disabled), true);
  assert.match(await page.$eval('#share-sees', (note) => note.textContent), /as the link shows it anyway/);
  assert.deepEqual(problems, []);
  await close();
});

test('the bare address of a link with a view is the default recipe, not the last work', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await click(page, '#seed-next');
  await digest(page);
  await reloading(page, () => page.evaluate(() => {
    location.hash = 'view=cells&step=2';
    location.reload();
  }));
  await held(page, 2);
  assert.equal(await link(page), '');
  await addressed(page, 'view=cells&step=2');
  assert.deepEqual(problems, []);
  await close();
});

test('the words for looking closer stand in both languages, with the same places for values', sameEverywhere, () => {
  const { en, ja } = JSON.parse(readFileSync(new URL('../../www/strings/look.json', import.meta.url), 'utf8'));
  assert.deepEqual(Object.keys(ja), Object.keys(en));
  const places = (text) => (text.match(/\{\w+\}/g) ?? []).sort();
  for (const key of Object.keys(en)) assert.deepEqual(places(ja[key]), places(en[key]), key);
});
