// Drags that end otherwise than by a release over what they move: outside of it, by Escape, at the place where they
// began, at a limit, or under another recipe. `npm test -- drags`.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { BALL, click, digest, frames, handles, inSight, link, PILE, resize, set, SMALL, SQUARE } from './page.mjs';
import { box, drag, listening, spot } from './sheet.mjs';
import { frame, hash, turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;
before(async () => {
  site = await open();
});
after(() => site.close());

/** Presses just inside an edge, and releases the button outside. @param {Page} page @param {string} selector */
async function leave(page, selector) {
  const { right, y } = await box(page, selector);
  await page.mouse.move(right - 2, y + 200);
  await page.mouse.down();
  await page.mouse.move(right + 1, y + 200);
  await page.mouse.move(right + 60, y + 200, { steps: 3 });
  await page.mouse.up();
}

/** Moves the mouse over the sheet without a button. @param {Page} page */
async function hover(page) {
  const [from, to] = [await spot(page, 0.7, 0.3), await spot(page, 0.3, 0.6)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await frames(page, 2);
}

test('a mouse that is released outside of bodies, or after Escape, turns them no more', async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&camera=330,45`, { still: true });
  await turned(page);
  const stays = async () => {
    const before = await hash(page);
    await hover(page);
    assert.equal(await page.$('#turn[data-held]'), null);
    assert.equal(await hash(page), before);
  };
  await leave(page, '#turn');
  await page.waitForSelector('#turn:not([data-held])');
  await stays();
  await drag(page, await spot(page, 0.5, 0.6), await spot(page, 0.6, 0.6));
  await page.waitForSelector('#turn[data-held]');
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => !document.querySelector('#turn'));
  await page.mouse.up();
  await click(page, '#turn-button');
  await page.waitForSelector('#turn');
  await stays();
  assert.deepEqual(problems, []);
  await close();
});

test('a mouse that is released outside of the picture moves it no more', async () => {
  const { page, problems, close } = await listening(site, SQUARE, { still: true });
  await click(page, '#zoom-in');
  await click(page, '#zoom-in');
  await page.waitForFunction(() => document.querySelector('#zoom-now')?.textContent === '2.3×');
  const before = await box(page, '#pane');
  await leave(page, '#sheet');
  await hover(page);
  assert.equal(await page.$('#sheet[data-panning]'), null);
  assert.deepEqual(await box(page, '#pane'), before);
  assert.deepEqual(problems, []);
  await close();
});

test('a drag that changes no camera keeps the frame, and its state', async () => {
  for (const recipe of [SMALL, BALL]) {
    const { page, problems, close } = await site.newPage(`${recipe}&camera=330,90`, { fine: true, still: true });
    await turned(page, 'fine');
    const before = await frame(page);
    await drag(page, await spot(page, 0.5, 0.4), await spot(page, 0.5, 0.6));
    await page.waitForSelector('#turn[data-held]');
    await turned(page, 'fine');
    await page.mouse.up();
    await page.waitForSelector('#turn:not([data-held])');
    await turned(page, 'fine');
    assert.deepEqual(await frame(page), before);
    assert.deepEqual(problems, []);
    await close();
  }
});

test('a slider that is dragged back to where it began has ended its drag', async () => {
  const { page, problems, close } = await site.newPage(`${PILE}&cut=0,1,0,0.05`, { still: true });
  await turned(page);
  const { x, y, width, height } = await inSight(page, '#turn-cut-at');
  const [thumb, middle] = [18, y + height / 2];
  const at = x + thumb / 2 + ((width - thumb) * 0.75) / 1.4;
  await page.mouse.move(at, middle);
  await page.mouse.down();
  await page.mouse.move(at + 20, middle, { steps: 3 });
  await turned(page, 'moving');
  await page.mouse.move(at, middle, { steps: 3 });
  await page.mouse.up();
  await turned(page);
  assert.equal(await page.$eval('#turn-cut-at', (slider) => /** @type {HTMLInputElement} */ (slider).value), '0.05');
  assert.deepEqual(problems, []);
  await close();
});

test('the card of a body stays in its frame, and closes with the recipe of the body', async () => {
  const { page, problems, close } = await site.newPage(BALL, { still: true });
  await turned(page);
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.turn-card[data-picked]', { visible: true });
  const isInside = () =>
    page.waitForFunction(() => {
      const [card, stand] = ['.turn-card', '#turn'].map((one) => document.querySelector(one)?.getBoundingClientRect());
      return card && stand && card.width > 0 && card.bottom <= stand.bottom + 1 && card.right <= stand.right + 1;
    });
  await isInside();
  await resize(page, { width: 900, height: 620 });
  await isInside();
  await page.focus('#turn-how');
  await set(page, 'cn', '90');
  await page.waitForSelector('.turn-card', { hidden: true });
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'turn', 'the focus is lost');
  assert.deepEqual(problems, []);
  await close();
});

test('another recipe ends the drag of a point, which changes it no more', async () => {
  const { page, problems, close } = await site.newPage(SQUARE, { still: true });
  await digest(page);
  await click(page, '#edit-outline');
  await page.waitForSelector('button.handle');
  await frames(page, 2);
  const [[x, y] = [0, 0]] = await handles(page);
  await drag(page, { x, y }, { x: x + 30, y: y + 30 });
  assert.match(await link(page), /poly=/);
  const other = 'v=1&size=192&cs=20';
  // The last move is not yet drawn when the recipe changes.
  await page.evaluate((fragment) => {
    const layer = /** @type {HTMLElement} */ (document.querySelector('#editor'));
    const { left, top } = layer.getBoundingClientRect();
    layer.dispatchEvent(new PointerEvent('pointermove', { pointerId: 1, pointerType: 'mouse', buttons: 1, clientX: left + 90, clientY: top + 90, bubbles: true }));
    location.hash = fragment;
  }, other);
  await page.waitForFunction((fragment) => /** @type {any} */ (window).bubblestone.link() === fragment, {}, other);
  await page.mouse.move(x + 60, y + 60);
  await page.mouse.up();
  await frames(page, 2);
  assert.equal(await link(page), other);
  await page.keyboard.press('Escape');
  await page.waitForSelector('#editor', { hidden: true });
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'edit-outline', 'the focus is lost');
  await click(page, '#edit-outline');
  await page.waitForSelector('#editor:not([hidden])');
  assert.ok((await handles(page)).length > 4, 'the ring has the points of the square');
  assert.deepEqual(problems, []);
  await close();
});
