import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { digest, frames, get, SMALL, steps } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const viewport = { width: 390, height: 844, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A page on a phone, with all controls to be seen. */
async function unfolded() {
  const opened = await site.newPage(SMALL, { viewport });
  await digest(opened.page);
  await opened.page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    for (const control of document.querySelectorAll('.control')) {
      control.hidden = false;
      control.toggleAttribute('data-changed', true);
    }
  });
  return opened;
}

test('the canvas comes first and as wide as the screen, the controls below', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport });
  await digest(page);
  const [canvas, play, panel] = await page.evaluate(() =>
    ['#canvas', '#play', '#panel'].map((name) => document.querySelector(name).getBoundingClientRect().toJSON()),
  );
  assert.ok(canvas.width >= 388 && canvas.top < 64, JSON.stringify(canvas));
  assert.ok(play.top >= canvas.bottom && play.bottom <= 844);
  assert.ok(panel.top >= play.bottom);
  await close();
});

test('nothing is wider than the screen', async () => {
  const { page, close } = await unfolded();
  await page.click('#edit-outline');
  await page.waitForSelector('.handle');
  await page.select('#edit-what', 'spots');
  await page.click('#add-figure');
  const { wide, scroll } = await page.evaluate(() => ({
    scroll: document.documentElement.scrollWidth,
    wide: [...document.querySelectorAll('body *')]
      .filter((element) => !element.closest('.rail, .editor, .toolbox') && element.getBoundingClientRect().right > innerWidth + 0.5)
      .map((element) => element.outerHTML.slice(0, 80)),
  }));
  assert.deepEqual(wide, []);
  assert.equal(scroll, 390);
  await close();
});

test('everything to touch is at least 44 pixels high and wide', async () => {
  const { page, close } = await unfolded();
  await page.$eval('#p-spots', (button) => button.click());
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
  const { page, problems, close } = await site.newPage(SMALL, { viewport });
  await digest(page);
  await page.tap('#play');
  await page.tap('#restart');
  await page.waitForFunction(() => document.documentElement.dataset.stage === 'packing', { timeout: 20_000 });
  const before = await steps(page);
  await page.tap('#step');
  assert.equal(await steps(page), before + 1);
  await page.$eval('[data-key=el]', (control) => {
    control.closest('details').open = true;
    control.scrollIntoView({ block: 'center' });
  });
  await frames(page, 2);
  const elevation = await get(page, 'el');
  const slider = await page.$eval('[data-key=el] [type=range]', (range) => range.getBoundingClientRect().toJSON());
  await page.touchscreen.tap(slider.x + slider.width * 0.85, slider.y + slider.height / 2);
  assert.notEqual(await get(page, 'el'), elevation);
  assert.deepEqual(problems, []);
  await close();
});
