// The page's digests in this browser. The digests of all presets are compared natively and, with the shipped module, under
// Node.
import assert from 'node:assert/strict';
import { cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { targetDir } from '../../scripts/lib/rust.mjs';
import { pageModule } from '../../scripts/lib/wasm.mjs';
import { figuresText, golden } from '../common/figures.mjs';
import { digests, frames, varied } from '../common/golden.mjs';
import { open } from './harness.mjs';
import { digest, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('ten presets of many kinds have the same planes in the browser as natively', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await page.$eval('#speed label:last-child input', (radio) => radio.click());
  const presets = await page.evaluate(() => window.bubblestone.presets);
  assert.deepEqual(presets.map(({ name }) => name), digests.map(([name]) => name));
  const chosen = varied(presets);
  const wanted = digests.filter(([name]) => chosen.has(name));
  const found = [];
  for (const [name] of wanted) {
    await page.$eval(`[data-preset="${name}"]`, (button) => button.click());
    found.push([name, await digest(page)]);
  }
  assert.deepEqual(found, wanted);
  assert.deepEqual(problems, []);
  await close();
});

test('frames of a tile by a lamp, of stones from near and of a surface are those that are made natively', async () => {
  const chosen = frames.filter(({ link }) => /light=point|outline=square$|form=vase/.test(link));
  assert.equal(chosen.length, 3);
  for (const { hash, camera, link } of chosen) {
    const { page, problems, close } = await site.newPage(`#${link}`);
    await digest(page);
    const found = await page.evaluate((from) => /** @type {any} */ (window).bubblestone.frame(from), camera);
    assert.equal(found, hash, link);
    assert.deepEqual(problems, []);
    await close();
  }
});

/** An empty page beside the page's module and the code of the chapters' figures. */
async function besideFigures() {
  const folder = join(targetDir, 'figures-alone');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  cpSync(pageModule, join(folder, 'module'), { recursive: true });
  writeFileSync(join(folder, 'figures.js'), await figuresText());
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>Figures</title><link rel="icon" href="data:,">');
  return open({ files: folder });
}

test('the figures of all chapters have the same numbers in the browser as natively', async (t) => {
  const own = await besideFigures();
  t.after(() => own.close());
  const { page, problems, close } = await own.newPage();
  const lines = await page.evaluate(async () => {
    const load = (/** @type {string} */ file) => import(new URL(file, location.href).href);
    const [module, { measured }] = await Promise.all([load('module/bubblestone.js'), load('figures.js')]);
    await module.default();
    return measured(module);
  });
  assert.deepEqual(lines, golden());
  assert.deepEqual(problems, []);
  await close();
});
