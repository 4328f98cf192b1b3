// The main states of the page, each with how to get there: tests look at all of them.
import { digest, frames, message, SMALL } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/**
 * @typedef {object} State
 * @property {string} [query] such as `?embed`
 * @property {string} [fragment] the link that is opened, a small picture unless given
 * @property {(fresh: Page) => Promise<unknown>} [before] before it is opened
 * @property {(page: Page) => Promise<unknown>} [arrange] once the picture is done
 * @property {boolean} [early] nothing waits for the picture
 */

const SQUARE = `${SMALL}&outline=square`;

/** Clicks without scrolling, whatever lies over it. @param {string} selector */
const click = (selector) => (/** @type {Page} */ page) => page.$eval(selector, (element) => /** @type {HTMLElement} */ (element).click());

/** A dialog that comes when it is asked for. @param {string} button */
const opening = (button) => async (/** @type {Page} */ page) => {
  await click(button)(page);
  await page.waitForSelector('dialog.take[open]');
};

/** @param {(document: Document) => void} change */
const change = (change) => (/** @type {Page} */ page) => page.evaluate(`(${change})(document)`);

/** @type {Record<string, State>} */
export const states = {
  opening: { fragment: '', early: true },
  done: { fragment: '' },
  japanese: { fragment: '', before: (fresh) => fresh.evaluateOnNewDocument(() => localStorage.setItem('bubblestone.language', 'ja')) },
  editing: { fragment: SQUARE, arrange: click('#edit-outline') },
  spots: { fragment: `${SQUARE}&spots=0.5,0.5,0.2,0.4`, arrange: click('#p-spots') },
  paused: { arrange: click('#play') },
  share: { arrange: opening('#share') },
  save: { arrange: opening('#save') },
  locked: {
    arrange: change((document) => document.querySelectorAll('.lock').forEach((lock) => /** @type {HTMLElement} */ (lock).click())),
  },
  embedded: { query: '?embed' },
  panel: { arrange: change((document) => document.querySelectorAll('details').forEach((details) => (details.open = true))) },
  presets: { arrange: click('.rail h2:nth-of-type(3) button') },
  message: { fragment: `${SMALL}&nonsense=1&cs=banana`, arrange: (page) => message(page, 'status', /nonsense/) },
  error: {
    arrange: async (page) => {
      await page.evaluate(() => {
        // Its own property hides that of all clocks until it is deleted.
        performance.now = () => {
          throw new Error('The clock is broken.');
        };
      });
      await click('#restart')(page);
      await message(page, 'alert', /\S/);
      await page.evaluate(() => delete (/** @type {any} */ (performance).now));
    },
  },
  about: { arrange: click('#about-button') },
};

/**
 * Opens a state.
 * @param {Awaited<ReturnType<typeof import('./harness.mjs').open>>} site
 * @param {State} state
 * @param {import('./harness.mjs').PageOptions} options
 */
export async function enter(site, { query = '', fragment = SMALL, before, arrange, early = false }, options) {
  const opened = await site.newPage(query + fragment, { still: true, ...options, before });
  if (!early) await digest(opened.page);
  await arrange?.(opened.page);
  await frames(opened.page, 2);
  return opened;
}
