import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { click, digest, frames, get, link, messages, reloading, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

const disabled = (page, id) => page.$eval(`#${id}`, (button) => button.disabled);

/** Presses keys together. */
async function press(page, ...keys) {
  for (const key of keys.slice(0, -1)) await page.keyboard.down(key);
  await page.keyboard.press(keys.at(-1));
  for (const key of keys.slice(0, -1).reverse()) await page.keyboard.up(key);
  await frames(page, 1);
}

/** Waits until the work is in the browser's storage. */
async function stored(page) {
  await page.waitForFunction(() => document.querySelector('#stored').textContent !== '', { timeout: 60_000 });
}

test('each change is undone and redone, by buttons and by keys, and digests come back', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  const digests = [await digest(page)];
  assert.equal(await disabled(page, 'undo'), true);
  for (const [key, value] of [['cs', '20'], ['kind', 'circle'], ['outline', 'star'], ['az', '90']]) {
    await set(page, key, value);
    digests.push(await digest(page));
  }
  // The light does not change the planes.
  assert.equal(new Set(digests).size, 4);
  const last = digests.pop();
  for (const before of digests.toReversed()) {
    await click(page, '#undo');
    await frames(page, 1);
    assert.equal(await digest(page), before);
  }
  assert.equal(await disabled(page, 'undo'), true);
  for (let k = 0; k < 4; k += 1) await press(page, 'Control', k % 2 ? 'y' : 'Y');
  assert.equal(await digest(page), last);
  assert.equal(await disabled(page, 'redo'), true);
  await press(page, 'Control', 'z');
  assert.equal(await get(page, 'az'), '225');
  await set(page, 'hs', '9');
  assert.equal(await disabled(page, 'redo'), true, 'a change ends what could be redone');
  assert.deepEqual(problems, []);
  await close();
});

test('a slider on its way is one step', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await page.$eval('[data-key=hs] [type=range]', (slider) => {
    for (const place of ['300', '350', '400', '450']) {
      slider.value = place;
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }
    slider.dispatchEvent(new Event('change', { bubbles: true }));
  });
  await frames(page, 2);
  assert.notEqual(await get(page, 'hs'), '18');
  await click(page, '#undo');
  assert.equal(await get(page, 'hs'), '18');
  assert.equal(await disabled(page, 'undo'), true);
  await close();
});

test('a hundred and fifty steps survive a reload', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&shadow=0&occl=0`);
  await digest(page);
  await set(page, 'az', '0');
  await page.evaluate(() => {
    const field = document.querySelector('[data-key=az] [type=number]');
    for (let k = 1; k < 150; k += 1) {
      field.value = String(k);
      field.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await stored(page);
  const last = await link(page);
  await page.reload();
  await digest(page);
  assert.equal(await link(page), last);
  const pressed = (button, times) =>
    page.$eval(
      button,
      (key, count) =>
        Array.from({ length: count }, () => {
          key.click();
          return Number(window.bubblestone.get('az'));
        }),
      times,
    );
  const steps = Array.from({ length: 149 }, (_, k) => k);
  assert.deepEqual(await pressed('#undo', 149), steps.toReversed());
  await click(page, '#undo');
  assert.equal(await get(page, 'az'), '225');
  assert.equal(await disabled(page, 'undo'), true);
  assert.deepEqual(await pressed('#redo', 150), [...steps, 149]);
  assert.equal(await link(page), last);
  assert.deepEqual(problems, []);
  await close();
});

test('the last work is there at the next visit of the bare address', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await set(page, 'cs', '24');
  await stored(page);
  const [work, kept] = [await link(page), await digest(page)];
  await page.goto('about:blank');
  await page.goto(site.address);
  assert.equal(await digest(page), kept);
  assert.equal(await link(page), work);
  assert.ok(page.url().endsWith(work), page.url());
  await close();
});

test('a link that was only looked at is not remembered as work', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&cs=30`);
  await digest(page);
  await frames(page, 40);
  await page.goto('about:blank');
  await page.goto(site.address);
  await page.waitForFunction(() => 'bubblestone' in window);
  const first = await page.evaluate(() => window.bubblestone.presets.find(({ name }) => name === 'lane').link);
  assert.equal(await link(page), first.replace('#', ''));
  await close();
});

test('a link opened over work of one’s own can be taken back', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await set(page, 'cs', '24');
  await stored(page);
  const work = await link(page);
  await page.goto('about:blank');
  await page.goto(`${site.address}${SMALL}&kind=circle`);
  await digest(page);
  assert.match((await messages(page)).join(), /over the work/);
  await click(page, '.message .actions button');
  await frames(page, 2);
  assert.equal(await link(page), work);
  assert.doesNotMatch((await messages(page)).join(), /over the work/);
  // A reloaded page restores its own last work, not the work that another tab stored meanwhile.
  await page.evaluate((other) => {
    const kept = JSON.parse(localStorage.getItem('bubblestone.work'));
    addEventListener('pagehide', () => localStorage.setItem('bubblestone.work', JSON.stringify({ ...kept, recipe: other })));
  }, `${work}&seed=9`);
  await page.reload();
  await digest(page);
  assert.equal(await link(page), work);
  assert.doesNotMatch((await messages(page)).join(), /over the work/);
  await close();
});

test('two tabs keep their works apart, and a third one finds both', async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&seed=5`);
  await digest(page);
  await set(page, 'cs', '24');
  await stored(page);
  const first = await link(page);
  const other = await page.browserContext().newPage();
  await other.bringToFront();
  await other.goto(`${site.address}${SMALL}&seed=6`);
  await digest(other);
  await set(other, 'cs', '28');
  await stored(other);
  const second = await link(other);
  await page.bringToFront();
  await reloading(page, () => page.goto(site.address));
  await digest(page);
  assert.equal(await link(page), first);
  await set(page, 'cs', '20');
  await stored(page);
  const third = await page.browserContext().newPage();
  await third.bringToFront();
  await third.goto(site.address);
  await digest(third);
  const past = [];
  for (let k = 0; k < 12 && !past.includes(second); k += 1) {
    past.push(await link(third));
    await click(third, '#undo');
  }
  assert.ok(past.includes(first) && past.includes(second), past.join(' '));
  assert.deepEqual(problems, []);
  await close();
});

test('many new entries become few, and the address follows', async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const pushed = await page.evaluate(async () => {
    const plain = history.pushState;
    let count = 0;
    history.pushState = function (...words) {
      count += 1;
      plain.apply(this, words);
    };
    for (let k = 0; k < 150; k += 1) {
      /** @type {HTMLElement} */ (document.querySelector('#dice')).click();
      await new Promise(requestAnimationFrame);
    }
    return count;
  });
  assert.ok(pushed > 20 && pushed <= 60, String(pushed));
  const now = await link(page);
  await page.waitForFunction((wanted) => location.hash === `#${wanted}`, {}, now);
  assert.deepEqual(problems, []);
  await close();
});

test('a broken storage breaks nothing', async () => {
  const { page, problems, close } = await site.newPage(SMALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        Storage.prototype.setItem = () => {
          throw new DOMException('full', 'QuotaExceededError');
        };
        Storage.prototype.getItem = () => '{"recipe": 7, "past": "x"}';
      }),
  });
  await digest(page);
  await set(page, 'cs', '24');
  await click(page, '#undo');
  assert.equal(await get(page, 'cs'), '16');
  assert.equal(await page.$eval('#stored', (note) => note.textContent), '');
  assert.deepEqual(problems, []);
  await close();
});
