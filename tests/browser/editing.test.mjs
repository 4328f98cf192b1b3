import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, click, digest, edit, frames, get, link, phone, SQUARE } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const LINED = `${SQUARE}&lines=0.2,0.5,0.8,0.5`;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Places of the handles on the screen. */
function handles(page) {
  return page.$$eval('button.handle', (all) =>
    all.map((handle) => {
      const box = handle.getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }),
  );
}

/** Drags with the mouse. */
async function drag(page, from, [dx, dy]) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + dx, from.y + dy, { steps: 4 });
  await page.mouse.up();
  await frames(page, 2);
}

const noAlerts = async (page) => assert.equal((await page.$$('[role=alert] .message')).length, 0);

test('a line is added and its points are moved by the mouse; the link brings it back', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const plain = await digest(page);
  await edit(page, 'lines');
  assert.equal((await handles(page)).length, 2);
  const added = await digest(page);
  assert.notEqual(added, plain);
  const first = await link(page);
  assert.match(first, /lines=/);
  await drag(page, (await handles(page))[0], [-30, 60]);
  assert.notEqual(await link(page), first);
  assert.notEqual(await digest(page), added);
  await noAlerts(page);
  await click(page, '#edit-done');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  const again = await site.newPage(`#${await link(page)}`);
  assert.equal(await digest(again.page), await digest(page));
  await edit(again.page, 'lines');
  assert.equal((await handles(again.page)).length, 2);
  assert.deepEqual([...problems, ...again.problems], []);
  await again.close();
  await close();
});

test('a whole line is moved by its middle, and a double click gives it a point', sameEverywhere, async () => {
  const { page, close } = await site.newPage(LINED);
  await digest(page);
  await edit(page, 'lines');
  const before = await handles(page);
  const middle = { x: before[0].x * 0.7 + before[1].x * 0.3, y: before[0].y };
  await drag(page, middle, [10, 40]);
  const now = await handles(page);
  for (const k of [0, 1]) {
    assert.ok(Math.abs(now[k].x - before[k].x - 10) < 1.5 && Math.abs(now[k].y - before[k].y - 40) < 1.5);
  }
  // Two presses count as a double click only if the page is not busy between them.
  await digest(page);
  await page.mouse.click(middle.x + 10, middle.y + 40, { count: 2 });
  assert.equal((await handles(page)).length, 3);
  await close();
});

test('a line is added, moved, lengthened and removed by the keyboard alone', async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const plain = await digest(page);
  await all(page);
  await page.focus('#p-lines');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.handle');
  await frames(page, 2);
  const named = () => page.evaluate(() => document.activeElement.getAttribute('aria-label'));
  assert.match(await named(), /^Point 1 of 2, line 1/);
  const links = new Set([await link(page)]);
  const press = async (...keys) => {
    for (const key of keys.slice(0, -1)) await page.keyboard.down(key);
    await page.keyboard.press(keys.at(-1));
    for (const key of keys.slice(0, -1)) await page.keyboard.up(key);
    await frames(page, 2);
    links.add(await link(page));
  };
  const [a, b] = await handles(page);
  await press('Shift', 'ArrowDown');
  await press('Control', 'Shift', 'ArrowLeft');
  const [c, d] = await handles(page);
  assert.ok(c.y > a.y + 5 && Math.abs(d.y - b.y) < 1, 'only one point goes down');
  assert.ok(c.x < a.x - 5 && d.x < b.x - 5, 'both go to the left');
  await press('Insert');
  assert.match(await named(), /^Point 2 of 3, line 1/);
  assert.equal(links.size, 4);
  assert.notEqual(await digest(page), plain);
  await press('Delete');
  await press('Delete');
  assert.equal((await handles(page)).length, 0);
  assert.equal(await get(page, 'lines'), '');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'add-figure');
  assert.equal(await digest(page), plain);
  await press('Escape');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  assert.deepEqual(problems, []);
  await close();
});

test('a finger moves a point of a line', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(LINED, { viewport: phone });
  await digest(page);
  await edit(page, 'lines');
  await page.evaluate(() => scrollTo(0, 0));
  const before = await link(page);
  const [{ x, y }] = await handles(page);
  await page.touchscreen.touchStart(x, y);
  for (const k of [1, 2, 3]) await page.touchscreen.touchMove(x + 10 * k, y + 25 * k);
  await page.touchscreen.touchEnd();
  await frames(page, 2);
  assert.notEqual(await link(page), before);
  const [now] = await handles(page);
  assert.ok(Math.abs(now.x - x - 30) < 2 && Math.abs(now.y - y - 75) < 2, JSON.stringify(now));
  assert.equal(await page.evaluate(() => scrollY), 0);
  await noAlerts(page);
  assert.deepEqual(problems, []);
  await close();
});

test('a stroke turns the rows, and its reset takes it away', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SQUARE}&dir=constant`);
  const plain = await digest(page);
  await edit(page, 'strokes');
  await drag(page, (await handles(page))[1], [-20, 120]);
  assert.notEqual(await digest(page), plain);
  assert.equal(await page.$eval('#p-strokes', (button) => button.textContent), 'Edit 1…');
  assert.equal(await page.$eval('[data-key=reach]', (control) => control.hidden), false);
  await page.$eval('[data-key=strokes] .reset', (button) => button.click());
  assert.equal(await digest(page), plain);
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  await close();
});

test('a spot has a place, a radius and a factor', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  const seen = new Set([await digest(page)]);
  const list = () => get(page, 'spots');
  const texts = new Set([await list()]);
  const look = async () => {
    await frames(page, 2);
    seen.add(await digest(page));
    texts.add(await list());
  };
  await edit(page, 'spots');
  await look();
  const [middle, rim] = await handles(page);
  await drag(page, middle, [30, 20]);
  const moved = await handles(page);
  assert.ok(Math.abs(moved[1].x - rim.x - 30) < 1.5, 'the rim goes with the middle');
  await look();
  await drag(page, moved[1], [40, 0]);
  await look();
  await page.$eval('#figure-value', (box) => {
    box.value = '2';
    box.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await look();
  assert.equal(await page.$eval('.handle', (handle) => handle.dataset.tag), '×2');
  assert.equal(seen.size, 5);
  assert.equal(texts.size, 5);
  await click(page, '#remove-point');
  await look();
  assert.equal(seen.size, 5, 'without the spot all is as before');
  assert.equal(await list(), '');
  await close();
});

test('a part is tapped and gets a kind', async () => {
  const { page, problems, close } = await site.newPage(`${SQUARE}&lines=0,0.5,1,0.5`);
  const plain = await digest(page);
  await edit(page, 'parts');
  assert.equal((await handles(page)).length, 1);
  const circles = await digest(page);
  assert.notEqual(circles, plain);
  const sheet = await page.$eval('#sheet', (element) => element.getBoundingClientRect().toJSON());
  const tap = (part) => page.mouse.click(sheet.x + sheet.width * 0.3, sheet.y + sheet.height * part);
  await tap(0.3);
  await tap(0.7);
  await frames(page, 2);
  assert.equal((await handles(page)).length, 2, 'one for each part');
  await page.select('#figure-kind', 'Ellipse');
  await frames(page, 2);
  const both = await digest(page);
  assert.ok(both !== circles && both !== plain);
  // One part has a kind with an aspect ratio, so its control appears.
  assert.equal(await page.$eval('[data-key=ca]', (control) => control.hidden), false);
  await tap(0.02);
  assert.equal((await handles(page)).length, 2, 'outside there is no part');
  await noAlerts(page);
  assert.deepEqual(problems, []);
  await close();
});

test('what is edited is chosen under the canvas, and only what does something', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  const words = () => page.$$eval('#edit-what option', (options) => options.map((option) => option.value));
  await edit(page, 'strokes');
  assert.deepEqual(await words(), ['outline', 'road', 'lines', 'strokes', 'spots']);
  await page.select('#edit-what', 'lines');
  await click(page, '#add-figure');
  await frames(page, 2);
  assert.deepEqual(await words(), ['outline', 'road', 'lines', 'parts', 'strokes', 'spots']);
  await page.select('#edit-what', 'outline');
  assert.equal(await get(page, 'outline'), 'square');
  assert.equal((await handles(page)).length, 4);
  assert.equal(await page.$eval('#add-figure', (button) => button.textContent), 'Add hole');
  await close();
});

test('the canvas keeps its place when editing begins', async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  const place = () => page.$eval('#canvas', (canvas) => JSON.stringify(canvas.getBoundingClientRect()));
  const before = await place();
  for (const key of ['lines', 'spots']) {
    await edit(page, key);
    assert.equal(await place(), before, key);
  }
  await close();
});
