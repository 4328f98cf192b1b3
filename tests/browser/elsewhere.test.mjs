// The npm package on other pages: bundled from its tarball, and as plain files.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { host } from '../../scripts/lib/host.mjs';
import { buildPackage, packageFolder } from '../../scripts/lib/package.mjs';
import { root } from '../../scripts/lib/run.mjs';
import { targetDir } from '../../scripts/lib/rust.mjs';
import { kind, sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';

const given = join(root, 'tests', 'elsewhere');
const folder = join(targetDir, 'elsewhere');
const plain = join(targetDir, 'elsewhere-plain');

/** @type {Awaited<ReturnType<typeof open>>} */
let bundled;
/** @type {Awaited<ReturnType<typeof open>>} */
let files;

/** A page with an element whose module is missing. */
const BROKEN = '<!doctype html><link rel="icon" href="data:,"><script type="module" src="./bubblestone/element.js"></script><bubble-stone></bubble-stone>';

/** A page built by Vite from nothing but the tarball. @param {string} tarball */
async function bundle(tarball) {
  rmSync(folder, { recursive: true, force: true });
  cpSync(given, folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }\n');
  const { status, stderr } = spawnSync('npm', ['install', '--offline', '--no-audit', '--no-fund', '--no-save', tarball], { cwd: folder, encoding: 'utf8', shell: process.platform === 'win32' });
  assert.equal(status, 0, stderr);
  const { build } = await import('vite');
  await build({ root: folder, configFile: false, logLevel: 'warn', base: './', build: { target: 'es2022' } });
}

/** A page beside the package's plain files. */
function unbundled() {
  rmSync(plain, { recursive: true, force: true });
  mkdirSync(plain, { recursive: true });
  cpSync(packageFolder, join(plain, 'bubblestone'), { recursive: true });
  cpSync(join(given, 'index.html'), join(plain, 'index.html'));
  writeFileSync(join(plain, 'main.js'), readFileSync(join(given, 'main.js'), 'utf8').replace("'bubblestone'", "'./bubblestone/index.js'").replace("'bubblestone/element'", "'./bubblestone/element.js'"));
  cpSync(packageFolder, join(plain, 'broken', 'bubblestone'), { recursive: true, filter: (file) => !file.endsWith('.wasm') });
  writeFileSync(join(plain, 'broken', 'index.html'), BROKEN);
}

before(async () => {
  const tarball = buildPackage();
  unbundled();
  files = await open({ serve: () => host(plain) });
  if (kind !== 'chromium') return;
  await bundle(tarball);
  bundled = await open({ serve: () => host(join(folder, 'dist')) });
});

after(async () => {
  await bundled?.close();
  await files?.close();
});

/** The last event of an element. @param {import('puppeteer-core').Page} page @param {string} id */
async function told(page, id) {
  const handle = await page.waitForFunction((name) => window.told?.[name], {}, id);
  return handle.jsonValue();
}

test('a page that was bundled paints pictures and has elements that form while they are seen', sameEverywhere, async () => {
  const { page, problems, external, close } = await bundled.newPage();
  const near = await told(page, 'near');
  assert.equal(near.kind, 'done');
  await page.waitForFunction(() => window.painted);
  const painted = await page.evaluate(() => window.painted);
  assert.match(painted.digest, /^[0-9a-f]+$/);
  assert.equal(near.digest, painted.digest, 'the same link gives the same picture');
  assert.ok((await page.evaluate(() => window.presets)) > 20);
  assert.deepEqual(await page.$eval('#far', (stone) => [stone.studio === undefined, window.told.far === undefined]), [true, true], 'what is far away does nothing');
  await page.$eval('#far', (stone) => stone.scrollIntoView());
  const far = await told(page, 'far');
  assert.equal(far.kind, 'done');
  assert.match(far.notices.join(), /nonsense/);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('plain files do the same; an element follows its attributes, and frees what it took', async () => {
  const { page, problems, close } = await files.newPage('', { still: true });
  const { digest } = await told(page, 'near');
  await page.waitForFunction(() => window.painted);
  assert.equal(await page.evaluate(() => window.painted.digest), digest);
  const colours = () =>
    page.$eval('#near', (stone) => {
      const canvas = stone.shadowRoot.querySelector('canvas');
      return [canvas.width, new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size];
    });
  const [side, count] = await colours();
  assert.ok(side === 128 && count > 100, `${side} ${count}`);
  assert.equal(await page.$eval('#near', (stone) => stone.shadowRoot.querySelector('canvas').ariaLabel), 'A ring of stones');

  // Another view shows the same picture's data; another link makes a new picture.
  await page.$eval('#near', (stone) => (stone.view = 'ids'));
  await page.waitForFunction((before) => {
    const canvas = document.querySelector('#near').shadowRoot.querySelector('canvas');
    return new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, 128, 128).data.buffer)).size !== before;
  }, {}, count);
  await page.evaluate(() => {
    window.told = {};
    window.drawn = [];
    const put = CanvasRenderingContext2D.prototype.putImageData;
    CanvasRenderingContext2D.prototype.putImageData = function (image, ...place) {
      window.drawn.push(image.width);
      put.call(this, image, ...place);
    };
    document.querySelector('#near').link = '#size=160&cs=24&seed=2';
  });
  assert.notEqual((await told(page, 'near')).digest, digest);
  assert.deepEqual(await page.evaluate(() => window.drawn), [160], 'another size takes one drawing');
  assert.equal((await colours())[0], 160);

  // A paused element does no work.
  await page.evaluate(() => {
    window.told = {};
    const near = document.querySelector('#near');
    near.paused = true;
    near.restart();
  });
  await page.evaluate(async () => {
    for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
  });
  assert.deepEqual(await page.$eval('#near', (stone) => [stone.studio.stage(), window.told.near === undefined]), ['packing', true]);
  await page.$eval('#near', (stone) => (stone.paused = false));
  assert.equal((await told(page, 'near')).kind, 'done');

  // A moved element goes on; a removed one has freed its studio.
  await page.$eval('#near', (stone) => document.body.append(stone));
  assert.equal(await page.$eval('#near', (stone) => stone.studio !== undefined), true);
  const left = await page.$eval('#near', async (stone) => {
    stone.remove();
    await Promise.resolve();
    return stone.studio;
  });
  assert.equal(left, undefined);
  assert.deepEqual(problems, []);
  await close();
});

test('an element that cannot have its module says so in a sentence', sameEverywhere, async () => {
  const { page, close } = await files.newPage('broken/');
  await page.waitForFunction(() => document.querySelector('bubble-stone').shadowRoot?.querySelector('[role=alert]').textContent !== '');
  const words = await page.$eval('bubble-stone', (stone) => stone.shadowRoot.querySelector('[role=alert]').textContent);
  assert.match(words, /^The WebAssembly module of Bubblestone could not be loaded \(.+\)\.$/);
  // Another link loads again.
  const again = await page.$eval(
    'bubble-stone',
    (stone) =>
      new Promise((resolve) => {
        stone.addEventListener('error', ({ detail }) => resolve(detail.message));
        stone.link = '#seed=2';
      }),
  );
  assert.equal(again, words);
  await close();
});
