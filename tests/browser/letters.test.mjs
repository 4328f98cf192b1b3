import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { digest, frames, get, link, messages, phone, rings, SQUARE, tool } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => void (site = await open()));
after(() => site?.close());

/** Opens the dialog for letters. @param {import('./harness.mjs').PageOptions} [options] @param {string} [fragment] */
async function dialog(options, fragment = SQUARE) {
  const opened = await site.newPage(fragment, options);
  await digest(opened.page);
  await tool(opened.page, 'text', options?.viewport?.hasTouch);
  await opened.page.waitForSelector('#letters');
  return opened;
}

/** Replaces the whole text in one step. @param {import('puppeteer-core').Page} page @param {string} text */
function write(page, text) {
  return page.$eval(
    '#letters',
    (box, written) => {
      /** @type {HTMLTextAreaElement} */ (box).value = written;
      box.dispatchEvent(new Event('input', { bubbles: true }));
    },
    text,
  );
}

/**
 * Waits until the text beside the picture, or in another place, has these words. @param {import('puppeteer-core').Page}
 * page @param {RegExp} words @param {string} [place]
 */
function said(page, words, place = '.letters-side') {
  return page.waitForFunction((selector, source) => new RegExp(source).test(document.querySelector(selector)?.textContent ?? ''), {}, place, words.source);
}

/** Waits until the dialog shows the letters in finished stones. @param {import('puppeteer-core').Page} page */
function inStones(page) {
  return page.waitForSelector('#text-dialog[data-stage=done] canvas:not([hidden])');
}

test('the picture and the fields stand side by side, though this is the first tool', async () => {
  const { page, close } = await dialog();
  // The styles of all outline dialogs come with those of this one.
  await page.waitForFunction(() => [...document.styleSheets].some(({ href }) => /\/editor-[^/]*\.css$/.test(href ?? '')));
  const [picture, drawn, side, face] = await page.evaluate(() =>
    ['#text-dialog figure', '#text-dialog svg', '.letters-side', '#face'].map((name) => document.querySelector(name).getBoundingClientRect().toJSON()),
  );
  assert.ok(Math.abs(drawn.height - picture.height) < 1, JSON.stringify([picture, drawn]));
  assert.ok(picture.width > 300 && Math.abs(picture.width - picture.height) < 1 && side.left >= picture.right, JSON.stringify([picture, side]));
  assert.ok(face.width > 90, JSON.stringify(face));
  await close();
});

test('letters become the outline with cells of their strokes, in one step', async () => {
  const { page, problems, close } = await dialog();
  await inStones(page);
  await page.select('#face', 'sans');
  await page.keyboard.type('O8');
  await page.keyboard.down('Control');
  await page.keyboard.press('Enter');
  await page.keyboard.up('Control');
  await page.waitForSelector('.handle');
  await frames(page, 3);
  assert.equal(await page.$('dialog[open]'), null, 'the key is not taken for a press of the tool, which has the focus again');
  const found = await rings(page);
  assert.equal(found.length, 5, 'two outer rings and three holes');
  assert.ok(found.flat().length <= 300);
  const all = found.flat();
  assert.ok(Math.min(...all.flat()) > 0.03 && Math.max(...all.flat()) < 0.97, 'with a margin');
  assert.ok((await link(page)).length < 2000, String((await link(page)).length));
  assert.notEqual(await get(page, 'cs'), '16', 'cells of another size');
  assert.deepEqual(await messages(page), []);
  await page.click('#undo');
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'square');
  assert.deepEqual([await get(page, 'cs'), await get(page, 'size')], ['16', '192'], 'one step');
  assert.deepEqual(problems, []);
  await close();
});

test('the size of cells is that of so many across a stroke, or stays', sameEverywhere, async () => {
  const { page, problems, close } = await dialog();
  await said(page, /3\.[3-7] across/);
  await page.focus('#letters-across');
  await page.keyboard.press('Home');
  await said(page, /: 1(\.\d)? across/);
  await page.click('#letters-follow');
  await said(page, /cells of 16 px/);
  assert.equal(await page.$eval('#letters-across', (slider) => /** @type {HTMLInputElement} */ (slider).disabled), true);
  await page.select('#letters-side', '1024');
  await page.click('#take-letters');
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'polygon');
  assert.deepEqual([await get(page, 'cs'), await get(page, 'size')], ['16', '1024']);
  assert.deepEqual(problems, []);
  await close();
});

test('what is wrong, or more than allowed, is said in the dialog', sameEverywhere, async () => {
  const { page, problems, close } = await dialog({ viewport: phone });
  const usable = () => page.$eval('#take-letters', (button) => !(/** @type {HTMLButtonElement} */ (button).disabled));
  await write(page, '');
  await said(page, /Type letters/);
  assert.equal(await usable(), false);
  await write(page, '\u200b\u200b');
  await said(page, /Nothing of this text/);
  assert.equal(await usable(), false);
  await write(page, 'on '.repeat(50).trim());
  await said(page, /of 149, the first 120 are taken/);
  await said(page, /\d points/);
  assert.equal(await usable(), true);
  const { bottom, height } = await page.$eval('#text-dialog', (box) => ({ bottom: box.getBoundingClientRect().bottom, height: innerHeight }));
  assert.ok(bottom <= height, 'on the screen');
  await page.tap('#leave-letters');
  assert.deepEqual([await get(page, 'outline'), await messages(page)], ['square', []]);
  assert.deepEqual(problems, []);
  await close();
});

test('lines break where Japanese and English let them', sameEverywhere, async () => {
  const { page, problems, close } = await dialog();
  // The lines that the worker's canvas painted.
  const linesOf = async (/** @type {string} */ text) => {
    await page.evaluate(() => {
      if (window.asked) return;
      const post = Worker.prototype.postMessage;
      Worker.prototype.postMessage = function (order) {
        window.asked = order;
        this.addEventListener('message', ({ data }) => (window.lines = data.lines), { once: true });
        post.call(this, order);
      };
    });
    await page.evaluate(() => void (window.lines = undefined));
    await write(page, text);
    await page.waitForFunction(() => window.lines);
    return page.evaluate(() => window.lines);
  };
  assert.deepEqual(await linesOf('stone stone\nof'), ['stone', 'stone', 'of'], 'at a space, as that makes them larger, and where it was asked for');
  const lines = await linesOf('石畳の上を歩くと、泡が押し合い、やがて落ち着いて石になる。');
  assert.ok(lines.length > 3 && lines.length < 8, lines.join('|'));
  assert.ok(lines.every((line) => !/^[、。っゃゅょー）」]/.test(line)), lines.join('|'));
  assert.equal(lines.join(''), '石畳の上を歩くと、泡が押し合い、やがて落ち着いて石になる。', 'nothing is lost');
  const brackets = await linesOf('（泡）'.repeat(9));
  assert.ok(brackets.length > 3 && brackets.every((line) => /^（.*）$/.test(line)), brackets.join('|'));
  assert.deepEqual(problems, []);
  await close();
});
