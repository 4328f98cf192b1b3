// The editor's tools: figures are drawn over the canvas, changed and removed.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, frames, get, handles, link, phone, rings, SQUARE, tool } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Places of the canvas on the screen, from fractions of its side. */
async function placesOf(page) {
  const box = await page.$eval('#sheet', (sheet) => sheet.getBoundingClientRect().toJSON());
  return (x, y) => [box.x + x * box.width, box.y + y * box.height];
}

/** The messages about the outline. */
const messages = (page) => page.$$eval('.message[data-topic=outline]', (notes) => notes.map((note) => note.textContent));

async function drag(page, from, to, between = 6) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: between });
  await page.mouse.up();
  await frames(page, 3);
}

const undo = async (page) => {
  await page.keyboard.down('Control');
  await page.keyboard.press('z');
  await page.keyboard.up('Control');
  await frames(page, 3);
};

test('the editor is loaded when it is first wanted', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  const loaded = () => page.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => /editor-.*\.js/.test(name)));
  assert.equal(await loaded(), false);
  await page.keyboard.press('e');
  await page.waitForSelector('.handle');
  assert.equal(await loaded(), true);
  await close();
});

test('a road is drawn point after point, widened, bent, and taken back step by step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const square = await digest(page);
  await tool(page, 'road');
  const at = await placesOf(page);
  assert.equal(await page.$eval('[data-tool=road]', (button) => button.getAttribute('aria-pressed')), 'true');
  await page.mouse.click(...at(0.1, 0.5));
  await page.mouse.click(...at(0.9, 0.5));
  assert.equal(await get(page, 'outline'), 'square', 'nothing changes before it is finished');
  await page.keyboard.press('Enter');
  await frames(page, 3);
  // A road with straight ends and sides: a rectangle of four corners, 16 hundredths wide.
  const [straight, ...others] = await rings(page);
  assert.equal(others.length, 0);
  assert.equal(straight.length, 4, JSON.stringify(straight));
  for (const [x, y] of straight) {
    assert.ok(Math.abs(Math.abs(y - 0.5) - 0.08) < 0.0015, `side at ${y}`);
    assert.ok(Math.abs(Math.abs(x - 0.5) - 0.4) < 0.004, `end at ${x}`);
  }
  assert.notEqual(await digest(page), square);
  const first = await link(page);
  // Change the width by its number, and by its handle.
  await page.$eval('#figure-value', (box) => {
    box.value = '24';
    box.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await frames(page, 3);
  const wide = await link(page);
  assert.notEqual(wide, first);
  const knob = await page.$eval('.knob', (handle) => {
    const box = handle.getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
  });
  await drag(page, knob, at(0.5, knob[1] < at(0.5, 0.5)[1] ? 0.4 : 0.6));
  assert.ok(Math.abs(Number(await page.$eval('#figure-value', (box) => box.value)) - 20) <= 1);
  const knobbed = await link(page);
  // Add a point at the middle of the edge.
  await drag(page, at(0.5, 0.5), at(0.5, 0.25));
  assert.equal((await handles(page)).length, 3);
  const bent = await link(page);
  for (const before of [knobbed, wide, first]) {
    await undo(page);
    assert.equal(await link(page), before, 'each of them is one step');
    assert.equal((await handles(page)).length, 2, 'the middle line comes back with it');
  }
  assert.notEqual(bent, knobbed);
  await undo(page);
  assert.equal(await get(page, 'outline'), 'square');
  assert.equal((await handles(page)).length, 0);
  assert.equal(await digest(page), square);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('a road that comes back to itself leaves a hole, and one drawn by hand follows the hand', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  await tool(page, 'road');
  const at = await placesOf(page);
  for (const [x, y] of [[0.2, 0.2], [0.8, 0.2], [0.8, 0.8], [0.2, 0.8]]) await page.mouse.click(...at(x, y));
  await page.mouse.click(...at(0.2, 0.2));
  await frames(page, 3);
  assert.equal((await rings(page)).length, 2);
  await click(page, '#edit-done');
  await undo(page);
  assert.equal(await get(page, 'outline'), 'square');
  await tool(page, 'road');
  await page.mouse.move(...at(0.15, 0.75));
  await page.mouse.down();
  for (let k = 1; k <= 24; k += 1) await page.mouse.move(...at(0.15 + (0.7 * k) / 24, 0.5 + 0.25 * Math.cos((Math.PI * k) / 24)));
  await page.mouse.up();
  await frames(page, 3);
  const points = (await handles(page)).length;
  assert.ok(points > 4 && points < 16, `${points} points of the middle line`);
  assert.equal((await rings(page)).length, 1);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('Escape takes back what is drawn, then leaves the points', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  const before = await link(page);
  await tool(page, 'lines');
  const at = await placesOf(page);
  await page.mouse.click(...at(0.3, 0.3));
  await page.mouse.click(...at(0.6, 0.3));
  const drawn = () => page.$eval('.draft', (path) => path.getAttribute('d').split('L').length);
  const points = await drawn();
  await undo(page);
  assert.equal(await drawn(), points - 1, 'undo takes back the last point only');
  assert.equal(await page.$eval('#draw-finish', (button) => button.hidden), false);
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), false);
  assert.equal(await page.$eval('.draft', (path) => path.getAttribute('d')), '');
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  assert.equal(await link(page), before);
  await tool(page, 'lines');
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true, 'also right after the tool was clicked');
  await close();
});

test('a hole is drawn, dragged as a whole, and removed; each is one step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const square = await digest(page);
  await tool(page, 'hole');
  const at = await placesOf(page);
  await drag(page, at(0.4, 0.45), at(0.62, 0.45));
  assert.equal((await handles(page)).length, 10);
  const drawn = await link(page);
  const holed = await digest(page);
  assert.notEqual(holed, square);
  // Drag the line, away from the middle of an edge.
  const points = await handles(page);
  const [a, b] = [points[4], points[5]];
  const grab = [a[0] * 0.75 + b[0] * 0.25, a[1] * 0.75 + b[1] * 0.25];
  await drag(page, grab, [grab[0] + 80, grab[1] + 40]);
  const moved = await handles(page);
  for (let k = 4; k < 10; k += 1) {
    assert.ok(Math.abs(moved[k][0] - points[k][0] - 80) < 1.5 && Math.abs(moved[k][1] - points[k][1] - 40) < 1.5);
  }
  await undo(page);
  assert.equal(await link(page), drawn, 'a drag is one step');
  const back = await handles(page);
  assert.ok(Math.abs(back[4][0] - points[4][0]) < 1, 'the handles follow');
  for (let k = 0; k < 4; k += 1) {
    await page.$eval('button.handle:last-child', (handle) => handle.focus());
    await page.keyboard.press('Delete');
    await frames(page, 2);
  }
  assert.equal((await handles(page)).length, 4, 'a hole of less than three points is none');
  assert.equal((await rings(page)).length, 1);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('a hole may be drawn on what is there, as an island in a hole', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  const at = await placesOf(page);
  for (const rim of [0.75, 0.62]) {
    await tool(page, 'hole');
    await page.waitForSelector('[data-tool=hole][aria-pressed=true]');
    await drag(page, at(0.5, 0.5), at(rim, 0.5));
  }
  const widths = (await rings(page)).map((ring) => Math.max(...ring.map(([x]) => x)) - 0.5);
  assert.equal(widths.length, 3);
  assert.ok(Math.abs(widths[1] - 0.25) < 0.01 && Math.abs(widths[2] - 0.12) < 0.01, JSON.stringify(widths));
  assert.deepEqual(await messages(page), [], 'whichever way round they run');
  // A drag on nothing selects no text.
  await click(page, '#edit-done');
  await drag(page, at(0.04, 0.04), at(0.9, 1.2));
  assert.equal(await page.evaluate(() => String(getSelection())), '');
  await close();
});

test('points come from the middles of edges and go by a double click', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  await tool(page, 'outline');
  const four = await link(page);
  const [a, b] = await handles(page);
  const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const at = await placesOf(page);
  await drag(page, middle, at(0.5, 0.5));
  assert.equal((await handles(page)).length, 5);
  await undo(page);
  assert.equal(await link(page), four, 'adding and dragging is one step');
  assert.equal((await handles(page)).length, 4);
  await drag(page, middle, at(0.5, 0.5));
  await page.keyboard.press('Delete');
  await frames(page, 2);
  assert.equal((await handles(page)).length, 4, 'the keyboard is on the point that came');
  await page.mouse.click(...middle);
  assert.equal((await handles(page)).length, 5);
  // Two presses count as a double click only if the page is not busy between them.
  await digest(page);
  await page.mouse.click(...middle, { count: 2 });
  await frames(page, 2);
  assert.equal((await handles(page)).length, 4);
  await close();
});

test('with Shift a point goes to the grid, to directions and to other points, and a guide tells', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SQUARE);
  await digest(page);
  await tool(page, 'outline');
  const at = await placesOf(page);
  const [box] = [await page.$eval('#sheet', (sheet) => sheet.getBoundingClientRect().toJSON())];
  const corner = (await handles(page))[0];
  const held = async (to) => {
    await page.keyboard.down('Shift');
    await page.mouse.move(...corner);
    await page.mouse.down();
    await page.mouse.move(...to, { steps: 4 });
    await frames(page, 2);
    const guide = await page.$eval('.guide', (path) => path.getAttribute('d'));
    const [x, y] = (await handles(page))[0];
    await page.mouse.up();
    await page.keyboard.up('Shift');
    await frames(page, 2);
    await undo(page);
    return { guide, at: [(x - box.x) / box.width, (y - box.y) / box.height] };
  };
  const grid = await held(at(0.246, 0.348));
  assert.notEqual(grid.guide, '');
  for (const place of grid.at) assert.ok(Math.abs(place * 32 - Math.round(place * 32)) < 0.05, `${place} is on the grid`);
  const others = (await handles(page)).slice(1);
  const side = await held([corner[0] + 60, corner[1] + 3]);
  const [x, y] = [side.at[0] * box.width + box.x, side.at[1] * box.height + box.y];
  const on = others.some(([u, v]) => {
    const angle = (Math.atan2(y - v, x - u) * 12) / Math.PI;
    return Math.abs(angle - Math.round(angle)) < 0.02;
  });
  assert.ok(on, 'in a direction of 15 degrees');
  assert.equal(await page.$eval('.guide', (path) => path.getAttribute('d')), '');
  await close();
});

test('lines, strokes and spots are drawn by dragging', async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  const seen = new Set([await digest(page)]);
  const at = await placesOf(page);
  for (const [name, key] of [['lines', 'lines'], ['strokes', 'strokes'], ['spots', 'spots']]) {
    await tool(page, name);
    await drag(page, at(0.3, 0.35), at(0.6, 0.45));
    assert.match(await get(page, key), /\S/, name);
    assert.equal((await handles(page)).length, 2, name);
    seen.add(await digest(page));
    await click(page, '#edit-done');
  }
  assert.equal(seen.size, 4);
  assert.deepEqual(problems, []);
  await close();
});

test('the tools are used by the keyboard alone', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  await page.focus('[data-tool=outline]');
  assert.equal(await page.$$eval('[data-tool]', (all) => all.filter((one) => one.tabIndex === 0).length), 1, 'one stop for Tab');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.tool), 'road');
  await page.keyboard.press('Enter');
  await page.waitForSelector('button.handle');
  await frames(page, 3);
  assert.equal(await get(page, 'outline'), 'polygon');
  assert.match(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), /^Point 1 of 2, road 1/);
  const before = await link(page);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.up('Shift');
  await frames(page, 3);
  assert.notEqual(await link(page), before);
  await page.focus('[data-tool=road]');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await frames(page, 3);
  assert.match(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), /^Point 1 of 6, hole/);
  assert.equal((await rings(page)).length, 2);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('a finger draws a road, and two fingers do not', async () => {
  const { page, problems, close } = await site.newPage(SQUARE, { viewport: phone });
  await digest(page);
  await tool(page, 'road', true);
  await page.evaluate(() => scrollTo(0, 0));
  const at = await placesOf(page);
  const finger = await page.touchscreen.touchStart(...at(0.2, 0.3));
  await finger.move(...at(0.3, 0.35));
  const other = await page.touchscreen.touchStart(...at(0.7, 0.7));
  await finger.move(...at(0.4, 0.4));
  await other.end();
  await finger.end();
  await frames(page, 3);
  assert.equal(await get(page, 'outline'), 'square');
  assert.equal((await handles(page)).length, 0);
  for (const place of [at(0.2, 0.3), at(0.8, 0.3), at(0.8, 0.8)]) await page.touchscreen.tap(...place);
  await page.tap('#draw-finish');
  await frames(page, 3);
  assert.equal((await handles(page)).length, 3);
  assert.equal(await get(page, 'outline'), 'polygon');
  const sizes = await page.$$eval('.handle:not([hidden]), [data-tool]:not([hidden])', (all) => all.filter((one) => one.checkVisibility()).map((one) => one.getBoundingClientRect()).map(({ width, height }) => Math.min(width, height)));
  assert.ok(Math.min(...sizes) >= 44, String(Math.min(...sizes)));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(problems, []);
  await close();
});
