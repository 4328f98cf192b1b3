// Outlines with curves: the editor finds few handles. Finding them changes nothing, and moving one changes only its surroundings.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, digest, frames, get, link, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A ring with a width and a turn other than the defaults. */
const RING = `${SMALL}&ow=0.8&oa=30`;

/** The outer circle of the built-in ring, in sides. */
const RADIUS = 0.5 - 3 / 64;

/** Places of the handles, in sides of the picture. */
function handles(page) {
  return page.$$eval('button.handle', (all) => all.map(({ style }) => [parseFloat(style.left) / 100, parseFloat(style.top) / 100]));
}

async function look(page) {
  await page.keyboard.press('e');
  await page.waitForSelector('.handle');
  await frames(page, 2);
}

async function press(page, ...keys) {
  for (const key of keys.slice(0, -1)) await page.keyboard.down(key);
  await page.keyboard.press(keys.at(-1));
  for (const key of keys.slice(0, -1)) await page.keyboard.up(key);
  await frames(page, 3);
}

const closed = (page) => page.$eval('#editor', (layer) => layer.hidden);

/** The rings of the free outline in sides of the picture. The link has differences of numbers, five bits per letter. */
async function rings(page) {
  const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
  const last = [0, 0];
  return (await get(page, 'poly')).split('.').map((row) => {
    const ring = [];
    let [value, shift, axis] = [0, 0, 0];
    for (const letter of row) {
      const code = letters.indexOf(letter);
      value += (code % 32) * 2 ** shift;
      shift += 5;
      if (code >= 32) continue;
      last[axis] += value % 2 ? -(value + 1) / 2 : value / 2;
      if (axis) ring.push(last.map((step) => step / 32768));
      [value, shift, axis] = [0, 0, 1 - axis];
    }
    return ring;
  });
}

/** The angles by which a ring turns at its points, in radians. */
function turns(ring) {
  return ring.map(([x, y], k) => {
    const [a, b] = ring.at(k - 1);
    const [c, d] = ring[(k + 1) % ring.length];
    return Math.abs(Math.atan2((x - a) * (d - y) - (y - b) * (c - x), (x - a) * (c - x) + (y - b) * (d - y)));
  });
}

test('to look is not to edit', async () => {
  const { page, problems, close } = await site.newPage(RING);
  const made = await digest(page);
  await all(page);
  const was = await link(page);
  const untouched = async (what) => {
    assert.equal(await link(page), was, what);
    assert.equal(await page.$eval('#undo', (button) => button.disabled), true, what);
    for (const key of ['ow', 'oa']) assert.equal(await page.$eval(`[data-key=${key}]`, (control) => control.hidden), false, what);
  };
  await look(page);
  assert.equal((await handles(page)).length, 16);
  await untouched('handles are shown');
  await press(page, 'Tab');
  const box = await page.$eval('button.handle:last-child', (handle) => handle.getBoundingClientRect().toJSON());
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await frames(page, 3);
  await untouched('a handle is marked');
  await press(page, 'e');
  assert.equal(await closed(page), true);
  await untouched('E again');
  await look(page);
  await press(page, 'Escape');
  assert.equal(await closed(page), true);
  await untouched('Escape');
  assert.equal(await digest(page), made);
  assert.deepEqual(problems, []);
  await close();
});

test('on a tile without lines, E shows what could be drawn and draws nothing', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&tile=1`);
  await digest(page);
  const was = await link(page);
  await press(page, 'e');
  await page.waitForSelector('#editor:not([hidden])');
  await frames(page, 2);
  assert.equal((await handles(page)).length, 0);
  assert.equal(await link(page), was);
  await close();
});

test('handles go with the shape while it is only looked at, and are few', sameEverywhere, async () => {
  const { page, close } = await site.newPage(RING);
  await digest(page);
  await look(page);
  const right = (await handles(page))[1];
  await set(page, 'oa', '52');
  await frames(page, 2);
  assert.notDeepEqual((await handles(page))[1], right);
  for (const [shape, corners, most] of [['square', 4, 4], ['star', 10, 10], ['l_shape', 6, 6], ['road_notch', 8, 8], ['road_s', 8, 20], ['crossing', 16, 24], ['plaza', 16, 26], ['road_spiral', 20, 36]]) {
    await set(page, 'outline', shape);
    await frames(page, 2);
    const { length } = await handles(page);
    assert.ok(length >= corners && length <= most, `${shape}: ${length} handles`);
    assert.equal(await get(page, 'outline'), shape);
  }
  await close();
});

test('a circle that is moved at one point stays smooth there and a circle elsewhere', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(RING);
  const made = await digest(page);
  const was = await link(page);
  await look(page);
  const before = await handles(page);
  for (let k = 0; k < 2; k += 1) await press(page, 'Shift', 'ArrowLeft');
  const after = await handles(page);
  assert.ok(after[0][0] < before[0][0] - 0.1);
  assert.deepEqual(after.slice(1), before.slice(1));
  const [outer, inner] = await rings(page);
  assert.ok(outer.length + inner.length < 320, `${outer.length} and ${inner.length} points`);
  const near = ([x, y]) => Math.hypot(x - before[0][0], y - before[0][1]) < 2 * RADIUS * Math.sin(Math.PI / 8) + 0.03;
  for (const [k, turn] of turns(outer).entries()) {
    const far = Math.abs(Math.hypot(outer[k][0] - 0.5, outer[k][1] - 0.5) - RADIUS);
    assert.ok(near(outer[k]) ? turn < 0.25 : turn < 0.06 && far < 1e-4, `${outer[k]} turns by ${turn}, ${far} off the circle`);
  }
  assert.ok(outer.filter((point) => !near(point)).length > 60);
  const [smallest, largest] = [Math.min, Math.max].map((end) => end(...inner.map(([x, y]) => Math.hypot(x - 0.5, y - 0.5))));
  assert.ok(largest - smallest < 1e-4, 'the other circle stays one');
  // Another visitor gets few handles again, and the outline does not change.
  const now = await link(page);
  const other = await site.newPage(`#${now}`);
  const moved = await digest(other.page);
  assert.notEqual(moved, made);
  await look(other.page);
  const { length } = await handles(other.page);
  assert.ok(length >= 14 && length <= 24, `${length} handles`);
  assert.equal(await link(other.page), now);
  await other.close();
  for (let k = 0; k < 2; k += 1) await press(page, 'Control', 'z');
  assert.equal(await link(page), was, 'undo brings back the ring with its width and its turn');
  assert.deepEqual(await handles(page), before);
  await press(page, 'Control', 'y');
  await press(page, 'Control', 'y');
  assert.equal(await link(page), now);
  assert.deepEqual((await handles(page)).map((at) => at.map((part) => part.toFixed(5))), after.map((at) => at.map((part) => part.toFixed(5))), 'the same handles as before');
  assert.deepEqual(problems, []);
  await close();
});

test('a point of a curve comes and goes without a corner', sameEverywhere, async () => {
  const { page, close } = await site.newPage(RING);
  await digest(page);
  await look(page);
  await press(page, 'Insert');
  assert.equal((await handles(page)).length, 17);
  assert.equal(await get(page, 'outline'), 'polygon');
  const round = async (slack) => {
    const [outer] = await rings(page);
    for (const [x, y] of outer) assert.ok(Math.abs(Math.hypot(x - 0.5, y - 0.5) - RADIUS) < slack);
    assert.ok(Math.max(...turns(outer)) < 0.08);
  };
  await round(3e-4);
  for (let left = 16; left > 12; left -= 1) {
    await press(page, 'Delete');
    assert.equal((await handles(page)).length, left);
  }
  await round(0.01);
  await close();
});

test('corners stay corners: straight sides beside a corner stay straight, a polygon keeps its points', sameEverywhere, async () => {
  const star = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map((k) => [0, 1].map((axis) => (0.5 + (k % 2 ? 0.2 : 0.45) * [Math.cos, Math.sin][axis](k * Math.PI / 5)).toFixed(4))).flat().join();
  const twelve = Array.from({ length: 12 }, (_, k) => [0.5 + 0.15 * Math.cos(k * Math.PI / 6), 0.5 - 0.15 * Math.sin(k * Math.PI / 6)].map((part) => part.toFixed(4))).flat().join();
  const { page, close } = await site.newPage(`${SMALL}&outline=polygon&poly=${star};${twelve}`);
  await digest(page);
  await look(page);
  assert.equal((await handles(page)).length, 22);
  const before = await rings(page);
  await press(page, 'Shift', 'ArrowLeft');
  const now = await rings(page);
  assert.deepEqual(now.map(({ length }) => length), [10, 12]);
  const same = now.flat().filter(([x, y]) => before.flat().some(([a, b]) => a === x && b === y));
  assert.equal(same.length, 21);
  await close();
});

test('a corner is made round and a corner again, by the keyboard and by its button', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&outline=square`);
  await digest(page);
  await look(page);
  const square = async () => {
    const [ring] = await rings(page);
    assert.equal(ring.length, 4);
  };
  await press(page, 'Enter');
  const [round] = await rings(page);
  assert.ok(round.length > 12);
  assert.equal(turns(round).filter((turn) => turn > 0.6).length, 3, 'three corners are left');
  assert.equal((await handles(page)).length, 4);
  await page.click('#turn-point');
  await frames(page, 3);
  await square();
  // With all four corners smooth, the square is a disc.
  for (let k = 0; k < 4; k += 1) {
    await page.$$eval('button.handle', (all, at) => all[at].focus(), k);
    await press(page, 'Enter');
  }
  const [disc] = await rings(page);
  const corner = (0.5 - 3 / 64) * Math.SQRT2;
  assert.ok(Math.max(...turns(disc)) < 0.12);
  for (const [x, y] of disc) assert.ok(Math.abs(Math.hypot(x - 0.5, y - 0.5) - corner) < 0.001);
  await close();
});
