// Surfaces from model files: opened, stored by digest, requested by name, and inside a recipe file. Painting on them.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { chooses, click, digest, drop, get, link, message, messages, phone, reloading, set, SMALL } from './page.mjs';
import { opened, saved } from './saved.mjs';
import { box } from './sheet.mjs';
import { turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

const EGG = '#v=1&make=surface&size=128&cn=60&form=egg';

/** A box of this height as an OBJ file. @param {number} height */
function cube(height) {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1} ${k & 2 ? height : 0} ${k & 4 ? 1 : 0}\n`);
  const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}\n`);
  return corners.join('') + faces.join('');
}

/** Waits until a parameter has this value. @param {Page} page @param {string} key @param {string} value */
const until = (page, key, value) => page.waitForFunction((name, text) => /** @type {any} */ (window).bubblestone.get(name) === text, {}, key, value);

/** The link and the digest of a box with 60 cells, which the first test makes. */
let box60 = { fragment: '', digest: '' };

/** That box in the file of a recipe. */
let packed60 = {};

test('a model is opened by the panel, and found again by undo and after a reload', async () => {
  const { page, problems, close } = await site.newPage(EGG);
  const egg = await digest(page);
  await page.waitForSelector('#p-form');
  await chooses(page, 'box.obj', cube(1.5));
  await set(page, 'form', 'file');
  await until(page, 'form', 'file');
  const made = await digest(page);
  assert.notEqual(made, egg);
  assert.equal(await get(page, 'cn'), '60');
  box60 = { fragment: `#${await link(page)}`, digest: made };
  await click(page, '#undo');
  await until(page, 'form', 'egg');
  assert.equal(await digest(page), egg);
  await click(page, '#redo');
  await until(page, 'form', 'file');
  assert.equal(await digest(page), made);
  await reloading(page, () => page.reload());
  assert.equal(await digest(page), made);
  assert.equal(await page.$('.asked'), null);
  assert.deepEqual(problems, []);
  await close();
});

test('a file that is not here is asked for by its name, and another one takes its place', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(box60.fragment);
  await page.waitForSelector('.asked');
  assert.match(await page.$eval('.asked', (asked) => asked.textContent ?? ''), /box\.obj/);
  await drop(page, 'tower.obj', cube(3), '');
  await message(page, 'status', /tower\.obj is another file than box\.obj/);
  await page.waitForFunction(() => !document.querySelector('.asked'));
  assert.notEqual(await digest(page), box60.digest);
  await click(page, '#undo');
  await page.waitForSelector('.asked');
  await chooses(page, 'renamed.obj', cube(1.5));
  await click(page, '#open-missing');
  await page.waitForFunction(() => !document.querySelector('.asked'));
  assert.equal(await digest(page), box60.digest);
  assert.equal(`#${await link(page)}`, box60.fragment);
  assert.deepEqual(problems, []);
  await close();
});

test('a model dropped anywhere becomes a surface, and one that cannot be read says why', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await drop(page, 'box.obj', cube(1.5), '');
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  await until(page, 'form', 'file');
  // The rest takes less time on a smaller surface.
  await page.evaluate((fragment) => (location.hash = fragment), EGG);
  await until(page, 'form', 'egg');
  // One side is turned over, and another one occurs twice.
  await drop(page, 'mended.obj', `${cube(1.5).replace('f 1 2 6 5', 'f 5 6 2 1')}f 2 4 8 6\n`, '');
  await message(page, 'status', /mended\.obj is open, and this of it was mended.*left out: 2.*turned: 2/);
  await drop(page, 'half.obj', 'v 0 0 0\nv 1 0 0\nv 1\n', '');
  await message(page, 'alert', /Line 3 of the OBJ file/);
  assert.deepEqual(problems, []);
  await close();
});

/** The corner of a cube: its edges are too sharp for a few cells to follow. */
const WEDGE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';

test('a model that the present cells cannot cover is opened, and one press takes cells that cover it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(EGG);
  await digest(page);
  await drop(page, 'wedge.obj', WEDGE, '');
  await until(page, 'form', 'file');
  // One message: the file is open, but that it is would seem to contradict the refusal.
  const refused = async () => {
    await message(page, 'alert', /Set Cells \(cn\) to \d+ or more/);
    assert.deepEqual((await messages(page)).filter((text) => /is open/.test(text)), []);
  };
  await refused();
  assert.equal(await get(page, 'cn'), '60');
  await click(page, '#alerts .actions button');
  await digest(page);
  const fits = Number(await get(page, 'cn'));
  assert.ok(fits > 60, `${fits} cells`);
  assert.deepEqual(await page.$$eval('#alerts .message', (notes) => notes.length), 0);
  // Numbers of the earlier run do not stand beside a refusal, and a sentence tells that its picture does.
  const counts = () => page.$$eval('#counts dd, #timeline output', (all) => all.map((one) => one.textContent));
  await page.waitForSelector('#moment:not(:disabled)');
  await turned(page);
  const [, cells] = await counts();
  assert.ok(Number(cells) > 60, `${cells} cells`);
  await set(page, 'cn', '60');
  await refused();
  await page.waitForSelector('#moment:disabled');
  assert.deepEqual(await counts(), ['', '–', '–', '–', '–']);
  assert.match(await page.$eval('#caption', (caption) => caption.textContent), /^The picture is the last one that worked\./);
  assert.deepEqual(problems, []);
  await close();
});

/** An open slope whose faces look down. */
const SLOPE = `v 0 0 0\nv 1 0 0\nv 1 0.3 1\nv 0 0.3 1\nf 1 2 3 4\n`;

test('the button for models names the open file, opens others, and turns open parts; a refused file changes nothing', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await chooses(page, 'slope.obj', SLOPE);
  await click(page, '#your-model');
  await page.waitForSelector('#model:not([hidden])');
  await message(page, 'status', /slope\.obj is open.*faced down or inwards were turned.*Triangles turned: 2\./);
  // Fewer cells take less time.
  await page.evaluate((fragment) => (location.hash = fragment), `${await link(page)}&size=128&cn=60`);
  await until(page, 'cn', '60');
  const [guess, up] = [await digest(page), await link(page)];
  assert.match(up, /side=guess/);
  assert.equal(await page.$eval('#model-name', (name) => name.textContent), 'slope.obj');
  await page.waitForFunction(() => /× .* cells/.test(document.getElementById('model-size')?.textContent ?? ''));
  await click(page, '#model-side');
  await page.waitForSelector('#model-side[aria-pressed=true]');
  assert.notEqual(await digest(page), guess);
  await click(page, '#model-side');
  await page.waitForSelector('#model-side[aria-pressed=false]');
  assert.equal(await digest(page), guess);
  // Nothing changes with a file that is refused: not the link, the name, the steps back, or the picture.
  const before = await page.$eval('#caption', (caption) => caption.textContent);
  await chooses(page, 'bad.obj', 'no model\n');
  await page.focus('#model-other');
  await page.keyboard.press('Enter');
  await message(page, 'alert', /bad\.obj was not opened, and nothing has changed\. There are no triangles/);
  assert.equal(await link(page), up);
  assert.equal(await digest(page), guess);
  assert.deepEqual(await page.$$eval('#model-name, #caption', (both) => both.map((one) => one.textContent)), ['slope.obj', before]);
  assert.deepEqual((await messages(page)).filter((text) => text?.includes('bad.obj is open')), []);
  await drop(page, 'scene.fbx', 'Kaydara', '');
  await message(page, 'alert', /of a kind that cannot be opened here.*PNG pictures saved here/);
  // A closed model has only one outside.
  await chooses(page, 'box.obj', cube(1.5));
  await click(page, '#model-other');
  await page.waitForSelector('#model-side:disabled');
  assert.equal(await page.$eval('#model-name', (name) => name.textContent), 'box.obj');
  // From a pavement, the button returns to the last model.
  const box = await link(page);
  await click(page, '.make[data-make=pavement]');
  await page.waitForSelector('#model[hidden]', { visible: false });
  await click(page, '#your-model');
  await page.waitForSelector('#model:not([hidden])');
  assert.equal(await link(page), box);
  assert.deepEqual(problems, []);
  await close();
});

test('the file of a recipe holds the models, each with its role, and older files with one model are read', sameEverywhere, async () => {
  const first = await opened(site, box60.fragment);
  await first.page.waitForSelector('.asked');
  await drop(first.page, 'box.obj', cube(1.5), '');
  await first.page.waitForFunction(() => !document.querySelector('.asked'));
  assert.equal(await digest(first.page), box60.digest);
  const { bytes } = await saved(first.page, '#save-recipe');
  const { files, ...rest } = JSON.parse(new TextDecoder().decode(bytes));
  assert.deepEqual(files.map(({ role, name }) => [role, name]), [['model', 'box.obj']]);
  await first.close();
  // Files of the older form have one model, without a role.
  packed60 = files[0];
  const file = { ...files[0], role: undefined };
  const older = new TextEncoder().encode(JSON.stringify({ ...rest, file }, null, 1).replace('"gzip":"', '"gzip": "'));
  for (const recipe of [bytes, older]) {
    const { page, problems, close } = await site.newPage(SMALL);
    await digest(page);
    await drop(page, 'recipe.json', recipe, 'application/json');
    await until(page, 'form', 'file');
    assert.equal(await digest(page), box60.digest);
    assert.equal(await page.$('.asked'), null);
    assert.deepEqual(problems, []);
    await close();
  }
});

/** The stored files: for each digest the number of bytes. @param {Page} page @returns {Promise<Record<string, number>>} */
const shelf = (page) =>
  page.evaluate(async () => {
    const asked = (/** @type {IDBRequest<any>} */ request) => new Promise((resolve) => request.addEventListener('success', () => resolve(request.result)));
    const base = await asked(indexedDB.open('bubblestone files', 1));
    const all = await asked(base.transaction('files').objectStore('files').getAll());
    base.close();
    return Object.fromEntries(all.map((/** @type {{ digest: string, file: Blob }} */ kept) => [kept.digest, kept.file.size]));
  });

// It uses the model that the test before this one has packed.
test("the file of a stranger's recipe neither changes nor removes a kept model", sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(EGG);
  await digest(page);
  await drop(page, 'tower.obj', cube(3), '');
  await until(page, 'form', 'file');
  const before = await digest(page);
  const kept = await shelf(page);
  const own = { role: 'model', name: 'tower.obj', digest: Object.keys(kept)[0] };
  const tower = `#${await link(page)}`;
  const packed = (/** @type {string | Uint8Array} */ bytes) => gzipSync(bytes).toString('base64');
  const zeros = packed(new Uint8Array(20_000_000));
  /** @type {[string, object[], string][]} */
  const cases = [
    // Other content under the digest of a kept model, and a model that the recipe does not name.
    [tower, [{ ...own, size: 13, gzip: packed('not the model') }], 'is open'],
    [tower, [{ ...own, digest: '0123456789abcdef', size: 20_000_000, gzip: zeros }], 'is open'],
    // A model that is not stored here, with other content, more bytes than stated, a size below 0, and no archive.
    ...[{ gzip: packed('x'.repeat(20)), size: 20 }, { gzip: zeros, size: 100 }, { size: -1 }, { gzip: 'AAAA' }].map(
      (wrong) => /** @type {[string, object[], string]} */ ([box60.fragment, [{ ...packed60, ...wrong }], 'does not hold the model']),
    ),
  ];
  for (const [k, [fragment, files, words]] of cases.entries()) {
    const text = JSON.stringify({ program: 'Bubblestone', recipe: fragment.slice(1), files }, null, 1);
    await drop(page, `${k}.json`, text, 'application/json');
    await message(page, 'status', new RegExp(`${k}\\.json ${words}`));
    assert.deepEqual(await shelf(page), kept);
  }
  await page.goto('about:blank');
  await page.goto(site.address + tower);
  assert.equal(await digest(page), before);
  assert.deepEqual(problems, []);
  await close();
});

test('strokes are painted on the surface, one step each, and taken away by a click', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('#v=1&make=surface&size=128&cn=100&form=sphere');
  await digest(page);
  await turned(page);
  await click(page, '#paint-strokes');
  const { x, y, width, height } = await box(page, '#turn');
  const [cx, cy] = [x + width / 2, y + height / 2];
  await page.mouse.move(cx - 50, cy);
  await page.mouse.down();
  await page.mouse.move(cx, cy - 15, { steps: 4 });
  await page.mouse.move(cx + 50, cy, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(() => /** @type {any} */ (window).bubblestone.get('strokes') !== '');
  await page.waitForSelector('.paint-over .paint-strokes');
  await digest(page);
  // The finished picture does not show the painted row, but the eraser does.
  await page.waitForFunction(() => !document.querySelector('.paint-over .paint-strokes'));
  await click(page, '#paint-erase');
  await page.waitForSelector('.paint-over .paint-strokes');
  await click(page, '#undo');
  await until(page, 'strokes', '');
  await click(page, '#redo');
  await page.waitForFunction(() => /** @type {any} */ (window).bubblestone.get('strokes') !== '');
  await turned(page);
  await click(page, '#paint-erase');
  await page.mouse.click(cx, cy - 15);
  await until(page, 'strokes', '');
  // By keyboard: two points in the middle of the view, and the end of the line.
  await turned(page);
  await click(page, '#paint-lines');
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  for (const key of ['ArrowLeft', 'ArrowLeft']) await page.keyboard.press(key);
  await turned(page);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /^Point 2/.test(document.querySelector('#paint-told')?.textContent ?? ''));
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => /** @type {any} */ (window).bubblestone.get('lines') !== '');
  await click(page, '#paint-flip');
  await until(page, 'flip', '1');
  assert.deepEqual(problems, []);
  await close();
});

test('with a tool one finger paints, and two turn the model', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('#v=1&make=surface&size=128&cn=100&form=sphere', { viewport: phone });
  await digest(page);
  await turned(page);
  const painting = await page.waitForSelector('#paint-strokes');
  await painting?.tap();
  await page.waitForSelector('.turn-frame[data-paint]');
  const { x, y, width, height } = await box(page, '#turn');
  const [cx, cy] = [x + width / 2, y + height / 2];
  const far = () => page.$eval('#turn-seen', (told) => told.textContent);
  const before = await far();
  const fingers = [await page.touchscreen.touchStart(cx - 15, cy), await page.touchscreen.touchStart(cx + 15, cy)];
  for (let k = 1; k <= 5; k += 1) for (const [which, finger] of fingers.entries()) await finger.move(cx + (which ? 1 : -1) * (15 + 15 * k), cy);
  for (const finger of fingers) await finger.end();
  await page.waitForFunction((then) => document.querySelector('#turn-seen')?.textContent !== then, {}, before);
  await turned(page);
  assert.equal(await get(page, 'strokes'), '');
  const finger = await page.touchscreen.touchStart(cx - 40, cy);
  for (let k = 1; k <= 4; k += 1) await finger.move(cx - 40 + 20 * k, cy);
  await finger.end();
  await page.waitForFunction(() => /** @type {any} */ (window).bubblestone.get('strokes') !== '');
  assert.deepEqual(problems, []);
  await close();
});
