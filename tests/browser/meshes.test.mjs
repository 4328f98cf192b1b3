// Meshes that the page saves, read by other programs.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import validator from 'gltf-validator';
import { PNG } from 'pngjs';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, SMALL } from './page.mjs';
import { dialog, files, opened, saved } from './saved.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** @param {ArrayLike<number>} list */
const threes = (list) => Array.from({ length: list.length / 3 }, (_, k) => [list[3 * k], list[3 * k + 1], list[3 * k + 2]]);

test('the mesh is a valid GLB file and an OBJ file of as many triangles', sameEverywhere, async () => {
  const { page, problems, external, close } = await opened(site, `${SMALL}&seed=7&outline=star&stone=skin&sc=0.5`);
  await digest(page);
  const glb = await saved(page, '#save-glb');
  assert.equal(glb.name, 'bubblestone-star-7-middle.glb');
  const { issues, info } = await validator.validateBytes(glb.bytes);
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
  assert.ok(info.totalTriangleCount > 5_000);
  const obj = await saved(page, '#save-obj');
  assert.equal(obj.name, 'bubblestone-star-7-middle.obj');
  const lines = Buffer.from(obj.bytes).toString().split('\n');
  assert.equal(lines.filter((line) => line.startsWith('f ')).length, info.totalTriangleCount);
  assert.equal(lines.filter((line) => line.startsWith('v ')).length, info.totalVertexCount);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

/**
 * The number of triangle sides that are open or have the wrong orientation: 0 for a closed surface.
 * @param {number[][]} corners x, y, z of three corners after each other
 */
function openSides(corners) {
  const sides = new Map();
  for (let k = 0; k < corners.length; k += 3) {
    for (let by = 0; by < 3; by += 1) {
      const [a, b] = [corners[k + by], corners[k + (by + 1) % 3]].map(String);
      const [side, turn] = a < b ? [`${a} ${b}`, 1] : [`${b} ${a}`, -1];
      sides.set(side, (sides.get(side) ?? 0) + turn);
    }
  }
  return [...sides.values()].filter((sum) => sum !== 0).length;
}

/**
 * @param {number[][]} corners x, y, z of three corners after each other; the volume is above 0 if they go
 * counter-clockwise seen from outside
 */
function volume(corners) {
  let six = 0;
  for (let k = 0; k < corners.length; k += 3) {
    const [[a, b, c], [d, e, f], [g, h, i]] = corners.slice(k, k + 3);
    six += a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g);
  }
  return six / 6;
}

test('the dialog tells how large meshes are, and their files are so, in every reader', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&stone=flag&cs=24`);
  await digest(page);
  await dialog(page);
  const told = {};
  for (const detail of ['low', 'middle', 'high']) {
    await page.select('#detail', detail);
    told[detail] = await page.$eval('#mesh-size', (size) => size.value);
  }
  assert.match(told.low, /^About [\d,]+ triangles\. About [\d.]+ MB as GLB, [\d.]+ MB with images, [\d.]+ MB as OBJ\.$/);
  await click(page, '#save-dialog [data-close]');
  const cells = await page.$eval('#count-cells', (count) => Number(count.textContent));
  const reader = new NodeIO();
  for (const [detail, triangles] of [['low', 100], ['middle', 400]]) {
    const { bytes } = await saved(page, '#save-glb', { detail });
    const root = (await reader.readBinary(bytes)).getRoot();
    const [whole] = root.listScenes()[0].listChildren();
    const nodes = whole.listChildren();
    assert.equal(nodes.length, cells + 1);
    assert.deepEqual([nodes[0].getName(), nodes.at(-1).getName()], ['stone_1', 'ground']);
    const maps = files(await saved(page, '#save-maps'));
    const ids = PNG.sync.read(Buffer.from(maps['id.png']));
    let sum = 0;
    for (const node of nodes) {
      const [primitive] = node.getMesh().listPrimitives();
      const places = threes(primitive.getAttribute('POSITION').getArray());
      const indices = primitive.getIndices().getArray();
      sum += indices.length / 3;
      if (node.getName() === 'ground') continue;
      const corners = [...indices].map((k) => places[k]);
      assert.equal(openSides(corners), 0, node.getName());
      assert.ok(volume(corners) > 0, node.getName());
      assert.ok(Math.abs(indices.length / 3 - triangles) < 0.3 * triangles);
      // The colour of its top is in the map of ids.
      const uv = primitive.getAttribute('TEXCOORD_0').getArray();
      const top = places.reduce((best, [, y], k) => (y > places[best][1] ? k : best), 0);
      const [x, y] = [uv[2 * top], uv[2 * top + 1]].map((v) => Math.floor(v * 192));
      const seen = [0, 1, 2].map((k) => ids.data[4 * (192 * y + x) + k]);
      assert.deepEqual(node.getExtras().id_map, seen, node.getName());
    }
    const said = Number(/About ([\d,]+)/.exec(told[detail])[1].replaceAll(',', ''));
    assert.ok(Math.abs(sum / said - 1) < 0.05, `${sum} triangles, ${told[detail]}`);
    const megabytes = Number(/About ([\d.]+) MB/.exec(told[detail])[1]);
    assert.ok(Math.abs(bytes.length / 1e6 / megabytes - 1) < 0.15, `${bytes.length} bytes, ${told[detail]}`);
  }
  const obj = await saved(page, '#save-obj', { detail: 'low' });
  const objects = new OBJLoader().parse(Buffer.from(obj.bytes).toString()).children;
  assert.deepEqual([objects.length, objects[0].name, objects.at(-1).name], [cells + 1, 'cell_0', 'ground']);
  const { position, uv } = objects[0].geometry.attributes;
  for (let k = 0; k < position.count; k += 1) {
    assert.ok(Math.abs(position.getX(k) + 0.5 - uv.getX(k)) < 1e-5 && Math.abs(0.5 - position.getZ(k) - uv.getY(k)) < 1e-5);
  }
  assert.equal(openSides(threes(position.array)), 0);
  assert.deepEqual(problems, []);
  await close();
});

test('bodies are joined to one mesh of one material, in files as large as told', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&stone=flag&cs=24`);
  await digest(page);
  const reader = new NodeIO();
  const counted = async (/** @type {string} */ button, /** @type {string} */ bodies) => {
    const { name, bytes } = await saved(page, button, { detail: 'low', bodies });
    const { issues, info } = await validator.validateBytes(bytes);
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
    const root = (await reader.readBinary(bytes)).getRoot();
    const parts = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
    return { name, bytes: bytes.length, triangles: info.totalTriangleCount, parts, nodes: root.listNodes().map((node) => node.getName()) };
  };
  for (const button of ['#save-glb', '#save-glb-images']) {
    const each = await counted(button, 'each');
    const one = await counted(button, 'one');
    await dialog(page);
    const told = await page.$eval('#mesh-size', (size) => size.value);
    await click(page, '#save-dialog [data-close]');
    assert.match(one.name, button === '#save-glb' ? /-low-one-mesh\.glb$/ : /-low-images-one-mesh\.glb$/);
    assert.deepEqual([one.parts.length, one.nodes, one.triangles], [1, ['Bubblestone', 'all'], each.triangles]);
    const list = (/** @type {typeof each} */ file, /** @type {string} */ name) => file.parts.flatMap((part) => [...(part.getAttribute(name)?.getArray() ?? [])]);
    for (const name of ['POSITION', 'COLOR_0', 'TEXCOORD_0']) assert.deepEqual(list(one, name), list(each, name), name);
    const megabytes = Number((button === '#save-glb' ? /About ([\d.]+) MB as GLB/ : /([\d.]+) MB with images/).exec(told)?.[1]);
    assert.ok(Math.abs(one.bytes / 1e6 / megabytes - 1) < 0.15, `${one.bytes} bytes, ${told}`);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('a mesh with images has its maps inside, and upright normals', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&cs=24`);
  await digest(page);
  const { bytes } = await saved(page, '#save-glb-images', { detail: 'low' });
  const { issues } = await validator.validateBytes(bytes);
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
  const root = (await new NodeIO().readBinary(bytes)).getRoot();
  const [material] = root.listMaterials();
  const maps = files(await saved(page, '#save-maps', { normals: 'godot' }));
  for (const [texture, file] of [
    [material.getBaseColorTexture(), 'albedo'],
    [material.getNormalTexture(), 'normal'],
    [material.getOcclusionTexture(), 'orm'],
    [material.getMetallicRoughnessTexture(), 'orm'],
  ]) {
    const [inside, beside] = [texture.getImage(), maps[`bubblestone_${file}.png`]].map((png) => PNG.sync.read(Buffer.from(png)).data);
    assert.ok(inside.equals(beside), file);
  }
  for (const mesh of root.listMeshes()) {
    const [primitive] = mesh.listPrimitives();
    const all = (name) => new Set(primitive.getAttribute(name).getArray().join().match(/[^,]+,[^,]+,[^,]+(,1$)?/g));
    assert.deepEqual([...all('NORMAL')], ['0,1,0']);
    assert.equal(primitive.getAttribute('COLOR_0'), null);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('a slab to print is closed and as large as asked for', sameEverywhere, async () => {
  const { page, problems, close } = await opened(site, `${SMALL}&cs=24`);
  await digest(page);
  await dialog(page);
  const told = await page.$eval('#slab-size', (size) => size.value);
  assert.match(told, /^134,144 triangles, 6\.7 MB\.$/);
  await click(page, '#save-dialog [data-close]');
  const { name, bytes } = await saved(page, '#save-stl', { 'slab-side': '80', 'slab-base': '2', 'slab-relief': '5', 'slab-grid': '128' });
  assert.equal(name, 'bubblestone-ring-1.stl');
  const geometry = new STLLoader().parse(bytes.buffer);
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  assert.deepEqual([min.toArray(), [max.x, max.y]], [[0, 0, 0], [80, 80]]);
  assert.ok(max.z > 6 && max.z <= 7.0001, `${max.z} mm high`);
  const corners = threes(geometry.attributes.position.array);
  assert.equal(corners.length, 3 * (2 * 128 ** 2 + 12 * 128));
  assert.equal(openSides(corners), 0);
  assert.ok(volume(corners) > 80 * 80 * 2);
  const normals = threes(geometry.attributes.normal.array);
  assert.ok(normals.every(([x, y, z]) => Math.abs(Math.hypot(x, y, z) - 1) < 1e-3));
  assert.deepEqual(problems, []);
  await close();
});
