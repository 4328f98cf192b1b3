import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import validator from 'gltf-validator';
import { PNG } from 'pngjs';
import { open } from './harness.mjs';
import { digest, message, messages, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A page that keeps the files it hands over. */
async function opened(fragment = SMALL) {
  return site.newPage(fragment, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        const blobs = new Map();
        const create = URL.createObjectURL;
        URL.createObjectURL = (blob) => {
          const url = create(blob);
          blobs.set(url, blob);
          return url;
        };
        HTMLAnchorElement.prototype.click = function () {
          window.saved = { name: this.download, blob: blobs.get(this.href) };
        };
      }),
  });
}

/** Clicks a button of the menu; answers the file's name and bytes. */
async function saved(page, button) {
  await page.evaluate(() => {
    window.saved = undefined;
    document.querySelector('#files').open = true;
  });
  await page.click(button);
  await page.waitForFunction(() => window.saved, { timeout: 60_000 });
  const { name, text } = await page.evaluate(async () => {
    const { name, blob } = window.saved;
    const reader = new FileReader();
    await new Promise((resolve) => {
      reader.onload = resolve;
      reader.readAsDataURL(blob);
    });
    return { name, text: reader.result };
  });
  return { name, bytes: new Uint8Array(Buffer.from(text.slice(text.indexOf(',') + 1), 'base64')) };
}

test('the mesh is a valid GLB file and an OBJ file of as many triangles', async () => {
  const { page, problems, external, close } = await opened(`${SMALL}&seed=7&outline=star&stone=skin&sc=0.5`);
  await digest(page);
  const glb = await saved(page, '#save-glb');
  assert.equal(glb.name, 'bubblestone-star-7.glb');
  const { issues, info } = await validator.validateBytes(glb.bytes);
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
  assert.ok(info.totalTriangleCount > 10_000);
  const obj = await saved(page, '#save-obj');
  assert.equal(obj.name, 'bubblestone-star-7.obj');
  const lines = Buffer.from(obj.bytes).toString().split('\n');
  assert.equal(lines.filter((line) => line.startsWith('f ')).length, info.totalTriangleCount);
  assert.equal(lines.filter((line) => line.startsWith('v ')).length, info.totalVertexCount);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('all maps come in one zip file, those of a tile without a seam', async () => {
  const { page, problems, external, close } = await opened(`${SMALL}&tile=1`);
  await digest(page);
  const zip = await saved(page, '#save-maps');
  assert.match(zip.name, /^bubblestone-\w+-\d+-maps\.zip$/);
  const files = unzipSync(zip.bytes);
  const maps = ['height', 'normal-opengl', 'albedo', 'roughness', 'ao', 'id'];
  assert.deepEqual(Object.keys(files).sort(), [...maps.map((name) => `${name}.png`), 'report.json'].sort());
  /** @type {Record<string, any>} */
  const read = {};
  for (const name of maps) {
    const file = Buffer.from(files[`${name}.png`]);
    read[name] = PNG.sync.read(file, { skipRescale: true });
    const { width, height, depth, data } = read[name];
    assert.deepEqual([width, height, depth], [192, 192, name === 'height' ? 16 : 8], name);
    assert.ok(new Set(data.filter((_, k) => k % 4 === 0)).size > 2, `${name} is flat`);
    // Steps over the seam are as those inside.
    const step = (from, to) => {
      let sum = 0;
      for (let y = 0; y < 192; y += 1) sum += Math.abs(data[4 * (192 * y + from)] - data[4 * (192 * y + to)]);
      return sum;
    };
    const steps = Array.from({ length: 191 }, (_, x) => step(x, x + 1));
    assert.ok(step(191, 0) <= Math.max(...steps), `${name} has a seam`);
  }
  const range = [Math.min(...read.height.data.filter((_, k) => k % 4 === 0)), Math.max(...read.height.data.filter((_, k) => k % 4 === 0))];
  assert.deepEqual(range, [0, 65535]);
  const report = JSON.parse(Buffer.from(files['report.json']).toString());
  assert.ok(report.height_range[1] > report.height_range[0]);
  await page.select('#normals', 'normal-directx');
  const other = unzipSync((await saved(page, '#save-maps')).bytes);
  const [up, down] = [read['normal-opengl'], PNG.sync.read(Buffer.from(other['normal-directx.png']))];
  const mirrored = (_, k) => k % 4 !== 1 || Math.abs(up.data[k] + down.data[k] - 255) <= 1;
  assert.ok(down.data.every(mirrored) && !down.data.every((v, k) => v === up.data[k]));
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('before the picture is done a sentence says so, and the menu closes by Escape', async () => {
  const { page, problems, close } = await opened(`${SMALL}&vs=0.1`);
  await digest(page);
  await page.click('#play');
  await page.click('#restart');
  await page.focus('#files summary');
  await page.keyboard.press('Enter');
  await page.click('#save-maps');
  await message(page, 'status', /when it is done/);
  await page.click('#save-glb');
  await message(page, 'status', /when it is done/);
  assert.equal((await messages(page)).filter((text) => text.includes('when it is done')).length, 1);
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#files', (menu) => menu.open), false);
  assert.equal(await page.evaluate(() => document.activeElement.tagName), 'SUMMARY');
  assert.deepEqual(problems, []);
  await close();
});
