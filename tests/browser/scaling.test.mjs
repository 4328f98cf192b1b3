// The picture's side, changed with all lengths or alone.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, click, digest, get, link, messages, reloading, set } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A finished page with all controls open. */
async function opened(fragment) {
  const found = await site.newPage(fragment, { still: true });
  await digest(found.page);
  await all(found.page);
  await found.page.$eval('[data-key=size]', (control) => (control.closest('details').open = true));
  return found;
}

/** Values by their keys. */
const values = async (page, ...keys) => Promise.all(keys.map((key) => get(page, key)));

const stones = (page) => page.evaluate(() => window.bubblestone.status().stones);

/** Moves the side's slider to a position; `kind` is 'input' while it moves and 'change' at its end. */
const slide = (page, place, kind) =>
  page.$eval(
    '[data-key=size] [type=range]',
    (slider, to, name) => {
      slider.value = String(to);
      slider.dispatchEvent(new Event(name, { bubbles: true }));
    },
    place,
    kind,
  );

test('the same design comes with more pixels, in one step, and the first link on the way back', sameEverywhere, async () => {
  for (const fragment of ['seed=3', 'kind=ellipse&ca=1.35&cs=30&dir=constant&vs=0.35&hs=20&af=1', 'stone=skin&cs=31.7']) {
    const { page, problems, close } = await opened(`#v=1&${fragment}`);
    const first = await link(page);
    const before = await values(page, 'cs', 'hs', 'af', 'sr', 'pn');
    const few = await stones(page);
    await set(page, 'size', '1024');
    await digest(page);
    const skin = fragment.includes('skin');
    const [cs, hs, af, ...others] = before;
    const doubled = [String(2 * cs), skin ? hs : String(2 * hs), skin ? af : String(2 * af), ...others];
    assert.deepEqual(await values(page, 'cs', 'hs', 'af', 'sr', 'pn'), doubled);
    const many = await stones(page);
    assert.ok(Math.abs(many / few - 1) < 0.05, `${few} stones, then ${many}`);
    const second = await link(page);
    await click(page, '#undo');
    assert.equal(await link(page), first);
    await click(page, '#redo');
    assert.equal(await link(page), second);
    await set(page, 'size', '512');
    assert.equal(await link(page), first);
    assert.deepEqual(await messages(page), []);
    assert.deepEqual(problems, []);
    await close();
  }
});

test('every way of the control takes the lengths along, and rounds nothing on the way', sameEverywhere, async () => {
  const { page, problems, close } = await opened('#v=1&size=256&cs=17.3&hs=9.7&af=1.15');
  const first = await link(page);
  // By keyboard, there and back.
  await page.focus('[data-key=size] [type=range]');
  for (let k = 0; k < 5; k += 1) await page.keyboard.press('ArrowRight');
  assert.deepEqual(await values(page, 'size', 'cs'), ['576', '38.925']);
  for (let k = 0; k < 5; k += 1) await page.keyboard.press('ArrowLeft');
  assert.equal(await link(page), first);
  // A slider's move is one step of the history.
  const undo = () => page.$eval('#undo', (button) => button.click());
  await set(page, 'seed', '9');
  const seeded = await link(page);
  for (const place of [100, 350, 420, 30, 333]) await slide(page, place, 'input');
  await slide(page, 333, 'change');
  const [side, cs] = await values(page, 'size', 'cs');
  assert.ok(Math.abs(Number(cs) - (17.3 * Number(side)) / 256) < 1e-3, `${cs} at ${side}`);
  assert.notEqual(side, '256');
  await undo();
  assert.equal(await link(page), seeded);
  // A value that was changed in between is scaled from what it is now. The reset works as well.
  await set(page, 'size', '512');
  await set(page, 'cs', '40');
  await set(page, 'size', '256');
  assert.deepEqual(await values(page, 'cs', 'hs', 'af'), ['20', '9.7', '1.15']);
  await page.$eval('[data-key=size] .reset', (button) => button.click());
  assert.deepEqual(await values(page, 'size', 'cs', 'hs'), ['512', '40', '19.4']);
  assert.deepEqual(problems, []);
  await close();
});

test('what meets a limit is told, and is as it was on the way back', sameEverywhere, async () => {
  const { page, problems, close } = await opened('#v=1&size=256&cs=16&hs=100');
  const first = await link(page);
  await set(page, 'size', '512');
  assert.deepEqual(await values(page, 'cs', 'hs'), ['32', '128']);
  assert.match((await messages(page)).join(), /Height/);
  assert.doesNotMatch((await messages(page)).join(), /Cell size/);
  await set(page, 'size', '256');
  assert.equal(await link(page), first);
  assert.deepEqual(await messages(page), []);
  // The side is clamped, too, and the lengths follow its real value.
  await set(page, 'size', '100');
  assert.deepEqual(await values(page, 'size', 'cs', 'hs'), ['128', '8', '50']);
  assert.match((await messages(page)).join(), /Picture side/);
  assert.equal((await messages(page)).length, 1);
  assert.deepEqual(problems, []);
  await close();
});

test('without it the side is the side alone, and the choice is kept', sameEverywhere, async () => {
  const { page, problems, close } = await opened('#v=1&size=192&cs=16');
  await page.focus('#scale-all');
  assert.match(await page.$eval('#hint', (hint) => hint.textContent), /same design/);
  await page.keyboard.press(' ');
  await set(page, 'size', '256');
  assert.deepEqual(await values(page, 'size', 'cs'), ['256', '16']);
  await reloading(page, () => page.reload({ waitUntil: 'load' }));
  await digest(page);
  await page.waitForSelector('#scale-all');
  assert.equal(await page.$eval('#scale-all', (check) => check.checked), false);
  // A click on the words works as well.
  await page.$eval('[data-key=size] .option label span', (words) => words.click());
  await set(page, 'size', '512');
  assert.deepEqual(await values(page, 'size', 'cs'), ['512', '32']);
  assert.deepEqual(problems, []);
  await close();
});
