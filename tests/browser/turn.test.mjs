// The turntable: a picture's bodies seen by a camera.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { dist, low, open } from './harness.mjs';
import { BALL, click, digest, frames, link, message, phone, reloading, set, SMALL } from './page.mjs';
import { opened, saved } from './saved.mjs';
import { box, drag, spot } from './sheet.mjs';
import { frame, told, turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

test('it is turned by keys, tells where it is seen from, and is no step of the recipe', sameEverywhere, async () => {
  const { page, problems, external, close } = await site.newPage(SMALL);
  const planes = await digest(page);
  const recipe = await link(page);
  await page.keyboard.press('g');
  await turned(page);
  const first = await frame(page);
  assert.ok(first.colours > 100, `${first.colours} colours`);
  const sheet = await box(page, '#sheet');
  assert.deepEqual([first.width, first.height], [Math.round(sheet.width), Math.round(sheet.height)]);
  assert.match(await told(page), /^\d+ stones, seen from the lower left, 40 degrees above the ground, from near\.$/);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'turn');
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowUp']) await page.keyboard.press(key);
  await page.waitForFunction(() => /from the lower edge, 45 degrees/.test(document.querySelector('#turn-seen')?.textContent ?? ''));
  await turned(page);
  const other = await frame(page);
  assert.notEqual(other.hash, first.hash);
  for (const key of ['+', '+', '+', '+', '+']) await page.keyboard.press(key);
  await page.waitForFunction(() => /from close by/.test(document.querySelector('#turn-seen')?.textContent ?? ''));
  await page.keyboard.press('Home');
  await turned(page);
  assert.equal((await frame(page)).hash, first.hash);
  assert.deepEqual([await link(page), await digest(page)], [recipe, planes]);
  assert.equal(await page.$eval('#undo', (undo) => /** @type {HTMLButtonElement} */ (undo).disabled), true);
  // Another light gives other frames.
  await set(page, 'az', '45');
  await turned(page);
  assert.notEqual((await frame(page)).hash, first.hash);
  await page.focus('#turn');
  await page.keyboard.press('Escape');
  assert.deepEqual(await page.evaluate(() => [document.activeElement?.id, document.querySelector('#turn')]), ['turn-button', null]);
  // Each time the slant opens, its first camera follows the light.
  await page.keyboard.press('g');
  await page.waitForFunction(() => /from the upper right, 40 degrees/.test(document.querySelector('#turn-seen')?.textContent ?? ''));
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('a link with a camera opens on the slant, and shows the same when it is loaded anew', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&camera=20,50,1.2`);
  await turned(page);
  const first = await frame(page);
  assert.ok(await page.evaluate(() => document.activeElement === document.body), 'the focus was moved');
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  const shared = await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value);
  assert.match(shared, /&camera=20,50,1\.2$/);
  await page.keyboard.press('Escape');
  await reloading(page, () => page.reload());
  await turned(page);
  assert.deepEqual(await frame(page), first);
  // Scripts can get the hash of the still frame, from this camera and from others.
  const [here, same, there] = await page.evaluate(() => Promise.all([undefined, '20,50,1.2', '200'].map((from) => /** @type {any} */ (window).bubblestone.frame(from))));
  assert.match(here, /^[0-9a-f]{16}$/);
  assert.deepEqual([same === here, there === here], [true, false]);
  await click(page, '#tile-button');
  assert.equal(await page.$('#turn'), null, 'the tile is covered');
  assert.deepEqual(problems, []);
  await close();
});

test('the page is scrolled over it, by one finger and by the wheel, and two fingers come closer', async () => {
  const { page, problems, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  await page.$eval('#turn-button', (button) => /** @type {HTMLElement} */ (button).click());
  await turned(page);
  const action = await page.$eval('#turn', (stand) => getComputedStyle(stand).touchAction);
  assert.equal(action, 'pan-y');
  const before = await told(page);
  const wheel = (deltaY) =>
    page.$eval(
      '#turn',
      (stand, delta) => {
        const { left, top } = stand.getBoundingClientRect();
        return stand.dispatchEvent(new WheelEvent('wheel', { deltaY: delta, clientX: left + 100, clientY: top + 100, bubbles: true, cancelable: true }));
      },
      deltaY,
    );
  assert.equal(await wheel(100), true, 'the wheel is kept from the page');
  const at = await spot(page, 0.5, 0.5);
  const stroke = async (dx, dy) => {
    const finger = await page.touchscreen.touchStart(at.x, at.y);
    for (let k = 1; k <= 5; k += 1) await finger.move(at.x + (k * dx) / 5, at.y + (k * dy) / 5);
    await finger.end();
    await frames(page, 3);
  };
  await stroke(0, -60);
  assert.equal(await told(page), before);
  await page.evaluate(() => scrollTo(0, 0));
  await stroke(120, 0);
  await page.waitForFunction((was) => document.querySelector('#turn-seen')?.textContent !== was, {}, before);
  const aside = /seen from [^,]+,/.exec((await told(page)) ?? '')?.[0] ?? '';
  assert.equal(await wheel(-100), false, 'the first turn of the wheel comes no closer');
  const fingers = [await page.touchscreen.touchStart(at.x - 20, at.y), await page.touchscreen.touchStart(at.x + 20, at.y)];
  for (let k = 1; k <= 5; k += 1) for (const [which, finger] of fingers.entries()) await finger.move(at.x + (which ? 1 : -1) * (20 + 22 * k), at.y);
  await fingers[1]?.end();
  // The finger that stays turns the bodies.
  for (let k = 1; k <= 5; k += 1) await fingers[0]?.move(at.x - 130 + 24 * k, at.y);
  await fingers[0]?.end();
  await page.waitForFunction((was) => /from close by/.test(document.querySelector('#turn-seen')?.textContent ?? '') && !document.querySelector('#turn-seen')?.textContent?.includes(was), {}, aside);
  assert.equal(await page.evaluate(() => visualViewport?.scale), 1, 'the page itself was zoomed');
  assert.deepEqual(problems, []);
  await close();
});

test('a mouse turns it, moves its ground with Shift, and comes closer to what it points at', async () => {
  // Stones have to be large compared with the steps of the pointer.
  const { page, problems, close } = await site.newPage('#size=192&cs=30&outline=square&camera=330,45', { still: true });
  await turned(page);
  /** The body under the pointer at a place; 'none' if there is none. */
  const body = async ({ x, y }) => {
    await page.mouse.move(2, 2);
    await page.waitForSelector('#turn:not([data-body])');
    await turned(page);
    await page.mouse.move(x, y);
    await page.waitForSelector('#turn[data-body]');
    return page.$eval('#turn', (stand) => stand.getAttribute('data-body'));
  };
  const { x, y } = await spot(page, 0.35, 0.6);
  const at = { x: Math.round(x), y: Math.round(y) };
  // Well inside a stone, places a few pixels apart hit the same one.
  const near = (off) => body({ x: at.x + off, y: at.y + off });
  const inside = async () => {
    const first = await near(-6);
    return first !== 'none' && first === (await near(6));
  };
  while (!(await inside())) at.x += 4;
  const stone = await body(at);
  assert.match(stone ?? '', /^\d+$/);
  assert.equal(await page.$eval('.turn-card', (card) => card.querySelector('strong')?.textContent), `Stone ${stone}`);
  for (let k = 0; k < 3; k += 1) await page.mouse.wheel({ deltaY: -100 });
  assert.equal(await body(at), stone);
  const to = { x: at.x + 44, y: at.y - 22 };
  await page.keyboard.down('Shift');
  await drag(page, at, to);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  assert.equal(await body(to), stone);
  const { width } = await box(page, '#sheet');
  await drag(page, to, { x: to.x + (40 / 220) * width, y: to.y + (10 / 130) * width });
  await page.mouse.up();
  await page.waitForFunction(() => /seen from the lower edge, 55 degrees/.test(document.querySelector('#turn-seen')?.textContent ?? ''));
  // In this small frame the card of the first click comes under the second one.
  await page.mouse.click(to.x, to.y);
  await page.waitForSelector('.turn-card[data-picked]', { visible: true });
  assert.ok(await page.evaluate(({ x, y }) => document.elementFromPoint(x, y)?.closest('.turn-card') !== null, to));
  await page.mouse.down({ clickCount: 2 });
  await page.mouse.up({ clickCount: 2 });
  await page.waitForFunction(() => /seen from the lower left, 40 degrees/.test(document.querySelector('#turn-seen')?.textContent ?? ''));
  await page.waitForSelector('.turn-card', { hidden: true });
  assert.deepEqual(problems, []);
  await close();
});

test('how a stone is made goes forward and back', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&outline=square&camera=330,60`);
  await turned(page);
  const all = await frame(page);
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#turn-how');
  assert.match(await page.$eval('#cell-said', (text) => text.textContent), /^Stone \d+, Size [\d.]+, asked [\d.]+.*how it is made\.$/);
  await page.keyboard.press('Enter');
  await page.waitForSelector('.turn-making', { visible: true });
  await turned(page);
  const seen = [];
  const step = async (key) => {
    if (key) await page.keyboard.press(key);
    await turned(page);
    seen.push([await page.$eval('.turn-step strong', (name) => name.textContent), (await frame(page)).hash]);
  };
  for (const key of [undefined, '.', 'ArrowRight', 'ArrowLeft', ',']) await step(key);
  assert.deepEqual(seen.map(([name]) => name), ['Base', 'Sweep', 'Distortion', 'Sweep', 'Base']);
  assert.deepEqual([seen[3]?.[1], seen[4]?.[1]], [seen[1]?.[1], seen[0]?.[1]]);
  assert.equal(new Set(seen.map(([, hash]) => hash)).size, 3);
  const count = (await page.$$('.turn-dot')).length;
  for (let k = 0; k < count + 2; k += 1) await page.keyboard.press('.');
  await turned(page);
  assert.match(await told(page), new RegExp(`^Stone \\d+, step ${count} of ${count}: Colour and light\\.$`));
  const sentences = await page.$$eval('.turn-dot', async (dots) => {
    const notes = [];
    for (const dot of dots) {
      /** @type {HTMLElement} */ (dot).click();
      notes.push(document.querySelector('.turn-note')?.textContent ?? '');
    }
    return notes;
  });
  for (const sentence of sentences) assert.match(sentence, /\w{3}.*\. Miyata, Itoh, Shimada 2000\.$/);
  await page.keyboard.press('Escape');
  await turned(page);
  assert.equal((await frame(page)).hash, all.hash);
  assert.deepEqual(problems, []);
  await close();
});

test('a card that comes under the finger is opened by it, and none of its buttons is pressed', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BALL, { viewport: { ...phone, width: 844, height: 390 } });
  await turned(page);
  const { x, y } = await spot(page, 0.5, 0.5);
  await page.touchscreen.tap(x, y);
  await page.waitForSelector('#turn-how', { visible: true });
  await frames(page, 5);
  assert.ok(await page.$eval('#turn-how', (button) => button.checkVisibility()), 'the card stays');
  assert.ok(await page.$eval('.turn-making', (strip) => !strip.checkVisibility()), 'nothing is pressed');
  await page.tap('#turn-how');
  await page.waitForSelector('.turn-making', { visible: true });
  assert.deepEqual(problems, []);
  await close();
});

test('a finger opens how a stone of a surface is made, and a link opens the same step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BALL, { viewport: phone });
  await turned(page);
  const { x, y } = await spot(page, 0.5, 0.5);
  await page.touchscreen.tap(x, y);
  await page.waitForSelector('#turn-how');
  const card = await page.$eval('.turn-card', (text) => text.textContent ?? '');
  for (const fact of [/^Stone \d+/, /Size[\d.]+, asked [\d.]+/, /Sides\d/, /Neighbours\d/, /Area\d+/]) assert.match(card, fact);
  await page.tap('#turn-how');
  await page.waitForSelector('.turn-making', { visible: true });
  await turned(page);
  const names = await page.$$eval('.turn-dot', (dots) => dots.map((dot) => dot.getAttribute('aria-label')));
  assert.deepEqual(names.slice(0, 4), ['Cell on the surface', 'Tangent plane', 'Base', 'Sweep']);
  assert.deepEqual(names.slice(-4), ['Fractal noise', 'Fewer triangles', 'Bent to the surface', 'Colour and light']);
  const first = await frame(page);
  await page.tap('#turn-on');
  await turned(page);
  const [flat, step] = [await frame(page), await told(page)];
  assert.notEqual(flat.hash, first.hash);
  assert.match(step ?? '', /^Stone \d+, step 2 of \d+: Tangent plane\.$/);
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  const shared = await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value);
  assert.equal(await page.$eval('#share-sees', (line) => line.textContent), 'The link then shows: how one body is made.');
  assert.match(shared, /&body=\d+:1$/);
  await page.keyboard.press('Escape');
  const other = await site.newPage(new URL(shared).hash, { viewport: phone });
  await other.page.waitForSelector('.turn-making', { visible: true });
  await turned(other.page);
  assert.deepEqual([await frame(other.page), await told(other.page)], [flat, step]);
  await other.page.tap('#turn-all');
  await turned(other.page);
  assert.match((await told(other.page)) ?? '', /^\d+ stones, seen/);
  assert.deepEqual([problems, other.problems], [[], []]);
  await other.close();
  await close();
});

test('frames at rest are refined if the visitor wants fine pictures', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&camera=330,60`, { fine: true });
  await turned(page, 'fine');
  const refined = await frame(page);
  await click(page, '#layers-button');
  await click(page, '#fine');
  await turned(page);
  assert.notEqual((await frame(page)).hash, refined.hash);
  await click(page, '#fine');
  await turned(page, 'fine');
  assert.deepEqual(await frame(page), refined);
  assert.deepEqual(problems, []);
  await close();
});

test('depth, normals, numbers and coverage are looked at instead of light', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&camera=330,60`, { fine: true });
  await turned(page, 'fine');
  const light = await frame(page);
  const seen = new Map();
  for (const [plane, last] of [['depth', 'still'], ['normal', 'still'], ['id', 'still'], ['alpha', 'fine'], ['light', 'fine']]) {
    await page.select('#turn-plane', plane);
    await turned(page, last);
    seen.set(plane, await frame(page));
  }
  assert.equal(new Set([...seen.values()].map(({ hash }) => hash)).size, 5);
  assert.equal(seen.get('light').hash, light.hash);
  // Each stone has its own number. A body covers a pixel in none of the twelve samples, in some or in all.
  assert.ok(seen.get('id').colours > 50, `${seen.get('id').colours} colours`);
  assert.ok(seen.get('alpha').colours <= 13, `${seen.get('alpha').colours} greys`);
  assert.deepEqual(problems, []);
  await close();
});

test('pictures are saved with nothing behind the bodies, and their planes', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&camera=330`);
  await turned(page);
  const { name, bytes } = await saved(page, '#save-turn', { 'turn-backdrop': 'nothing' });
  assert.equal(name, 'bubblestone-ring-1-1024-turn.png');
  const { side, clear, full } = await page.evaluate(async (text) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${text}`;
    await picture.decode();
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(picture.width, picture.height).getContext('2d'));
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, picture.width, picture.height);
    const alpha = data.filter((_, k) => k % 4 === 3);
    return { side: picture.width, clear: alpha.filter((value) => value === 0).length, full: alpha.filter((value) => value === 255).length };
  }, Buffer.from(bytes).toString('base64'));
  assert.equal(side, 1024);
  assert.ok(clear > 10_000 && full > 10_000, `${clear} clear, ${full} full`);
  const { bytes: depth } = await saved(page, '#save-turn-depth');
  // The head of the PNG file has the side, the bits, and the kind of pixels: grey.
  const head = new DataView(depth.buffer, depth.byteOffset);
  assert.deepEqual([head.getUint32(16), depth[24], depth[25]], [1024, 16, 0]);
  assert.deepEqual(problems, []);
  await close();
});

test('in another page it opens from its link, and lets go of the wheel', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`?embed${SMALL}&camera=100,30`, { viewport: { width: 480, height: 480 } });
  await turned(page, 'fine');
  assert.match(await told(page), /^\d+ stones, seen from the left, 30 degrees/);
  const free = await page.$eval('#turn', (stand) => [100, -100].map((deltaY) => stand.dispatchEvent(new WheelEvent('wheel', { deltaY, bubbles: true, cancelable: true }))));
  assert.deepEqual(free, [true, true]);
  await page.evaluate((fragment) => (location.hash = fragment), SMALL);
  await page.waitForFunction(() => !document.querySelector('#turn'));
  assert.deepEqual(problems, []);
  await close();
});

test('where the module does not come, a sentence says so, and the picture stays', sameEverywhere, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'bubblestone-site-'));
  cpSync(dist, folder, { recursive: true });
  const [, file = ''] = /data-surface="([^" ]+)/.exec(readFileSync(join(folder, 'index.html'), 'utf8')) ?? [];
  rmSync(join(folder, file));
  const cut = await open({ files: folder });
  const { page, close } = await cut.newPage(SMALL);
  const planes = await digest(page);
  await click(page, '#turn-button');
  await message(page, 'alert', /could not be loaded/);
  assert.deepEqual(await page.evaluate(() => [document.querySelector('#turn'), document.querySelector('#turn-button')?.getAttribute('aria-pressed')]), [null, 'false']);
  assert.equal(await digest(page), planes);
  await close();
  await cut.close();
  rmSync(folder, { recursive: true });
});
