// Phones and large letters: what is made for fingers and for the room of a narrow screen.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { desk, open } from './harness.mjs';
import { click, digest, done, drop, phone, PILE, SMALL, SQUARE, tool } from './page.mjs';
import { turned } from './turned.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A closed wedge. */
const WEDGE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';

/** Letters of twice the usual size. */
const large = (/** @type {import('puppeteer-core').Page} */ fresh) =>
  fresh.evaluateOnNewDocument(() => addEventListener('DOMContentLoaded', () => (document.documentElement.style.fontSize = '200%')));

test('the link to the keys is there where a keyboard is likely', async () => {
  for (const [viewport, isThere] of /** @type {const} */ ([[phone, false], [desk, true]])) {
    const { page, problems, close } = await site.newPage(SMALL, { viewport });
    await digest(page);
    assert.equal(await page.$eval('#keys-button', (button) => button.checkVisibility()), isThere);
    // The key itself always works.
    await page.keyboard.press('?');
    await page.waitForSelector('#keys[open]');
    assert.deepEqual(problems, []);
    await close();
  }
});

for (const [letters, before] of Object.entries({ usual: undefined, large })) {
  test(`the name of a model has the width of a phone, and never widens the page: ${letters} letters`, async () => {
    const { page, problems, close } = await site.newPage(PILE, { viewport: phone, before });
    await digest(page);
    const name = 'my_first_scanned_chestnut_again.obj';
    await drop(page, name, WEDGE, '');
    await page.waitForFunction((wanted) => document.querySelector('#model-name')?.textContent === wanted, {}, name);
    await done(page);
    const { cut, right } = await page.$eval('#model-name', (box) => ({ cut: box.scrollWidth > box.clientWidth, right: box.getBoundingClientRect().right }));
    assert.equal(cut, letters === 'large');
    assert.ok(right <= phone.width, `the name ends at ${right}`);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= phone.width);
    // A short name leaves room beside it. The buttons have a row of their own all the same, with room for a finger.
    await drop(page, 'wedge.obj', WEDGE, '');
    await page.waitForFunction(() => document.querySelector('#model-name')?.textContent === 'wedge.obj' && document.querySelector('#model-move:not([hidden])'));
    const buttons = await page.$$eval('#model > :is(button, .segments)', (all) => all.filter((one) => one.checkVisibility()).map((one) => one.getBoundingClientRect().toJSON()));
    assert.ok(buttons.length > 2 && buttons.every(({ height }) => height >= 44), JSON.stringify(buttons));
    if (letters === 'usual') assert.ok(Math.max(...buttons.map(({ top }) => top)) < Math.min(...buttons.map(({ bottom }) => bottom)), 'more than one row');
    assert.deepEqual(problems, []);
    await close();
  });

  test(`the steps in which a stone is made leave it in sight: ${letters} letters`, async () => {
    const { page, problems, close } = await site.newPage(`${SQUARE}&camera=330,60`, { viewport: phone, before });
    await digest(page);
    await turned(page);
    await page.focus('#turn');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#turn-how');
    await page.keyboard.press('Enter');
    await page.waitForSelector('.turn-making', { visible: true });
    // Surfaces have twelve steps.
    const found = await page.evaluate(() => {
      const dots = /** @type {HTMLElement} */ (document.querySelector('.turn-dots'));
      while (dots.children.length < 12) dots.append(/** @type {Element} */ (dots.lastElementChild).cloneNode(true));
      const sides = (/** @type {string} */ selector) => document.querySelector(selector)?.getBoundingClientRect().toJSON();
      return { rows: new Set([...dots.children].map((dot) => dot.getBoundingClientRect().top)).size, stand: sides('#turn'), strip: sides('.turn-making'), sheet: sides('#sheet') };
    });
    if (letters === 'usual') assert.equal(found.rows, 1);
    assert.ok(found.stand.height > 0.39 * found.sheet.height, JSON.stringify(found));
    assert.ok(found.strip.top >= found.stand.bottom - 1 && found.strip.bottom <= found.sheet.bottom + 1, JSON.stringify(found));
    assert.deepEqual(problems, []);
    await close();
  });
}

/** The parts that are wider than the room of an element. @param {import('puppeteer-core').Page} page @param {string} selector */
const tooWide = (page, selector) =>
  page.$eval(selector, (whole) => {
    const { left } = whole.getBoundingClientRect();
    const ends = [left + whole.clientLeft - 0.5, left + whole.clientLeft + whole.clientWidth + 0.5];
    return [...whole.querySelectorAll('*')]
      .filter((part) => part.checkVisibility() && !part.closest('.said, svg > *'))
      .filter((part) => part.getBoundingClientRect().left < ends[0] || part.getBoundingClientRect().right > ends[1])
      .map((part) => part.id || part.className || part.tagName);
  });

for (const language of ['en', 'ja']) {
  test(`large letters on the narrowest phone fit dialogs and the transport without scrolling sideways: ${language}`, async () => {
    const { page, problems, close } = await site.newPage(SMALL, { viewport: { ...phone, width: 320, height: 640 }, before: large });
    await digest(page);
    await page.select('#language', language);
    await page.waitForFunction((chosen) => document.documentElement.lang === chosen, {}, language);
    assert.deepEqual(await tooWide(page, '.transport'), []);
    for (const [id, opens] of /** @type {const} */ ([['share-dialog', 'share'], ['save-dialog', 'save'], ['keys', '?'], ['text-dialog', 'text'], ['import-dialog', 'import']])) {
      if (opens === '?') await page.keyboard.press('?');
      else if (opens === 'text' || opens === 'import') await tool(page, opens);
      else await click(page, `#${opens}`);
      await page.waitForSelector(`#${id}[open]`);
      assert.deepEqual(await tooWide(page, `#${id}`), [], id);
      assert.equal(await page.$eval(`#${id}`, (dialog) => dialog.scrollWidth - dialog.clientWidth), 0, id);
      await page.$eval(`#${id}`, (dialog) => /** @type {HTMLDialogElement} */ (dialog).close());
      await page.waitForFunction(() => !document.querySelector('dialog[open]'));
    }
    assert.deepEqual(problems, []);
    await close();
  });
}

test('the tool that cuts is under the pointer while two pictures are compared', async () => {
  for (const viewport of [desk, phone]) {
    const { page, problems, close } = await site.newPage(`${PILE}&cut=0,1,0,0.05`, { viewport });
    await digest(page);
    await turned(page);
    await click(page, '#compare-button');
    await page.waitForSelector('.compare-left', { visible: true });
    const covered = await page.$$eval('#turn-cut, #turn-cut-at, .turn-cut label', (parts) =>
      parts.flatMap((part) => {
        part.scrollIntoView({ block: 'center', behavior: 'instant' });
        const { left, top, width, height } = part.getBoundingClientRect();
        const hit = document.elementFromPoint(left + width / 2, top + height / 2);
        return part.contains(hit) ? [] : [`${part.id || part.textContent} under ${hit?.id || hit?.className}`];
      }),
    );
    assert.deepEqual(covered, []);
    assert.deepEqual(problems, []);
    await close();
  }
});
