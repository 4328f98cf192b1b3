// Surfaces in space: only their bodies are visible, from any side and at any time.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import validator from 'gltf-validator';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { all, BALL, click, digest, frames, get, link, phone, reloading, set, SMALL } from './page.mjs';
import { dialog, opened, saved } from './saved.mjs';
import { box, drag, spot } from './sheet.mjs';
import { frame, other, tells, told, turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

/** Whether each of these elements is visible. @param {Page} page @param {string[]} ids */
const seen = (page, ids) => page.evaluate((names) => names.filter((id) => document.getElementById(id)?.checkVisibility({ visibilityProperty: true })), ids);

test('a surface shows its stones and nothing else, and is not left', sameEverywhere, async () => {
  const { page, problems, external, close } = await site.newPage(BALL);
  await turned(page);
  const first = await frame(page);
  assert.ok(first.colours > 100, `${first.colours} colours`);
  assert.match(await told(page), /^\d+ stones, seen from the front right, 20 degrees above the ground, from near\.$/);
  await page.focus('#turn');
  for (const key of ['Escape', 'g', 'e', 't', 'p']) await page.keyboard.press(key);
  assert.notEqual(await page.$('#turn'), null);
  assert.deepEqual(await seen(page, ['canvas', 'edit-tools', 'cells', 'layers-button', 'tile-button', 'turn-button', 'turn-end', 'plots-button', 'compare-button', 'light-button', 'turn']), ['layers-button', 'compare-button', 'light-button', 'turn']);
  // There is nothing to draw over frames, but each view has a sentence.
  await page.keyboard.press('o');
  await page.waitForSelector('#layers', { visible: true });
  assert.deepEqual(await page.$$eval('#layers legend', (legends) => legends.filter((legend) => legend.checkVisibility()).map(({ textContent }) => textContent)), ['Drawn', 'On this screen']);
  await page.click('#layers [value=curvature]');
  await page.waitForFunction(() => /bends at each place/.test(document.querySelector('.layers-legend dd')?.textContent ?? ''));
  assert.equal(await page.$eval('#view', (select) => /** @type {HTMLSelectElement} */ (select).value), 'curvature');
  await page.click('#layers [value=auto]');
  await page.keyboard.press('Escape');
  await page.waitForSelector('#layers', { hidden: true });
  await turned(page);
  // The panel has only the numbers of this shape, and no parameter that is drawn on a picture.
  await all(page);
  const rows = await page.$$eval('.control', (controls) => controls.filter((control) => control.checkVisibility({ contentVisibilityAuto: true })).map((control) => control.getAttribute('data-key')));
  assert.deepEqual(rows.filter((key) => /^(sphere|torus|leg)_/.test(key ?? '')), ['sphere_height', 'sphere_depth', 'sphere_square']);
  assert.deepEqual(rows.filter((key) => ['size', 'strokes', 'spots', 'lines', 'model'].includes(key ?? '')), []);
  // Another palette changes the frame, and undo brings the first one back.
  await set(page, 'palette', 'marble');
  const marble = await other(page, first.hash);
  await click(page, '#undo');
  assert.equal(await other(page, marble), first.hash);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('it is turned while the cells are packed, held, and packed on', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${BALL}&pace=0.05`);
  await page.waitForFunction(() => document.documentElement.dataset['stage'] === 'packing');
  await click(page, '#play');
  await turned(page);
  const steps = await page.evaluate(() => window.bubblestone.status().steps);
  const held = await frame(page);
  assert.match(await told(page), /^\d+ cells as they are packed, seen from the front right/);
  const from = await spot(page, 0.5, 0.5);
  const { width } = await box(page, '#sheet');
  await drag(page, from, { x: from.x + (75 / 220) * width, y: from.y });
  await page.mouse.up();
  // A quick release keeps it turning.
  await tells(page, /seen from the (?!front right)/);
  await turned(page);
  assert.notEqual((await frame(page)).hash, held.hash);
  const before = await frame(page);
  await click(page, '#step');
  await page.waitForFunction((made) => window.bubblestone.status().steps > made, {}, steps);
  await page.waitForFunction(() => document.documentElement.dataset['stage'] === 'packing');
  await turned(page);
  // It goes on forming, and is turned meanwhile.
  await click(page, '#play');
  await turned(page, 'moving');
  assert.notEqual((await frame(page)).hash, before.hash);
  await drag(page, from, { x: from.x - (75 / 220) * width, y: from.y });
  assert.equal(await page.evaluate(() => document.documentElement.dataset['stage']), 'packing');
  await page.mouse.up();
  await click(page, '#speed [value="100000"]');
  await digest(page);
  await tells(page, /^\d+ stones, seen from/);
  assert.deepEqual(problems, []);
  await close();
});

test('a link has view and camera, and opens so again', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${BALL}&view=direction&camera=90,-10`);
  await turned(page);
  await tells(page, /^The directions, seen from the left, 10 degrees below, from near\.$/);
  assert.equal(await page.$eval('#view', (select) => /** @type {HTMLSelectElement} */ (select).value), 'direction');
  const caption = await page.$eval('#caption', (text) => text.textContent);
  const [, positive, negative, sum, euler] = /Singular points: (\d+) positive, (\d+) negative\. The sum of their indices is ([−\d.]+), the Euler characteristic ([−\d]+)\./.exec(caption ?? '') ?? [];
  assert.deepEqual([sum, euler], ['2', '2'], caption ?? '');
  assert.equal((Number(positive) - Number(negative)) / 4, 2);
  const first = await frame(page);
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  assert.match(await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value), /&view=direction&camera=90,-10$/);
  await page.keyboard.press('Escape');
  await reloading(page, () => page.reload());
  await turned(page);
  assert.deepEqual(await frame(page), first);
  for (const key of ['2', '0']) await page.keyboard.press(key);
  await tells(page, /^\d+ stones, seen from the left/);
  assert.equal(await link(page), BALL.slice(1));
  assert.deepEqual(problems, []);
  await close();
});

test('a pavement and a surface are chosen one after the other, and each is seen in its way', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const planes = await digest(page);
  await page.evaluate((fragment) => (location.hash = fragment), BALL);
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  await turned(page);
  await tells(page, /stones, seen from the front right/);
  await click(page, '.make[data-make=pavement]');
  await page.waitForSelector('.make[data-make=pavement][aria-current]');
  assert.equal(await digest(page), planes);
  assert.deepEqual(await seen(page, ['canvas', 'turn', 'turn-button', 'edit-tools']), ['canvas', 'turn-button', 'edit-tools']);
  await page.keyboard.press('g');
  await turned(page);
  assert.match(await told(page), /seen from the lower left, 40 degrees/);
  await click(page, '.make[data-make=surface]');
  await tells(page, /seen from the front right, 20 degrees/);
  assert.equal(await get(page, 'cn'), '60');
  assert.deepEqual(problems, []);
  await close();
});

test('a surface is taken away as a picture and a mesh, and compared with another one', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, BALL);
  await digest(page);
  const { name, bytes } = await saved(page, '#save-turn');
  assert.equal(name, 'bubblestone-sphere-1-1024-turn.png');
  assert.equal(new DataView(bytes.buffer, bytes.byteOffset).getUint32(16), 1024);
  const { name: mesh, bytes: glb } = await saved(page, '#save-glb', { detail: 'low' });
  assert.equal(mesh, 'bubblestone-sphere-1-low.glb');
  const { issues } = await validator.validateBytes(glb);
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
  const { name: joined, bytes: one } = await saved(page, '#save-glb', { bodies: 'one' });
  assert.equal(joined, 'bubblestone-sphere-1-low-one-mesh.glb');
  const meshes = (await new NodeIO().readBinary(one)).getRoot().listMeshes();
  const [part, ...others] = meshes.flatMap((mesh) => mesh.listPrimitives());
  assert.deepEqual([meshes.length, others.length, part?.listSemantics().sort()], [1, 0, ['COLOR_0', 'NORMAL', 'POSITION', 'TEXCOORD_0']]);
  await dialog(page);
  assert.deepEqual(await page.$$eval('#save-dialog section', (rows) => rows.map((row) => row.getAttribute('aria-label'))), ['Picture', 'Film', 'Mesh', 'Recipe']);
  await page.keyboard.press('Escape');
  await click(page, '#compare-button');
  await page.waitForSelector('#divider');
  await page.select('#compare-with', 'link');
  await page.$eval('#compare-link', (field, text) => {
    /** @type {HTMLInputElement} */ (field).value = text;
    field.dispatchEvent(new Event('change'));
  }, `${BALL}&palette=terracotta`);
  await page.waitForFunction(() => document.querySelector('.compare-progress')?.textContent === '', { timeout: 60_000 });
  await page.waitForFunction(() => /** @type {HTMLCanvasElement | null} */ (document.querySelector('#sheet > .other'))?.width === /** @type {HTMLCanvasElement | null} */ (document.querySelector('#turn canvas'))?.width);
  assert.notEqual((await frame(page, '#sheet > .other')).hash, (await frame(page)).hash);
  await click(page, '#compare-beside');
  await page.waitForFunction(() => document.querySelector('#play')?.getAttribute('data-does') === 'again' && /[1-9]/.test(document.querySelector('#beside-name span')?.textContent ?? ''), { timeout: 60_000 });
  const at = await box(page, '#beside');
  await drag(page, { x: at.x + 50, y: at.y + 100 }, { x: at.x + 50 + (120 / 220) * at.width, y: at.y + 100 });
  await page.mouse.up();
  await tells(page, /from the (left|front left|back left)/);
  assert.deepEqual(problems, []);
  await close();
});

test('in another page it is seen and turned, with a button beside it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`?embed${BALL}&camera=100,30`, { viewport: { width: 240, height: 240, deviceScaleFactor: 2 } });
  await turned(page, 'fine');
  const { width, height } = await frame(page);
  assert.deepEqual([width, height], [480, 480], 'the frame has the pixels of the screen');
  assert.match(await told(page), /^\d+ stones, seen from the left, 30 degrees/);
  const play = await box(page, '.embed-play');
  assert.ok(play.width < 60, `the button is ${play.width} wide`);
  await page.focus('#turn');
  await page.keyboard.press('ArrowRight');
  await tells(page, /seen from the (left|back left), 30 degrees/);
  await page.evaluate((fragment) => (location.hash = fragment), SMALL);
  await page.waitForFunction(() => !document.querySelector('#turn') && document.documentElement.dataset['stage'] === 'done');
  assert.deepEqual(problems, []);
  await close();
});

test('on a phone one finger turns it, and the page is scrolled', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BALL, { viewport: phone });
  await turned(page);
  const before = await told(page);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), phone.width);
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
  await stroke(150, 0);
  await page.waitForFunction((was) => document.querySelector('#turn-seen')?.textContent !== was, {}, before);
  assert.deepEqual(problems, []);
  await close();
});

/** The states of the frames from the first one at rest on. @param {Page} page */
const states = (page) => page.evaluate(() => /** @type {any} */ (window).turns.slice(/** @type {any} */ (window).turns.findIndex((/** @type {string} */ word) => ['still', 'fine'].includes(word))));

/** Opens the ball for a new visitor, and records the states of its frames. @param {object} [options] */
function welcomed(options = {}) {
  return site.newPage(BALL, {
    sways: true,
    fine: true,
    ...options,
    before: (page) =>
      page.evaluateOnNewDocument(() => {
        const turns = (/** @type {any} */ (window).turns = []);
        const look = () => {
          const word = document.querySelector('#sheet')?.getAttribute('data-turn');
          if (word && word !== turns.at(-1)) turns.push(word);
        };
        new MutationObserver(look).observe(document, { subtree: true, childList: true, attributeFilter: ['data-turn'] });
      }),
  });
}

test('bodies sway once for a new visitor, and come back to the camera of the link', async () => {
  const usual = await site.newPage(BALL, { fine: true });
  await turned(usual.page, 'fine');
  const rest = await frame(usual.page);
  const hash = await usual.page.evaluate(() => location.hash);
  await usual.close();
  const { page, problems, close } = await welcomed();
  await turned(page, 'fine');
  assert.ok((await states(page)).includes('moving'), String(await states(page)));
  assert.deepEqual(await frame(page), rest);
  assert.equal(await page.evaluate(() => location.hash), hash);
  await page.reload({ waitUntil: 'load' });
  await turned(page, 'fine');
  assert.ok(!(await states(page)).includes('moving'), 'it sways on the second visit');
  assert.deepEqual(problems, []);
  await close();
});

test('a touch ends the sway, or prevents it; less motion does, too', sameEverywhere, async () => {
  const still = await welcomed({ still: true });
  await turned(still.page, 'fine');
  assert.ok(!(await states(still.page)).includes('moving'));
  await still.close();
  const { page, close } = await welcomed();
  await page.waitForSelector('#turn');
  await page.keyboard.press('Shift');
  await turned(page, 'fine');
  assert.ok(!(await states(page)).includes('moving'));
  await close();
});
