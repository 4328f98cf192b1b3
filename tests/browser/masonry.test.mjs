// Masonry: blocks laid on a building, by rule or from a file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { BALL, BRICKS, chooses, click, digest, done, drop, exported, frames, get, link, message, PILE, reloading, SMALL, SQUARE, steps } from './page.mjs';
import { dialog, opened, saved } from './saved.mjs';
import { spot } from './sheet.mjs';
import { longestTask, skip } from './tasks.mjs';
import { hash, other, tells, told, turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ viewport: low });
});

after(() => site?.close());

/** The building that the docs show: a wall with an opening and a pane. */
const [, BUILDING = ''] = /```json\n([^]+?)```/.exec(readFileSync(new URL('../../docs/building.md', import.meta.url), 'utf8')) ?? [];

/** A closed block in metres, of two groups, as an OBJ file. */
const WALLS = [
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1 ? 2 : 0} ${k & 2 ? 1 : 0} ${k & 4 ? 1 : 0}`),
  'g Wall',
  ...['1 3 4 2', '5 6 8 7', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`),
  'g Cap',
  ...['1 2 6 5', '3 7 8 4'].map((face) => `f ${face}`),
  '',
].join('\n');

/** Waits until masonry is shown, then for its digest. @param {Page} page */
async function made(page) {
  await page.waitForSelector('.make[data-make=masonry][aria-current]');
  return digest(page);
}

/** Waits until all blocks are laid. @param {Page} page */
const lit = (page) => page.waitForFunction(() => ['light', 'done'].includes(document.documentElement.dataset['stage'] ?? ''), { timeout: 60_000 });

/** Waits until the laying is held, and its frame has all pixels. @param {Page} page @param {number} blocks */
async function held(page, blocks) {
  await page.waitForFunction((count) => document.querySelector('#play')?.getAttribute('data-does') === 'play' && Number(document.querySelector('#count-steps')?.textContent) === count, {}, blocks);
  await tells(page, new RegExp(`^${blocks} blocks, seen`));
  return hash(page);
}

test('one press on Masonry shows the cottage, laid in its stages', sameEverywhere, async () => {
  const { page, problems, external, close } = await site.newPage(SMALL);
  await digest(page);
  // The page keeps the last picture's stage until the cottage has its first, so all stages are recorded.
  await page.evaluate(() => {
    const root = document.documentElement;
    const stages = (/** @type {any} */ (window).stages = []);
    new MutationObserver(() => stages.push(root.dataset['stage'])).observe(root, { attributeFilter: ['data-stage'] });
  });
  await click(page, '.make[data-make=masonry]');
  // The light of the cottage takes seconds, and comes after all that is looked at here.
  await page.waitForFunction(() => {
    const { stages } = /** @type {any} */ (window);
    return stages.includes('laying') && ['light', 'done'].includes(stages.at(-1));
  });
  assert.deepEqual(await page.$$eval('#pipeline .word', (words) => words.map((word) => word.textContent)), ['Building', 'Cells', 'Laying', 'Bodies', 'Light']);
  await page.waitForSelector('[data-preset=cottage][aria-current]');
  assert.equal(await link(page), 'v=1&make=masonry');
  assert.ok((await steps(page)) > 1000);
  assert.deepEqual(await page.$$eval('#counts div', (boxes) => boxes.filter((box) => box.checkVisibility()).map((box) => box.querySelector('dt')?.textContent)), ['Blocks']);
  // Watched again, it is laid course by course, as its sentence says.
  const laying = (/** @type {boolean} */ shown) => page.waitForFunction((wanted) => (document.querySelector('#subtitle .said')?.textContent === 'Blocks go on corners, then edges, then faces.') === wanted, {}, shown);
  await laying(false);
  const laid = laying(true);
  await page.keyboard.press('r');
  await laid;
  await click(page, '#speed [value="100000"]');
  await lit(page);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

/** The description of the frame of each view, and the beginning of its caption. */
const VIEWS = {
  mortar: ['The mortar', 'The building’s surface'],
  features: ['The features of \\d+ blocks', 'Blocks of corners in red.* Corners have 8 blocks, edges \\d+, faces \\d+'],
  sizes: ['The sizes of \\d+ blocks', 'Whole bricks are pale.* \\d+ bricks are whole, \\d+ half, 0 cut'],
  polygons: ['The polygons', 'The polygons of the building'],
  plan: ['The lines of the plan', 'Courses are blue.* Rows have \\d+ lines'],
  parity: ['The bricks of edges', 'Each row of an edge.* meet at 4 edges\\. Conflicts: 0'],
  occupancy: ['The claimed pixels', 'The pixels of each face.* Of \\d+ pixels'],
  clipping: ['The clipped among \\d+ blocks', 'Half and cut blocks are.* \\d+ blocks are clipped'],
  seams: ['A texture with its seams', 'A plain texture.* Of \\d+ bricks'],
  picture: ['\\d+ blocks', 'This recipe: Block'],
};

test('each view has a frame and sentences of its own', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BRICKS);
  await made(page);
  const shown = new Set([await hash(page)]);
  assert.deepEqual((await page.$$eval('#view option', (options) => options.map((option) => option.value))).sort(), ['auto', ...Object.keys(VIEWS)].sort());
  for (const [view, [words = '', note = '']] of Object.entries(VIEWS)) {
    await page.select('#view', view);
    await tells(page, new RegExp(`^${words}, seen from the front right, 16 degrees`));
    await page.waitForFunction((source) => new RegExp(`^${source}`).test(document.querySelector('#caption')?.textContent ?? ''), {}, note);
    const now = await hash(page);
    // Only the view of finished blocks has a frame that was seen before: blocks end up in it when the view is
    // automatic.
    assert.equal(shown.has(now), view === 'picture', view);
    shown.add(now);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('the view of features has labels that lie on no other, and no other view has any', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('#v=1&make=masonry&building=wall&size=128&view=features');
  await page.waitForSelector('.turn-label');
  await made(page);
  const labels = await page.$$eval('.turn-label', (all) =>
    all.map((label) => {
      const { left, right, top, bottom } = label.getBoundingClientRect();
      return { text: label.textContent, left, right, top, bottom };
    }),
  );
  assert.ok(labels.some(({ text }) => text.includes('Window')), JSON.stringify(labels));
  for (const [k, a] of labels.entries()) {
    const meets = labels.slice(k + 1).filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom);
    assert.deepEqual(meets, [], a.text);
  }
  await page.select('#view', 'sizes');
  await page.waitForFunction(() => !document.querySelector('.turn-label'));
  assert.deepEqual(problems, []);
  await close();
});

test('the laying is held at the block of a link, goes on block by block, and is held so again', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${BRICKS}&step=40`);
  const forty = await held(page, 40);
  assert.equal(await page.evaluate(() => document.documentElement.dataset['stage']), 'laying');
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  assert.match(await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value), /&ground=none&step=40$/);
  await page.keyboard.press('Escape');
  await click(page, '#step');
  assert.notEqual(await held(page, 41), forty);
  await click(page, '#step');
  await held(page, 42);
  // A link leads back.
  await page.evaluate((fragment) => (location.hash = fragment), `${BRICKS}&step=40`);
  assert.equal(await held(page, 40), forty);
  await reloading(page, () => page.reload());
  assert.equal(await held(page, 40), forty);
  await click(page, '#play');
  const whole = await made(page);
  await close();
  const straight = await site.newPage(BRICKS);
  assert.equal(await made(straight.page), whole);
  assert.deepEqual([problems, straight.problems], [[], []]);
  await straight.close();
});

test('a click on a block turns the bricks of its edge or corner, and undo turns them back', sameEverywhere, async () => {
  // One edge stands upright in the middle of the frame.
  const { page, problems, close } = await site.newPage(`${BRICKS}&camera=315,20`);
  const laid = await made(page);
  const first = await hash(page);
  const { x, y } = await spot(page, 0.5, 0.45);
  await page.mouse.click(x + 1, y);
  await page.waitForSelector('.turn-card[data-picked] #turn-flip');
  const card = await page.$eval('.turn-card', (box) => box.textContent ?? '');
  assert.match(card, /^Block \d+Kindwhole brick.*Feature(corner|edge) \d+/);
  await click(page, '#turn-flip');
  await page.waitForFunction(() => window.bubblestone.get('flips') !== '');
  assert.notEqual(await made(page), laid);
  assert.notEqual(await other(page, first), first);
  const turnedLink = await link(page);
  assert.match(turnedLink, /&flips=/);
  await click(page, '#undo');
  assert.equal(await made(page), laid);
  assert.equal(await hash(page), first);
  assert.doesNotMatch(await link(page), /flips/);
  await click(page, '#redo');
  await made(page);
  assert.equal(await link(page), turnedLink);
  assert.deepEqual(problems, []);
  await close();
});

test('a block is made step by step, and a link opens the same step', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${BRICKS}&camera=315,20`);
  await made(page);
  const all = await hash(page);
  await page.focus('#turn');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#turn-how');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.turn-making', { visible: true });
  assert.match(await page.$eval('.turn-making h2', (title) => title.textContent ?? ''), /^How block \d+ is made$/);
  const names = await page.$$eval('.turn-dot', (dots) => dots.map((dot) => dot.getAttribute('aria-label')));
  assert.deepEqual(names.slice(-4), ['Claim', 'Joints', 'Chamfer', 'In the wall']);
  const seen = new Set();
  for (const name of names) {
    await tells(page, new RegExp(`^Block \\d+, step ${seen.size + 1} of ${names.length}: ${name}\\.$`));
    seen.add(await hash(page));
    assert.doesNotMatch(await page.$eval('.turn-note', (note) => note.textContent ?? ''), /Miyata/);
    await page.keyboard.press('.');
  }
  assert.equal(seen.size, names.length);
  const last = [await hash(page), await told(page)];
  await click(page, '#share');
  await page.waitForSelector('#share-seen');
  await click(page, '#share-seen');
  const shared = await page.$eval('#share-link', (field) => /** @type {HTMLInputElement} */ (field).value);
  await page.keyboard.press('Escape');
  const again = await site.newPage(new URL(shared).hash);
  await again.page.waitForSelector('.turn-making', { visible: true });
  assert.deepEqual([await hash(again.page), await told(again.page)], last);
  await click(page, '#turn-all');
  await tells(page, /^\d+ blocks, seen/);
  assert.equal(await hash(page), all);
  assert.deepEqual([problems, again.problems], [[], []]);
  await again.close();
  await close();
});

test('a turned edge that the building does not have is told', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${BRICKS}&flips=1,999`);
  await made(page);
  await click(page, '#caption .remarks');
  await message(page, 'status', /turned by hand that the building does not have: 1\. They were left out/);
  assert.deepEqual(problems, []);
  await close();
});

test('a building opens as masonry, whatever is shown, and a refused one changes nothing', sameEverywhere, async () => {
  assert.match(BUILDING, /"faces"/);
  const first = await site.newPage(SMALL);
  await digest(first.page);
  for (const [make, fragment] of [['pavement', SMALL], ['surface', BALL], ['pile', PILE]]) {
    await first.page.evaluate((hash) => (location.hash = hash), fragment ?? '');
    await first.page.waitForSelector(`.make[data-make=${make}][aria-current]`);
    await drop(first.page, `on-${make}.json`, BUILDING, 'application/json');
    await message(first.page, 'status', new RegExp(`on-${make}\\.json is open`));
    await first.page.waitForSelector('.make[data-make=masonry][aria-current]');
    assert.match(await link(first.page), /^v=1&make=masonry&building=file&model=[\w-]+$/);
    assert.equal(await first.page.$eval('#model-name', (name) => name.textContent), `on-${make}.json`);
  }
  assert.deepEqual(first.problems, []);
  await first.close();
  // Where masonry is shown, its pattern stays.
  const { page, problems, close } = await site.newPage(BRICKS);
  await made(page);
  await drop(page, 'walls.obj', WALLS, '');
  await message(page, 'status', /walls\.obj is open/);
  const walls = await made(page);
  const before = await link(page);
  assert.match(before, /building=file&.*pattern=bricks/);
  await turned(page);
  for (const [name, content, words] of [
    ['broken.json', BUILDING.replace('"faces": [', '"faces": [,'), /broken\.json was not opened, and nothing has changed\. Line 6, column 13 of the building is not JSON/],
    ['later.json', BUILDING.replace('"version": 1', '"version": 2'), /later\.json was not opened, and nothing has changed\. .*version/],
  ]) {
    await drop(page, String(name), String(content), 'application/json');
    await message(page, 'alert', /** @type {RegExp} */ (words));
    assert.deepEqual([await link(page), await digest(page)], [before, walls]);
  }
  // A file is chosen in the panel.
  await chooses(page, 'wall.json', BUILDING);
  await click(page, '#model-other');
  await page.waitForFunction(() => document.querySelector('#model-name')?.textContent === 'wall.json');
  assert.notEqual(await made(page), walls);
  assert.match(await link(page), /pattern=bricks/);
  await click(page, '#undo');
  assert.equal(await made(page), walls);
  assert.deepEqual(problems, []);
  await close();
});

test('a file in millimetres opens as such, and its unit and upright axis can be changed beside its name', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(BRICKS);
  await made(page);
  await drop(page, 'walls.obj', WALLS, '');
  await message(page, 'status', /walls\.obj is open\.(?! In)/);
  const metres = await made(page);
  assert.equal(await page.$eval('#model-unit', (select) => /** @type {HTMLSelectElement} */ (select).value), 'm');
  // The file's name stands for the choice of a file.
  assert.equal(await page.$eval('#caption', (caption) => caption.textContent), 'This recipe: walls.obj · Bricks');
  await page.select('#model-unit', 'ft');
  await page.waitForFunction(() => location.hash.includes('unit=ft'));
  assert.notEqual(await made(page), metres);
  const long = WALLS.replace(/^v .*$/gm, (line) => line.replace(/\d/g, '$&000'));
  await drop(page, 'long.obj', long, '');
  await message(page, 'status', /long\.obj is open\. .*unit is: Millimetres\./);
  assert.equal(await made(page), metres);
  assert.equal(await page.$eval('#model-unit', (select) => /** @type {HTMLSelectElement} */ (select).value), 'mm');
  assert.match(await link(page), /unit=mm/);
  // The block is 2 by 1 by 1: with z up it is as long, and lies in another place of its file.
  await click(page, '#model input[value=z]');
  await page.waitForFunction(() => location.hash.includes('up=z'));
  assert.notEqual(await made(page), metres);
  // A file in JSON tells both itself, and another file begins in metres.
  await drop(page, 'wall.json', BUILDING, 'application/json');
  await message(page, 'status', /wall\.json is open\.(?! In)/);
  await page.waitForSelector('#model-unit[hidden]');
  await drop(page, 'walls.obj', WALLS, '');
  await message(page, 'status', /walls\.obj is open\.(?! In)/);
  await page.waitForSelector('#model-unit:not([hidden])');
  assert.equal(await page.$eval('#model-unit', (select) => /** @type {HTMLSelectElement} */ (select).value), 'm');
  assert.deepEqual(problems, []);
  await close();
});

test('a building saved as JSON opens again with the same blocks', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, BRICKS);
  const blocks = await made(page);
  const { name, bytes } = await saved(page, '#save-building');
  assert.match(name, /^bubblestone-.*building.*\.json$/);
  const text = new TextDecoder().decode(bytes);
  assert.ok(JSON.parse(text).faces.length > 5, text.slice(0, 200));
  await drop(page, 'mine.json', text, 'application/json');
  await message(page, 'status', /mine\.json is open/);
  await page.waitForFunction(() => document.querySelector('#model-name')?.textContent === 'mine.json');
  assert.equal(await made(page), blocks);
  assert.deepEqual(problems, []);
  await close();
});

test('from masonry, a JSON file leads to what it holds: a recipe, an outline, a building, or a sentence', sameEverywhere, async () => {
  const drawn = await site.newPage(`${SQUARE}&outline=star`);
  await digest(drawn.page);
  const outline = await exported(drawn.page, 'json');
  await drawn.close();
  const { page, problems, close } = await site.newPage(BRICKS);
  const bricks = await made(page);
  const before = await link(page);
  for (const [name, content] of [['none.json', '{"name": "something else"}'], ['broken.json', '{"rings": [']]) {
    await drop(page, name, content, 'application/json');
    await message(page, 'alert', name === 'none.json' ? /none\.json” has no outline .*no building .*no recipe\. Nothing has changed\./ : /broken\.json” cannot be read as JSON\. Nothing has changed\./);
    assert.deepEqual([await link(page), await digest(page)], [before, bricks]);
  }
  await drop(page, 'star.json', outline, 'application/json');
  await page.waitForSelector('.make[data-make=pavement][aria-current]');
  assert.match(await link(page), /^v=1&outline=polygon&poly=/);
  await page.waitForSelector('.handle');
  assert.notEqual(await digest(page), '');
  await click(page, '#undo');
  assert.equal(await made(page), bricks);
  await drop(page, 'mine.json', JSON.stringify({ program: 'Bubblestone', recipe: SMALL.slice(1) }), 'application/json');
  await message(page, 'status', /mine\.json is open/);
  await page.waitForSelector('.make[data-make=pavement][aria-current]');
  assert.equal(await get(page, 'cs'), '16');
  // The dialog for saving opens the same files.
  await digest(page);
  for (const [name, content, make] of [['wall.json', BUILDING, 'masonry'], ['star.json', outline, 'pavement']]) {
    await chooses(page, name ?? '', content ?? '');
    await dialog(page);
    await click(page, '#open-recipe');
    await page.waitForSelector(`.make[data-make=${make}][aria-current]`);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('sliders that are moved without a rest hold the page for less than 50 ms', { skip }, async () => {
  const { page, problems, close } = await site.newPage(`${BRICKS}&module=own`);
  await made(page);
  await page.waitForSelector('[data-key=block_length] [type=range]');
  const storm = () =>
    page.evaluate(async () => {
      for (let k = 0; k < 60; k += 1) {
        const key = ['block_length', 'block_height', 'w'][k % 3];
        const slider = /** @type {HTMLInputElement} */ (document.querySelector(`[data-key=${key}] [type=range]`));
        slider.value = String(Number(slider.min) + ((((k * 7) % 11) + 4) / 20) * (Number(slider.max) - Number(slider.min)));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        for (let left = 3; left > 0; left -= 1) await new Promise(requestAnimationFrame);
      }
    });
  const runs = [];
  // The first run takes longer, and so does each run while other programs use the processor's caches.
  while (runs.length < 6 && !(runs.at(-1) < 1)) {
    runs.push(
      await longestTask(page, async () => {
        await storm();
        await done(page);
        await frames(page, 3);
      }),
    );
  }
  assert.ok((runs.at(-1) ?? 2) < 1, `tasks of ${runs.join(', ')} times 50 ms`);
  assert.match((await told(page)) ?? '', /blocks, seen/);
  assert.deepEqual(problems, []);
  await close();
});
