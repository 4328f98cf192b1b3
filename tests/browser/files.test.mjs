// Files that the page saves, except meshes and maps.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PNG } from 'pngjs';
import sharp from 'sharp';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, done, drop, link, message, set, SMALL } from './page.mjs';
import { dialog, handed, opened, saved } from './saved.mjs';
import { longestTask, skip } from './tasks.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('the cells are saved as a well-formed SVG with a polygon or a path for each', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site);
  await digest(page);
  const { name, bytes } = await saved(page, '#save-svg');
  assert.equal(name, 'bubblestone-ring-1.svg');
  const cells = await page.$eval('#count-cells', (count) => Number(count.textContent));
  const { root, faults, shapes } = await page.evaluate((text) => {
    const read = new DOMParser().parseFromString(text, 'image/svg+xml');
    return {
      root: read.documentElement.localName,
      faults: read.querySelectorAll('parsererror').length,
      shapes: read.querySelectorAll('polygon, path').length,
    };
  }, Buffer.from(bytes).toString());
  assert.deepEqual([root, faults], ['svg', 0]);
  assert.ok(shapes >= cells, `${shapes} shapes of ${cells} cells`);
  assert.deepEqual(problems, []);
  await close();
});

test('a recipe saved as JSON and opened again, by dialog or drop, gives the same planes', async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&seed=5&stone=flag&palette=marble`);
  const planes = await digest(page);
  const { name, bytes } = await saved(page, '#save-recipe');
  assert.equal(name, 'bubblestone-ring-5.json');
  const recipe = JSON.parse(Buffer.from(bytes).toString());
  assert.equal(recipe.program, 'Bubblestone');
  assert.match(recipe.version, /^\d+\.\d+/);
  assert.equal(recipe.link, `${site.address}#${recipe.recipe}`);
  assert.equal(Object.keys(recipe.parameters).length, await page.evaluate(() => window.bubblestone.schema.length));
  assert.deepEqual([recipe.parameters.seed, recipe.parameters.palette, recipe.parameters.cs], [5, 'marble', 16]);
  const folder = mkdtempSync(join(tmpdir(), 'bubblestone-recipe-'));
  const path = join(folder, name);
  writeFileSync(path, bytes);
  // Change the picture, then open the file.
  await click(page, '#dice');
  assert.notEqual(await digest(page), planes);
  await dialog(page);
  const [chooser] = await Promise.all([page.waitForFileChooser(), click(page, '#open-recipe')]);
  await chooser.accept([path]);
  await message(page, 'status', /is open/);
  assert.equal(await digest(page), planes);
  await click(page, '#undo');
  assert.notEqual(await digest(page), planes);
  await drop(page, 'again.json', bytes, 'application/json');
  await message(page, 'status', /again\.json is open/);
  assert.equal(await digest(page), planes);
  // A file of another kind changes nothing.
  writeFileSync(path, '{"recipe": 3}');
  await dialog(page);
  const [again] = await Promise.all([page.waitForFileChooser(), click(page, '#open-recipe')]);
  await again.accept([path]);
  await message(page, 'alert', /has no outline .* and no recipe/);
  assert.equal(await digest(page), planes);
  rmSync(folder, { recursive: true });
  assert.deepEqual(problems, []);
  await close();
});

test('pictures and drawings saved here open their recipe when they are dropped; another picture gets a sentence', sameEverywhere, async () => {
  const recipe = `${SMALL}&seed=5&palette=marble&poly=0.1,0.1,0.9,0.2,0.5,0.9&outline=custom`;
  const { page, problems, close } = await opened(site, recipe);
  const planes = await digest(page);
  const work = await link(page);
  for (const button of ['#save-png', '#save-png-2', '#save-svg']) {
    const { name, bytes } = await saved(page, button);
    await click(page, '#dice');
    assert.notEqual(await link(page), work);
    await drop(page, name, bytes, name.endsWith('svg') ? 'image/svg+xml' : 'image/png');
    await message(page, 'status', new RegExp(`${name.replaceAll('.', '\\.')} is open`));
    assert.equal(await link(page), work, name);
    assert.equal(await digest(page), planes);
    await click(page, '#undo');
    assert.notEqual(await link(page), work);
    await click(page, '#redo');
    await digest(page);
  }
  const image = new PNG({ width: 2, height: 2 });
  await drop(page, 'holiday.png', PNG.sync.write(image), 'image/png');
  await message(page, 'alert', /holiday\.png.* without a recipe/);
  assert.equal(await link(page), work);
  assert.deepEqual(problems, []);
  await close();
});

test('a picture of the default recipe opens that one', sameEverywhere, async () => {
  const { page, close } = await opened(site, '#v=1');
  await done(page);
  const { bytes } = await saved(page, '#save-svg');
  assert.match(Buffer.from(bytes.subarray(0, 400)).toString(), /<metadata>Bubblestone: http[^#<]*<\/metadata>/);
  await set(page, 'cs', '30');
  await drop(page, 'first.svg', bytes, 'image/svg+xml');
  await message(page, 'status', /first\.svg is open/);
  assert.equal(await link(page), '');
  await close();
});

test('the forming is saved as a looping GIF, to its end, while the page stays free', sameEverywhere, async () => {
  const { page, problems, external, close } = await opened(site);
  const planes = await digest(page);
  const { name, bytes } = await saved(page, '#save-gif');
  assert.equal(name, 'bubblestone-ring-1-forming.gif');
  const file = Buffer.from(bytes);
  assert.equal(file.subarray(0, 6).toString('latin1'), 'GIF89a');
  assert.deepEqual([file.readUInt16LE(6), file.readUInt16LE(8)], [192, 192]);
  assert.ok(file.includes('NETSCAPE2.0\x03\x01\x00\x00', 0, 'latin1'), 'it does not loop for ever');
  const { pages, loop, delay } = await sharp(file).metadata();
  assert.ok(pages >= 15 && pages <= 70, `${pages} frames`);
  assert.equal(loop, 0);
  assert.ok(delay.at(-1) >= 2000, 'the end is not held');
  // The last frame equals the canvas, up to the palette.
  const last = await sharp(file, { page: pages - 1 }).ensureAlpha().raw().toBuffer();
  const shown = await page.$eval('#canvas', (canvas) => Array.from(canvas.getContext('2d').getImageData(0, 0, 192, 192).data));
  const off = shown.reduce((sum, value, k) => sum + Math.abs(value - last[k]), 0) / shown.length;
  assert.ok(off < 6, `the last frame is ${off} off`);
  assert.equal(await digest(page), planes);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('Stop stops what is being made, and then another file can be saved', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, '#size=512&cs=9');
  await digest(page);
  for (const button of ['#save-gif', '#save-png-8', '#save-obj']) {
    await dialog(page);
    if (button === '#save-png-8') {
      for (const words of ['textContent', 'ariaLabel']) assert.match(await page.$eval(button, (key, name) => key[name], words), /4096 px, about \d+ (s|min)$/);
    }
    await click(page, button);
    await page.waitForSelector('.message progress');
    assert.equal(await page.$('.message:has(progress) .close'), null, 'the way to stop can be put out of sight');
    await page.$eval('#stop-files', (stop) => stop.click());
    await message(page, 'status', /was stopped/);
    await page.evaluate(() => document.querySelector('.message .close')?.click());
    assert.equal(await page.evaluate(() => window.saved), undefined);
  }
  assert.equal((await saved(page, '#save-recipe')).name, 'bubblestone-ring-1.json');
  await page.$eval('[data-preset=snake]', (button) => button.click());
  assert.equal((await saved(page, '#save-recipe')).name, 'bubblestone-snake-1.json');
  await set(page, 'cs', '40');
  assert.equal((await saved(page, '#save-recipe')).name, 'bubblestone-seamless-tile-1.json');
  assert.deepEqual(problems, []);
  await close();
});

test('saving is done beside the page, which is never held for long', { skip }, async () => {
  const { page, problems, close } = await opened(site, '#seed=2');
  await digest(page);
  for (const button of ['#save-png-2', '#save-maps']) {
    const runs = [];
    // The page may be busy, for example with garbage collection, and its code is slow at first.
    while (runs.length < 6 && !(runs.at(-1) < 1)) {
      await dialog(page);
      const saving = () => handed(page, () => page.$eval(button, (key) => key.click()));
      runs.push(await longestTask(page, saving));
    }
    assert.ok(runs.at(-1) < 1, `${button}: tasks of ${runs.join(' and ')} times 50 ms`);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('the caption of a recipe that was dropped is its own', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, '');
  await digest(page);
  const file = (recipe) => JSON.stringify({ program: 'Bubblestone', recipe });
  const caption = (words) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector('#caption').textContent), { timeout: 60_000 }, words);
  const presets = await page.evaluate(() => window.bubblestone.presets);
  // The first picture of a visit is a preset.
  const title = 'Mossy lane';
  const other = presets.find((preset) => preset.title !== title);
  await caption(`^${title}:`);
  await drop(page, 'mine.json', file('v=1&size=192&cs=16&outline=star'), 'application/json');
  await caption('^This recipe: Star · Square');
  await set(page, 'seed', '7');
  await digest(page);
  await caption('^This recipe: Star · Square');
  for (let step = 0; step < 2; step += 1) await click(page, '#undo');
  await caption(`^${title}:`);
  await drop(page, 'theirs.json', file(other.link.replace('#', '')), 'application/json');
  await caption(`^${other.title}:`);
  assert.deepEqual(problems, []);
  await close();
});
