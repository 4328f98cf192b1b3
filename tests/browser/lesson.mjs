// The figures of a chapter in a browser: their state, handles, timeline and questions.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before } from 'node:test';
import { goldenStops } from '../common/figures.mjs';
import { desk, open } from './harness.mjs';
import { inSight, phone } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/**
 * Opens the site before the tests of a file, and closes it after them. Returns a function that opens a chapter in a page. A page
 * that was closed is opened again for a later test with the same options, as its files and the compiled module are there.
 * @param {string} name of the chapter
 */
export function chapterPages(name) {
  /** @typedef {Awaited<ReturnType<typeof site.newPage>>} Opened */
  /** @type {Awaited<ReturnType<typeof open>>} */
  let site;
  /** The closed pages, by their options. @type {Map<string, Opened[]>} */
  const closed = new Map();
  before(async () => {
    site = await open();
  });
  after(() => site?.close());
  /** @param {string} [fragment] @param {import('./harness.mjs').PageOptions & { language?: 'en' | 'ja' }} [options] */
  return async (fragment = '', { language = 'en', ...options } = {}) => {
    const path = `learn/${language === 'ja' ? 'ja/' : ''}${name}/${fragment}`;
    // A script that runs before the page is opened stays in it.
    if (options.before) return site.newPage(path, options);
    const pages = closed.get(JSON.stringify(options)) ?? [];
    closed.set(JSON.stringify(options), pages);
    const opened = pages.pop() ?? (await site.newPage(path, options));
    if (opened.page.url() === 'about:blank') {
      opened.problems.length = 0;
      await opened.page.goto(site.address + path, { waitUntil: 'load' });
    }
    const close = async () => {
      await opened.page.goto('about:blank');
      await opened.page.mouse.move(0, 0);
      await opened.page.setViewport(options.viewport ?? desk);
      pages.push(opened);
    };
    return { ...opened, close };
  };
}

/** Brings a figure of a page that has all its scenes into sight and waits until it works. @param {Page} page @param {string} name */
export async function at(page, name) {
  await page.waitForSelector('html:not([data-opening])');
  await page.$eval(`#fig-${name}`, (figure) => figure.scrollIntoView({ block: 'center', behavior: 'instant' }));
  await page.waitForSelector(`#fig-${name}[data-live][data-step][data-hash]`);
  return `#fig-${name}`;
}

/** Follows a link to a state on the open page. @param {Page} page @param {string} fragment */
export const follow = (page, fragment) =>
  page.evaluate(
    (to) =>
      new Promise((followed) => {
        addEventListener('hashchange', () => followed(undefined), { once: true });
        location.hash = to;
      }),
    fragment,
  );

/** The state that a figure shows. @param {Page} page @param {string} figure */
export function shown(page, figure) {
  return page.$eval(figure, (element) => ({
    step: Number(element.getAttribute('data-step')),
    hash: element.getAttribute('data-hash') ?? '',
    said: element.querySelector('.time-said')?.textContent,
    // No-break spaces join letters to their numbers.
    told: (element.querySelector('.figure-told')?.textContent ?? '').replaceAll('\u00a0', ' '),
    picture: [...element.querySelectorAll('.plate-svg')].map((plate) => plate.innerHTML).join(''),
  }));
}

/** Waits until the box of a handle has a number near this one. @param {Page} page @param {string} figure @param {string} key @param {number} wanted @param {number} [by] */
export async function boxHas(page, figure, key, wanted, by = 0.0015) {
  await page.waitForFunction(
    (selector, value, apart) => Math.abs(Number(/** @type {HTMLInputElement} */ (document.querySelector(selector)).value) - value) < apart,
    {},
    `${figure} .handle[data-key="${key}"] input[type="number"]`,
    wanted,
    by,
  );
}

/** Types a number into the box of a handle. @param {Page} page @param {string} figure @param {string} key @param {number} value */
export async function type(page, figure, key, value) {
  await page.$eval(
    `${figure} .handle[data-key="${key}"] input[type="number"]`,
    (box, text) => {
      for (let fold = box.closest('details'); fold; fold = null) fold.open = true;
      box.focus();
      box.value = text;
      box.dispatchEvent(new Event('change', { bubbles: true }));
    },
    String(value),
  );
  await boxHas(page, figure, key, value);
}

/** Goes to a step and waits for it. @param {Page} page @param {string} figure @param {number} step */
export async function seek(page, figure, step) {
  await page.$eval(
    `${figure} input.time`,
    (slider, to) => {
      slider.value = String(to);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    },
    step,
  );
  await page.waitForSelector(`${figure}[data-step="${step}"]`);
}

/**
 * The heights of a figure at steps of its run. There should be only one, or else all below it would jump. @param {Page}
 * page @param {string} figure @returns {Promise<number[]>}
 */
export const heights = (page, figure) =>
  page.$eval(figure, (element) => {
    const slider = /** @type {HTMLInputElement | null} */ (element.querySelector('input.time'));
    const last = Number(slider?.max ?? 0);
    const found = [...Array(16).keys(), ...Array(25).keys()].map((k, at) => (at < 16 ? k : Math.round((last * (k + 1)) / 25)));
    const seen = found.map((step) => {
      if (slider) slider.value = String(step);
      slider?.dispatchEvent(new Event('input', { bubbles: true }));
      return element.getBoundingClientRect().height;
    });
    return [...new Set(seen)];
  });

/** Goes to the end of a figure's runs, however long they are. @param {Page} page @param {string} figure */
export async function toEnd(page, figure) {
  await page.focus(`${figure} input.time`);
  await page.keyboard.press('End');
  await page.waitForFunction(
    (selector) => document.querySelector(selector)?.getAttribute('data-step') === document.querySelector(`${selector} input.time`)?.getAttribute('max'),
    {},
    figure,
  );
}

/** Waits until a change has been read. @param {Page} page @param {string} figure @param {string} before the hash of the state before */
export const changed = (page, figure, before) =>
  page.waitForFunction((selector, hash) => document.querySelector(selector)?.getAttribute('data-hash') !== hash, {}, figure, before);

/** The middle of an element in the window, scrolled into sight. @param {Page} page @param {string} selector */
export async function middle(page, selector) {
  const { x, y, width, height } = await inSight(page, selector);
  return { x: x + width / 2, y: y + height / 2 };
}

/** The sentence of an answered question; '' while it is open. @param {Page} page @param {string} key */
export const answer = (page, key) => page.$eval(`[data-seen="${key}"]`, (place) => (place.hasAttribute('hidden') ? '' : (place.textContent ?? '')));

/** Waits for a question's answer, and checks the room that was kept for it. @param {Page} page @param {string} key */
export async function answered(page, key) {
  const seen = await page.waitForSelector(`[data-seen="${key}"]:not([hidden])`);
  const heights = await seen?.evaluate((element) => {
    const sentence = /** @type {HTMLElement} */ (element);
    return [true, false].map((isHidden) => {
      sentence.hidden = isHidden;
      return sentence.parentElement?.getBoundingClientRect().height ?? 0;
    });
  });
  assert.ok(heights && heights[0] === heights[1], `${key}: ${heights}`);
}

/** Axe's findings in all unfolded figures, and too wide a page. @param {Page} page @returns {Promise<string[]>} */
export async function violations(page) {
  const wide = await page.evaluate(() => (document.documentElement.scrollWidth > innerWidth ? [`${document.documentElement.scrollWidth} of ${innerWidth} pixels`] : []));
  await page.$$eval('figure details', (folds) => folds.forEach((fold) => fold.setAttribute('open', '')));
  await page.evaluate(axe);
  const faults = await page.evaluate(async () => {
    const found = await /** @type {any} */ (window).axe.run('figure[data-figure]', { resultTypes: ['violations'] });
    return found.violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { html }) => `${id}: ${html.slice(0, 160)}`));
  });
  return [...wide, ...faults];
}

/**
 * Checks that each figure has the golden state at each of its stops.
 * @param {ReturnType<typeof chapterPages>} chapter
 * @param {readonly string[]} figures
 * @param {(page: Page, figure: string, golden: { stop: string, step: string }) => Promise<void>} [look] at each stop
 */
export async function hasGoldenStates(chapter, figures, look) {
  const { page, problems, close } = await chapter();
  const stops = goldenStops().filter(({ figure }) => figures.includes(figure));
  assert.deepEqual([...new Set(stops.map(({ figure }) => figure))], figures);
  for (const { figure: name, stop, step, hash } of stops) {
    const figure = await at(page, name);
    // A run that was seen to its end offers all its stops.
    if (stop === 'start') await toEnd(page, figure);
    if (stop !== 'opens') await page.click(`${figure} [data-stop="${stop}"]`);
    await page.waitForSelector(`${figure}[data-step="${step}"][data-hash="${hash}"]`);
    await look?.(page, figure, { stop, step });
  }
  assert.deepEqual(problems, []);
  await close();
}

/**
 * Checks the figures of a Japanese page on a dark phone: each has its text and one height at all steps, and axe finds
 * nothing in it. Nothing is wider than the page.
 * @param {ReturnType<typeof chapterPages>} chapter
 * @param {readonly string[]} figures
 * @param {RegExp} told
 */
export async function isSoundOnPhone(chapter, figures, told) {
  const { page, problems, close } = await chapter('', { language: 'ja', dark: true, viewport: phone });
  for (const name of figures) {
    const figure = await at(page, name);
    assert.match((await shown(page, figure)).told, told);
    assert.equal((await heights(page, figure)).length, 1, `the height of ${name}`);
  }
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(problems, []);
  await close();
}
