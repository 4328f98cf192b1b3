// The pages of the chapters in a browser: without scripts, without a connection, in both languages, on paper, in class.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { host } from '../../scripts/lib/host.mjs';
import { chapters } from '../../www/learn/chapters/contents.mjs';
import { kind, sameEverywhere } from './browsers.mjs';
import { desk, dist, open } from './harness.mjs';
import { at, follow, seek } from './lesson.mjs';
import { digest, frames, phone, resize, SMALL } from './page.mjs';
import { longestTask } from './tasks.mjs';
import { badInClass, badWords, walkByTab, watchMemory, watchShifts } from './walks.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const CHAPTERS = ['learn/two-bubbles/', 'learn/ja/two-bubbles/'];
const PLACES = ['', 'glossary/', 'guide/', 'papers/', ...chapters.flatMap(({ name }) => [`${name}/`, `${name}/sheet/`])];
const PAGES = PLACES.flatMap((place) => [`learn/${place}`, `learn/ja/${place}`]);

/** One page of each kind in each language: Firefox opens only these. */
const KINDS = ['', 'glossary/', 'guide/', 'papers/', 'two-bubbles/', 'two-bubbles/sheet/'].flatMap((place) => [`learn/${place}`, `learn/ja/${place}`]);

/** Each chapter once, by turns in English and in Japanese: its parts are the same in both (tests/node/learn.test.mjs). */
const BY_TURNS = chapters.map((chapter, k) => ({ ...chapter, path: `learn/${k % 2 ? 'ja/' : ''}${chapter.name}/` }));

/** The names of a chapter's figures. */
const figuresOf = ({ blocks }) => blocks.flatMap(({ figure, kind: part }) => (figure && part !== 'mark' ? [figure] : []));

/** The number of figures in a chapter, and of replies in its text. */
const partsOf = ({ blocks }) => ({
  figures: figuresOf({ blocks }).length,
  replies: blocks.flatMap(({ answers = [] }) => answers.filter(({ reply }) => reply)).length,
});

const CHAPTER_PATHS = new Set(chapters.flatMap(({ name }) => [`learn/${name}/`, `learn/ja/${name}/`]));

/** The state of a figure in an address. */
const STATE = '#fig=pair&outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&fend=0&mend=0&most=1000&given=0.25,0.5,1;0.45,0.5,0&damp=0.5&move=rk4&dt=0.1&step=3';

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Waits until all scenes are there and the scripts have begun. They show the buttons that are useless without them. */
const begun = (page) => page.waitForSelector('html:not([data-opening]) #theme:not([hidden])');

/** Texts that are cut off, or stick out of the window. A formula may scroll in its own box. */
const lost = (page) =>
  page.evaluate(() => {
    const found = [];
    if (document.documentElement.scrollWidth > innerWidth) found.push(`the page is ${document.documentElement.scrollWidth} wide`);
    for (const element of document.querySelectorAll('main :is(p, h1, h2, h3, li, label, figcaption, dt, dd, th, td, button)')) {
      if (!element.checkVisibility() || element.closest('.equation')) continue;
      const { left, right, height } = element.getBoundingClientRect();
      const isCut = element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).overflowX !== 'visible';
      if (left < -1 || right > innerWidth + 1 || isCut || height === 0) found.push(`${element.localName}: ${element.textContent.trim().slice(0, 40)} ${Math.round(left)} to ${Math.round(right)}`);
    }
    return found;
  });

for (const chapter of BY_TURNS) {
  const { path } = chapter;
  test(`without scripts the text and the pictures are whole: ${path}`, sameEverywhere, async () => {
    const { page, problems, close } = await site.newPage(path, { before: (fresh) => fresh.setJavaScriptEnabled(false) });
    await page.setJavaScriptEnabled(true);
    const seen = await page.evaluate(() => ({
      text: document.querySelector('main').innerText,
      pictures: [...document.querySelectorAll('figure')].map((figure) => [...figure.querySelectorAll('svg.plate, .figure-stage svg')].filter((svg) => svg.getBoundingClientRect().width > 200).length),
      formulas: [...document.querySelectorAll('math')].every((formula) => formula.getBoundingClientRect().width > 0),
      tools: [...document.querySelectorAll('.head button')].some((button) => button.checkVisibility({ visibilityProperty: true })),
    }));
    assert.ok(seen.text.length > (path.includes('/ja/') ? 1000 : 2500), `${seen.text.length}`);
    assert.equal(seen.pictures.length, partsOf(chapter).figures);
    assert.ok(seen.pictures.every((count) => count > 0), String(seen.pictures));
    assert.ok(seen.formulas);
    assert.equal(seen.tools, false, 'a button is shown that can do nothing');
    assert.deepEqual(problems, []);
    await close();
  });
}

/** Faults that axe finds on a page with all handles of its figures. */
async function faults(page) {
  await page.$$eval('figure details', (folds) => folds.forEach((fold) => fold.setAttribute('open', '')));
  await page.evaluate(axe);
  const found = await page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { resultTypes: ['violations'], runOnly: { type: 'tag', values: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] } });
    return violations.flatMap(({ id, nodes }) => nodes.map(({ html, any }) => `${id}: ${html.slice(0, 140)} ${any.map(({ message }) => message).join(' ')}`));
  });
  await page.$$eval('figure details', (folds) => folds.forEach((fold) => fold.removeAttribute('open')));
  return found;
}

/** Checks that a page loses nothing at a width of 390 px, nor with text of 200 %. */
async function losesNothing(page, path) {
  // The viewport is not that of a touch screen, as changing to touch would load the page again.
  await page.setViewport({ width: phone.width, height: phone.height });
  await frames(page, 2);
  assert.deepEqual(await lost(page), [], `${path} on a phone`);
  await page.setViewport(desk);
  await page.evaluate(() => document.documentElement.style.setProperty('font-size', '200%'));
  await frames(page, 2);
  assert.deepEqual(await lost(page), [], `${path} at 200 %`);
  await page.setViewport({ width: phone.width, height: phone.height });
  await frames(page, 2);
  assert.deepEqual(await lost(page), [], `${path} on a phone at 200 %`);
}

test('each page opens without an error, asks nobody else, is accessible and loses nothing', async () => {
  const { page, problems, external, close } = await site.newPage(PAGES[0]);
  for (const [k, path] of (kind === 'chromium' ? PAGES : KINDS).entries()) {
    // Each place is checked once, by turns in both languages, light and dark: its elements are the same in both.
    const place = k >> 1;
    const isChecked = k % 2 === place % 2;
    if (kind === 'chromium') {
      await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: (place >> 1) % 2 ? 'dark' : 'light' }]);
      await page.setViewport(desk);
    }
    await page.goto(site.address + path, { waitUntil: 'load' });
    await begun(page);
    if (kind === 'chromium') {
      // The sheets of all chapters are made alike, so one is checked.
      if (isChecked && !/(?<!two-bubbles)\/sheet\/$/.test(path)) assert.deepEqual(await faults(page), [], path);
      if (isChecked && CHAPTER_PATHS.has(path)) assert.deepEqual(await walkByTab(page), [], path);
      await losesNothing(page, path);
    }
    assert.deepEqual([problems, external], [[], []], path);
  }
  await close();
});

test('on a small phone the tools of a page stand beside its name', sameEverywhere, async () => {
  for (const path of CHAPTERS) {
    const { page, close } = await site.newPage(path, { viewport: { ...phone, width: 360, height: 640 } });
    await begun(page);
    const [name, ...tools] = await page.$$eval('.home, .tools > *', (all) => all.map((one) => one.getBoundingClientRect().toJSON()));
    assert.ok(tools.length >= 4 && tools.every(({ top, bottom, left }) => top < name.bottom && bottom > name.top && left >= name.right), `${path} ${JSON.stringify([name, ...tools])}`);
    await close();
  }
});

/** Plays a figure for an eighth of its run, from its start on, and pauses it. */
async function plays(page, figure) {
  if (!(await page.$(`${figure} [data-do="play"]`))) return;
  await page.select(`${figure} select.speed`, '4');
  await seek(page, figure, 0);
  await page.$eval(`${figure} [data-do="play"]`, (button) => button.click());
  await page.waitForFunction((selector) => Number(document.querySelector(selector).dataset.step) >= document.querySelector(`${selector} input.time`).max / 8, {}, figure);
  // It may have come to its end by itself.
  await page.$$eval(`${figure} [data-do="play"]:has(.icon-pause)`, (buttons) => buttons.forEach((button) => button.click()));
  await page.waitForSelector(`${figure} [data-do="play"]:has(.icon-play)`);
}

/** Presses a key on every slider and every grip of a figure, and waits for another value. */
async function hasKeys(page, figure) {
  await page.$$eval(`${figure} details`, (folds) => folds.forEach((fold) => fold.setAttribute('open', '')));
  for (const slider of await page.$$(`${figure} :is(.grip, .handle input[type="range"])`)) {
    await slider.focus();
    const [said, isLast] = await slider.evaluate((element) => [element.ariaValueText, element.localName === 'input' && element.value === element.max]);
    await page.keyboard.press(isLast ? 'ArrowLeft' : 'ArrowRight');
    await page.waitForFunction((element, before) => element === document.activeElement && element.ariaValueText !== before, {}, slider, said);
  }
}

/** The most memory that the module may have at the end of a chapter, in bytes. */
const MOST_MEMORY = 64 * 2 ** 20;

for (const chapter of BY_TURNS) {
  test(`figures begin without a shift, run in short tasks and little memory, and have keys: ${chapter.path}`, sameEverywhere, async () => {
    const before = async (page) => {
      await watchShifts(page);
      await watchMemory(page);
    };
    // The contents in the same language come before, as for a reader: they make its fonts ready.
    const contents = chapter.path.replace(`${chapter.name}/`, '');
    const { page, close } = await site.newPage(contents, { before });
    let shifts = ['not measured'];
    const walk = async () => {
      await page.goto(site.address + chapter.path, { waitUntil: 'load' });
      for (const name of figuresOf(chapter)) await at(page, name);
      shifts = await page.evaluate(() => window.shifts);
      for (const name of figuresOf(chapter)) {
        const figure = await at(page, name);
        await plays(page, figure);
        await hasKeys(page, figure);
      }
    };
    const runs = [];
    // Tasks take longer while other programs use the caches.
    while (runs.length < 4 && !(runs.at(-1) < 1)) {
      if (runs.length) await page.goto(site.address + contents, { waitUntil: 'load' });
      runs.push(await longestTask(page, walk));
    }
    assert.deepEqual(shifts, []);
    assert.ok(runs.at(-1) < 1, `tasks of ${runs.join(', ')} times 50 ms`);
    const sizes = await page.evaluate(() => window.memories.map(({ buffer }) => buffer.byteLength));
    assert.ok(sizes.length > 0 && sizes.every((size) => size <= MOST_MEMORY), String(sizes));
    await close();
  });
}

test('nothing jumps while a chapter comes in pieces', sameEverywhere, async (t) => {
  const own = await open({ serve: () => host(dist, { inPieces: true }) });
  t.after(() => own.close());
  const { page, close } = await own.newPage('learn/ja/squares/', { before: watchShifts });
  await begun(page);
  await frames(page, 3);
  assert.deepEqual(await page.evaluate(() => window.shifts), []);
  // The heads of arrows have nothing to wait for.
  assert.deepEqual(await page.$$eval('[data-open]', (all) => [...new Set(all.map(({ localName }) => localName))]), ['header', 'section']);
  await close();
});

test('after a visit to the studio all pages open without a host', async (t) => {
  const own = await open();
  t.after(() => own.close());
  const { page, problems, close } = await own.newPage(SMALL, { stores: true });
  await page.waitForFunction(() => document.documentElement.dataset.offline === 'stored', { timeout: 120_000 });
  own.stop();
  const answers = await page.evaluate((addresses) => Promise.all(addresses.map(async (address) => (await fetch(address)).ok)), PAGES.map((path) => own.address + path));
  assert.ok(answers.every(Boolean), String(answers));
  for (const path of BY_TURNS.map((chapter) => chapter.path)) {
    await page.goto(own.address + path, { waitUntil: 'load' });
    await begun(page);
    assert.equal(await page.$eval('link[rel=stylesheet]', (link) => link.sheet.cssRules.length > 50), true, path);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('a visit to a chapter stores the site, too', sameEverywhere, async (t) => {
  const own = await open();
  t.after(() => own.close());
  const { page, close } = await own.newPage(CHAPTERS[0], { stores: true });
  await page.waitForFunction(() => document.documentElement.dataset.offline === 'stored', { timeout: 120_000 });
  own.stop();
  await page.goto(own.address + CHAPTERS[1], { waitUntil: 'load' });
  await begun(page);
  await close();
});

test('the other language opens with the same state', async () => {
  const { page, close } = await site.newPage(CHAPTERS[0] + STATE);
  await begun(page);
  const fragment = await page.evaluate(() => location.hash);
  await page.evaluate(() => ['made', 'broken'].forEach((key) => document.querySelector(`[data-ask="${key}"] input[value="c"]`).click()));
  await Promise.all([page.waitForNavigation({ waitUntil: 'load' }), page.evaluate(() => document.querySelector('#language').click())]);
  await begun(page);
  // The answers come along, and leave the address.
  assert.deepEqual(await page.$$eval('[data-ask] input:checked', (all) => all.map((input) => `${input.closest('[data-ask]').dataset.ask} ${input.value}`)), ['made c', 'broken c']);
  assert.equal(await page.$$eval('details.answers[open] [data-chosen]', (all) => all.length), 1);
  assert.equal(await page.evaluate(() => location.pathname.split('/').slice(-4).join('/')), 'learn/ja/two-bubbles/');
  assert.equal(decodeURIComponent(await page.evaluate(() => location.hash)), decodeURIComponent(fragment));
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'ja');

  // A class goes on at its screen, which need not be that of the state.
  const screen = () => page.evaluate(() => [document.documentElement.dataset.part, [...document.querySelectorAll('.scene')].findIndex((scene) => scene.hasAttribute('data-now'))].join(' '));
  await page.evaluate(() => {
    document.querySelector('#class').click();
    for (let k = 0; k < 4; k += 1) document.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
  });
  const there = await screen();
  // So do the hands that were counted there.
  await page.$eval('[data-ask=far] label:has([value=b]) + .hands', (box) => (box.value = '12'));
  await Promise.all([page.waitForNavigation({ waitUntil: 'load' }), page.evaluate(() => document.querySelector('#language').click())]);
  await page.waitForSelector('[data-class]');
  assert.deepEqual([await screen(), await page.$eval('#class', (button) => button.ariaPressed)], [there, 'true']);
  const hands = (shown) => shown.$$eval('.hands', (boxes) => boxes.map(({ value }) => value).filter(Boolean));
  assert.deepEqual([await hands(page), await page.$eval('[data-ask=far] label:has([value=b]) + .hands', ({ value }) => value)], [['12'], '12']);
  assert.equal(decodeURIComponent(await page.evaluate(() => location.hash)), decodeURIComponent(fragment));
  // Without a class, the other language is an ordinary page.
  await page.keyboard.press('Escape');
  await Promise.all([page.waitForNavigation({ waitUntil: 'load' }), page.evaluate(() => document.querySelector('#language').click())]);
  await begun(page);
  assert.equal(await page.evaluate(() => document.documentElement.hasAttribute('data-class')), false);
  await close();

  const made = await site.newPage(`${CHAPTERS[0]}#hands=far.a.7,far.b.999,far.c.-1,made.a.1e1,made.b.,made.c.%3Cb%3E,none.a.5`);
  await begun(made.page);
  assert.deepEqual([await hands(made.page), await made.page.evaluate(() => location.hash)], [['7'], '']);
  assert.deepEqual(made.problems, []);
  await made.close();
});

test('the studio leads to the chapters in its language', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  const addresses = () => page.evaluate(() => ['#learn', '[data-preset=bubbles] + a', '[data-preset=whirl] + a'].map((link) => document.querySelector(link).getAttribute('href')));
  assert.deepEqual(await addresses(), ['learn/', 'learn/two-bubbles/', 'learn/squares/']);
  await page.select('#language', 'ja');
  await page.waitForFunction(() => document.querySelector('#learn').textContent === '学ぶ');
  assert.deepEqual(await addresses(), ['learn/ja/', 'learn/ja/two-bubbles/', 'learn/ja/squares/']);
  await page.select('#language', 'en');
  await page.waitForFunction(() => document.querySelector('#learn').textContent === 'Learn');
  assert.deepEqual(await addresses(), ['learn/', 'learn/two-bubbles/', 'learn/squares/']);
  await close();
});

test('a page that the browser kept takes the theme that was chosen on the next one', sameEverywhere, async () => {
  const { page, close } = await site.newPage('learn/');
  await begun(page);
  const themes = await page.evaluate(() => {
    // Another page of the same tab stores its choice, and the way back shows this one as it was left.
    localStorage.setItem('bubblestone.theme', 'dark');
    return [false, true].map((persisted) => {
      dispatchEvent(new PageTransitionEvent('pageshow', { persisted }));
      return `${document.documentElement.dataset.theme} ${document.querySelector('#theme').ariaPressed}`;
    });
  });
  assert.deepEqual(themes, ['light false', 'dark true']);
  // The next press begins at the theme that is shown.
  await page.$eval('#theme', (button) => button.click());
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
  await close();
});

/** The windows of a class. */
const projector = { width: 1024, height: 768 };
const tiny = { width: 640, height: 480 };
const small = { width: 800, height: 600 };
const wide = { width: 1920, height: 1080 };

test('on paper a chapter has every figure and every answer, and no handles', sameEverywhere, async () => {
  const { page, close } = await site.newPage('learn/', { dark: true });
  for (const chapter of BY_TURNS) {
    await page.emulateMediaType('screen');
    await page.goto(site.address + chapter.path, { waitUntil: 'load' });
    await begun(page);
    await page.emulateMediaType('print');
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const seen = await page.evaluate(() => ({
      figures: [...document.querySelectorAll('figure')].filter((figure) => figure.querySelector('svg.plate').checkVisibility()).length,
      replies: [...document.querySelectorAll('[data-reply]')].filter((reply) => reply.checkVisibility() && reply.getBoundingClientRect().height > 0).length,
      arrows: [...document.querySelectorAll('figure .arrow path')].every((part) => part.checkVisibility()),
      tools: [...document.querySelectorAll('body > .head, .figure-tools, .ask input')].filter((tool) => tool.checkVisibility()).length,
      ground: getComputedStyle(document.body).backgroundColor,
    }));
    assert.deepEqual(seen, { ...partsOf(chapter), arrows: true, tools: 0, ground: 'rgb(255, 255, 255)' });
    const inks = await page.evaluate(() =>
      ['dark', 'light'].map((theme) => {
        document.documentElement.dataset.theme = theme;
        const parts = [...document.querySelectorAll('figure svg.plate *')].map((part) => getComputedStyle(part));
        return [...new Set(parts.map(({ fill, stroke }) => `${fill} ${stroke}`))];
      }),
    );
    assert.ok((inks[0]?.length ?? 0) > 3);
    assert.deepEqual(inks[0], inks[1], `${chapter.path}: colours of a dark page on paper`);
  }
  await close();
});

test('after printing, the answers are folded again that the reader had not opened', sameEverywhere, async () => {
  const { page, close } = await site.newPage('learn/two-bubbles/');
  await begun(page);
  await page.evaluate(() => document.querySelector('.chapter')?.insertAdjacentHTML('beforeend', '<details class="answers" open></details>'));
  const opened = (/** @type {string} */ event) =>
    page.evaluate((name) => {
      dispatchEvent(new Event(name));
      return [...document.querySelectorAll('details.answers')].map((fold) => fold.open);
    }, event);
  assert.deepEqual(await opened('beforeprint'), [true, true]);
  assert.deepEqual(await opened('afterprint'), [false, true]);
  await close();
});

/** The parts of a page that print has, in pixels: 10 mm are left free on each side. */
const A4 = { width: 718, height: 1047 };
const LETTER = { width: 740, height: 980 };

/**
 * Words in plates that are cut, or smaller on paper than 6.5 points. Indices may be smaller. Runs in the page.
 * @param {Element[]} plates
 */
function badLetters(plates) {
  return plates.flatMap((plate) => {
    const { left, right, top, bottom, width } = plate.getBoundingClientRect();
    const shown = [...plate.querySelectorAll('text')].filter((text) => text.checkVisibility());
    return shown.flatMap((text) => {
      const own = text.getBoundingClientRect();
      const points = ((parseFloat(getComputedStyle(text).fontSize) * width) / 400) * 0.75;
      const isWhole = own.left > left - 1 && own.right < right + 1 && own.top > top - 1 && own.bottom < bottom + 1;
      return isWhole && points > 6.5 ? [] : [`${text.textContent}: ${points.toFixed(1)} pt, ${[own.left - left, right - own.right, own.top - top, bottom - own.bottom].map(Math.round)}`];
    });
  });
}

/** The number of pages of a height for these parts, if none of them is cut. @param {number[]} parts @param {number} height */
function pagesOf(parts, height) {
  const ends = [0];
  for (const part of parts) {
    const end = (ends.at(-1) ?? 0) + part;
    if (end > height) ends.push(part);
    else ends[ends.length - 1] = end;
  }
  return ends.length;
}

test('each sheet to print has two pages, on A4 and on Letter, and on them each question with its sentence, its pictures and its lines, uncut, as the parts of the guide', sameEverywhere, async () => {
  const { page, close } = await site.newPage('learn/');
  await page.emulateMediaType('print');
  for (const { name, blocks } of chapters) {
    for (const language of ['en', 'ja']) {
      await page.setViewport(A4);
      await page.goto(`${site.address}learn/${language === 'ja' ? 'ja/' : ''}${name}/sheet/`, { waitUntil: 'load' });
      const seen = await page.$$eval('.asked', (all) =>
        all.map((one) => ({
          height: one.getBoundingClientRect().height,
          text: one.textContent,
          pictures: [...one.querySelectorAll('svg.plate')].filter((plate) => plate.getBoundingClientRect().width > 120).length,
          answers: one.querySelectorAll('.box').length,
          blanks: one.querySelectorAll('.blank').length,
          lines: one.querySelectorAll('span.line').length,
          breaks: getComputedStyle(one).breakInside,
        })),
      );
      assert.deepEqual(await page.$$eval('svg.plate', badLetters), [], `${name} ${language}`);
      const asked = blocks.filter((block) => block.key && block.kind !== 'exercise');
      assert.equal(seen.length, asked.length);
      for (const [at, { height, text, answers, blanks, lines, breaks }] of seen.entries()) {
        const block = asked[at];
        assert.ok(height < A4.height * 0.9, `${name}: question ${at + 1} is ${height} high`);
        assert.equal(breaks, 'avoid');
        // A formula is no text of its own, so the sentence is compared up to the first one, without links.
        const sentence = (block.ask ?? block.heading ?? block.text)[language].split('$')[0].replace(/\[\[([^|\]]+\|)?([^\]]+)\]\]/g, '$2');
        assert.ok(text.includes(sentence), `${name}: ${sentence}`);
        assert.deepEqual([answers, blanks, lines], [block.answers?.length ?? 0, block.blanks?.length ?? 0, 6]);
      }
      const pictured = seen.map(({ pictures }) => pictures > 0);
      assert.ok(pictured.filter(Boolean).length >= 2, `${name}: ${pictured}`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), A4.width, `${name} ${language}`);
      // No picture tells the answer to a question before it: the sum at the point in the middle of the road.
      if (name === 'which-way') assert.deepEqual(pictured, [false, true, false, true, true]);
      for (const paper of [A4, LETTER]) {
        await page.setViewport(paper);
        const parts = await page.$$eval('.sheet > header, .asked', (all) => all.map((part) => part.getBoundingClientRect().height));
        assert.equal(pagesOf(parts, paper.height), 2, `${name} ${language}: ${parts.map(Math.round)} on ${paper.height}`);
      }
    }
  }
  // The plans and the questions of the guide are not cut, and no heading is left alone.
  await page.goto(`${site.address}learn/guide/`, { waitUntil: 'load' });
  const cut = await page.$$eval('.guide :is(h2, h3, caption, .plan, li)', (all) =>
    all.filter((one) => getComputedStyle(one)[one.matches('.plan, li') ? 'breakInside' : 'breakAfter'] !== 'avoid').map((one) => one.textContent),
  );
  assert.deepEqual(cut, []);
  await close();
});

test('in class every slide fits the screen with a large picture; an answer, and the sentence on what happened, move nothing', sameEverywhere, async () => {
  // Each chapter in each window, by turns in both languages: windows up to 1024 pixels have the same layout in other letters.
  for (const { name, path: byTurns } of BY_TURNS) {
    await Promise.all(
      [`learn/${name}/`, `learn/ja/${name}/`].map(async (path) => {
        const { page, close } = await site.newPage(path, { viewport: projector });
        await begun(page);
        for (const viewport of path === byTurns ? [projector, tiny] : [small, wide]) {
          await resize(page, viewport);
          assert.deepEqual(await badInClass(page), [], `${path} at ${viewport.width}`);
        }
        await close();
      }),
    );
  }
});

test('a link to a state opens where its plates are seen, in class on the screen of its figure', sameEverywhere, async () => {
  const state = STATE.replace('fig=pair', 'fig=exercise');
  const narrow = await site.newPage(CHAPTERS[0] + state, { viewport: phone });
  await narrow.page.waitForSelector('#fig-exercise[data-step="3"]');
  assert.ok(await narrow.page.$eval('#fig-exercise', (figure) => figure.offsetHeight > innerHeight), 'higher than the window');
  const top = await narrow.page.$eval('#fig-exercise .plates', (plates) => plates.getBoundingClientRect().top);
  assert.ok(top >= 0 && top < 100, `the plates begin at ${top}`);
  await narrow.close();

  const { page, problems, close } = await site.newPage(CHAPTERS[0], { viewport: projector });
  await begun(page);
  await page.$eval('#class', (button) => button.click());
  assert.equal(await page.$eval('#fig-exercise', (figure) => figure.checkVisibility()), false);
  await follow(page, state.slice(1));
  await page.waitForSelector('#fig-exercise[data-step="3"]');
  assert.equal(await page.$eval('#fig-exercise', (figure) => figure.checkVisibility()), true);
  assert.equal(await page.evaluate(() => document.querySelectorAll('[data-now]').length), 1);
  assert.deepEqual(problems, []);
  await close();
});

test('in class the plates fill the room that the window has, and are as before afterwards', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('learn/many-bubbles/', { viewport: projector });
  await begun(page);
  const width = (/** @type {string} */ name) => page.$eval(`#fig-${name} .plates`, (plates) => plates.getBoundingClientRect().width);
  const usual = await width('best');
  await page.$eval('#class', (button) => button.click());
  for (const name of ['crowd', 'energy', 'best', 'quiet']) {
    await page.evaluate((figure) => {
      const shown = () => document.documentElement.dataset.part === 'figure' && document.querySelector(`[data-now] #fig-${figure}`);
      for (let k = 0; k < 20 && !shown(); k += 1) document.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));
    }, name);
    const end = await page.$eval(`#fig-${name} .figure-told`, (told) => told.getBoundingClientRect().bottom);
    // Plates beside a question may have the whole width before they have the whole height.
    const spare = await page.$eval(`#fig-${name}`, (figure) => (figure.closest('[data-aside]') ? figure.clientWidth - figure.querySelector('.plates').clientWidth : Infinity));
    assert.ok(end <= projector.height && (end > projector.height - 80 || spare === 0), `${name} ends at ${end}, with ${spare} beside the plates`);
  }
  await page.keyboard.press('Escape');
  assert.equal(await width('best'), usual);
  assert.deepEqual(problems, []);
  await close();
});

test('a plate has its place before the one beside it has come', sameEverywhere, async () => {
  for (const viewport of [desk, phone]) {
    const { page, close } = await site.newPage('learn/how-many/', { viewport });
    await begun(page);
    const found = await page.$$eval('.plates-2', (all) =>
      all.map((plates) => {
        const place = () => ['left', 'width'].map((side) => plates.firstElementChild?.getBoundingClientRect()[side]).join(' ');
        const before = place();
        const other = plates.lastElementChild;
        other?.remove();
        const alone = place();
        plates.append(other);
        return [before, alone];
      }),
    );
    assert.ok(found.length >= 4);
    for (const [before, alone] of found) assert.equal(alone, before);
    await close();
  }
});

/** Plates beside each other are as wide here as on a projector. */
const narrow = { width: 820, height: 800 };

test('figures have lines and areas alone, sharp on any screen, and words that can be read, on a desk and on a phone', sameEverywhere, async () => {
  const { page, close } = await site.newPage('learn/');
  for (const { path, ...chapter } of BY_TURNS) {
    await page.setViewport({ ...desk, deviceScaleFactor: 2 });
    await page.goto(site.address + path, { waitUntil: 'load' });
    await begun(page);
    await page.waitForSelector('.figure[data-live]');
    const found = await page.$$eval('.figure', (all) => all.map((figure) => [figure.querySelectorAll('canvas, img, image, foreignObject').length, figure.querySelectorAll('svg.plate').length > 0]));
    assert.deepEqual(found, figuresOf(chapter).map(() => [0, true]), path);
    for (const viewport of [desk, narrow, { width: phone.width, height: phone.height }]) {
      await page.setViewport(viewport);
      await frames(page, 2);
      assert.deepEqual(await page.$$eval('.figure svg.plate', badWords), [], `${path} at ${viewport.width}`);
    }
  }
  await close();
});

test('choosing an answer opens what is said on the answers', sameEverywhere, async () => {
  const { page, close } = await site.newPage(CHAPTERS[0]);
  await begun(page);
  assert.equal(await page.$eval('.answers', (fold) => fold.open), false);
  await page.$eval('[data-ask=made] input[value=a]', (answer) => answer.click());
  assert.deepEqual(await page.$$eval('[data-chosen]', (all) => all.map((reply) => reply.dataset.reply)), ['a']);
  assert.equal(await page.$eval('.answers', (fold) => fold.open), true);
  await close();
});

test('a symbol of a formula and that of a figure mark each other', sameEverywhere, async () => {
  const { page, close } = await site.newPage(CHAPTERS[0]);
  await begun(page);
  const marked = () => page.evaluate(() => [...new Set([...document.querySelectorAll('.marked')].map((one) => one.dataset.symbol))]);
  await page.$eval('#eq-5 [data-symbol=c]', (symbol) => symbol.dispatchEvent(new PointerEvent('pointerover', { bubbles: true })));
  assert.deepEqual(await marked(), ['c']);
  const places = await page.evaluate(() => [...document.querySelectorAll('.marked')].map((one) => (one.closest('figure') ? 'figure' : 'text')));
  assert.deepEqual([...new Set(places)].sort(), ['figure', 'text']);
  await page.$eval('#eq-5 [data-symbol=c]', (symbol) => symbol.dispatchEvent(new PointerEvent('pointerout', { bubbles: true })));
  assert.deepEqual(await marked(), []);
  await close();
});

test('in class one question or figure fills the screen, by keys, and hands are counted', async () => {
  const { page, close } = await site.newPage(CHAPTERS[0], { viewport: projector });
  await begun(page);
  const shown = () => page.evaluate(() => ['h2', '.ask legend', '.plates'].map((part) => [...document.querySelectorAll(`main ${part}`)].filter((one) => one.checkVisibility()).length));
  await page.focus('#class');
  await page.keyboard.press('Enter');
  // The question on top with a picture that does nothing, then its figure in full.
  assert.deepEqual(await shown(), [1, 1, 1]);
  const asked = await page.$eval('[data-now] .figure', (figure) => ({ inert: figure.inert, tools: figure.querySelector('.figure-tools').checkVisibility(), ...figure.querySelector('.plates').getBoundingClientRect().toJSON() }));
  assert.ok(asked.inert && !asked.tools && asked.height > 200 && asked.bottom < projector.height, JSON.stringify(asked));
  await page.focus('.hands');
  await page.keyboard.type('12');
  assert.equal(await page.$eval('.hands', (box) => box.value), '12');
  // Arrows belong to the box.
  await page.keyboard.press('ArrowRight');
  assert.deepEqual(await shown(), [1, 1, 1]);
  await page.evaluate(() => document.activeElement.blur());
  assert.equal(await page.$eval('[data-now] .answers', (answers) => answers.open), false, 'counted hands give nothing away');
  await page.keyboard.press('ArrowRight');
  // The figure has its question and the numbers of hands with it.
  assert.deepEqual(await shown(), [0, 1, 1]);
  assert.deepEqual(await page.$$eval('[data-now] .hands', (boxes) => boxes.map((box) => box.checkVisibility() && box.value)), ['12', false, false]);
  await page.$eval('[data-now] .ask input', (answer) => answer.click());
  assert.equal(await page.$eval('[data-now] .answers', (answers) => answers.open && !answers.checkVisibility()), true);
  assert.equal(await page.$eval('[data-now] .figure', (figure) => figure.inert), false);
  const { width, bottom } = await page.evaluate(() => {
    const box = [...document.querySelectorAll('.plates')].find((one) => one.checkVisibility()).getBoundingClientRect();
    return { width: box.width, bottom: box.bottom };
  });
  assert.ok(width > 400 && bottom < projector.height, `${width} wide, down to ${bottom}`);
  // Arrows choose among answers, but the keys of a presenter go on and back.
  await page.focus('[data-now] .ask input');
  await page.keyboard.press('PageUp');
  assert.deepEqual(await shown(), [1, 1, 1]);
  await page.focus('[data-now] .ask input');
  await page.keyboard.press('PageDown');
  assert.deepEqual(await shown(), [0, 1, 1]);
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await shown(), [1, 1, 1]);
  for (let k = 0; k < 12; k += 1) await page.keyboard.press('ArrowRight');
  assert.deepEqual(await shown(), [1, 0, 0], 'the last is the text on ours and theirs');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => document.documentElement.hasAttribute('data-class')), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'class');
  await close();
});
