// Actions and queries of the tests on an open page.
import assert from 'node:assert/strict';

/** @typedef {import('puppeteer-core').Page} Page */

/** A recipe that takes little time. */
export const SMALL = '#size=192&cs=16';

/** The same recipe with a square as its outline. */
export const SQUARE = `${SMALL}&outline=square`;

/** Some stones on a ball. */
export const BALL = '#v=1&make=surface&form=sphere&size=128&cn=60';

/** Some pebbles of one form on a small heap. */
export const PILE = '#v=1&make=pile&size=128&c1=pebble&variants=1&form=heap&ps=5';

/** A small block of some 150 bricks. */
export const BRICKS = '#v=1&make=masonry&building=block&block_length=8&block_width=8&block_height=8&size=128&pattern=bricks&ground=none';

/** A phone with one pixel for each of the layout: frames of bodies have a quarter of the usual number of pixels. */
export const phone = { width: 390, height: 844, isMobile: true, hasTouch: true };

/** Waits for the page's functions for scripts, which come when its panel is built. @param {Page} page */
async function furnished(page) {
  await page.waitForFunction(() => 'bubblestone' in window, { timeout: 240_000 });
}

/** The digest of the planes, once they are done. @param {Page} page @returns {Promise<string>} */
export async function digest(page) {
  await furnished(page);
  return page.evaluate(() => /** @type {any} */ (window).bubblestone.digest());
}

/** Waits for the finished picture, and for the panel. @param {Page} page */
export async function done(page) {
  await page.waitForFunction(() => document.documentElement.dataset.stage === 'done', { timeout: 240_000 });
  await furnished(page);
}

/** Waits for some frames. @param {Page} page @param {number} count */
export async function frames(page, count) {
  await page.evaluate(async (left) => {
    while (left-- > 0) await new Promise(requestAnimationFrame);
  }, count);
}

/**
 * Scrolls an element to the middle of the window, and waits until its box there is the same in three frames. An earlier
 * press might miss it, since the browser finds what lies at a place by the last drawn frame. Returns the box.
 * @param {Page} page @param {string} selector
 * @returns {Promise<{ x: number, y: number, width: number, height: number }>}
 */
export const inSight = (page, selector) =>
  page.$eval(selector, async (element) => {
    element.scrollIntoView({ block: 'center', behavior: 'instant' });
    let box = element.getBoundingClientRect();
    for (let same = 0; same < 3; ) {
      await new Promise(requestAnimationFrame);
      const now = element.getBoundingClientRect();
      same = now.x === box.x && now.y === box.y && now.width === box.width && now.height === box.height ? same + 1 : 0;
      box = now;
    }
    return { x: box.x, y: box.y, width: box.width, height: box.height };
  });

/** Gives the page another size, and waits for its layout. @param {Page} page @param {import('puppeteer-core').Viewport} viewport */
export async function resize(page, viewport) {
  await page.setViewport(viewport);
  await page.waitForFunction((width, height) => innerWidth === width && innerHeight === height, {}, viewport.width, viewport.height);
  await frames(page, 2);
}

/** A hash of the canvas, and its number of colours. @param {Page} page */
export function canvas(page) {
  return page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('#canvas'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    const pixels = new Uint32Array(data.buffer);
    let hash = 2166136261;
    for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 16777619) >>> 0;
    return { hash, colours: new Set(pixels).size, side: canvas.width };
  });
}

/** The value of a parameter. @param {Page} page @param {string} key @returns {Promise<string>} */
export async function get(page, key) {
  await furnished(page);
  return page.evaluate((name) => /** @type {any} */ (window).bubblestone.get(name), key);
}

/** The recipe's link. @param {Page} page @returns {Promise<string>} */
export async function link(page) {
  await furnished(page);
  return page.evaluate(() => /** @type {any} */ (window).bubblestone.link());
}

/**
 * Does something that reloads the page, and waits for the load. Changing the address alone does not load it.
 * @param {Page} page
 * @param {() => Promise<unknown>} act
 */
export async function reloading(page, act) {
  const loaded = new Promise((resolve) => page.once('load', resolve));
  await act();
  await loaded;
}

/** The number of packing steps. @param {Page} page @returns {Promise<number>} */
export async function steps(page) {
  await furnished(page);
  return page.evaluate(() => /** @type {any} */ (window).bubblestone.status().steps);
}

/** Shows all parameters in the panel. @param {Page} page */
export async function all(page) {
  await page.$eval('#extent [value=all]', (radio) => /** @type {HTMLElement} */ (radio).click());
}

/** Shows all parameters if the control of this one is not a simple one. @param {Page} page @param {string} key */
async function reveal(page, key) {
  const hidden = await page.$eval(`[data-key="${key}"]`, (control) => /** @type {HTMLElement} */ (control).hidden);
  if (hidden) await all(page);
}

/**
 * Sets a parameter through its control.
 * @param {Page} page
 * @param {string} key
 * @param {string} value
 */
export async function set(page, key, value) {
  if (key !== 'seed') await reveal(page, key);
  const found = await page.evaluate((name, text) => {
    const box = name === 'seed' ? document.querySelector('#seed') : document.querySelector(`[data-key="${name}"]`);
    const changed = (element) => element.dispatchEvent(new Event('change', { bubbles: true }));
    if (!box) return false;
    const radio = /** @type {HTMLElement | null} */ (box.querySelector(`[type=radio][value="${text}"]`));
    const field = /** @type {HTMLInputElement} */ (box.matches('input') ? box : box.querySelector('select, [type=number], [type=text]'));
    if (radio) radio.click();
    else {
      field.value = text;
      changed(field);
    }
    return true;
  }, key, value);
  assert.ok(found, `no control for ${key}`);
}

/**
 * The texts of all messages except the one that the site is stored, which may come at any time.
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
export function messages(page) {
  return page.$$eval('.message:not([data-topic=offline])', (notes) => notes.map((note) => note.textContent));
}

/**
 * Waits for a message with this role and these words.
 * @param {Page} page
 * @param {'alert' | 'status'} role
 * @param {RegExp} words
 */
export async function message(page, role, words) {
  await page.waitForFunction(
    (wanted, source, flags) =>
      [...document.querySelectorAll(`[role=${wanted}] .message`)].some((note) => new RegExp(source, flags).test(note.textContent)),
    { timeout: 60_000 },
    role,
    words.source,
    words.flags,
  );
}

/** Chooses a tool of the editor by mouse or finger. @param {Page} page @param {string} name @param {boolean} [finger] */
export async function tool(page, name, finger = false) {
  const button = `[data-tool=${name}]`;
  const folded = await page.$eval(button, (element) => element.closest('.rare') !== null && !element.getClientRects().length);
  if (folded) await click(page, '#more-tools');
  await page.$eval(button, (element) => element.scrollIntoView({ block: 'nearest', inline: 'center', behavior: 'instant' }));
  if (!finger) await click(page, button);
  else {
    await inSight(page, button);
    await page.tap(button);
  }
  await page.waitForSelector('#editor:not([hidden]), dialog[open]');
}

/**
 * Clicks an element once it is laid out and enabled. Under load, the page builds its parts a little later.
 * @param {Page} page
 * @param {string} selector
 * @param {import('puppeteer-core').ClickOptions} [options]
 */
export function click(page, selector, options) {
  return page.locator(selector).setWaitForStableBoundingBox(false).setTimeout(60_000).click(options);
}

/**
 * Drops a file on the sheet.
 * @param {Page} page
 * @param {string} name
 * @param {string | Uint8Array} content
 * @param {string} type
 */
export async function drop(page, name, content, type) {
  await page.evaluate(
    (called, base64, kind) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], called, { type: kind }));
      const sheet = /** @type {Element} */ (document.querySelector('#sheet'));
      sheet.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
    },
    name,
    Buffer.from(content).toString('base64'),
    type,
  );
}

/** Chooses this file in the next file dialog. @param {Page} page @param {string} name @param {string} content */
export function chooses(page, name, content) {
  return page.evaluate(
    (called, text) => {
      HTMLInputElement.prototype.click = function () {
        const data = new DataTransfer();
        data.items.add(new File([text], called));
        this.files = data.files;
        this.dispatchEvent(new Event('change'));
      };
    },
    name,
    content,
  );
}

/**
 * Opens a list over the canvas by its control in the panel. The editor is loaded first.
 * @param {Page} page
 * @param {string} key
 */
export async function edit(page, key) {
  await reveal(page, key);
  await page.$eval(`#p-${key}`, (button) => {
    /** @type {HTMLDetailsElement} */ (button.closest('details')).open = true;
    /** @type {HTMLElement} */ (button).click();
  });
  await page.waitForSelector('#editor:not([hidden])');
  await frames(page, 2);
}

/** Gives text to the import's dialog, and waits until it is taken or refused. @param {Page} page @param {string} text */
export async function bring(page, text) {
  await begin(page, text);
  await read(page);
}

/** Gives text to the import's dialog without waiting for the end. @param {Page} page @param {string} text */
export async function begin(page, text) {
  await tool(page, 'import');
  await page.waitForSelector('#outline-text');
  await page.$eval(
    '#outline-text',
    (box, value) => {
      /** @type {HTMLTextAreaElement} */ (box).value = value;
      box.dispatchEvent(new Event('input', { bubbles: true }));
    },
    text,
  );
  await unread(page);
  await click(page, '#take-text');
}

/** Lets `read` wait for the end of the next reading: the end of its worker, or a message instead. @param {Page} page */
export function unread(page) {
  return page.evaluate(() => {
    const all = /** @type {any} */ (window);
    const end = (all.end ??= Worker.prototype.terminate);
    Worker.prototype.terminate = function () {
      all.ended = true;
      end.call(this);
    };
    all.ended = false;
    for (const note of document.querySelectorAll('.message')) note.setAttribute('data-old', '');
  });
}

/** @param {Page} page */
export async function read(page) {
  await page.waitForFunction(() => /** @type {any} */ (window).ended || document.querySelector('[role=alert] .message:not([data-old])'), { timeout: 120_000, polling: 100 });
  await frames(page, 3);
}

/** The places of the handles on the screen. @param {Page} page @returns {Promise<number[][]>} */
export function handles(page) {
  return page.$$eval('button.handle', (all) =>
    all.map((handle) => {
      const box = handle.getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    }),
  );
}

/** The outline as the export writes it. @param {Page} page @param {string} kind @returns {Promise<string>} */
export async function exported(page, kind) {
  await page.evaluate(() => {
    const create = (/** @type {any} */ (window).create ??= URL.createObjectURL);
    URL.createObjectURL = (blob) => {
      void /** @type {Blob} */ (blob).text().then((text) => (/** @type {any} */ (window).saved = text));
      return create(blob);
    };
    HTMLAnchorElement.prototype.click = function () {};
    /** @type {any} */ (window).saved = undefined;
  });
  await tool(page, 'export');
  await click(page, `#export-${kind}`);
  await page.waitForFunction(() => /** @type {any} */ (window).saved);
  return page.evaluate(() => /** @type {any} */ (window).saved);
}

/** The outline's rings in sides of the picture. @param {Page} page @returns {Promise<[number, number][][]>} */
export async function rings(page) {
  const { size, rings: found } = JSON.parse(await exported(page, 'json'));
  return found.map((ring) => ring.map(([x, y]) => [x / size[0], y / size[1]]));
}
