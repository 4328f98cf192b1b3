import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, frames, get, message, set, tool } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;
let folder = '';

const SQUARE = '#size=192&cs=16&outline=square';

before(async () => {
  site = await open();
  folder = mkdtempSync(join(tmpdir(), 'bubblestone-outline-'));
});

after(() => {
  rmSync(folder, { recursive: true, force: true });
  return site?.close();
});

/** Opens an outline file in the page. */
async function load(page, content) {
  const path = join(folder, 'outline.json');
  writeFileSync(path, content);
  await tool(page, 'import');
  const input = await page.waitForSelector('#outline-file');
  await input.uploadFile(path);
}

/** Places of the outline's handles on the screen. */
function handles(page) {
  return page.$$eval('button.handle', (all) =>
    all.map((handle) => {
      const box = handle.getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }),
  );
}

test('an outline becomes free when its points are dragged by the mouse', async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const square = await digest(page);
  await click(page, '#edit-outline');
  await page.waitForSelector('.handle');
  assert.equal(await get(page, 'outline'), 'square');
  const [corner] = await handles(page);
  const sheet = await page.$eval('#sheet', (element) => element.getBoundingClientRect().toJSON());
  await page.mouse.move(corner.x, corner.y);
  await page.mouse.down();
  await page.mouse.move(corner.x + (sheet.x + sheet.width / 2 - corner.x) / 2, corner.y + (sheet.y + sheet.height / 2 - corner.y) / 2, { steps: 5 });
  await page.mouse.up();
  await frames(page, 2);
  assert.notEqual(await digest(page), square);
  assert.equal((await page.$$('[role=alert] .message')).length, 0);
  assert.equal(await get(page, 'outline'), 'polygon');
  const link = await page.evaluate(() => window.bubblestone.link());
  assert.match(link, /poly=/);
  const again = await site.newPage(`#${link}`);
  assert.equal(await digest(again.page), await digest(page));
  assert.deepEqual([...problems, ...again.problems], []);
  await again.close();
  await close();
});

test('points are moved, added and removed by the keyboard, and an edge takes a point by double click', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  await page.keyboard.press('e');
  await page.waitForSelector('.handle');
  const count = (await handles(page)).length;
  assert.match(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), /^Point 1 of/);
  const before = (await handles(page))[0];
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.up('Shift');
  assert.ok((await handles(page))[0].x > before.x + 5);
  await page.keyboard.press('Insert');
  assert.equal((await handles(page)).length, count + 1);
  await page.keyboard.press('Delete');
  assert.equal((await handles(page)).length, count);
  const [from, to] = await handles(page);
  // Two presses count as a double click only if the page is not busy between them.
  await digest(page);
  await page.mouse.click(from.x * 0.4 + to.x * 0.6, from.y * 0.4 + to.y * 0.6, { count: 2 });
  assert.equal((await handles(page)).length, count + 1);
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  await close();
});

test('a bad outline is told in words, and the last good one stays until it is mended', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  await click(page, '#edit-outline');
  await page.waitForSelector('.handle');
  await frames(page, 2);
  const good = await digest(page);
  const points = await handles(page);
  const sheet = await page.$eval('#sheet', (element) => element.getBoundingClientRect().toJSON());
  const middle = { x: sheet.x + sheet.width / 2, y: sheet.y + sheet.height / 2 };
  const beyond = { x: middle.x + (middle.x - points[0].x) * 0.4, y: middle.y + (middle.y - points[0].y) * 0.4 };
  // Dragged through the opposite edges, the ring crosses itself.
  await page.mouse.move(points[0].x, points[0].y);
  await page.mouse.down();
  await page.mouse.move(points[1].x + (points[1].x - middle.x) * 0.1, middle.y, { steps: 2 });
  await page.mouse.move(points[2].x, beyond.y, { steps: 2 });
  await page.mouse.move(sheet.x + sheet.width - 2, middle.y, { steps: 2 });
  await page.mouse.up();
  await message(page, 'alert', /ring|cross|outline/i);
  assert.ok(await page.$('.editor.bad'));
  assert.notEqual(good, '');
  assert.match(await digest(page), /^[0-9a-f]+$/);
  await page.mouse.move(sheet.x + sheet.width - 2, middle.y);
  await page.mouse.down();
  await page.mouse.move(points[0].x, points[0].y, { steps: 4 });
  await page.mouse.up();
  await frames(page, 2);
  assert.equal((await page.$$('[role=alert] .message')).length, 0);
  assert.deepEqual(problems, []);
  await close();
});

test('an outline file is opened, holes and all', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const square = await digest(page);
  await load(
    page,
    JSON.stringify({
      size: [512, 512],
      outer: [[20, 20], [490, 30], [480, 490], [30, 480]],
      holes: [[[200, 200], [200, 300], [300, 300], [300, 200]]],
    }),
  );
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'polygon', { timeout: 60_000 });
  await page.waitForSelector('.handle');
  assert.equal((await handles(page)).length, 8);
  assert.notEqual(await digest(page), square);
  assert.deepEqual(problems, []);
  await close();
});

test('an outline file may be dropped anywhere, also among other files', async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  await page.$eval('#panel', (place) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(['a shopping list'], 'list.txt', { type: 'text/plain' }));
    const content = '{"size": [100, 100], "outer": [[10, 10], [90, 10], [50, 90]]}';
    dataTransfer.items.add(new File([content], 'triangle.json', { type: 'application/json' }));
    for (const kind of ['dragenter', 'dragover', 'drop']) {
      place.dispatchEvent(new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true }));
    }
  });
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'polygon', { timeout: 60_000 });
  await page.waitForSelector('.handle');
  assert.equal((await handles(page)).length, 3);
  assert.match(await digest(page), /^[0-9a-f]+$/);
  assert.deepEqual(problems, []);
  await close();
});

test('an outline file of several islands is opened, and each is paved', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  await load(
    page,
    JSON.stringify({
      size: [512, 512],
      rings: [
        [[40, 40], [200, 40], [200, 470], [40, 470]],
        [[260, 200], [470, 200], [470, 470], [260, 470]],
        [[310, 250], [310, 420], [420, 420], [420, 250]], // a hole
        [[300, 40], [420, 40], [420, 150], [300, 150]],
      ],
    }),
  );
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'polygon', { timeout: 60_000 });
  await page.waitForSelector('.handle');
  assert.match(await digest(page), /^[0-9a-f]+$/);
  assert.equal((await handles(page)).length, 16);
  assert.equal((await page.$$('[role=alert] .message')).length, 0);
  assert.deepEqual(problems, []);
  await close();
});

test('an outline file that makes no sense gets a sentence, and the outline stays', sameEverywhere, async (t) => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const square = await digest(page);
  for (const [what, content, words] of [
    ['no outline', 'hello', /neither SVG, nor JSON/],
    ['broken JSON', '{"outer": [[0, 0]', /cannot be read as JSON/],
    ['broken SVG', '<svg><path d="M0 0"', /no path/],
    ['an empty SVG', '<svg xmlns="http://www.w3.org/2000/svg"><text>a</text></svg>', /no path/],
    ['no ring', '{"rings": []}', /no outline/],
    ['a point that is none', '{"outer": [[0, 0], [1, "x"], [3, 3]]}', /point 2/],
    ['a line', '{"size": [512, 512], "outer": [[50, 50], [450, 450]]}', /\S/],
  ]) {
    await t.test(what, async () => {
      await load(page, content);
      await message(page, 'alert', words);
      await message(page, 'alert', /outline stays/);
      assert.equal(await get(page, 'outline'), 'square');
      assert.equal(await digest(page), square);
      await click(page, '[role=alert] .message .close');
      await page.waitForSelector('[role=alert] .message', { hidden: true });
    });
  }
  assert.deepEqual(problems, []);
  await close();
});

test('choosing the free polygon from the list keeps the shape, and another shape shows its own points', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  await set(page, 'outline', 'polygon');
  await page.waitForSelector('.handle');
  assert.equal(await get(page, 'outline'), 'polygon');
  assert.equal((await handles(page)).length, 4);
  await set(page, 'outline', 'star');
  assert.equal((await handles(page)).length, 10);
  assert.equal(await get(page, 'outline'), 'star');
  await close();
});
