// The browsers that the tests drive, and the settings of each. BROWSER=firefox chooses Firefox.
import { mkdtempSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';
import { browsers, findBrowser } from '../../scripts/lib/browser.mjs';

/** @typedef {import('puppeteer-core').Browser} Browser */
/** @typedef {import('puppeteer-core').Page} Page */

/**
 * The system's settings that pages can read.
 * @typedef {object} System
 * @property {boolean} [dark] dark pages
 * @property {boolean} [still] less motion
 * @property {boolean} [touch] fingers instead of a mouse
 */

/** The browser in use. @type {'chromium' | 'firefox'} */
export const kind = process.env.BROWSER === 'firefox' ? 'firefox' : 'chromium';

/**
 * Marks tests of results that the module or the page's scripts compute themselves: they are the same in every
 * browser, so Chromium is enough. Tests of the browser's own work are never marked: layout and drawing, focus, keys,
 * pointers and fingers, the clipboard, storage, history, files, workers, the service worker, and the system's
 * settings. Tests of digests are not marked either. One unmarked test of each kind is enough for a part of the page;
 * further ones are marked.
 */
export const sameEverywhere = { skip: kind !== 'chromium' && 'the same scripts work it out in every browser' };

/** The settings of the tests of one kind: all but the first are marked. @param {number} at the place among them */
export const firstEverywhere = (at) => (at ? sameEverywhere : {});

const chromiumFlags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  // Chromium prepares an internal page behind each window, which costs a quarter of a test.
  '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup',
  // A test's page lives for seconds: only the busiest functions of the module are compiled a second time, to run faster.
  '--js-flags=--wasm-tiering-budget=200000000',
  // Pages go on painting while another page is in front.
  '--disable-background-timer-throttling',
  '--disable-backgrounding-occluded-windows',
  '--disable-renderer-backgrounding',
];

/** Firefox has the system's settings for all pages at once, and Chromium for each page. @param {System} system */
const firefoxPreferences = ({ dark, still, touch }) => ({
  'ui.systemUsesDarkTheme': dark ? 1 : 0,
  'ui.prefersReducedMotion': still ? 1 : 0,
  // 1 is a coarse pointer; 6 a fine one that hovers.
  'ui.primaryPointerCapabilities': touch ? 1 : 6,
  'ui.allPointerCapabilities': touch ? 1 : 6,
  // Scroll bars of a phone take no room.
  'ui.useOverlayScrollbars': touch ? 1 : 0,
});

/**
 * Removes a folder. Some processes of a browser end a little later than it, and write new files while the old ones
 * are removed. After a minute the rest is left: it is not worth a failure.
 * @param {string} folder
 */
async function remove(folder) {
  for (let tries = 0; tries < 300; tries += 1) {
    try {
      return await rm(folder, { recursive: true, force: true });
    } catch {
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
  }
}

/**
 * Starts a browser with an empty profile.
 * @returns {Promise<{ browser: Browser, close: () => Promise<void> }>}
 */
export async function launch() {
  const executablePath = findBrowser(kind);
  if (!executablePath) throw new Error(`No ${browsers[kind].title}: name its program in ${browsers[kind].variable}.`);
  const profile = mkdtempSync(join(tmpdir(), 'bubblestone-browser-'));
  const browser = await puppeteer
    .launch({
      browser: kind === 'firefox' ? 'firefox' : 'chrome',
      executablePath,
      userDataDir: profile,
      protocolTimeout: 240_000,
      timeout: 120_000,
      ...(kind === 'firefox'
        ? { args: ['--remote-allow-system-access'], extraPrefsFirefox: { 'dom.events.testing.asyncClipboard': true } }
        : { headless: 'shell', args: chromiumFlags }),
    })
    .catch(async (error) => {
      await remove(profile);
      throw error;
    });
  return {
    browser,
    close: async () => {
      await browser.close();
      await remove(profile);
    },
  };
}

/**
 * Gives all pages of a Firefox other settings of the system: they are preferences, which a script may set that runs in the
 * browser's own window.
 * @param {Browser} browser @param {System} system
 */
export async function setSystem(browser, system) {
  /** The connection to Firefox, which this library has for its own use. @type {{ send: (method: string, params: object) => Promise<{ result: any }> }} */
  const connection = /** @type {any} */ (browser).connection;
  const { result } = await connection.send('browsingContext.getTree', { 'moz:scope': 'chrome' });
  const expression = Object.entries(firefoxPreferences(system)).map(([name, value]) => `Services.prefs.setIntPref('${name}', ${value});`).join('');
  const answer = await connection.send('script.evaluate', { target: { context: result.contexts[0].context }, awaitPromise: false, expression });
  if (answer.result.type !== 'success') throw new Error(`Firefox refuses the settings of the system: ${JSON.stringify(answer.result)}`);
}

/** A page in its own context. @param {Browser} browser @param {System} system */
export async function blankPage(browser, { dark, still }) {
  const context = await browser.createBrowserContext();
  // In Firefox a background tab sleeps.
  const page = await context.newPage(kind === 'firefox' ? { type: 'window' } : undefined);
  if (kind === 'chromium') {
    await page.emulateMediaFeatures([
      { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
      { name: 'prefers-reduced-motion', value: still ? 'reduce' : 'no-preference' },
    ]);
  }
  return { page, close: () => context.close() };
}

/** Lets a page read the clipboard. Firefox allows it to all pages. @param {Page} page @param {string} origin */
export async function allowClipboard(page, origin) {
  if (kind === 'firefox') return;
  await page.browserContext().overridePermissions(origin, ['clipboard-read', 'clipboard-write', 'clipboard-sanitized-write']);
}
