import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { dist, open } from './harness.mjs';
import { click, digest, drop, frames, get, inSight, link, message, messages, reloading, SMALL, SQUARE } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('a break inside becomes a message with the recipe, and the page can start afresh', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&seed=77`);
  await digest(page);
  await page.evaluate(() => {
    performance.now = () => {
      throw new Error('The clock is broken.');
    };
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
  await assert.rejects(page.evaluate(() => window.bubblestone.digest()));
  assert.match(await page.$eval('[role=alert] a', (anchor) => anchor.href), /seed=77/);
  await reloading(page, () => click(page, '[role=alert] a'));
  await digest(page);
  assert.equal(await get(page, 'seed'), '77');
  await page.evaluate(() => {
    performance.now = () => {
      throw new Error('The clock is broken.');
    };
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  await reloading(page, () => click(page, '[role=alert] .actions button'));
  await digest(page);
  assert.match(await page.evaluate(() => window.bubblestone.link()), /palette=mossy/, 'the first picture of a visit');
  await close();
});

test('a trap in the module as it is sent becomes the same message', async () => {
  const { page, close } = await site.newPage(`${SMALL}&seed=77`);
  await digest(page);
  await page.evaluate(() => {
    // Nothing may call the studio while one of its calls runs, but this clock does, and such a call reads it.
    performance.now = () => Number(window.bubblestone.link());
  });
  await click(page, '#play');
  await message(page, 'alert', /mistake/);
  assert.match(await page.$eval('[role=alert] a', (anchor) => anchor.href), /seed=77/);
  await reloading(page, () => click(page, '[role=alert] a'));
  await digest(page);
  await close();
});

test('a browser without WebAssembly gets a sentence', async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: (fresh) => fresh.evaluateOnNewDocument(() => Object.defineProperty(window, 'WebAssembly', { value: undefined })),
  });
  await message(page, 'alert', /no WebAssembly/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
  await close();
});

for (const [language, words] of /** @type {const} */ ([['en', /^There is too little free memory .* close other tabs and load the page again/], ['ja', /^空きメモリーが足りず、.*ほかのタブを閉じて/]])) {
  test(`too little memory for the module is told as such: ${language}`, sameEverywhere, async () => {
    for (const error of ['RangeError', 'CompileError']) {
      const { page, close } = await site.newPage(SMALL, {
        before: (fresh) =>
          fresh.evaluateOnNewDocument(
            (name, chosen) => {
              localStorage.setItem('bubblestone.language', chosen);
              const what = 'WebAssembly.instantiate(): Out of memory: Cannot allocate Wasm memory for new instance';
              WebAssembly.instantiateStreaming = () => Promise.reject(name === 'RangeError' ? new RangeError(what) : new WebAssembly.CompileError(what));
            },
            error,
            language,
          ),
      });
      await message(page, 'alert', /\S/);
      assert.match((await messages(page)).join(), words);
      assert.equal(await page.evaluate(() => document.documentElement.dataset.stage), 'error');
      await close();
    }
  });
}

test('a page that cannot be stored works, and says nothing of it', async () => {
  /** @type {string[]} */
  const errors = [];
  let asked = () => {};
  const refused = new Promise((resolve) => (asked = () => resolve(undefined)));
  const { page, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      fresh.on('pageerror', (error) => errors.push(String(error)));
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (/offline/.test(request.url()) ? request.abort() : request.continue()));
      fresh.on('requestfailed', (request) => /offline/.test(request.url()) && asked());
    },
  });
  await refused;
  await digest(page);
  await frames(page, 5);
  assert.deepEqual(errors, []);
  assert.equal(await page.$('.message'), null);
  await close();
});

test('words that do not arrive leave the page in English, which says so once', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      await fresh.evaluateOnNewDocument(() => localStorage.setItem('bubblestone.language', 'ja'));
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (/\bja-.*\.js$/.test(request.url()) ? request.abort() : request.continue()));
    },
  });
  await digest(page);
  await message(page, 'status', /in English until it is loaded again/);
  assert.equal(await page.$$eval('.message', (notes) => notes.length), 1);
  assert.equal(await page.$eval('html', (html) => html.lang), 'en');
  assert.equal(await page.$eval('#share', (button) => button.checkVisibility({ visibilityProperty: true }) && button.textContent.trim()), 'Share');
  await close();
});

// A network that wants a sign-in first answers every request with a page.
for (const how of ['does not arrive', 'comes as a page to sign in']) {
  test(`a module that ${how} gets a sentence`, sameEverywhere, async () => {
    const { page, close } = await site.newPage(SMALL, {
      before: async (fresh) => {
        await fresh.setRequestInterception(true);
        const answer = { status: 200, contentType: 'text/html', body: '<!doctype html><title>Sign in</title>' };
        fresh.on('request', (request) => {
          if (!request.url().endsWith('.wasm')) void request.continue();
          else void (how === 'does not arrive' ? request.abort() : request.respond(answer));
        });
      },
    });
    await message(page, 'alert', /could not be loaded. Please check the connection/);
    await close();
  });
}

/**
 * A page whose requests for files of this kind fail while `lost.now` matches them; `lost.first` waits for the first one.
 * @param {string} fragment @param {RegExp} [now]
 */
async function losing(fragment, now = /^$/) {
  let tell = () => {};
  const lost = { now, first: new Promise((resolve) => (tell = () => resolve(undefined))) };
  const before = async (/** @type {import('puppeteer-core').Page} */ fresh) => {
    await fresh.setRequestInterception(true);
    fresh.on('request', (request) => (lost.now.test(request.url()) ? request.abort() : request.continue()));
    fresh.on('requestfailed', tell);
  };
  return { lost, ...(await site.newPage(fragment, { before })) };
}

test('a part that did not arrive is told, and the next press shows it with its styles', sameEverywhere, async () => {
  const { page, lost, close } = await losing(SMALL);
  await digest(page);
  const quiet = () => page.waitForFunction(() => !document.querySelector('[role=alert] .message'));
  lost.now = /assets\/(light|look)-/;
  await click(page, '#light-button');
  await message(page, 'alert', /could not be loaded/);
  await page.waitForSelector('#light-button[aria-pressed=false]');
  lost.now = /^$/;
  await click(page, '#light-button');
  await page.waitForSelector('.light-layer');
  assert.equal(await page.$eval('.light-layer', (layer) => getComputedStyle(layer).position), 'absolute');
  await quiet();
  lost.now = /assets\/ja-/;
  await page.select('#language', 'ja');
  await message(page, 'alert', /could not be loaded/);
  lost.now = /^$/;
  await page.select('#language', 'ja');
  await page.waitForFunction(() => document.documentElement.lang === 'ja');
  await quiet();
  await close();
});

test('a part that never arrives can be had by loading the page again, which keeps the work', sameEverywhere, async () => {
  const { page, lost, close } = await losing(`${SMALL}&seed=77`);
  await digest(page);
  lost.now = /assets\/(key-list|job\.worker)-/;
  await click(page, '#save');
  await click(page, '#save-svg');
  await message(page, 'status', /could not be made: This part of the page could not be loaded/);
  await click(page, '#keys-button');
  await message(page, 'alert', /could not be loaded/);
  lost.now = /^$/;
  await reloading(page, () => click(page, '[role=alert] .actions button'));
  await digest(page);
  assert.equal(await get(page, 'seed'), '77');
  await click(page, '#keys-button');
  await page.waitForSelector('#keys[open]');
  await close();
  const embedded = await losing(`?embed${SMALL}`, /assets\/embed-/);
  await message(embedded.page, 'alert', /could not be loaded/);
  await embedded.close();
});

test('a browser without workers and storing keeps the picture, and opens a model', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL, {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        const refuse = () => {
          throw new DOMException('The operation is insecure.', 'SecurityError');
        };
        // As in a closed frame, and where cookies are blocked.
        window.Worker = class extends EventTarget {
          constructor() {
            super();
            refuse();
          }
        };
        window.BroadcastChannel = window.Worker;
        IDBFactory.prototype.open = refuse;
      }),
  });
  await digest(page);
  await click(page, '#turn-button');
  await message(page, 'alert', /could not be loaded/);
  await page.waitForSelector('#turn-button[aria-pressed=false]');
  assert.equal(await page.$('.turn'), null);
  // Another part that arrives leaves the sentence where it is.
  await click(page, '#light-button');
  await page.waitForSelector('#light-sun', { visible: true });
  await frames(page, 5);
  assert.match((await messages(page)).join(), /could not be loaded/);
  await drop(page, 'wedge.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n', '');
  await message(page, 'status', /wedge\.obj could not be kept/);
  assert.equal(await get(page, 'form'), 'file');
  assert.deepEqual(problems, []);
  await close();
});

test('a storage that never answers is soon as good as none', sameEverywhere, async () => {
  const before = (/** @type {import('puppeteer-core').Page} */ fresh) =>
    fresh.evaluateOnNewDocument(() => {
      // As in some versions of Safari: the request neither succeeds nor fails.
      IDBFactory.prototype.open = () => /** @type {any} */ (new EventTarget());
    });
  const { page, problems, close } = await site.newPage(SMALL, { before });
  await digest(page);
  await drop(page, 'wedge.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n', '');
  await message(page, 'status', /wedge\.obj could not be kept/);
  assert.equal(await get(page, 'form'), 'file');
  await digest(page);
  for (const button of ['share', 'save']) {
    await click(page, `#${button}`);
    await page.waitForSelector(`#${button}-dialog[open]`);
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => !document.querySelector('dialog[open]'));
  }
  // A page that has not received the file asks for it.
  const other = await site.newPage(`#${await link(page)}`, { before });
  await other.page.waitForSelector('.asked');
  assert.deepEqual([problems, other.problems], [[], []]);
  await other.close();
  await close();
});

// Only Chromium's protocol drops files from the disk.
test('a dropped folder cannot be read, which a sentence tells', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const { x, y } = await inSight(page, '#sheet');
  const browser = await page.createCDPSession();
  const data = { items: [], files: [dist], dragOperationsMask: 1 };
  for (const type of /** @type {const} */ (['dragEnter', 'dragOver', 'drop'])) await browser.send('Input.dispatchDragEvent', { type, x: x + 50, y: y + 50, data });
  await message(page, 'alert', /could not be read, and nothing has changed/);
  assert.deepEqual(problems, []);
  await close();
});

test('a file that is dropped while a dialog is open closes it, and is opened', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  const before = await link(page);
  await click(page, '#save');
  await page.waitForSelector('#save-dialog[open]');
  await drop(page, 'shape.svg', '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100"><path d="M10 10H90V50H10Z"/></svg>', 'image/svg+xml');
  await page.waitForFunction((was) => window.bubblestone.link() !== was, {}, before);
  assert.equal(await page.$('dialog[open]'), null);
  assert.deepEqual(problems, []);
  await close();
});

/** Drags data over an element and drops it there, as the browser does. Returns which of these events the page takes. @param {import('puppeteer-core').Page} page @param {string} selector @param {Record<string, string>} data */
const dragged = (page, selector, data) =>
  page.$eval(
    selector,
    (place, content) => {
      const dataTransfer = new DataTransfer();
      for (const [type, text] of Object.entries(content)) dataTransfer.setData(type, text);
      return ['dragover', 'drop'].filter((type) => !place.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true })));
    },
    data,
  );

test('a link or a picture of another page that is dropped never replaces the page, and text goes where it can', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SQUARE);
  await digest(page);
  const both = ['dragover', 'drop'];
  const picture = { 'text/uri-list': 'https://example.org/a.png', 'text/html': '<img src="https://example.org/a.png">' };
  for (const place of ['#sheet', '#head', '#seed', '[data-key=cs] [type=range]']) assert.deepEqual(await dragged(page, place, picture), both, place);
  await message(page, 'alert', /Links and pictures of other pages cannot be opened here/);
  assert.equal(await page.$$eval('.message', (notes) => notes.length), 1);
  // The browser writes text into fields.
  assert.deepEqual(await dragged(page, '#seed', { 'text/plain': '12' }), []);
  const before = await link(page);
  assert.deepEqual(await dragged(page, '#sheet', { 'text/plain': 'some words' }), both);
  assert.equal(await link(page), before);
  assert.deepEqual(await dragged(page, '#sheet', { 'text/plain': 'M10 10H110V60H10Z' }), both);
  await page.waitForFunction((was) => window.bubblestone.link() !== was, {}, before);
  // Thumbnails of the page itself are no gifts.
  await page.$eval('.rail img', (image) => image.dispatchEvent(new DragEvent('dragstart', { bubbles: true })));
  const made = await link(page);
  assert.deepEqual(await dragged(page, '#sheet', { 'text/plain': 'M10 10H110V110H10Z' }), both);
  await page.$eval('.rail img', (image) => image.dispatchEvent(new DragEvent('dragend', { bubbles: true })));
  await frames(page, 5);
  assert.equal(await link(page), made);
  assert.deepEqual(problems, []);
  await close();
});

test('figures of a chapter work though its module did not arrive at the first one', sameEverywhere, async () => {
  const { page, lost, close } = await losing('learn/two-bubbles/', /\.wasm$/);
  await lost.first;
  lost.now = /^$/;
  // Figures that come near ask for it again.
  await page.waitForFunction(
    () => {
      const figures = [...document.querySelectorAll('figure[data-figure]')];
      const next = figures.findIndex((figure) => figure.getBoundingClientRect().top > innerHeight);
      figures[Math.max(0, next)].scrollIntoView({ behavior: 'instant' });
      return document.querySelector('figure[data-live]');
    },
    { polling: 200 },
  );
  await close();
});

test('two quick presses open one dialog', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await page.$eval('#save', (button) => {
    button.focus();
    button.click();
    button.click();
  });
  await page.waitForSelector('#save-dialog[open]');
  assert.equal(await page.$$eval('dialog[open]', (all) => all.length), 1);
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => !document.querySelector('#save-dialog'));
  assert.equal(await page.evaluate(() => document.activeElement.id), 'save');
  await close();
});
