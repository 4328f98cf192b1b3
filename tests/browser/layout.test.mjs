import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { firstEverywhere, sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, canvas, click, digest, frames, get, inSight, phone, reloading, resize, SMALL, tool } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const small = { ...phone, width: 360, height: 640 };
const tablet = { ...phone, width: 820, height: 1180 };
const lying = { ...phone, width: 844, height: 390 };
const desk = { width: 1280, height: 800 };

// Screens of one kind are shown one after the other on the same page.
const TOUCHED = { 'smallest phone': { ...phone, width: 320, height: 568 }, 'small phone': small, phone, 'upright tablet': tablet, 'tablet on its side': { ...tablet, width: 1180, height: 820 }, 'phone on its side': lying };
const KINDS = { touched: TOUCHED, clicked: { desk } };

before(async () => {
  site = await open();
});

after(() => site?.close());

/** @param {string} language */
const speaking = (language) => (/** @type {Page} */ fresh) =>
  fresh.evaluateOnNewDocument((code) => localStorage.setItem('bubblestone.language', code), language);

/**
 * Opens a link in each language, and calls `look` on one screen after the other.
 * @param {string} fragment
 * @param {Record<string, import('puppeteer-core').Viewport>} screens
 * @param {(page: Page, where: string) => Promise<void>} look
 */
async function onEach(fragment, screens, look) {
  for (const language of ['en', 'ja']) {
    const { page, close } = await site.newPage(fragment, { viewport: Object.values(screens)[0], before: speaking(language) });
    await digest(page);
    for (const [device, viewport] of Object.entries(screens)) {
      await resize(page, viewport);
      await look(page, `${device}, ${language}`);
    }
    await close();
  }
}

/** The box of an element in the window. @param {Page} page @param {string} selector */
const place = (page, selector) => page.$eval(selector, (element) => element.getBoundingClientRect().toJSON());

/** Presses a button where it is: a tap on a slow machine may pass for a long one. @param {Page} page @param {string} selector */
const press = (page, selector) => page.$eval(selector, (button) => button.click());

/** The place of the picture, and whether its middle is uncovered. @param {Page} page */
const sight = (page) =>
  page.$eval('#canvas', (picture) => {
    const { left, top, right, bottom, width, height } = picture.getBoundingClientRect();
    const over = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    return { left, top, right, bottom, width, height, free: over?.closest('#frame') !== null };
  });

for (const [at, [device, viewport]] of Object.entries({ phone, 'small phone': small, 'upright tablet': tablet, 'phone on its side': lying }).entries()) {
  test(`every slider moves with the picture in sight: ${device}`, firstEverywhere(at), async () => {
    const { page, problems, close } = await site.newPage(SMALL, { viewport });
    await digest(page);
    const { width, height } = viewport;
    for (const key of ['cs', 'dr', 'el']) {
      const slider = `[data-key=${key}] [type=range]`;
      const box = await inSight(page, slider);
      const [before, value, drawn] = [await page.evaluate(() => scrollY), await get(page, key), (await canvas(page)).hash];
      await page.touchscreen.tap(box.x + box.width * 0.8, box.y + box.height / 2);
      await page.waitForFunction((name, old) => window.bubblestone.get(name) !== old, {}, key, value);
      await digest(page);
      await frames(page, 2);
      assert.notEqual((await canvas(page)).hash, drawn, key);
      assert.equal(await page.evaluate(() => scrollY), before, `${key}: the page scrolls`);
      const seen = await sight(page);
      assert.ok(seen.left >= 0 && seen.right <= width && seen.top >= -1 && seen.bottom <= height, `${key}: ${JSON.stringify(seen)}`);
      assert.ok(seen.free, `${key}: something lies over the picture`);
      assert.ok(seen.height > 100 && (width > height || seen.height <= 0.4 * height), `${key}: ${seen.height} pixels high`);
    }
    assert.deepEqual(problems, []);
    await close();
  });
}

/** The head's height. @param {Page} page */
const headHeight = async (page) => (await place(page, '#head')).height;

for (const [at, [kind, screens]] of Object.entries(KINDS).entries()) {
  test(`the head keeps its height when the work is stored, on screens that are ${kind}`, firstEverywhere(at), async () => {
    await onEach('#size=192&cs=16&seed=2', screens, async (page, where) => {
      const word = await page.$('#stored');
      // Text of another size and width stands for the fonts of other machines. The last style is the page's own: large text
      // would make the window of the next screen wider.
      for (const style of ['font-family: monospace; font-size: 1.5rem', '']) {
        await page.$eval('#head', (head, rule) => {
          for (const part of [head, ...head.querySelectorAll('*')]) part.style.cssText = rule;
        }, style);
        await word.evaluate((element) => (element.textContent = ''));
        const before = await headHeight(page);
        await word.evaluate((element) => (element.textContent = 'Stored on this device, '.repeat(4)));
        assert.equal(await headHeight(page), before, `${where}, ${style}`);
      }
    });
  });
}

test('the picture shrinks in its place: nothing else moves, and a press brings it back', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  const look = () =>
    page.evaluate(() => ({
      long: document.documentElement.scrollHeight,
      panel: Math.round(document.querySelector('#panel').getBoundingClientRect().top + scrollY),
      side: document.querySelector('#canvas').getBoundingClientRect().width,
    }));
  const first = await look();
  assert.equal(first.side, 390);
  const sides = [];
  for (const y of [0, 100, 130, 160, 190, 600]) {
    await page.evaluate((to) => window.scrollTo({ top: to, behavior: 'instant' }), y);
    await frames(page, 3);
    const now = await look();
    assert.deepEqual({ ...now, side: 0 }, { ...first, side: 0 }, `at ${y}`);
    sides.push(now.side);
  }
  assert.deepEqual(sides, [...sides].sort((a, b) => b - a));
  assert.ok(sides.at(-1) < 300, String(sides));
  await page.tap('#enlarge');
  await page.waitForFunction(() => document.querySelector('#canvas').getBoundingClientRect().width === 390);
  assert.equal(await page.$eval('#enlarge', (button) => button.hidden), true);
  await close();
});

test('a keyboard on the screen leaves the picture and the controls in sight', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  await inSight(page, '#p-dr');
  // A keyboard that shrinks the page moves nothing on it.
  const long = () => page.evaluate(() => [document.documentElement.scrollWidth, document.querySelector('#panel').getBoundingClientRect().top + scrollY]);
  const before = await long();
  await page.setViewport({ ...phone, height: 440 });
  await page.waitForFunction(() => innerHeight === 440);
  await frames(page, 3);
  const lower = await sight(page);
  assert.ok(lower.top >= -1 && lower.bottom <= 0.4 * 440, JSON.stringify(lower));
  assert.deepEqual(await long(), before);
  await page.setViewport(phone);
  // A keyboard that covers the page is reported by the browser.
  await page.evaluate(() => {
    const seen = window.visualViewport;
    for (const [name, value] of Object.entries({ height: 440, offsetTop: 60 })) Object.defineProperty(seen, name, { value });
    seen.dispatchEvent(new Event('resize'));
  });
  await frames(page, 3);
  const { top, bottom } = await sight(page);
  assert.ok(top >= 59 && bottom <= 60 + 0.4 * 440, JSON.stringify([top, bottom]));
  await close();
});

for (const [at, [device, viewport]] of Object.entries({ phone, 'upright tablet': tablet }).entries()) test(`a tool wants the picture large, with its buttons below: ${device}`, firstEverywhere(at), async () => {
  const { page, problems, close } = await site.newPage(SMALL, { viewport });
  await digest(page);
  const large = (await sight(page)).width;
  for (const button of ['[data-tool=lines]', '#light-button']) {
    await inSight(page, button);
    assert.ok((await sight(page)).width < 0.8 * large);
    await press(page, button);
    await page.waitForFunction((width) => document.querySelector('#canvas').getBoundingClientRect().width === width, {}, large);
    const { top, bottom } = await sight(page);
    assert.ok(top >= 0 && bottom <= viewport.height);
    if (button === '#light-button') continue;
    const [bar, tools] = [await place(page, '#editor-bar'), await place(page, '#edit-tools')];
    assert.ok(bar.top >= bottom && tools.top >= bar.bottom && tools.top < viewport.height, JSON.stringify([bar, tools]));
    assert.ok(bar.height < 160, `the buttons take ${bar.height} pixels`);
    await press(page, button);
    await page.waitForSelector('#editor', { hidden: true });
  }
  assert.deepEqual(problems, []);
  await close();
});

for (const [at, [device, viewport]] of Object.entries({ phone, 'upright tablet': tablet }).entries()) {
  test(`language and help come first, presets before tools: ${device}`, firstEverywhere(at), async () => {
    const { page, close } = await site.newPage(SMALL, { viewport });
    await digest(page);
    const order = ['#about-button', '#canvas', '#rail', '#play', '#edit-tools', '#look-tools', '#caption', '#panel'];
    const tops = await page.$$eval(order.join(), (elements) => elements.map((element) => [element.id, element.getBoundingClientRect().top]));
    assert.deepEqual(tops.map(([id]) => `#${id}`), order, 'the order in the document');
    assert.deepEqual(tops, [...tops].sort(([, a], [, b]) => a - b), 'the order on the page');
    for (const selector of ['#language', '#theme', '#about-button', '#keys-button']) assert.ok((await place(page, selector)).bottom < 100, selector);
    assert.ok((await place(page, '#rail')).bottom < viewport.height, 'the presets are below the first screen');
    // The tools stand side by side.
    for (const box of ['.edit-tools', '.look-tools']) {
      const rows = await page.$$eval(`${box} > .key`, (buttons) => new Set(buttons.map((button) => button.getBoundingClientRect().top)).size);
      assert.ok(rows <= (viewport === phone ? 2 : 1), `${box} has ${rows} rows`);
    }
    await close();
  });
}

for (const [at, [kind, screens]] of Object.entries(KINDS).entries()) {
  test(`tools have words, on screens that are ${kind}`, firstEverywhere(at), async () => {
    await onEach(`${SMALL}&kind=ellipse&lines=0.2,0.5,0.8,0.5`, screens, async (page, where) => {
      if (await page.$eval('#more-tools', (button) => button.getAttribute('aria-expanded') === 'false')) await page.$eval('#more-tools', (button) => button.click());
      const words = await page.$$eval(':is(.edit-tools, .look-tools) .key', (buttons) =>
        buttons
          .filter((button) => button.getClientRects().length)
          .map((button) => {
            const [word, box] = [button.querySelector('.word'), button.getBoundingClientRect()];
            const { left, right, width, height } = word.getBoundingClientRect();
            return { text: word.textContent, fits: width > 8 && height > 10 && left >= box.left + 2 && right <= box.right - 2 };
          }),
      );
      assert.ok(words.length >= 19, `${words.length} tools`);
      assert.deepEqual(words.filter(({ fits }) => !fits), [], where);
    });
  });
}

test('rare tools come and go under More', async () => {
  const { page, problems, close } = await site.newPage(SMALL, { viewport: phone });
  await digest(page);
  const shown = () => page.$$eval('.edit-tools .key', (buttons) => buttons.filter((button) => button.getClientRects().length).map((button) => button.dataset.tool ?? button.id));
  const common = ['outline', 'road', 'hole', 'lines', 'strokes', 'text', 'import', 'more-tools'];
  assert.deepEqual(await shown(), common);
  // By keyboard: the arrow keys reach them, Escape closes them.
  await page.focus('[data-tool=outline]');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'more-tools');
  await page.keyboard.press('Enter');
  assert.deepEqual(await shown(), [...common, 'spots', 'export']);
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.tool), 'spots');
  await page.keyboard.press('Escape');
  assert.deepEqual(await shown(), common);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'more-tools');
  await tool(page, 'spots', true);
  assert.deepEqual(await shown(), common);
  assert.deepEqual(problems, []);
  await close();
});

/** The page's background, and the colour that the browser's own frame gets. @param {Page} page */
const colours = (page) =>
  page.evaluate(() => ({
    ground: getComputedStyle(document.body).backgroundColor,
    scheme: getComputedStyle(document.documentElement).colorScheme,
    told: [...document.querySelectorAll('meta[name=theme-color]')].filter(({ media }) => matchMedia(media || 'all').matches).map(({ content }) => content),
    pressed: document.querySelector('#theme').getAttribute('aria-pressed'),
  }));

const PAGES = {
  light: { ground: 'rgb(234, 229, 220)', scheme: 'light', told: ['#eae5dc'], pressed: 'false' },
  dark: { ground: 'rgb(25, 23, 21)', scheme: 'dark', told: ['#191715'], pressed: 'true' },
};

for (const [at, dark] of [true, false].entries()) {
  test(`the page is as the ${dark ? 'dark' : 'light'} system is, until it is switched`, firstEverywhere(at), async () => {
    const [own, other] = dark ? [PAGES.dark, PAGES.light] : [PAGES.light, PAGES.dark];
    const { page, problems, close } = await site.newPage(SMALL, { dark });
    await digest(page);
    assert.deepEqual(await colours(page), own);
    await click(page, '#theme');
    assert.deepEqual(await colours(page), other);
    // The first paint already has the colours.
    await page.evaluateOnNewDocument(() => {
      const look = () => {
        if (document.body) window.grounds = (window.grounds ?? new Set()).add(getComputedStyle(document.body).backgroundColor);
        requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
    await reloading(page, () => page.reload());
    await digest(page);
    assert.deepEqual(await page.evaluate(() => [...window.grounds]), [other.ground]);
    assert.deepEqual(await colours(page), other);
    await click(page, '#theme');
    assert.deepEqual(await colours(page), own);
    assert.equal(await page.evaluate(() => localStorage.getItem('bubblestone.theme')), '', 'the system is followed again');
    assert.deepEqual(problems, []);
    await close();
  });
}

/** The keys of the visible controls, and of those with sliders. @param {Page} page */
const controls = (page) =>
  page.$$eval('#controls .control', (elements) => {
    const shown = elements.filter((control) => control.getClientRects().length);
    const keys = (some) => some.map((control) => control.dataset.key);
    return { keys: keys(shown), sliders: keys(shown.filter((control) => control.querySelector('[type=range]'))) };
  });

test('Simple shows ten sliders, All the rest, and the choice is remembered', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&rim=0.4&gx=0.2`);
  await digest(page);
  const simple = await controls(page);
  assert.equal(simple.sliders.length, 10, String(simple.sliders));
  assert.deepEqual(simple.keys.filter((key) => !simple.sliders.includes(key)), ['outline', 'kind', 'stone', 'palette']);
  // Hidden parameters are in the page, and a button counts them.
  assert.match(await page.$eval('#rest', (button) => button.textContent), /3 more/);
  await click(page, '#rest');
  assert.equal(await page.evaluate(() => document.activeElement.value), 'all');
  await page.$$eval('details', (groups) => groups.forEach((details) => (details.open = true)));
  const every = await controls(page);
  const expected = await page.$$eval('#controls .control', (elements) => elements.filter((control) => !control.hidden).map((control) => control.dataset.key));
  assert.deepEqual(every.keys, expected);
  assert.ok(every.keys.length > 40 && simple.keys.every((key) => every.keys.includes(key)));
  assert.equal(await get(page, 'rim'), '0.4');
  await reloading(page, () => page.reload());
  await digest(page);
  assert.equal(await page.$eval('#extent :checked', (radio) => radio.value), 'all');
  assert.ok((await controls(page)).keys.includes('gx'));
  await click(page, '#extent [value=simple]');
  assert.deepEqual(await controls(page), simple);
  assert.deepEqual(problems, []);
  await close();
});

test('skin and lamps have ten sliders in Simple, too, and groups stand as they were left', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&stone=skin&light=point`);
  await digest(page);
  const { sliders } = await controls(page);
  assert.equal(sliders.length, 10, String(sliders));
  await all(page);
  const states = () => page.$$eval('.group', (groups) => groups.map(({ open }) => open));
  await page.$eval('.group:last-of-type', (details) => (details.open = true));
  const left = await states();
  assert.ok(left.includes(false));
  await click(page, '#extent [value=simple]');
  await all(page);
  assert.deepEqual(await states(), left);
  await close();
});
