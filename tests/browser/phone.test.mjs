import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { kind } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, click, digest, done, edit, frames, get, inSight, phone, resize, SMALL, steps } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A page on a phone or a tablet, with all controls visible and all folds open. */
async function unfolded(size = phone) {
  const opened = await site.newPage(SMALL, { viewport: size });
  await digest(opened.page);
  await all(opened.page);
  await opened.page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    for (const control of document.querySelectorAll('.control')) {
      control.hidden = false;
      control.toggleAttribute('data-changed', true);
    }
  });
  return opened;
}

/**
 * Pairs of controls that overlap in the parts that their scrolling boxes show, and buttons whose words stick out.
 * @param {import('puppeteer-core').Page} page
 */
const collisions = (page) =>
  page.evaluate(() => {
    const told = (element) => `${element.id || element.className || element.localName} ${element.textContent.trim().slice(0, 20)}`;
    const seen = (element) => {
      let { left, top, right, bottom } = element.getBoundingClientRect();
      for (let parent = element.parentElement; parent; parent = parent.parentElement) {
        if (getComputedStyle(parent).overflow === 'visible') continue;
        const box = parent.getBoundingClientRect();
        [left, top, right, bottom] = [Math.max(left, box.left), Math.max(top, box.top), Math.min(right, box.right), Math.min(bottom, box.bottom)];
      }
      return { element, left, top, right, bottom };
    };
    const all = [...document.querySelectorAll('.app :is(button, select, input:not([type=radio]), .segments label)')];
    // Buttons of a group lie over its heading, which is no control here.
    const boxes = all.filter((element) => element.checkVisibility()).map(seen);
    const found = [];
    for (const [at, a] of boxes.entries()) {
      for (const b of boxes.slice(at + 1)) {
        if (a.element.contains(b.element) || b.element.contains(a.element)) continue;
        if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1.5 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1.5) found.push(`${told(a.element)} on ${told(b.element)}`);
      }
    }
    for (const { element } of boxes) {
      const box = element.getBoundingClientRect();
      for (const word of element.querySelectorAll('span')) {
        // Words for screen readers only are clipped.
        if (getComputedStyle(word).clipPath !== 'none') continue;
        const range = document.createRange();
        range.selectNodeContents(word);
        const { left, right, width } = range.getBoundingClientRect();
        if (width > 2 && (left < box.left - 0.5 || right > box.right + 0.5)) found.push(`words out of ${told(element)}`);
      }
    }
    return found;
  });

/** The boxes of elements. @param {import('puppeteer-core').Page} page @param {string[]} names */
const places = (page, ...names) =>
  page.evaluate((all) => all.map((name) => document.querySelector(name).getBoundingClientRect().toJSON()), names);

test('the canvas comes first and as wide as the screen, then presets, transport, tools and the rest', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  const [canvas, rail, play, tools, panel] = await places(page, '#canvas', '#rail', '#play', '#edit-tools', '#panel');
  assert.ok(canvas.width >= 388 && canvas.top < 150, JSON.stringify(canvas));
  assert.ok(rail.top >= canvas.bottom && play.top >= rail.bottom && play.bottom <= 844);
  assert.ok(tools.top >= play.bottom && panel.top >= tools.bottom);
  await close();
});

test('buttons for what is edited stand under the picture, plots above the controls, names of controls beside them', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  await page.tap('[data-tool=outline]');
  await page.waitForSelector('.handle');
  const [sheet, bar, tools] = await places(page, '#sheet', '#editor-bar', '#edit-tools');
  assert.ok(bar.top >= sheet.bottom && tools.top >= bar.bottom, JSON.stringify([sheet, bar, tools]));
  await page.tap('#plots-button');
  await page.waitForSelector('#plots canvas');
  const [look, plots, panel] = await places(page, '#look-tools', '#plots', '#panel');
  // Firefox rounds the edges of one line to different numbers.
  assert.ok(plots.top >= look.bottom - 0.1 && panel.top >= plots.bottom - 0.1, JSON.stringify([look, plots, panel]));
  const [name, box] = await places(page, '#p-cs-name', '#p-cs');
  assert.ok(name.left < 30 && name.right <= box.left && name.top < box.bottom && box.top < name.bottom, JSON.stringify([name, box]));
  await close();
});

test('on its side the phone shows the whole picture, all the rest beside it', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: { ...phone, width: 844, height: 390 } });
  await digest(page);
  const [sheet, ...rest] = await places(page, '#sheet', '.head', '#rail', '#play', '#edit-tools', '#look-tools', '#panel');
  assert.ok(sheet.top >= 0 && sheet.bottom <= 390 && sheet.height > 300, JSON.stringify(sheet));
  for (const { left, right } of rest) assert.ok(left >= sheet.right && right <= 844, JSON.stringify([left, right]));
  await close();
});

test('nothing is wider than the screen', async () => {
  const { page, close } = await unfolded();
  await click(page, '#edit-outline');
  await page.waitForSelector('.handle');
  await page.select('#edit-what', 'spots');
  await click(page, '#add-figure');
  const { wide, scroll } = await page.evaluate(() => ({
    scroll: document.documentElement.scrollWidth,
    wide: [...document.querySelectorAll('body *')]
      .filter((element) => !element.closest('.rail, .editor') && element.getBoundingClientRect().right > innerWidth + 0.5)
      .map((element) => element.outerHTML.slice(0, 80)),
  }));
  assert.deepEqual(wide, []);
  assert.equal(scroll, 390);
  // Nor do letters of double size, or a screen of 320 pixels.
  for (const [width, size] of [[390, '200%'], [320, '100%']]) {
    await page.evaluate((percent) => document.documentElement.style.setProperty('font-size', percent), size);
    await page.setViewport({ ...phone, width });
    // Layout follows a little later.
    await page.waitForFunction((wide) => document.documentElement.scrollWidth === wide, { timeout: 20_000 }, width);
  }
  await close();
});

const SCREENS = {
  'a small phone': { width: 360, height: 640 },
  'a small phone on its side': { width: 667, height: 375 },
  'a phone on its side': { width: 844, height: 390 },
  'an upright tablet': { width: 820, height: 1180 },
  'a tablet on its side': { width: 1180, height: 746 },
  'a small tablet on its side': { width: 1024, height: 690 },
};

test('no control lies on another one on small screens', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone, still: true });
  await done(page);
  await page.waitForSelector('.timeline input');
  for (const language of ['en', 'ja']) {
    await page.select('#language', language);
    await page.waitForFunction((wanted) => document.documentElement.lang === wanted, {}, language);
    for (const [device, size] of Object.entries(SCREENS)) {
      await resize(page, { ...phone, ...size });
      assert.deepEqual(await collisions(page), [], `${device}, ${language}`);
    }
  }
  await close();
});

test('letters of double size leave each control its place, and the timeline a slider', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone, still: true });
  await done(page);
  await page.waitForSelector('.timeline input');
  await page.evaluate(() => document.documentElement.style.setProperty('font-size', '200%'));
  for (const language of ['en', 'ja']) {
    await page.select('#language', language);
    await page.waitForFunction((wanted) => document.documentElement.lang === wanted, {}, language);
    await frames(page, 2);
    assert.deepEqual(await collisions(page), [], language);
    const [slider, transport, name, box] = await places(page, '.timeline input', '.transport', '#p-vs-name', '#p-vs');
    assert.ok(slider.width > 150 && transport.width <= 390, JSON.stringify([slider, transport]));
    assert.ok(name.bottom <= box.top + 1 || name.right <= box.left, JSON.stringify([name, box]));
  }
  await close();
});

for (const [device, size] of Object.entries({ phone, 'tablet on its side': { ...phone, width: 1180, height: 820 } })) test(`everything to touch on a ${device} is at least 44 pixels high and wide`, async () => {
  const { page, close } = await unfolded(size);
  await edit(page, 'spots');
  const small = await page.evaluate(() => {
    const targets = [...document.querySelectorAll('button, select, summary, input')].filter((target) => target.offsetParent);
    return targets
      .map((target) => (target.matches('[type=radio], [type=checkbox]') ? (target.closest('label') ?? target) : target))
      .filter((target) => {
        const { width, height } = target.getBoundingClientRect();
        return width < 43.5 || height < 43.5;
      })
      .map((target) => target.outerHTML.slice(0, 100));
  });
  assert.deepEqual(small, []);
  await close();
});

test('a finger pauses, steps and moves a slider', async () => {
  const { page, problems, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  await page.tap('#step');
  await page.waitForFunction(() => document.documentElement.dataset.stage === 'packing', { timeout: 60_000 });
  const before = await steps(page);
  await page.tap('#step');
  // The click of a finger may come a little later.
  await page.waitForFunction((count) => window.bubblestone.status().steps > count, {}, before);
  assert.equal(await steps(page), before + 1);
  await page.$eval('[data-key=el]', (control) => {
    control.closest('details').open = true;
  });
  const elevation = await get(page, 'el');
  const slider = await inSight(page, '[data-key=el] [type=range]');
  const [x, y] = [slider.x + slider.width * 0.85, slider.y + slider.height / 2];
  await page.touchscreen.tap(x, y);
  await page.waitForFunction((before) => window.bubblestone.get('el') !== before, {}, elevation);
  // A finger that starts on a slider and moves up scrolls the page, and leaves the value.
  if (kind !== 'firefox') {
    const chosen = await get(page, 'el');
    const before = await page.evaluate(() => scrollY);
    const finger = await page.touchscreen.touchStart(x - 150, y);
    for (let way = 10; way <= 200; way += 10) await finger.move(x - 150, y - way);
    await page.waitForFunction((place) => scrollY > place + 50, {}, before);
    await finger.end();
    assert.equal(await get(page, 'el'), chosen);
    assert.equal(await page.$eval('[data-key=el] input', (box) => box.value), chosen);
  }
  assert.deepEqual(problems, []);
  await close();
});
