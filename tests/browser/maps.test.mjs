// Maps and pictures that the page saves, read by other programs.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { unzipSync } from 'fflate';
import JSZip from 'jszip';
import { PNG } from 'pngjs';
import { FloatType, RedFormat } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, message, messages, set, SMALL } from './page.mjs';
import { choose, dialog, files, handed, opened, saved } from './saved.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('maps for a program have its names and packing', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&cs=24`);
  await digest(page);
  const own = files(await saved(page, '#save-maps', { normals: 'normal-opengl' }));
  const png = (file) => PNG.sync.read(Buffer.from(file)).data;
  const zip = await JSZip.loadAsync((await saved(page, '#save-maps', { normals: 'unity' })).bytes);
  assert.deepEqual(Object.keys(zip.files).sort(), ['Bubblestone_BaseMap.png', 'Bubblestone_Height.exr', 'Bubblestone_ID.png', 'Bubblestone_MaskMap.png', 'Bubblestone_Normal.png', 'report.json']);
  const mask = png(await zip.file('Bubblestone_MaskMap.png').async('nodebuffer'));
  const [ao, rough] = [png(own['ao.png']), png(own['roughness.png'])];
  for (let k = 0; k < mask.length; k += 4) assert.deepEqual([...mask.subarray(k, k + 4)], [0, ao[k], 0, 255 - rough[k]]);
  const unreal = files(await saved(page, '#save-maps', { normals: 'unreal' }));
  const orm = png(unreal['T_Bubblestone_ORM.png']);
  for (let k = 0; k < orm.length; k += 4) assert.deepEqual([...orm.subarray(k, k + 3)], [ao[k], rough[k], 0]);
  const green = [png(unreal['T_Bubblestone_N.png']), png(own['normal-opengl.png'])];
  assert.ok(green[0].every((v, k) => k % 4 !== 1 || Math.abs(v + green[1][k] - 255) <= 1));
  // The heights equal those of the 16-bit map, in sides of the picture. Readers of this format put the lowest row first.
  const blender = files(await saved(page, '#save-maps', { normals: 'blender' }));
  const { buffer } = Uint8Array.from(blender['Bubblestone_Displacement.exr']);
  const { width, height, data, format, type } = new EXRLoader().setDataType(FloatType).parse(buffer);
  assert.deepEqual([width, height, type], [192, 192, FloatType]);
  const channels = format === RedFormat ? 1 : 4;
  const { height_range: [low, high] } = JSON.parse(Buffer.from(blender['report.json']).toString());
  const grey = PNG.sync.read(Buffer.from(own['height.png']), { skipRescale: true }).data;
  for (let k = 0; k < 192 * 192; k += 1) {
    const [x, y] = [k % 192, Math.floor(k / 192)];
    const float = data[channels * ((191 - y) * 192 + x)] * 192;
    assert.ok(Math.abs(float - (low + ((high - low) * grey[4 * k]) / 65535)) < 1e-3 * high);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('all maps come in one zip file, those of a tile without a seam', sameEverywhere, async () => {
  const { page, problems, external, close } = await opened(site, `${SMALL}&tile=1`);
  await digest(page);
  const zip = await saved(page, '#save-maps');
  assert.equal(zip.name, 'bubblestone-seamless-tile-1-192-maps-opengl.zip');
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
    // Differences across the seam are like those inside.
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
  const other = unzipSync((await saved(page, '#save-maps', { normals: 'normal-directx' })).bytes);
  const [up, down] = [read['normal-opengl'], PNG.sync.read(Buffer.from(other['normal-directx.png']))];
  const mirrored = (_, k) => k % 4 !== 1 || Math.abs(up.data[k] + down.data[k] - 255) <= 1;
  assert.ok(down.data.every(mirrored) && !down.data.every((v, k) => v === up.data[k]));
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('before the picture is done a sentence says so', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&vs=0.1`);
  await digest(page);
  await click(page, '#step');
  for (const button of ['#save-maps', '#save-glb', '#save-png-2']) {
    await dialog(page);
    await click(page, button);
    await message(page, 'status', /when it is done/);
    assert.equal((await messages(page)).filter((text) => text.includes('when it is done')).length, 1);
    await page.$eval('.message .close', (close) => close.click());
  }
  // The step that is held is saved as it is shown.
  const { data } = PNG.sync.read(Buffer.from((await saved(page, '#save-png')).bytes));
  assert.deepEqual([...data], await pixels(page));
  assert.equal(await page.$eval('html', ({ dataset }) => dataset.stage), 'packing');
  assert.deepEqual(problems, []);
  await close();
});

/** The pixels of the picture. */
const pixels = (page) => page.$eval('#canvas', (canvas) => [...canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data]);

test('a file waits for the picture and is saved by itself, unless it is stopped or the picture is changed or paused', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&vs=0.1&pace=0.1`);
  const waits = async (button) => {
    await page.waitForSelector('[data-stage=packing]');
    await dialog(page);
    await click(page, button);
    await page.waitForFunction(() => /is made when the picture is done/.test(document.querySelector('#notices .message:has(progress, #stop-files) p')?.textContent ?? ''));
  };
  const ends = { stopped: () => click(page, '#stop-files'), 'picture was changed': () => set(page, 'seed', '2'), 'is paused': () => click(page, '#play') };
  for (const [sentence, act] of Object.entries(ends)) {
    await waits('#save-maps');
    await act();
    await message(page, 'status', new RegExp(sentence));
    assert.equal(await page.$('#stop-files'), null);
    assert.equal(await page.evaluate(() => window.saved), undefined);
  }
  await click(page, '#play');
  // The picture of the size that is shown waits as well.
  await handed(page, async () => {
    await waits('#save-png');
    await page.$eval('#speed label:last-of-type input', (fastest) => fastest.click());
  });
  const kept = await page.evaluate(async () => {
    const shown = await createImageBitmap(window.saved.blob);
    const context = new OffscreenCanvas(shown.width, shown.height).getContext('2d');
    context.drawImage(shown, 0, 0);
    return [...context.getImageData(0, 0, shown.width, shown.height).data];
  });
  assert.deepEqual(await page.$eval('html', ({ dataset }) => dataset.stage), 'done');
  assert.deepEqual(kept, await pixels(page));
  await set(page, 'seed', '3');
  await handed(page, async () => {
    await dialog(page);
    await click(page, '#save-maps');
  });
  assert.match(await page.evaluate(() => window.saved.name), /-3-192-maps-opengl\.zip$/);
  assert.deepEqual(problems, []);
  await close();
});

/**
 * @param {any} small
 * @param {any} large a picture's two PNG files; the second one has `scale` times the side of the first
 * @returns {number} the mean difference between the reds of the first and the means of the second
 */
function meanDifference(small, large, scale) {
  let off = 0;
  for (let y = 0; y < small.height; y += 1) {
    for (let x = 0; x < small.width; x += 1) {
      let sum = 0;
      for (let v = 0; v < scale; v += 1) for (let u = 0; u < scale; u += 1) sum += large.data[4 * ((y * scale + v) * large.width + x * scale + u)];
      off += Math.abs(sum / scale ** 2 - small.data[4 * (y * small.width + x)]);
    }
  }
  return off / (small.width * small.height);
}

test('maps come larger, and show the same', sameEverywhere, async () => {
  const { page, problems, external, close } = await opened(site, `${SMALL}&tile=1`);
  await digest(page);
  const sizes = () => page.$$eval('#maps-size option', (options) => options.map(({ value, textContent }) => [value, textContent]));
  await dialog(page);
  assert.deepEqual(await sizes(), [['1', '1× · 192 px'], ['2', '2× · 384 px'], ['4', '4× · 768 px'], ['8', '8× · 1536 px']]);
  await page.$eval('#save-dialog', (shown) => shown.close());
  const own = files(await saved(page, '#save-maps'));
  const png = (zip, name) => PNG.sync.read(Buffer.from(zip[`${name}.png`]), { skipRescale: true });
  const zip = await saved(page, '#save-maps', { 'maps-size': '2' });
  assert.equal(zip.name, 'bubblestone-seamless-tile-1-384-maps-opengl.zip');
  const twice = files(zip);
  assert.deepEqual(Object.keys(twice).sort(), Object.keys(own).sort());
  for (const name of Object.keys(own).filter((name) => name.endsWith('.png'))) {
    const [small, large] = [own, twice].map((zip) => png(zip, name.slice(0, -4)));
    assert.deepEqual([large.width, large.height, large.depth], [384, 384, small.depth], name);
    // Only colours are compared: ids jump from cell to cell, and heights in 16 bits differ by larger numbers.
    if (name === 'albedo.png') assert.ok(meanDifference(small, large, 2) < 7, `${name} is ${meanDifference(small, large, 2)} off`);
  }
  const reports = [own, twice].map((zip) => JSON.parse(Buffer.from(zip['report.json']).toString()));
  assert.deepEqual([reports[1].scale, reports[1].hash], [2, reports[0].hash]);
  // The dialog has kept the size that was chosen. The 32-bit heights equal the 16-bit ones.
  const blender = files(await saved(page, '#save-maps', { normals: 'blender' }));
  const { width, height, data, format } = new EXRLoader().setDataType(FloatType).parse(Uint8Array.from(blender['Bubblestone_Displacement.exr']).buffer);
  assert.deepEqual([width, height], [384, 384]);
  const channels = format === RedFormat ? 1 : 4;
  const [low, high] = reports[1].height_range;
  const grey = png(twice, 'height').data;
  for (let k = 0; k < 384 * 384; k += 1) {
    const [x, y] = [k % 384, Math.floor(k / 384)];
    const float = data[channels * ((383 - y) * 384 + x)] * 192;
    assert.ok(Math.abs(float - (low + ((high - low) * grey[4 * k]) / 65535)) < 1e-3 * high);
  }
  const most = png(files(await saved(page, '#save-maps', { 'maps-size': '8', normals: 'normal-opengl' })), 'albedo');
  assert.equal(most.width, 1536);
  assert.ok(meanDifference(png(own, 'albedo'), most, 8) < 10);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('a large picture has maps of at most 8192 pixels', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, '#size=1536&cs=90');
  await page.waitForFunction(() => document.querySelector('#canvas').width === 1536);
  await dialog(page);
  assert.deepEqual(await page.$$eval('#maps-size option', (options) => options.map(({ value }) => value)), ['1', '2', '4']);
  assert.deepEqual(await page.$$eval('[id^=save-png-]', (keys) => keys.map(({ id }) => id)), ['save-png-2', 'save-png-3', 'save-png-4']);
  assert.deepEqual(problems, []);
  await close();
});

test('the picture is saved at one to eight times its side, and shows the same', async () => {
  const { page, problems, external, close } = await opened(site);
  await digest(page);
  const plain = await saved(page, '#save-png');
  assert.equal(plain.name, 'bubblestone-ring-1-192.png');
  const small = PNG.sync.read(Buffer.from(plain.bytes));
  assert.deepEqual([small.width, small.height], [192, 192]);
  for (const scale of [2, 3, 4, 8]) {
    const { name, bytes } = await saved(page, `#save-png-${scale}`);
    assert.equal(name, `bubblestone-ring-1-${192 * scale}.png`);
    const large = PNG.sync.read(Buffer.from(bytes));
    assert.deepEqual([large.width, large.height], [192 * scale, 192 * scale]);
    // The mean of the large picture's pixels over a pixel is close to that pixel.
    const off = meanDifference(small, large, scale);
    assert.ok(off < 20, `the picture at ${scale} times its side is ${off} off`);
  }
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('Stop stops maps of many pixels in the midst of them', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, '#size=512');
  await digest(page);
  await dialog(page);
  await choose(page, { 'maps-size': '8' });
  await click(page, '#save-maps');
  await page.waitForFunction(() => document.querySelector('.message progress')?.value > 0.2);
  await page.$eval('#stop-files', (stop) => stop.click());
  await message(page, 'status', /was stopped/);
  assert.equal(await page.evaluate(() => window.saved), undefined);
  const { bytes } = await saved(page, '#save-maps', { 'maps-size': '1' });
  assert.equal(PNG.sync.read(Buffer.from(unzipSync(bytes)['albedo.png'])).width, 512);
  assert.deepEqual(problems, []);
  await close();
});
