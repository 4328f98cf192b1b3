// Piles: bodies heaped on a shape, of components by rule or from a file.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { dialog, opened, saved } from './saved.mjs';
import { all, chooses, click, digest, done, drop, get, link, message, PILE, set, SMALL } from './page.mjs';
import { hash, other, turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

/** A closed block as an OBJ file. */
const BLOCK = [
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1} ${k & 2 ? 0.7 : 0} ${k & 4 ? 0.6 : 0}`),
  ...['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`),
  '',
].join('\n');

test('the first press on Piles shows what the small picture promises, and its bodies settle', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await click(page, '.make[data-make=pile]');
  await page.waitForSelector('.make[data-make=pile][aria-current]');
  // The light of the first preset takes seconds, and comes after all that is looked at here.
  await page.waitForFunction(() => ['light', 'done'].includes(document.documentElement.dataset['stage'] ?? ''), { timeout: 60_000 });
  assert.deepEqual(await page.$$eval('#pipeline .word', (words) => words.map((word) => word.textContent)), ['Components', 'Shape', 'Darts', 'Refinement', 'Bodies', 'Light']);
  assert.deepEqual(await page.$$eval('#view option', (options) => options.slice(2, 4).map((option) => option.textContent)), ['Darts', 'Inner spheres']);
  assert.ok((await page.evaluate(() => window.bubblestone.status().stones)) > 100);
  await page.waitForSelector('[data-preset=rice-ball][aria-current]');
  // Colours change neither the component nor the shape.
  const before = await link(page);
  await page.evaluate(() => (Math.random = () => 0.9));
  await click(page, '#throw-colours');
  await page.waitForFunction(() => window.bubblestone.get('vary') === '1.25');
  assert.equal((await link(page)).replace(/&vary=[\d.]+/, ''), before.replace(/&vary=[\d.]+/, ''));
  assert.deepEqual(problems, []);
  await close();
});

test('a dropped model is heaped, is used as the shape, and comes back', sameEverywhere, async () => {
  // The recipe has the usual shape, as a model that is taken back from the shape leaves the usual one.
  const { page, problems, close } = await site.newPage(PILE.replace('form=heap&', '').replace('variants=1&', ''));
  const rice = await digest(page);
  await drop(page, 'block.obj', BLOCK, '');
  await message(page, 'status', /block\.obj is open/);
  await done(page);
  const heaped = await digest(page);
  assert.notEqual(heaped, rice);
  assert.equal(await get(page, 'c1'), 'file');
  assert.equal(await get(page, 'variants'), '1');
  const [, named] = /&file1=(\w[\w-]*)&/.exec(await link(page)) ?? [];
  assert.ok(named, await link(page));
  await page.waitForSelector('#model:not([hidden])');
  assert.deepEqual(await page.$$eval('#model > *', (parts) => parts.filter((part) => part.checkVisibility()).map((part) => part.id || part.className)), ['model-name', 'model-other', 'model-move', 'segments']);
  assert.equal(await page.$eval('#model-move', (button) => button.textContent), 'Use as the shape');
  await click(page, '#model-move');
  await page.waitForFunction(() => window.bubblestone.get('form') === 'file');
  await done(page);
  assert.equal(await link(page), `v=1&make=pile&form=file&model=${named}&ps=5&size=128`);
  assert.notEqual(await digest(page), heaped);
  await page.waitForFunction(() => document.querySelector('#model-move')?.textContent === 'Use as the component');
  await click(page, '#model-move');
  await page.waitForFunction(() => window.bubblestone.get('c1') === 'file');
  assert.equal(await digest(page), heaped);
  assert.deepEqual(problems, []);
  await close();
});

/** A closed wedge. */
const WEDGE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';

test('a file for each role is chosen in the panel, and a link asks for the ones that are missing', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(PILE);
  await digest(page);
  await page.waitForSelector('[data-key=form] input');
  await chooses(page, 'block.obj', BLOCK);
  await set(page, 'form', 'file');
  await page.waitForFunction(() => window.bubblestone.get('form') === 'file');
  assert.equal(await get(page, 'c1'), 'pebble');
  await done(page);
  await chooses(page, 'wedge.obj', WEDGE);
  await set(page, 'c1', 'file');
  await page.waitForFunction(() => window.bubblestone.get('c1') === 'file');
  await done(page);
  const [made, both] = [await digest(page), await link(page)];
  await close();
  // Another page has none of the files.
  const other = await site.newPage(`#${both}`);
  for (const [name, content] of [['wedge.obj', WEDGE], ['block.obj', BLOCK]]) {
    await other.page.waitForSelector(`.asked[data-name="${name}"]`);
    await drop(other.page, name ?? '', content ?? '', '');
  }
  await other.page.waitForFunction(() => !document.querySelector('.asked'));
  assert.equal(await digest(other.page), made);
  assert.equal(await link(other.page), both);
  assert.deepEqual([problems, other.problems], [[], []]);
  await other.close();
});

test('the picked body is outlined until the picture turns', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(PILE);
  await digest(page);
  await turned(page);
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  const wide = (/** @type {boolean} */ is) => page.waitForFunction((wanted) => (document.querySelector('canvas.turn-outline')?.getAttribute('width') !== '0') === wanted, {}, is);
  await wide(true);
  const found = await page.$eval('canvas.turn-outline', (element) => {
    const canvas = /** @type {HTMLCanvasElement} */ (element);
    const { width, height } = canvas;
    const pixels = canvas.getContext('2d')?.getImageData(0, 0, width, height).data ?? [];
    const inked = Array.from({ length: width * height }, (_, k) => k).filter((k) => (pixels[4 * k + 3] ?? 0) > 0);
    const [across, down] = [inked.map((k) => (k % width) / width), inked.map((k) => Math.floor(k / width) / height)];
    const [box, frame] = [canvas, canvas.parentElement].map((one) => one?.getBoundingClientRect().toJSON());
    return { left: Math.min(...across), right: Math.max(...across), top: Math.min(...down), bottom: Math.max(...down), isWhole: box.width === frame.width && box.height === frame.height };
  });
  // The keyboard picks the body in the middle of the frame. The outline covers the frame, and its line is around that body.
  assert.ok(found.isWhole, JSON.stringify(found));
  assert.ok(found.left < 0.5 && found.right > 0.5 && found.top < 0.5 && found.bottom > 0.5, JSON.stringify(found));
  assert.ok(found.right - found.left < 0.5 && found.bottom - found.top < 0.5, JSON.stringify(found));
  await page.keyboard.press('ArrowLeft');
  await wide(false);
  assert.deepEqual(problems, []);
  await close();
});

test('a body has a card, and a plane cuts bodies away', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(PILE);
  await digest(page);
  await turned(page);
  assert.match(await page.$eval('#turn-seen', (told) => told.textContent ?? ''), /^\d+ bodies, seen from/);
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.turn-card[data-picked]');
  const rows = await page.$$eval('.turn-card strong, .turn-card div', (parts) => parts.map((part) => part.textContent ?? ''));
  assert.match(rows.join('|'), /^Body \d+\|Type[A-Z][a-z ]+\|Layer1\|Slid−?\d\.\d\d d of −\d\.\d\d … \d\.\d\d d\|Touches\d+$/);
  const whole = await hash(page);
  await click(page, '#turn-cut');
  const half = await other(page, whole);
  await page.focus('#turn-cut-at');
  await page.keyboard.press('Home');
  const none = await other(page, half);
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  assert.match(await page.$eval('#share-sees', (line) => line.textContent ?? ''), /shows: (.+, )?cut open\.$/);
  assert.match(await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value), /&cut=[-\d.]+,[\d.]+,[-\d.]+,-0\.7$/);
  await page.keyboard.press('Escape');
  await click(page, '#turn-cut');
  assert.equal(await other(page, none), whole);
  assert.deepEqual(problems, []);
  await close();
});

test('the places of the bodies are saved as a table, a line for each', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, PILE);
  await digest(page);
  const { stones } = await page.evaluate(() => window.bubblestone.status());
  const { name, bytes } = await saved(page, '#save-places');
  await dialog(page);
  assert.equal(await page.$eval('#bodies [value=each]', (choice) => choice.textContent), 'A mesh for each body');
  assert.match(name, /^bubblestone-[a-z0-9-]+-places\.csv$/);
  const [head, ...lines] = Buffer.from(bytes).toString().trim().split('\n').map((line) => line.split(','));
  assert.deepEqual(head.slice(0, 9), ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw', 'scale', 'component']);
  assert.equal(lines.length, stones);
  for (const line of lines) {
    const [qx, qy, qz, qw] = line.slice(3, 7).map(Number);
    assert.ok(Math.abs(Math.hypot(qx, qy, qz, qw) - 1) < 1e-9, String(line));
    assert.equal(line[8], 'pebble');
  }
  assert.deepEqual(problems, []);
  await close();
});

test('components and shapes are chosen from small pictures', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(PILE);
  await digest(page);
  for (const key of ['c1', 'form']) {
    const rows = await page.$$eval(`[data-key=${key}] label`, (labels) =>
      labels.map((label) => ({ word: label.querySelector('input')?.value ?? '', picture: label.querySelector('img')?.getAttribute('src') ?? '' })),
    );
    assert.ok(rows.length > 15);
    for (const { word, picture } of rows) assert.equal(picture, word === 'file' ? '' : `thumbs/pile-${key}-${word}.avif`);
    const missing = await page.evaluate(
      async (addresses) => {
        const found = await Promise.all(addresses.map((address) => fetch(address).then(({ ok, headers }) => ok && headers.get('content-type'))));
        return addresses.filter((_, k) => found[k] !== 'image/avif');
      },
      rows.flatMap(({ picture }) => picture || []),
    );
    assert.deepEqual(missing, []);
  }
  await page.waitForFunction(() => document.querySelector('[data-key=c1] label:has(:checked) img')?.complete);
  await page.focus('[data-key=c1] :checked');
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => window.bubblestone.link().includes('c1=smooth'));
  // The chosen one is in sight, however far to the side it is.
  await page.evaluate(() => document.activeElement?.blur());
  await set(page, 'form', 'vase');
  await page.waitForFunction(() => {
    const [row, chosen] = ['[data-key=form] .pictured', '[data-key=form] label:has(:checked)'].map((part) => document.querySelector(part).getBoundingClientRect());
    return chosen.left >= row.left && chosen.right <= row.right;
  });
  assert.deepEqual(problems, []);
  await close();
});

test('one press takes the spacing that fits', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${PILE}&sigma1=0.3&ps=25`);
  await page.waitForSelector('[data-stage=error]');
  const sentence = await page.$eval('.message[data-topic=trouble] p', (text) => text.textContent);
  const [, told] = /Set Spacing .*to ([0-9.]+)/.exec(sentence) ?? [];
  await click(page, '.message[data-topic=trouble] .actions button');
  await page.waitForFunction(() => document.documentElement.dataset['stage'] !== 'error');
  assert.match(await link(page), new RegExp(`sigma1=${told}(&|$)`));
  await page.waitForFunction(() => !document.querySelector('.message[data-topic=trouble]'));
  await close();
});

test('a link with a plane opens with it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${PILE}&cut=0,1,0,0.05`);
  await digest(page);
  await turned(page);
  await page.waitForSelector('#turn-cut[aria-pressed=true]');
  assert.equal(await page.$eval('[name=turn-cut-way]:checked', (radio) => /** @type {HTMLInputElement} */ (radio).value), 'y');
  assert.equal(await page.$eval('#turn-cut-at', (slider) => /** @type {HTMLInputElement} */ (slider).value), '0.05');
  assert.deepEqual(problems, []);
  await close();
});

test('the rows of piles are Japanese on a Japanese page', sameEverywhere, async () => {
  const japanese = (/** @type {Page} */ fresh) => fresh.evaluateOnNewDocument(() => localStorage.setItem('bubblestone.language', 'ja'));
  const { page, problems, close } = await site.newPage(PILE, { before: japanese });
  await digest(page);
  await page.waitForSelector('[data-key=c1] input');
  await all(page);
  const texts = await page.$$eval('#controls .name, #controls summary span:first-child, #controls option, #controls .segments span, #view option, #pipeline .word, .make span', (parts) => parts.map((part) => part.textContent?.trim() ?? ''));
  assert.ok(texts.length > 100);
  // Single letters are allowed: symbols stand beside names.
  assert.deepEqual(texts.filter((text) => /^[ -~]*[A-Za-z]{2}[ -~]*$/.test(text)), []);
  assert.deepEqual(problems, []);
  await close();
});
