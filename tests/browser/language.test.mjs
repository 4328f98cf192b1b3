import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { desk, low, open } from './harness.mjs';
import { all, BALL, BRICKS, canvas, digest, frames, get, messages, phone, PILE, set, SMALL } from './page.mjs';
import { turned } from './turned.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const words = (code) => JSON.parse(readFileSync(new URL(`../../www/strings/${code}.json`, import.meta.url), 'utf8'));
const english = words('en');
const japanese = words('ja');

before(async () => {
  site = await open();
});

after(() => site?.close());

/** A page in a browser that prefers Japanese. */
function inJapanese(fragment, options = {}) {
  return site.newPage(fragment, {
    ...options,
    before: (page) =>
      page.evaluateOnNewDocument(() => {
        Object.defineProperty(navigator, 'languages', { get: () => ['ja-JP', 'en'] });
        window.shifts = [];
        if (!PerformanceObserver.supportedEntryTypes.includes('layout-shift')) return;
        new PerformanceObserver((list) => window.shifts.push(...list.getEntries().map(({ value }) => value))).observe({ type: 'layout-shift', buffered: true });
      }),
  });
}

test('every word has its Japanese, with the same values in it', sameEverywhere, () => {
  const values = (text) => (text.match(/\{\w+\}/g) ?? []).sort();
  // Signs and names of formats are the same in both languages.
  const same = (text) => !/[a-z]{3}/.test(text.replace(/\{\w+\}|PNG|OBJ|GLB|SVG|GIF|JSON|Bubblestone/g, ''));
  // The last files are those of lazy parts, with both languages in one file.
  const parts = [...['page', 'words'].map((part) => [english[part], japanese[part]]), ...['take', 'look', 'turn', 'space', 'editor', 'keys'].map(words).map(({ en, ja }) => [en, ja])];
  for (const [en, ja] of parts) {
    assert.deepEqual(Object.keys(ja).sort(), Object.keys(en).sort());
    for (const [key, text] of Object.entries(en)) {
      const other = ja[key];
      assert.deepEqual(values(other), values(text), key);
      assert.ok(other !== text || same(text), `${key} is not translated: ${text}`);
    }
  }
});

for (const link of [SMALL, BALL, PILE, BRICKS]) {
  test(`every word of the module has its Japanese: ${link}`, sameEverywhere, async () => {
    const plain = await site.newPage(link);
    const { page, problems, close } = await inJapanese(link);
    const read = (of) => of.evaluate(() => ({ schema: window.bubblestone.schema, presets: window.bubblestone.presets }));
    await digest(plain.page);
    await digest(page);
    const [en, ja] = [await read(plain.page), await read(page)];
    en.schema.forEach((row, k) => {
      assert.notEqual(ja.schema[k].name, row.name, row.key);
      assert.notEqual(ja.schema[k].help, row.help, row.key);
      row.choices.forEach(({ word, label }, c) => {
        // Letters are the same in all languages.
        if (!/^[A-Z]$/.test(label)) assert.notEqual(ja.schema[k].choices[c].label, label, `${row.key}=${word}`);
      });
    });
    en.presets.forEach((preset, k) => {
      for (const what of ['title', 'note']) assert.notEqual(ja.presets[k][what], preset[what], preset.name);
    });
    for (const selector of ['.group summary span:first-child', '.rail h2 button']) {
      const texts = (of) => of.$$eval(selector, (all) => all.map((element) => element.textContent));
      const [before, now] = [await texts(plain.page), await texts(page)];
      assert.equal(now.length, before.length);
      now.forEach((text, at) => assert.notEqual(text, before[at]));
    }
    assert.deepEqual(problems, []);
    await plain.close();
    await close();
  });
}

test('a browser in Japanese gets a page in Japanese, which may be changed to English and back', async () => {
  const { page, problems, close } = await inJapanese(`${SMALL}&dr=0.7`);
  const before = await digest(page);
  const lang = () => page.$eval('html', (html) => html.lang);
  assert.equal(await lang(), 'ja');
  assert.equal(await page.title(), japanese.page.title);
  assert.equal(await page.$eval('#p-cs-name', (name) => name.firstChild.textContent.trim()), 'セルの大きさ');
  await set(page, 'cs', '10000');
  await frames(page, 2);
  assert.match((await messages(page)).join(), /セルの大きさ \(cs\)は2から\d+ pxまでの数（画像の一辺192 px）でなければなりません。/);
  await set(page, 'cs', '16');
  for (const [code, title] of [['en', english.page.title], ['ja', japanese.page.title]]) {
    await speak(page, code);
    assert.equal(await digest(page), before);
    assert.equal(await get(page, 'dr'), '0.7');
    assert.equal(await lang(), code);
    assert.equal(await page.title(), title);
  }
  assert.deepEqual(problems, []);
  await close();
});

/** Chooses a language, and waits for its words. */
async function speak(page, code) {
  await page.select('#language', code);
  const { title } = { en: english, ja: japanese }[code].page;
  await page.waitForFunction((wanted) => document.title === wanted, {}, title);
  await frames(page, 5);
}

/** All words of the page, apart from times and positions. Buttons of large pictures tell a time only if it is long. */
function wordsOn(page) {
  return page.evaluate(() => {
    const found = [];
    const add = (where, text) => text?.trim() && found.push(`${where} ${text.trim().replace(/[\d.]+/g, '#').replace(/(, about # (s|min)|、約#[秒分])$/, '')}`);
    for (const element of document.querySelectorAll('body *:not(#language, #language *, #live, #offline, #work)')) {
      // A choice is a list or a row of buttons, as its words allow.
      const where = element.id ? `#${element.id}` : ['option', 'span'].includes(element.localName) ? '' : `${element.localName}.${element.classList[0] ?? ''}`;
      for (const name of ['title', 'aria-label', 'aria-valuetext', 'placeholder', 'label']) add(`${where}[${name}]`, element.getAttribute(name));
      for (const node of element.childNodes) if (node.nodeType === Node.TEXT_NODE) add(where, node.data);
    }
    return found;
  });
}

/** The words of the page once they are the wanted ones, as the panel is built anew after a change; the last ones if that takes too long. */
async function wordsOnceThey(page, wanted) {
  let words = await wordsOn(page);
  for (let k = 0; k < 300 && words.join() !== wanted.join(); k++) {
    await frames(page, 3);
    words = await wordsOn(page);
  }
  return words;
}

for (const [link, part] of [[SMALL, '#layers-button'], [BALL, '#light-button'], [PILE, '#light-button'], [`${BRICKS}&camera=315,20,2.8,28,0,0.03`, '#light-button']]) {
  test(`a change of the language changes the words, all of them, and nothing else: ${link}`, link === SMALL ? {} : sameEverywhere, async () => {
    const open = async (newPage) => {
      const made = await newPage(link);
      const { page } = made;
      await digest(page);
      await page.waitForSelector('[data-key=cs], [data-key=cn], [data-key=c1], [data-key=building]');
      if (link !== SMALL) {
        await turned(page);
        // The body in the middle of the frame has a card, with words that look like others of the page.
        await page.click('#turn');
        await page.waitForSelector('.turn-card[data-picked]', { visible: true });
      }
      await page.$eval('#extent [value=all]', (radio) => radio.click());
      await page.$eval(part, (button) => button.click());
      await page.waitForSelector(part === '#layers-button' ? '#layers' : '.light-kinds');
      await page.$eval('#save', (button) => button.click());
      await page.waitForSelector('#save-dialog[open]');
      await frames(page, 5);
      return { ...made, words: await wordsOn(page) };
    };
    const viewport = link === SMALL ? desk : low;
    const plain = await open((at) => site.newPage(at, { viewport }));
    const other = await open((at) => inJapanese(at, { viewport }));
    for (const [{ page, problems, words: own }, there, codes] of [[plain, other, ['ja', 'en']], [other, plain, ['en', 'ja']]]) {
      const state = () => page.evaluate(() => JSON.stringify([window.bubblestone.status(), window.bubblestone.link(), location.hash, document.querySelector('#sheet').dataset.turn, document.querySelectorAll('dialog[open]').length]));
      const before = [await canvas(page), await digest(page), await state()];
      await page.evaluate(() => (window.stays = true));
      await speak(page, codes[0]);
      assert.deepEqual(await wordsOnceThey(page, there.words), there.words);
      await speak(page, codes[1]);
      assert.deepEqual(await wordsOnceThey(page, own), own);
      assert.deepEqual([await canvas(page), await digest(page), await state()], before);
      assert.ok(await page.evaluate(() => window.stays), 'the page was loaded again');
      assert.deepEqual(problems, []);
    }
    await plain.close();
    await other.close();
  });
}

test('the last of two languages chosen in a row counts, whichever words arrive first', sameEverywhere, async () => {
  /** The requests that are held back. @type {import('puppeteer-core').HTTPRequest[]} */
  const held = [];
  const { page, problems, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      await fresh.setRequestInterception(true);
      fresh.on('request', (request) => (/assets\/ja-surface-/.test(request.url()) ? held.push(request) : request.continue()));
    },
  });
  await digest(page);
  const save = () => page.$eval('#save', (button) => button.textContent.trim());
  const before = await save();
  const asked = page.waitForRequest((request) => /ja-surface-/.test(request.url()));
  await page.select('#language', 'ja');
  await asked;
  await page.select('#language', 'en');
  await page.waitForFunction(() => document.documentElement.lang === 'en');
  await held[0]?.continue();
  await page.evaluate((address) => import(address), held[0]?.url() ?? '');
  await frames(page, 2);
  assert.deepEqual([await page.$eval('html', ({ lang }) => lang), await page.$eval('#language', ({ value }) => value), await save()], ['en', 'en', before]);
  assert.deepEqual(problems, []);
  await close();
});

test('links that are wrong are answered in Japanese', sameEverywhere, async () => {
  const { page, close } = await inJapanese(`${SMALL}&v=99&kind=blob&outline=donut&foo=1&spots=0.5,0.5,9,1&hs=&poly=x&seed=1&seed=2`);
  await digest(page);
  const said = await page.$$eval('.message p, .message li', (all) => all.map((item) => item.textContent));
  assert.ok(said.length >= 6, String(said));
  for (const sentence of said) assert.match(sentence, /[ぁ-ん]/, sentence);
  // Notices name choices as the page does.
  assert.ok(said.includes('種類 (kind)は正方形 (square)、長方形 (rectangle)、円 (circle)、楕円 (ellipse)のどれかでなければなりません。"blob"が与えられたので、正方形 (square)にしました。'), String(said));
  assert.match(said.find((sentence) => sentence.includes('"donut"')), /輪 \(annulus\)、S字の道 \(road_s\)、/);
  await close();
});

for (const [name, viewport] of Object.entries({ desk, phone })) {
  test(`Japanese fits on a ${name}`, async () => {
    const { page, close } = await inJapanese(SMALL, { viewport });
    await digest(page);
    await frames(page, 5);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page is wider than the window');
    const cut = () =>
      page.$$eval('button, summary', (buttons) =>
        buttons.filter((button) => button.offsetParent && button.scrollWidth > button.clientWidth + 1).map((button) => button.textContent.trim()),
      );
    assert.deepEqual(await cut(), []);
    const shifts = await page.evaluate(() => window.shifts.reduce((sum, value) => sum + value, 0));
    assert.ok(shifts < 0.02, `layout shifts: ${shifts}`);
    await page.$eval('#more-tools', (button) => button.click());
    await all(page);
    assert.deepEqual(await cut(), []);
    await close();
  });
}
