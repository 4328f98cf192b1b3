// The finished picture and drawings in the screen's own pixels, over the canvas.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, frames, reloading, set } from './page.mjs';
import { handed, keeping } from './saved.mjs';
import { longestTask, skip } from './tasks.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** On a screen of double density, the sheet needs three times the picture's pixels; zoomed by one press, five times. */
const LINK = '#size=384&cs=32&outline=square';
const THREE = '1152';
const CLOSER = '1920';

const retina = { width: 1280, height: 872, deviceScaleFactor: 2 };

/**
 * A page with fine pictures, which counts its workers.
 * @param {string} [fragment]
 * @param {import('./harness.mjs').PageOptions} [options]
 */
async function opened(fragment = LINK, options = {}) {
  const counting = (/** @type {import('puppeteer-core').Page} */ fresh) => fresh.evaluateOnNewDocument(count);
  return site.newPage(fragment, { fine: true, still: true, viewport: retina, before: counting, ...options });
}

function count() {
  const { Worker } = window;
  window.begun = window.ended = 0;
  window.Worker = class extends Worker {
    constructor(...given) {
      super(...given);
      window.begun += 1;
    }
    terminate() {
      window.ended += 1;
      super.terminate();
    }
  };
}

/** Waits for the fine picture with this many pixels along a side. */
const fine = (page, side = THREE) => page.waitForSelector(`#sheet[data-fine="${side}"]`);

/** The number of fine pictures right after a key is pressed. */
const leftAfter = (page, key) =>
  page.evaluate((pressed) => {
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key: pressed, bubbles: true }));
    return document.querySelectorAll('.fine, [data-fine]').length;
  }, key);

/** The number and the size of fine pictures. */
const there = (page) => page.evaluate(() => [document.querySelectorAll('.fine').length, document.querySelector('#sheet').dataset.fine ?? null]);

test('the finished picture gets the pixels of the screen: those of its file, and where the canvas has them', async () => {
  const { page, problems, external, close } = await opened(LINK, {
    before: (fresh) => fresh.evaluateOnNewDocument(keeping),
  });
  await digest(page);
  const plain = await canvas(page);
  await fine(page);
  assert.deepEqual(await canvas(page), plain, 'the canvas is another one');
  await click(page, '#save');
  await handed(page, () => click(page, '#save-png-3'));
  const { box, below, apart, other } = await page.evaluate(async () => {
    const [canvas, over] = ['#canvas', '.fine'].map((name) => document.querySelector(name));
    const pixels = (source, side) => {
      const copy = new OffscreenCanvas(side, side).getContext('2d');
      copy.drawImage(source, 0, 0);
      return copy.getImageData(0, 0, side, side).data;
    };
    const { width: side } = canvas;
    const scale = over.width / side;
    const [coarse, finer, file] = [pixels(canvas, side), pixels(over, over.width), pixels(await createImageBitmap(window.saved.blob), over.width)];
    // The difference between the pixels and the means of the fine pixels in them, with the fine picture shifted by
    // some of its own.
    const apart = (dx, dy) => {
      let [sum, all] = [0, 0];
      for (let y = 4; y < side - 4; y += 1) {
        for (let x = 4; x < side - 4; x += 1) {
          let mean = 0;
          for (let v = 0; v < scale; v += 1) for (let u = 0; u < scale; u += 1) mean += finer[4 * ((y * scale + v + dy) * over.width + x * scale + u + dx)];
          sum += Math.abs(mean / scale ** 2 - coarse[4 * (y * side + x)]);
          all += 1;
        }
      }
      return sum / all;
    };
    const places = [-scale, -1, 0, 1, scale];
    return {
      box: JSON.stringify(over.getBoundingClientRect()),
      below: JSON.stringify(canvas.getBoundingClientRect()),
      apart: places.flatMap((dy) => places.map((dx) => ({ dx, dy, off: apart(dx, dy) }))).sort((a, b) => a.off - b.off),
      other: finer.filter((value, k) => value !== file[k]).length,
    };
  });
  assert.equal(box, below);
  assert.equal(other, 0, 'values that are not those of the file');
  assert.deepEqual([apart[0].dx, apart[0].dy], [0, 0], JSON.stringify(apart.slice(0, 3)));
  assert.ok(apart[0].off < 12, `${apart[0].off} off`);
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('it goes with the first change, and comes back once the picture stands still', sameEverywhere, async () => {
  const { page, problems, close } = await opened();
  await fine(page);
  // A slider while it moves, and when it is released.
  for (const kind of ['input', 'change']) {
    const left = await page.$eval(
      '[data-key=az] [type=range]',
      (slider, name) => {
        slider.value = name === 'input' ? '300' : '400';
        slider.dispatchEvent(new Event(name, { bubbles: true }));
        return document.querySelectorAll('.fine, [data-fine]').length;
      },
      kind,
    );
    assert.equal(left, 0, 'it shows what was there before');
  }
  await fine(page);
  assert.deepEqual(await page.evaluate(() => [window.begun, window.ended]), [2, 2]);
  // Views other than the picture, and overlays. A map has no finer pixels.
  assert.equal(await leftAfter(page, '6'), 0);
  await frames(page, 40);
  assert.deepEqual(await there(page), [0, null]);
  await page.keyboard.press('1');
  await fine(page);
  await click(page, '#compare-button');
  await page.waitForSelector('#divider');
  assert.deepEqual(await there(page), [0, null]);
  await click(page, '#compare-button');
  await fine(page);
  assert.deepEqual(await there(page), [1, THREE]);
  assert.deepEqual(problems, []);
  await close();
});

test('closer it is finer, and all of the picture keeps what there is', sameEverywhere, async () => {
  const { page, problems, close } = await opened();
  await fine(page);
  await click(page, '#zoom-in');
  await fine(page, CLOSER);
  await page.waitForFunction(() => document.querySelectorAll('.fine').length === 1);
  await click(page, '#zoom-fit');
  await frames(page, 2);
  assert.deepEqual(await there(page), [1, CLOSER]);
  assert.equal(await page.evaluate(() => window.begun), 2);
  // Zoomed so far that single fine pixels are visible, they are squares.
  const rendering = () => page.$eval('.fine', (canvas) => getComputedStyle(canvas).imageRendering);
  assert.equal(await rendering(), 'auto');
  for (let k = 0; k < 7; k += 1) await click(page, '#zoom-in');
  await page.waitForFunction(() => Number(document.querySelector('#sheet').style.getPropertyValue('--zoom')) > 12);
  assert.notEqual(await rendering(), 'auto');
  assert.deepEqual(problems, []);
  await close();
});

test('it comes in softly, but for those who ask for less motion', sameEverywhere, async () => {
  for (const still of [true, false]) {
    const { page, close } = await opened(LINK, { still });
    await fine(page);
    assert.equal(await page.$eval('.fine', (canvas) => getComputedStyle(canvas).animationName), still ? 'none' : 'fine');
    await close();
  }
});

test('it is left to the visitor, and off where data is to be spared', sameEverywhere, async () => {
  const asked = () => site.requests.some((path) => /\/fine[-.][^/]*\.js$/.test(path));
  site.requests.length = 0;
  const sparing = (/** @type {import('puppeteer-core').Page} */ fresh) =>
    fresh.evaluateOnNewDocument(() => Object.defineProperty(navigator, 'connection', { value: { saveData: true } }));
  const { page, problems, close } = await opened(LINK, { before: sparing });
  await digest(page);
  await page.keyboard.press('o');
  await page.waitForSelector('#fine');
  assert.equal(await page.$eval('#fine', (check) => check.checked), false);
  assert.equal(asked(), false, 'what makes it fine was loaded');
  await click(page, '#fine');
  await fine(page);
  assert.ok(asked());
  assert.match(await page.$eval('.layers-legend', (legend) => legend.textContent), /Fine picture/);
  await reloading(page, () => page.reload({ waitUntil: 'load' }));
  await fine(page);
  await page.keyboard.press('o');
  await click(page, '#fine');
  assert.deepEqual(await there(page), [0, null]);
  site.requests.length = 0;
  await reloading(page, () => page.reload({ waitUntil: 'load' }));
  await digest(page);
  await page.keyboard.press('o');
  await page.waitForSelector('#fine');
  assert.equal(await page.$eval('#fine', (check) => check.checked), false);
  assert.equal(asked(), false);
  assert.deepEqual(problems, []);
  await close();
});

test('a page that is not seen makes none', sameEverywhere, async () => {
  const { page, problems, close } = await opened('#cs=12');
  const hide = (hidden) =>
    page.evaluate((now) => {
      Object.defineProperty(document, 'hidden', { value: now, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      return [window.begun, window.ended];
    }, hidden);
  await page.waitForFunction(() => window.begun === 1);
  assert.deepEqual(await hide(true), [1, 0]);
  await page.waitForFunction(() => window.ended === 1);
  assert.deepEqual(await there(page), [0, null]);
  await hide(false);
  await fine(page, '1536');
  // The present fine picture stays.
  await hide(true);
  await hide(false);
  assert.deepEqual(await there(page), [1, '1536']);
  assert.equal(await page.evaluate(() => window.begun), 2);
  assert.deepEqual(problems, []);
  await close();
});

test('the page is not held while it comes', { skip }, async () => {
  const { page, close } = await opened('#cs=24&zoom=1.8,0.5,0.5', { still: false });
  await fine(page, '2048');
  const runs = [];
  // Now and then the browser itself blocks a page for long.
  while (runs.length < 3 && !(runs.at(-1) < 1)) {
    await set(page, 'seed', String(10 + runs.length));
    await digest(page);
    runs.push(
      await longestTask(page, async () => {
        await fine(page, '2048');
        await frames(page, 40);
      }),
    );
  }
  assert.ok(runs.at(-1) < 1, `the page was held for ${runs.join(', ')} of 50 ms`);
  await close();
});

test('the picture alone in another page is fine, too', sameEverywhere, async () => {
  const { page, problems, close } = await opened(`?embed${LINK}`, { viewport: { width: 500, height: 500, deviceScaleFactor: 2 } });
  await fine(page);
  await page.evaluate((fragment) => (location.hash = fragment), `${LINK}&az=40`);
  await page.waitForFunction(() => !document.querySelector('.fine'));
  await fine(page);
  assert.equal(await page.evaluate(() => window.begun), 2);
  await page.evaluate((fragment) => (location.hash = fragment), `${LINK}&view=height`);
  await page.waitForFunction(() => !document.querySelector('.fine'));
  await page.evaluate((fragment) => (location.hash = fragment), `${LINK}&view=cells`);
  await fine(page);
  assert.equal(await page.evaluate(() => window.begun), 2);
  assert.deepEqual(problems, []);
  await close();
});

/**
 * The canvas and the fine drawing over it: their sides, the mean difference of their values if the fine ones are averaged, and
 * the sum of the squared differences of neighbours along a row: it would be a third if the fine ones were enlarged.
 */
const drawings = (page) =>
  page.evaluate(() => {
    const [coarse, finer] = ['#canvas', '.fine'].map((name) => {
      const from = document.querySelector(name);
      const copy = new OffscreenCanvas(from.width, from.width).getContext('2d');
      copy.drawImage(from, 0, 0);
      return { side: from.width, data: copy.getImageData(0, 0, from.width, from.width).data };
    });
    const scale = finer.side / coarse.side;
    let apart = 0;
    for (let k = 0; k < coarse.data.length; k += 1) {
      const [x, y] = [Math.floor(k / 4) % coarse.side, Math.floor(k / 4 / coarse.side)];
      let sum = 0;
      for (let v = 0; v < scale; v += 1) for (let u = 0; u < scale; u += 1) sum += finer.data[4 * ((y * scale + v) * finer.side + x * scale + u) + (k % 4)];
      apart += Math.abs(sum / scale ** 2 - coarse.data[k]);
    }
    const edges = ({ side, data }) => data.reduce((sum, value, k) => (k % (4 * side) < 4 ? sum : sum + (value - data[k - 4]) ** 2), 0) / side;
    return { sides: [coarse.side, finer.side], apart: apart / coarse.data.length, sharp: edges(finer) / edges(coarse) };
  });

test('a drawing, and one over the picture, has the pixels of the screen and the same marks', sameEverywhere, async () => {
  for (const [view, side, most, least] of [['mesh', 1152, 2, 0.7], ['packed', 1152, 2, 0.7], ['potential', 768, 2, 0.7], ['auto+direction', 1152, 5, 0.6]]) {
    const { page, problems, close } = await opened(`${LINK}&view=${view}`);
    await digest(page);
    await fine(page, String(side));
    const { sides, apart, sharp } = await drawings(page);
    assert.deepEqual(sides, [384, side], view);
    assert.ok(apart < most, `${view}: ${apart} apart`);
    assert.ok(sharp > least, `${view}: ${sharp} of the edges`);
    assert.equal(await page.evaluate(() => window.begun), 0, 'a worker was begun for a drawing');
    assert.deepEqual(problems, []);
    await close();
  }
});

test('a drawing follows the screen up to three pixels for one', sameEverywhere, async () => {
  const { page, problems, close } = await opened('#size=192&cs=16&outline=square&view=cells', { viewport: { width: 420, height: 800, deviceScaleFactor: 1 } });
  await page.waitForSelector('.fine');
  const needed = await page.$eval('.fine', ({ clientWidth, width }) => [Math.min(3, Math.ceil(clientWidth / 192 / 1.04)), width / 192]);
  assert.equal(needed[1], needed[0]);
  await page.setViewport({ width: 420, height: 800, deviceScaleFactor: 3 });
  await fine(page, '576');
  assert.deepEqual(problems, []);
  await close();
});

test('a paused packing is fine, and each step brings the next drawing', sameEverywhere, async () => {
  const { page, problems, close } = await opened(`${LINK}&step=5`);
  await page.waitForFunction(() => window.bubblestone?.status().steps === 5);
  await fine(page);
  const before = await drawings(page);
  assert.ok(before.apart < 2, `${before.apart} apart`);
  const { hash } = await canvas(page);
  await page.keyboard.press('.');
  while ((await canvas(page)).hash === hash) await frames(page, 1);
  await fine(page);
  const { apart } = await drawings(page);
  assert.ok(apart < 2, `${apart} apart after a step`);
  assert.deepEqual(problems, []);
  await close();
});

test('the page is not held while a drawing comes', { skip }, async () => {
  const { page, close } = await opened('#size=512&cs=24&view=mesh+cells', { still: false });
  await fine(page, '1536');
  const runs = [];
  while (runs.length < 3 && !(runs.at(-1) < 1)) {
    await page.keyboard.press('6');
    await page.waitForSelector('#sheet:not([data-fine])');
    runs.push(
      await longestTask(page, async () => {
        await page.keyboard.press(runs.length % 2 ? '3' : '4');
        await fine(page, '1536');
        await frames(page, 40);
      }),
    );
  }
  assert.ok(runs.at(-1) < 1, `the page was held for ${runs.join(', ')} of 50 ms`);
  await close();
});
