// States of the page that together show each of its parts once, and the steps to reach them. Tests check all of them.
// Their pictures are in target/page-pictures/.
import { all, BALL, BRICKS, digest, frames, message, PILE, SMALL, SQUARE } from './page.mjs';
import { turned } from './turned.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/**
 * @typedef {object} State
 * @property {string} [query] such as `?embed`
 * @property {string} [fragment] the link to open, a small picture by default
 * @property {(fresh: Page) => Promise<unknown>} [before] runs before the page is opened
 * @property {(page: Page) => Promise<unknown>} [arrange] runs once the picture is done
 * @property {boolean} [few] most of the page is hidden, or behind a dialog
 * @property {boolean} [early] does not wait for the picture
 * @property {boolean} [space] shows bodies, whose frames take long in a high window
 */

/** Clicks without scrolling, even if something covers the element. @param {string} selector */
const click = (selector) => (/** @type {Page} */ page) => page.$eval(selector, (element) => /** @type {HTMLElement} */ (element).click());

/** Clicks, and waits for the element that this shows. @param {string} selector @param {string} what */
const shown = (selector, what) => async (/** @type {Page} */ page) => {
  await click(selector)(page);
  await page.waitForSelector(what, { visible: true });
};

/** Clicks, and waits for the dialog that this opens. @param {string} selector @param {string} opened */
const opening = (selector, opened) => async (/** @type {Page} */ page) => {
  await click(selector)(page);
  await page.waitForSelector(opened);
};

/** @param {(document: Document) => void} change */
const change = (change) => (/** @type {Page} */ page) => page.evaluate(`(${change})(document)`);

/** @param {string} code */
const speaking = (code) => (/** @type {Page} */ fresh) => fresh.evaluateOnNewDocument((word) => localStorage.setItem('bubblestone.language', word), code);

/** @type {Record<string, State>} */
export const states = {
  opening: { fragment: '', early: true },
  done: { fragment: '' },
  japanese: {
    before: speaking('ja'),
    arrange: async (page) => {
      await all(page);
      await change((document) => {
        document.querySelectorAll('.lock').forEach((lock) => /** @type {HTMLElement} */ (lock).click());
        document.querySelectorAll('details').forEach((details) => (details.open = true));
      })(page);
    },
  },
  editing: { fragment: SQUARE, arrange: opening('#edit-outline', '.handle') },
  road: { fragment: SQUARE, arrange: opening('[data-tool=road]', '.handle') },
  letters: { fragment: SQUARE, arrange: opening('[data-tool=text]', '#letters') },
  import: { fragment: SQUARE, arrange: opening('[data-tool=import]', '#outline-text') },
  spots: { fragment: `${SQUARE}&spots=0.5,0.5,0.2,0.4`, arrange: opening('#p-spots', '.handle') },
  share: { few: true, arrange: shown('#share', '#share-dialog') },
  save: { few: true, arrange: shown('#save', '#save-dialog') },
  embedded: { few: true, query: '?embed' },
  rare: { arrange: async (page) => { for (const id of ['#step', '#theme', '#more-tools']) await click(id)(page); } },
  message: {
    fragment: `${SMALL}&nonsense=1&cs=banana`,
    arrange: async (page) => {
      await click('.rail h2:nth-of-type(3) button')(page);
      await message(page, 'status', /nonsense/);
    },
  },
  error: {
    arrange: async (page) => {
      await page.evaluate(() => {
        // An own property hides the prototype's clock until it is deleted.
        performance.now = () => {
          throw new Error('The clock is broken.');
        };
      });
      await click('#play')(page);
      await message(page, 'alert', /\S/);
      await page.evaluate(() => delete (/** @type {any} */ (performance).now));
    },
  },
  looking: {
    arrange: async (page) => {
      await click('#zoom-in')(page);
      await page.waitForSelector('.sheet[data-zoomed]');
      await page.focus('#cells');
      await page.waitForSelector('.cell-card');
      await page.keyboard.press('ArrowRight');
      await shown('#light-button', '#light-sun')(page);
      await shown('#layers-button', '#layers')(page);
      await shown('#plots-button', '#plots canvas')(page);
    },
  },
  repeated: {
    fragment: '#size=192&cs=16&tile=1&light=point',
    arrange: async (page) => {
      await shown('#tile-button', '.tiles')(page);
      await shown('#light-button', '#light-lamp')(page);
    },
  },
  compare: {
    arrange: async (page) => {
      await shown('#compare-button', '#divider')(page);
      await page.waitForFunction(() => document.querySelector('.compare-progress')?.textContent === '', { timeout: 120_000 });
    },
  },
  beside: {
    arrange: async (page) => {
      await shown('#compare-button', '#divider')(page);
      await shown('#compare-beside', '#beside')(page);
      await page.waitForFunction(() => document.querySelector('#play')?.getAttribute('data-does') === 'again' && /[1-9]/.test(document.querySelector('#beside-name span')?.textContent ?? ''), { timeout: 120_000 });
    },
  },
  making: {
    fragment: `${SQUARE}&camera=330,60`,
    space: true,
    arrange: async (page) => {
      await turned(page);
      await page.focus('#turn');
      await page.keyboard.press('Enter');
      await page.waitForSelector('#turn-how');
      await page.keyboard.press('Enter');
      await page.waitForSelector('.turn-making', { visible: true });
      await turned(page);
    },
  },
  surface: { space: true, fragment: `${BALL}&view=direction`, arrange: (page) => turned(page) },
  pile: { space: true, fragment: `${PILE}&cut=0,1,0,0.05`, arrange: (page) => turned(page) },
  masonry: {
    // The middle of the frame is a brick of an edge, which its card can turn.
    fragment: `${BRICKS}&camera=315,20,2.8,28,0,0.03`,
    space: true,
    arrange: async (page) => {
      await turned(page);
      await page.focus('#turn');
      await page.keyboard.press('Enter');
      await page.waitForSelector('#turn-flip', { visible: true });
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
