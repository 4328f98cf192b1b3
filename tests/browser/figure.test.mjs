// The host of an engine without the usual page around it: a figure on any other page works like this.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import page from '../../vite.config.mjs';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';

const SQUARE = 'outline=square&size=128&cs=16';
const BALL = 'make=surface&form=sphere&cn=60&size=128';

/** The plugins that the scripts of the page need. */
const NEEDED = ['notices', 'packed', 'made'];

const folder = mkdtempSync(join(tmpdir(), 'bubblestone-figure-'));
/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  if (sameEverywhere.skip) return;
  const plugins = page.plugins.filter(({ name }) => NEEDED.includes(name));
  const root = fileURLToPath(new URL('figure/', import.meta.url));
  await build({ ...page, configFile: false, root, plugins, publicDir: false, logLevel: 'warn', build: { target: page.build.target, assetsInlineLimit: 0, outDir: folder, emptyOutDir: true } });
  site = await open({ files: folder });
});

after(async () => {
  await site?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Waits for the line below the figure. */
const says = (page, words) => page.waitForFunction((text) => document.querySelector('p').textContent.includes(text), {}, words);

/** Hash, colours and sides of the figure. */
const seen = (page) =>
  page.$eval('canvas', (canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const pixels = new Uint32Array(data.buffer);
    return { hash: pixels.reduce((hash, pixel) => Math.imul(hash ^ pixel, 16777619) >>> 0, 2166136261), colours: new Set(pixels).size, sides: [canvas.width, canvas.height] };
  });

test('a figure forms in its view, is held, stepped, opens another recipe, and is freed', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`#${SQUARE}!packed`);
  await says(page, 'done');
  const end = await seen(page);
  assert.deepEqual(end.sides, [128, 128]);
  assert.ok(end.colours > 2, `${end.colours} colours`);
  // From the start, one step at a time.
  await page.evaluate(() => {
    window.host.drive({ paused: true, pace: 1 });
    window.host.restart();
  });
  await page.waitForFunction(() => window.host.loop.rests);
  assert.equal(await page.evaluate(() => window.host.engine.status().steps), 0);
  for (const steps of [1, 2]) {
    await page.evaluate(() => window.host.step());
    assert.equal(await page.evaluate(() => window.host.engine.status().steps), steps);
  }
  await page.waitForFunction(() => window.host.loop.rests);
  assert.notEqual((await seen(page)).hash, end.hash);
  await page.evaluate((link) => {
    window.host.drive({ paused: false, pace: 1000 });
    return window.host.open(link);
  }, `${SQUARE}&seed=2`);
  await says(page, 'done');
  assert.notEqual((await seen(page)).hash, end.hash);
  await page.evaluate(() => window.host.free());
  assert.equal(await page.evaluate(() => window.host.engine.alive), false);
  assert.deepEqual(problems, []);
  await close();
});

test('a figure of a surface is seen by frames in the same canvas, and a picture after it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`#${BALL}`);
  await says(page, 'done');
  await page.waitForFunction(() => document.querySelector('canvas').width === 240);
  await page.waitForFunction(() => window.host.loop.rests);
  const ball = await seen(page);
  assert.deepEqual(ball.sides, [240, 240]);
  assert.ok(ball.colours > 100, `${ball.colours} colours`);
  await page.evaluate((link) => window.host.open(link), SQUARE);
  await page.waitForFunction(() => document.querySelector('canvas').width === 128 && window.host.loop.rests);
  assert.equal(await page.evaluate(() => window.host.engine.stage()), 'done');
  assert.deepEqual(problems, []);
  await close();
});

test('a recipe that gives no picture gives a sentence', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('#make=surface&form=file&size=128&cn=60&model=qi3BmipB4jiDoi2BwGiG4GsG8C-GkG0G');
  await says(page, 'needs the file "half.obj"');
  assert.equal(await page.evaluate(() => window.host.engine.stage()), 'error');
  assert.deepEqual(problems, []);
  await close();
});
