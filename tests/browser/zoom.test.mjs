// Zooming the picture by wheel, keys and fingers.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { click, digest, frames, phone, SMALL, SQUARE } from './page.mjs';
import { box, drag, listening, spot } from './sheet.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

const factor = (page) => page.$eval('#sheet', (sheet) => Number(getComputedStyle(sheet).getPropertyValue('--zoom')) || 1);

test('the wheel zooms towards the pointer, dragging moves the picture, and a double click fits it', async () => {
  const { page, problems, close } = await listening(site);
  const at = await spot(page, 0.25, 0.7);
  await page.mouse.move(at.x, at.y);
  for (let k = 0; k < 5; k += 1) await page.mouse.wheel({ deltaY: -120 });
  await page.waitForFunction(() => Number(document.querySelector('#sheet').style.getPropertyValue('--zoom')) > 3);
  const zoom = await factor(page);
  assert.ok(zoom > 2 && zoom < 16, String(zoom));
  const near = await box(page, '#canvas');
  // The place under the pointer, a quarter from the left and seven tenths from the top, has stayed.
  assert.ok(Math.abs(near.x + 0.25 * near.width - at.x) < 1.5 && Math.abs(near.y + 0.7 * near.height - at.y) < 1.5);
  await drag(page, at, { x: at.x + 40, y: at.y - 30 });
  await page.mouse.up();
  const moved = await box(page, '#canvas');
  assert.ok(Math.abs(moved.x - near.x - 40) < 1.5 && Math.abs(moved.y - near.y + 30) < 1.5, JSON.stringify([near, moved]));
  await page.mouse.click(at.x, at.y, { count: 2 });
  await frames(page, 2);
  assert.equal(await factor(page), 1);
  const sheet = await box(page, '#sheet');
  assert.deepEqual(await box(page, '#canvas'), sheet);
  // All the way out, a drag moves nothing, and a double click zooms in.
  await drag(page, at, { x: at.x + 40, y: at.y });
  await page.mouse.up();
  assert.deepEqual(await box(page, '#canvas'), sheet);
  await page.mouse.click(at.x, at.y, { count: 2 });
  await frames(page, 2);
  assert.ok((await factor(page)) > 2);
  assert.equal(await page.$eval('#canvas', (element) => getComputedStyle(element).imageRendering), 'pixelated');
  await page.keyboard.press('f');
  for (const key of ['+', '+', '-']) await page.keyboard.press(key);
  await frames(page, 2);
  assert.equal(await factor(page), 1.5);
  assert.equal(await page.$eval('#zoom-now', (text) => text.textContent), '1.5×');
  await click(page, '#zoom-fit');
  assert.equal(await factor(page), 1);
  assert.deepEqual(problems, []);
  await close();
});

test('points that are edited keep their size when the picture is zoomed, and go where they are dragged', async () => {
  const { page, close } = await listening(site);
  await click(page, '#edit-outline');
  await page.waitForSelector('.handle');
  const before = await box(page, '.handle');
  const sheet = await box(page, '#sheet');
  // Beside the point, so that the wheel is over the picture.
  const centre = ({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 });
  const inwards = (from, far) => ({ x: from.x + far * Math.sign(centre(sheet).x - from.x), y: from.y + far * Math.sign(centre(sheet).y - from.y) });
  const beside = inwards(centre(before), 20);
  await page.mouse.move(beside.x, beside.y);
  for (let k = 0; k < 3; k += 1) await page.mouse.wheel({ deltaY: -120 });
  await frames(page, 2);
  await page.waitForFunction(() => Number(document.querySelector('#sheet').style.getPropertyValue('--zoom')) > 2);
  const handle = await box(page, '.handle');
  assert.ok(Math.abs(handle.width - before.width) < 0.1, String(handle.width));
  const middle = centre(handle);
  const to = inwards(middle, 40);
  await drag(page, middle, to);
  await page.mouse.up();
  const near = await page.$$eval('.handle', (all, { x, y }) => Math.min(...all.map((each) => each.getBoundingClientRect()).map((b) => Math.hypot(b.x + b.width / 2 - x, b.y + b.height / 2 - y))), to);
  assert.ok(near < 2, `the nearest point is ${near} pixels off`);
  await close();
});

test('two fingers zoom, one scrolls the page at fit and moves the picture when it is zoomed', async () => {
  const { page, problems, close } = await listening(site, SQUARE, { viewport: phone });
  const action = () => page.$eval('#sheet', (sheet) => getComputedStyle(sheet).touchAction);
  assert.equal(await action(), 'pan-x pan-y');
  const [a, b] = [await spot(page, 0.4, 0.5), await spot(page, 0.6, 0.5)];
  await page.touchscreen.tap(a.x, a.y);
  await page.waitForSelector('.cell-card', { visible: true });
  const [first, second] = [await page.touchscreen.touchStart(a.x, a.y), await page.touchscreen.touchStart(b.x, b.y)];
  for (let k = 1; k <= 4; k += 1) {
    await first.move(a.x - 20 * k, a.y);
    await second.move(b.x + 20 * k, b.y);
  }
  await first.end();
  await second.end();
  await frames(page, 2);
  const zoom = await factor(page);
  assert.ok(zoom > 2 && zoom < 4.5, String(zoom));
  assert.equal(await page.evaluate(() => visualViewport.scale), 1);
  assert.equal(await action(), 'none');
  const before = await box(page, '#canvas');
  const finger = await page.touchscreen.touchStart(a.x, a.y);
  for (const far of [15, 30, 45]) await finger.move(a.x + far, a.y + far);
  await finger.end();
  await frames(page, 2);
  const after = await box(page, '#canvas');
  assert.ok(Math.abs(after.x - before.x - 45) < 2 && Math.abs(after.y - before.y - 45) < 2, JSON.stringify([before, after]));
  assert.deepEqual(problems, []);
  await close();
});

test('the first turn of the wheel and the first double click zoom, though what answers them comes later', async () => {
  for (const [first, zoom] of [['wheel', '1.2×'], ['dblclick', '3×']]) {
    const { page, problems, close } = await site.newPage(SMALL);
    await digest(page);
    const scrolls = await page.$eval(
      '#canvas',
      (canvas, name) => {
        const { left, top, width, height } = canvas.getBoundingClientRect();
        const at = { clientX: left + width / 2, clientY: top + height / 2, bubbles: true, cancelable: true };
        return canvas.dispatchEvent(name === 'wheel' ? new WheelEvent(name, { ...at, deltaY: -100 }) : new MouseEvent(name, at));
      },
      first,
    );
    assert.equal(scrolls, first !== 'wheel', 'the page scrolls, too');
    await page.waitForSelector('.sheet[data-zoomed]');
    await frames(page, 3);
    assert.equal(await page.$eval('#zoom-now', (text) => text.textContent), zoom);
    assert.deepEqual(problems, []);
    await close();
  }
});
