import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { digest, drop, frames, get, message, phone, SMALL, steps } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Presses Tab until a matching element has the focus. Checks that the focus is visible at every stop. */
async function tabTo(page, selector, most = 120) {
  for (let presses = 0; presses < most; presses += 1) {
    await page.keyboard.press('Tab');
    const { fits, seen, what } = await page.evaluate((wanted) => {
      const element = document.activeElement;
      const ring = element.matches('.segments input') ? element.nextElementSibling : element;
      const { outlineStyle, outlineWidth } = getComputedStyle(ring);
      return {
        fits: element.matches(wanted),
        seen: element === document.body || (outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2),
        what: element.outerHTML.slice(0, 80),
      };
    }, selector);
    assert.ok(seen, `the focus is not to be seen on ${what}`);
    if (fits) return;
  }
  assert.fail(`the keyboard does not reach ${selector}`);
}

test('the keyboard alone pauses, steps, moves a slider, writes numbers with a comma and a minus sign, and takes all back', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const does = () => page.$eval('#play', (button) => button.textContent.trim());
  await tabTo(page, '#play', 40);
  assert.equal(await does(), 'Watch again');
  await tabTo(page, '#step', 4);
  await page.keyboard.press('Enter');
  assert.equal(await does(), 'Play');
  await page.waitForFunction(() => document.documentElement.dataset.stage === 'packing', { timeout: 60_000 });
  const before = await steps(page);
  await page.keyboard.press('Enter');
  assert.equal(await steps(page), before + 1);
  await tabTo(page, '[data-key=cs] [type=range]');
  const size = Number(await get(page, 'cs'));
  await page.keyboard.press('ArrowRight');
  assert.ok(Number(await get(page, 'cs')) > size);
  await page.keyboard.press('ArrowLeft');
  assert.equal(Number(await get(page, 'cs')), size);
  const select = () => page.$eval('[data-key=cs] [type=number]', (box) => (box.focus(), box.select()));
  await select();
  await page.keyboard.type('\u22123');
  assert.equal(await page.$eval('[data-key=cs] [type=number]', (box) => box.value), '-3');
  await select();
  await page.keyboard.type('20,5');
  await page.keyboard.press('Enter');
  assert.equal(await get(page, 'cs'), '20.5');
  // The last step back leaves the focus on its button.
  await page.focus('#undo');
  const spent = () => page.$eval('#undo', (button) => button.ariaDisabled === 'true');
  for (let k = 0; k < 3; k += 1) {
    assert.equal(await spent(), false);
    await page.keyboard.press('Enter');
    await frames(page, 1);
  }
  assert.equal(await spent(), true);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'undo');
  await page.keyboard.press('Enter');
  assert.equal(Number(await get(page, 'cs')), size);
  await page.keyboard.press('Tab');
  assert.deepEqual(await page.$eval('#undo', ({ disabled, ariaDisabled }) => [disabled, ariaDisabled]), [true, null]);
  assert.deepEqual(problems, []);
  await close();
});

/** Writes into the focused field as an input method does, which shows the text before it is taken. @param {import('puppeteer-core').Page} page @param {string} text */
async function compose(page, text) {
  const browser = await page.createCDPSession();
  await browser.send('Input.imeSetComposition', { text, selectionStart: text.length, selectionEnd: text.length });
  await browser.send('Input.insertText', { text });
  await browser.detach();
}

// Only Chromium's protocol writes by an input method.
test('wide digits of an input method are read, and wide signs that the browser drops refuse the number', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const box = '[data-key=cs] [type=number]';
  for (const [typed, read] of [['１２．５', '12.5'], ['２１，５', '12.5'], ['２１。５', '12.5'], ['２２', '22']]) {
    await page.$eval(box, (field) => (field.focus(), field.select()));
    await compose(page, typed);
    await page.keyboard.press('Enter');
    assert.equal(await get(page, 'cs'), read, typed);
    if (/[，。]/.test(typed)) await message(page, 'status', new RegExp(`"${typed}" was given, kept 12.5`));
  }
  assert.deepEqual(problems, []);
  await close();
});

test('keys that an input method takes are no shortcuts', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  // The layers open by O. Safari tells of some of these keys only by their number.
  const press = (/** @type {KeyboardEventInit} */ how) => page.evaluate((init) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key: 'o', bubbles: true, cancelable: true, ...init })), how);
  assert.deepEqual([await press({ isComposing: true }), await press({ keyCode: 229 })], [true, true]);
  assert.equal(await press({}), false);
  await page.waitForSelector('#layers-button[aria-expanded=true]');
  assert.deepEqual(problems, []);
  await close();
});

test('single keys work anywhere but where they are text', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  const does = () => page.$eval('#play', (button) => button.textContent.trim());
  await page.keyboard.press('r');
  assert.equal(await does(), 'Pause');
  // Starts again and pauses at once, because the packing lasts only two seconds, and the checks may take longer.
  await page.keyboard.press('r');
  await page.keyboard.press(' ');
  assert.equal(await does(), 'Play');
  await page.waitForFunction(() => document.documentElement.dataset.stage === 'packing', { timeout: 60_000 });
  const before = await steps(page);
  await page.keyboard.press('s');
  await page.keyboard.press('.');
  assert.equal(await steps(page), before + 2);
  await page.keyboard.press('3');
  assert.equal(await page.$eval('#view', (select) => select.value), 'cells');
  await page.focus('#seed');
  await page.keyboard.type('52');
  assert.equal(await page.$eval('#view', (select) => select.value), 'cells');
  await page.keyboard.press('Enter');
  await frames(page, 1);
  assert.match(await get(page, 'seed'), /52/);
  await close();
});

// Firefox keeps such a text in the box, and tells pages that the box is empty.
test('a number with two points or commas is refused as it was typed, and one that is mended is taken', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const size = await get(page, 'cs');
  const box = '[data-key=cs] [type=number]';
  const select = () => page.$eval(box, (field) => (field.focus(), field.select()));
  for (const typed of ['1.234,5', '12.3.4']) {
    await select();
    await page.keyboard.type(typed);
    await page.keyboard.press('Enter');
    await message(page, 'status', new RegExp(`"${typed}" was given, kept ${size}`));
    assert.deepEqual([await get(page, 'cs'), await page.$eval(box, (field) => field.value)], [size, size]);
  }
  await select();
  await page.keyboard.type('23.4,');
  await select();
  await page.keyboard.type('21.5');
  await page.keyboard.press('Enter');
  assert.equal(await get(page, 'cs'), '21.5');
  assert.deepEqual(problems, []);
  await close();
});

test('a message that is dismissed by keyboard gives the focus back, else to the next message, else to the picture', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const focus = () => page.evaluate(() => document.activeElement.id || document.activeElement.closest('[role=alert], [role=status]')?.role);
  const tooLarge = async () => {
    await page.$eval('[data-key=cs] [type=number]', (box) => (box.focus(), box.select()));
    await page.keyboard.type('9999');
    await page.keyboard.press('Enter');
    await message(page, 'status', /\d/);
    return focus();
  };
  const box = await tooLarge();
  await page.focus('[role=status] .message .close');
  await page.keyboard.press('Enter');
  assert.deepEqual([await focus(), await page.$('.message:not([data-topic=offline])')], [box, null]);
  // Nothing had the focus before.
  await tooLarge();
  await drop(page, 'none.svg', 'no drawing', 'image/svg+xml');
  await message(page, 'alert', /none/);
  await page.evaluate(() => document.activeElement.blur());
  await page.focus('[role=alert] .message .close');
  for (const next of ['status', 'cells']) {
    await page.keyboard.press('Enter');
    assert.equal(await focus(), next);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('listeners are told of the end of the work once, and only the first time that it is stored', async () => {
  const { page, problems, close } = await site.newPage(SMALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        window.told = [];
        new MutationObserver((changes) => {
          for (const { target } of changes) {
            const live = target.nodeType === Node.ELEMENT_NODE ? target : target.parentElement;
            if (live && /^(live|stored)$/.test(live.id) && live.textContent && live.ariaLive !== 'off') window.told.push(live.id);
          }
        }).observe(document, { subtree: true, childList: true, characterData: true });
        // On a slow machine, the page's timeouts could end between key presses: hold them back.
        const { setTimeout, clearTimeout } = window;
        const held = new Map();
        window.setTimeout = (work, wait, ...rest) => {
          if (!window.holding || wait !== 400) return setTimeout(work, wait, ...rest);
          const id = -1 - held.size;
          held.set(id, work);
          return id;
        };
        window.clearTimeout = (id) => (held.has(id) ? held.set(id, undefined) : clearTimeout(id));
        window.release = () => {
          window.holding = false;
          for (const [id, work] of held) {
            held.set(id, undefined);
            work?.();
          }
        };
      }),
  });
  await page.waitForFunction(() => window.told.join() === 'live');
  await page.waitForSelector('[data-key=cs] [type=range]');
  await page.focus('[data-key=cs] [type=range]');
  await page.evaluate(() => (window.holding = true));
  for (let presses = 0; presses < 4; presses += 1) {
    await page.keyboard.press('ArrowRight');
    await digest(page);
  }
  await page.evaluate(() => window.release());
  await page.waitForFunction(() => document.querySelector('#live').textContent && document.querySelector('#stored').textContent);
  assert.deepEqual(await page.evaluate(() => window.told.splice(0).sort()), ['live', 'live', 'stored']);
  await page.evaluate(() => (window.holding = true));
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => document.querySelector('#stored').textContent === '');
  await digest(page);
  await page.evaluate(() => window.release());
  await page.waitForFunction(() => document.querySelector('#live').textContent && document.querySelector('#stored').textContent);
  assert.deepEqual(await page.evaluate(() => window.told), ['live']);
  assert.deepEqual(problems, []);
  await close();
});

test('what gets the focus is not under the help at the foot', async () => {
  for (const viewport of [undefined, phone]) {
    const { page, close } = await site.newPage(SMALL, { viewport });
    await digest(page);
    await page.focus('#throw');
    for (let stops = 0; stops < 14; stops += 1) {
      await page.keyboard.press('Tab');
      await frames(page, 2);
      const [box, help] = await page.evaluate(() => [document.activeElement, document.querySelector('#hint')].map((element) => element.getBoundingClientRect().toJSON()));
      const shown = await page.$eval('#hint', (hint) => hint.textContent !== '');
      assert.ok(!shown || box.bottom <= help.top + 1 || box.top >= help.bottom, `stop ${stops}: ${JSON.stringify([box, help])}`);
    }
    await close();
  }
});
