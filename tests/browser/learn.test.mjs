// The figures of the chapters: stops, handles, questions, addresses.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { goldenStops } from '../common/figures.mjs';
import { sameEverywhere } from './browsers.mjs';
import { desk } from './harness.mjs';
import { answer, answered, at, boxHas, chapterPages, follow, hasGoldenStates, heights, middle, seek, shown, type, violations } from './lesson.mjs';
import { inSight, phone, resize } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const chapter = chapterPages('two-bubbles');

/** The number in a handle's box. @param {Page} page @param {string} figure @param {string} key */
const boxed = (page, figure, key) => page.$eval(`${figure} .handle[data-key="${key}"] input[type="number"]`, (box) => Number(box.value));

/** Whether an element is in the window, whole. @param {Element} element */
const inWindow = (element) => {
  const { top, bottom } = element.getBoundingClientRect();
  return top >= -0.5 && bottom <= innerHeight + 0.5;
};

const FIGURES = ['top', 'pair', 'let-go', 'not-so', 'exercise'];

test('each stop has the golden state', () => hasGoldenStates(chapter, FIGURES));

test('the distance follows the mouse, the keys, a tap and the box; figure, text and numbers follow it', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'pair');
  const first = await shown(page, figure);
  const grip = `${figure} .plate-box[data-plate="0"] .grip-w`;

  const from = await middle(page, grip);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 0.9, {}, `${figure} .handle[data-key="w"] input[type="number"]`);
  await page.waitForFunction((selector, hash) => document.querySelector(selector).dataset.hash !== hash, {}, figure, first.hash);
  const dragged = await shown(page, figure);
  const w = (await boxed(page, figure, 'w')).toFixed(3);
  assert.ok(dragged.picture !== first.picture && dragged.hash !== first.hash);
  assert.ok(dragged.told.includes(w) && dragged.picture.includes(w), dragged.told);

  await page.focus(grip);
  for (const [key, shift, by] of /** @type {const} */ ([['ArrowRight', false, 0.01], ['ArrowLeft', true, -0.001], ['PageUp', false, 0.1]])) {
    const now = await boxed(page, figure, 'w');
    if (shift) await page.keyboard.down('Shift');
    await page.keyboard.press(key);
    if (shift) await page.keyboard.up('Shift');
    await boxHas(page, figure, 'w', now + by);
  }
  assert.match((await page.$eval(grip, (slider) => slider.ariaValueText)) ?? '', /^\d\.\d{3} stable distances$/);

  const plate = await inSight(page, `${figure} .plate-box[data-plate="1"]`);
  await page.mouse.click(plate.x + (plate.width * (72 + 130 * 1.3)) / 400, plate.y + plate.height / 2);
  await boxHas(page, figure, 'w', 1.3, 0.01);
  await page.waitForFunction((selector) => /pull/.test(document.querySelector(selector).textContent), {}, `${figure} .figure-told`);

  await type(page, figure, 'w', 1.7);
  await page.waitForFunction((selector) => /no force/.test(document.querySelector(selector).textContent), {}, `${figure} .figure-told`);
  assert.deepEqual(problems, []);
  await close();
});

test('a tap moves the bubble; a finger on its grip moves it and not the page', sameEverywhere, async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  const figure = await at(page, 'pair');
  const plate = await middle(page, `${figure} .plate-box[data-plate="1"] .plate-svg`);
  await page.touchscreen.tap(plate.x, plate.y);
  await boxHas(page, figure, 'w', (200 - 72) / 130, 0.02);
  const from = await middle(page, `${figure} .plate-box[data-plate="0"] .grip-w`);
  const top = await page.evaluate(() => scrollY);
  await page.touchscreen.touchStart(from.x, from.y);
  for (let k = 1; k <= 5; k += 1) await page.touchscreen.touchMove(from.x + 12 * k, from.y + 8 * k);
  await page.touchscreen.touchEnd();
  await page.waitForFunction((selector) => Number(document.querySelector(selector).value) > 1.2, {}, `${figure} .handle[data-key="w"] input[type="number"]`);
  assert.equal(await page.evaluate(() => scrollY), top);
  assert.deepEqual(problems, []);
  await close();
});

test('every handle works by keys, by a press on its slider, and by its box or its buttons', async () => {
  const { page, problems, close } = await chapter();
  for (const name of ['pair', 'let-go', 'not-so', 'exercise']) {
    const figure = await at(page, name);
    await page.$$eval(`${figure} details`, (folds) => folds.forEach((fold) => (fold.open = true)));
    for (const key of await page.$$eval(`${figure} .handle:not(.choice)`, (handles) => handles.map((handle) => handle.dataset.key ?? ''))) {
      const slider = `${figure} .handle[data-key="${key}"] input[type="range"]`;
      const { x, y, width, height } = await inSight(page, slider);
      const { share, wanted, range } = await page.$eval(slider, ({ min, max, value }) => {
        const [from, wide] = [Number(min), Number(max) - Number(min)];
        // A press on the thumb itself moves nothing, so the place lies away from it.
        const part = Math.abs((Number(value) - from) / wide - 0.4) < 0.2 ? 0.75 : 0.4;
        return { share: part, wanted: from + part * wide, range: wide };
      });
      await page.mouse.click(x + width * share, y + height / 2);
      await boxHas(page, figure, key, wanted, 0.06 * range);
      const now = await boxed(page, figure, key);
      await page.keyboard.press('ArrowRight');
      await page.waitForFunction((selector, old) => Number(document.querySelector(selector).value) > old, {}, `${figure} .handle[data-key="${key}"] input[type="number"]`, now);
      assert.ok(await page.$eval(slider, (range) => range.getAttribute('aria-valuetext')), key);
      await type(page, figure, key, 0.7);
    }
    await seek(page, figure, 20);
    for (const choice of await page.$$(`${figure} .handle.choice input:not(:checked)`)) {
      const before = (await shown(page, figure)).hash;
      await choice.evaluate((button) => button.closest('label')?.click());
      await page.waitForFunction((selector, hash) => document.querySelector(selector).dataset.hash !== hash, {}, figure, before);
    }
  }
  assert.deepEqual(problems, []);
  await close();
});

test('the timeline steps on and back, plays, pauses and starts again', async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'let-go');
  const first = await shown(page, figure);
  await seek(page, figure, 12);
  const there = await shown(page, figure);
  assert.equal(there.said, 'step 12 of 200');
  await page.click(`${figure} [data-do="on"]`);
  await page.waitForSelector(`${figure}[data-step="13"]`);
  await page.click(`${figure} [data-do="back"]`);
  await page.waitForSelector(`${figure}[data-step="12"]`);
  const again = await shown(page, figure);
  assert.deepEqual(again, there);
  await page.click(`${figure} [data-do="play"]`);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).dataset.step) > 14, {}, figure);
  assert.equal(await page.$eval(`${figure} .figure-told`, (text) => text.getAttribute('aria-live')), 'off');
  await page.click(`${figure} [data-do="play"]`);
  await page.waitForSelector(`${figure} .figure-told[aria-live="polite"]`);
  await type(page, figure, 'damp', 1.5);
  await page.click(`${figure} [data-do="again"]`);
  await page.waitForSelector(`${figure}[data-step="200"][data-hash="${first.hash}"]`);
  assert.deepEqual(await shown(page, figure), first);
  assert.deepEqual(problems, []);
  await close();
});

test('with any stiffness the pair stays on its curves, and their numbers follow it', sameEverywhere, async () => {
  const { page, problems, close } = await chapter();
  const figure = await at(page, 'pair');
  /** The place of the dot on a plate, and the number below the sign of a curve. @param {number} plate */
  const dot = (plate) => page.$eval(`${figure} .plate-box[data-plate="${plate}"] svg .here`, (here) => [Number(here.getAttribute('cx')), Number(here.getAttribute('cy'))]);
  const [onForce, onValley] = [await dot(0), await dot(1)];
  for (const [stiffness, most] of [[10, '11.250'], [0.1, '0.113']]) {
    await type(page, figure, 'stiff', Number(stiffness));
    // Stiffness does not change the state at the start, so the test waits for a number on the plate.
    await page.waitForFunction((selector, number) => document.querySelector(selector).innerHTML.includes(`>${number}<`), {}, `${figure} .plate-box[data-plate="0"]`, most);
    assert.deepEqual([await dot(0), await dot(1)], [onForce, onValley], `stiffness ${stiffness}`);
    const { told } = await shown(page, figure);
    assert.match(told, stiffness === 10 ? /push each other with 3\.90/ : /push each other with 0\.039/);
    // Arrows and levels stay on the plates.
    const drawn = await page.$$eval(`${figure} svg.plate :is(.shaft, .head, .level, .bar)`, (parts) => parts.map((part) => [part.getBBox(), part.ownerSVGElement.viewBox.baseVal.height]).map(([{ x, y, width, height }, tall]) => x >= 0 && y >= 0 && x + width <= 400 && y + height <= tall));
    assert.ok(drawn.length >= 6 && drawn.every(Boolean), String(drawn));
  }
  assert.deepEqual(problems, []);
  await close();
});

test('with less motion a run goes from stop to stop', sameEverywhere, async () => {
  const { page, close } = await chapter('', { still: true });
  const figure = await at(page, 'let-go');
  await page.evaluate((selector) => {
    window.steps = [];
    new MutationObserver(() => window.steps.push(Number(document.querySelector(selector).dataset.step))).observe(document.querySelector(selector), { attributeFilter: ['data-step'] });
  }, figure);
  await page.select(`${figure} select.speed`, '4');
  await page.click(`${figure} [data-do="play"]`);
  await page.waitForFunction(() => window.steps.length > 2 && window.steps.at(-1) === 200);
  const stops = goldenStops().filter((stop) => stop.figure === 'let-go').map(({ step }) => Number(step));
  assert.deepEqual([...new Set(await page.evaluate(() => window.steps))], stops);
  await close();
});

test('each question is answered by doing what it asks', async () => {
  const { page, problems, close } = await chapter();
  for (const name of FIGURES) await at(page, name);
  for (const key of ['made', 'far', 'near', 'broken', 'still']) assert.equal(await answer(page, key), '', key);

  await at(page, 'top');
  await page.click('#fig-top [data-stop="two"]');
  await answered(page, 'made');

  await at(page, 'let-go');
  await page.$eval('[data-ask="far"] input[value="c"]', (button) => button.click());
  await type(page, '#fig-let-go', 'w', 1.6);
  await page.waitForSelector('#fig-let-go[data-step="0"]');
  assert.equal(await answer(page, 'far'), '');
  await seek(page, '#fig-let-go', 10);
  await answered(page, 'far');
  assert.match(await answer(page, 'far'), /^You expected that it comes back\. It stayed: at w = 1\.600 the force is 0\.000/);

  await type(page, '#fig-let-go', 'damp', 0);
  for (const [w, next] of /** @type {const} */ ([[0.71, 'From 0.710 it parted for good. Start a little farther apart.'], [0.74, 'From 0.710 it parted for good, from 0.740 it came back. Start in between'], [0.725, 'Step on or back']])) {
    assert.equal(await answer(page, 'near'), '');
    await type(page, '#fig-let-go', 'w', w);
    await page.waitForSelector('#fig-let-go[data-step="0"]');
    await seek(page, '#fig-let-go', 200);
    await page.waitForFunction((wanted) => document.querySelector('#fig-let-go .figure-told')?.textContent?.includes(wanted), {}, next);
  }
  await answered(page, 'near');
  assert.match(await answer(page, 'near'), /^You set no mark\. From 0\.710 it parted for good, from 0\.725 it came back/);
  await type(page, '#fig-let-go', 'mark', 0.5);
  await page.waitForFunction(() => document.querySelector('[data-seen=near]')?.textContent?.startsWith('Your mark'));
  assert.match(await answer(page, 'near'), /^Your mark is at 0\.500\. From 0\.710 it parted for good, from 0\.725 it came back.*0\.718/);
  await page.click('#fig-let-go [data-do="back"]');
  await page.waitForSelector('#fig-let-go .zero');

  await at(page, 'not-so');
  await type(page, '#fig-not-so', 'dt', 0.2);
  await seek(page, '#fig-not-so', 100);
  assert.equal(await answer(page, 'broken'), '');
  await type(page, '#fig-not-so', 'dt', 1);
  await answered(page, 'broken');

  await at(page, 'exercise');
  // A start at rest needs no damping, so it is not what the exercise asks for.
  await type(page, '#fig-exercise', 'w', 1);
  await seek(page, '#fig-exercise', 50);
  assert.equal(await answer(page, 'still'), '');
  await type(page, '#fig-exercise', 'w', 0.8);
  await type(page, '#fig-exercise', 'damp', 1);
  await seek(page, '#fig-exercise', 50);
  assert.equal(await answer(page, 'still'), '');
  await type(page, '#fig-exercise', 'damp', 2);
  await answered(page, 'still');
  assert.deepEqual(problems, []);
  await close();
});

test('on a phone, on a desk and in class the sentences on what happened stay in sight beside their figure', sameEverywhere, async () => {
  const { page, problems, close } = await chapter('', { viewport: phone });
  await at(page, 'top');
  await inSight(page, '#fig-top [data-stop="two"]');
  await page.tap('#fig-top [data-stop="two"]');
  await answered(page, 'made');
  assert.ok(await page.$eval('[data-seen="made"]', inWindow), 'the question on top');
  await at(page, 'let-go');
  await type(page, '#fig-let-go', 'w', 1.6);
  await page.waitForSelector('#fig-let-go[data-step="0"]');
  await seek(page, '#fig-let-go', 10);
  await answered(page, 'far');
  await type(page, '#fig-let-go', 'damp', 0);
  await type(page, '#fig-let-go', 'mark', 0.5);
  for (const w of [0.71, 0.725]) {
    await type(page, '#fig-let-go', 'w', w);
    await page.waitForSelector('#fig-let-go[data-step="0"]');
    await seek(page, '#fig-let-go', 200);
  }
  await answered(page, 'near');
  assert.ok(await page.$eval('#fig-let-go', (figure) => figure.offsetHeight > innerHeight), 'higher than the window');
  for (const block of ['start', 'center', 'end']) {
    await page.$eval('#fig-let-go', (figure, place) => figure.scrollIntoView({ block: place, behavior: 'instant' }), block);
    for (const key of ['far', 'near']) assert.ok(await page.$eval(`[data-seen="${key}"]`, inWindow), `${key}, ${block}`);
  }
  // The same kind of screen, as one without touch would load the page again.
  await resize(page, { ...phone, ...desk });
  for (const handle of ['.time-line', '.handle[data-key="damp"]']) {
    await inSight(page, `#fig-let-go ${handle}`);
    assert.ok(await page.$eval('[data-seen="far"]', inWindow), `far, on a desk at ${handle}`);
  }
  await page.setViewport({ width: 1024, height: 768 });
  await page.$eval('#class', (button) => button.click());
  await page.evaluate(() => {
    const isShown = () => document.documentElement.dataset.part === 'figure' && document.querySelector('#fig-let-go').checkVisibility();
    for (let k = 0; k < 20 && !isShown(); k += 1) document.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
  });
  for (const key of ['far', 'near']) assert.ok(await page.$eval(`[data-seen="${key}"]`, inWindow), `${key}, in class`);
  assert.deepEqual(problems, []);
  await close();
});

test('an address opens the same state in a fresh page, in both languages', async () => {
  const one = await chapter();
  const figure = await at(one.page, 'let-go');
  await type(one.page, figure, 'w', 0.83);
  await type(one.page, figure, 'damp', 0.35);
  await type(one.page, figure, 'mark', 0.64);
  await seek(one.page, figure, 47);
  await one.page.waitForFunction(() => location.hash.includes('step=47') && location.hash.includes('at=0.640'));
  const fragment = await one.page.evaluate(() => location.hash);
  const first = await shown(one.page, figure);
  await one.close();
  for (const language of /** @type {const} */ (['en', 'ja'])) {
    const { page, problems, close } = await chapter(fragment, { language });
    await page.waitForSelector(`${figure}[data-step="47"][data-hash="${first.hash}"]`);
    if (language === 'en') assert.deepEqual(await shown(page, figure), first);
    assert.ok(await page.$eval(figure, (element) => element.getBoundingClientRect().top < innerHeight && element.getBoundingClientRect().bottom > 0));
    assert.deepEqual(problems, []);
    await close();
  }
});

test('an address that fits no figure, or has no pair, opens what there is', sameEverywhere, async () => {
  const { page, problems, close } = await chapter('#fig=none&step=3');
  for (const fragment of ['#fig=pair&kind=square&step=99999', '#fig=pair&given=0.1,0.5,0&step=x&at=y', '']) {
    const figure = await at(page, 'pair');
    assert.match((await shown(page, figure)).told, /w = [01]\.\d{3}/);
    if (fragment) await follow(page, fragment);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('figures out of sight have no frames', sameEverywhere, async () => {
  const { page, close } = await chapter('', {
    before: (page) =>
      page.evaluateOnNewDocument(() => {
        window.asked = 0;
        const frame = requestAnimationFrame.bind(window);
        window.plainFrame = frame;
        window.requestAnimationFrame = (act) => {
          window.asked += 1;
          return frame(act);
        };
      }),
  });
  for (const name of FIGURES) await at(page, name);
  const figure = await at(page, 'let-go');
  await page.click(`${figure} [data-do="play"]`);
  await page.waitForFunction((selector) => Number(document.querySelector(selector).dataset.step) > 20, {}, figure);
  await page.$eval('#fig-top', (top) => top.scrollIntoView({ block: 'center', behavior: 'instant' }));
  const counts = await page.evaluate(async () => {
    const frames = async (/** @type {number} */ n) => {
      for (let k = 0; k < n; k += 1) await new Promise((done) => window.plainFrame(done));
    };
    await frames(10);
    const before = window.asked;
    await frames(30);
    return window.asked - before;
  });
  assert.equal(counts, 0);
  await close();
});

// Japanese on a dark page, English on a light one: nothing but colours and words is different.
for (const language of /** @type {const} */ (['en', 'ja'])) {
  test(`axe finds nothing in the figures, and on a desk and a phone each has one height at all steps: ${language}`, sameEverywhere, async () => {
    const dark = language === 'ja';
    const { page, close } = await chapter('', { language, dark, ...(dark ? { viewport: phone } : {}) });
    const are = async (/** @type {string} */ where) => {
      for (const name of FIGURES) assert.equal((await heights(page, await at(page, name))).length, 1, `the height of ${name} ${where}`);
    };
    await are('at first');
    assert.deepEqual(await violations(page), []);
    // The same kind of screen, as changing to touch or back would load the page again.
    await resize(page, dark ? { ...phone, ...desk } : { width: phone.width, height: phone.height });
    await are('in the other window');
    await close();
  });
}
