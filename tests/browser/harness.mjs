// Opens the built site in a real browser, for the tests beside this file.
//
//   const site = await open();
//   const { page, problems } = await site.newPage('#seed=7');
//   ...
//   assert.deepEqual(problems, []);
//   await site.close();
import { fileURLToPath } from 'node:url';
import { host } from '../../scripts/lib/host.mjs';
import { allowClipboard, blankPage, kind, launch, setSystem } from './browsers.mjs';

/** The window of pages that state none, and of sites that state none. */
export const desk = { width: 1280, height: 800 };

/**
 * Firefox tells of a request that waits for the service worker while its page is left. The page is gone then, so the
 * message has no address; that of a request which failed has one.
 */
const LEFT = /Failed to load ‘’\. A ServiceWorker intercepted the request/;

/**
 * A low window, for tests that wait for frames of bodies: the picture has a third of the pixels. Rare tools are
 * folded in windows below 704 lines; all else is as on a desk.
 */
export const low = { width: 1280, height: 560 };

/** The built site. */
export const dist = fileURLToPath(new URL('../../dist/', import.meta.url));

// A folder below the root, as the site must work from any folder.
const folder = '/any/folder/';

/**
 * A started browser, the system's settings that its pages have, and the number of its open pages.
 * @typedef {{ started: ReturnType<typeof launch>, system: string, pages: number }} Shared
 */

/**
 * The browsers that all open sites share. All pages of a Firefox have the same settings of the system, so a page with other
 * settings needs another Firefox as long as one is open.
 * @type {Set<Shared>}
 */
const launched = new Set();
let sites = 0;

/**
 * Opens a page in a browser with these settings.
 * @template {{ close: () => Promise<void> }} T
 * @param {import('./browsers.mjs').System} system
 * @param {(browser: import('puppeteer-core').Browser) => Promise<T>} opened
 * @returns {Promise<T>}
 */
async function sharing(system, opened) {
  const wanted = kind === 'firefox' ? JSON.stringify(system) : '';
  const all = [...launched];
  const shared = all.find((one) => one.system === wanted) ?? all.find((one) => !one.pages) ?? { started: launch(), system: '', pages: 0 };
  launched.add(shared);
  shared.pages += 1;
  if (shared.system !== wanted) {
    shared.system = wanted;
    shared.started = shared.started.then(async (one) => {
      await setSystem(one.browser, system);
      return one;
    });
  }
  // A start that failed is tried again for the next page, and leaves nothing to close.
  shared.started.catch(() => launched.delete(shared));
  const page = await opened((await shared.started).browser);
  let open = true;
  return {
    ...page,
    close: async () => {
      await page.close();
      if (open) shared.pages -= 1;
      open = false;
    },
  };
}

/**
 * Serves dist/. A browser with an empty profile is started for the first page, and closed with the last site.
 * @param {object} [options]
 * @param {string} [options.files] another folder than dist/
 * @param {import('puppeteer-core').Viewport} [options.viewport] the window of pages that state none
 * @param {(asked: (path: string) => void) => ReturnType<typeof host>} [options.serve] another host
 */
export async function open({ files = dist, viewport: usual = desk, serve = (asked) => host(files, { under: folder, asked }) } = {}) {
  /** The paths of all requests. @type {string[]} */
  const requests = [];
  const { origin, address, stop } = await serve((path) => requests.push(path));
  sites += 1;
  return {
    origin,
    requests,
    /** Stops the host, as if the connection was lost. */
    stop,
    /** The page's address. */
    address,
    /**
     * A page in its own context, opened at the address with a fragment.
     * @param {string} [fragment] such as `#seed=7`
     * @param {PageOptions} [options]
     */
    newPage: async (fragment = '', options = {}) => {
      const { dark = false, still = false, viewport = usual } = options;
      const system = { dark, still, touch: viewport.hasTouch ?? false };
      return sharing(system, (browser) => newPage(browser, system, address, fragment, { ...options, viewport }));
    },
    /** @param {import('puppeteer-core').Page} page */
    allowClipboard: (page) => allowClipboard(page, origin),
    close: async () => {
      stop();
      sites -= 1;
      if (sites) return;
      const browsers = [...launched];
      launched.clear();
      for (const { started } of browsers) await (await started).close();
    },
  };
}

/**
 * @typedef {object} PageOptions
 * @property {import('puppeteer-core').Viewport} [viewport]
 * @property {boolean} [dark] whether the system asks for a dark page
 * @property {boolean} [still] whether the system asks for less motion
 * @property {boolean} [fine] whether the finished picture is painted again in the screen's own pixels, and frames of bodies are refined
 * @property {boolean} [sways] whether bodies sway once, as for a new visitor
 * @property {boolean} [stores] whether the page may store the site, for which it fetches all files
 * @property {(page: import('puppeteer-core').Page) => Promise<unknown>} [before] runs before the page is opened
 */

/**
 * @param {import('puppeteer-core').Browser} browser
 * @param {import('./browsers.mjs').System} system
 * @param {string} address
 * @param {string} fragment
 * @param {PageOptions & { viewport: import('puppeteer-core').Viewport }} options
 */
async function newPage(browser, system, address, fragment, { viewport, stores = false, fine = false, sways = false, before }) {
  const { page, close } = await blankPage(browser, system);
  const { origin } = new URL(address);
  /** Errors on the console, uncaught errors, failed requests. @type {string[]} */
  const problems = [];
  /** Requests to anything but the site itself. @type {string[]} */
  const external = [];
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  page.on('pageerror', (error) => {
    if (!LEFT.test(String(error))) problems.push(String(error));
  });
  page.on('requestfailed', (request) => {
    const why = request.failure()?.errorText ?? '';
    // An aborted request is no failure: the page, or the end of the page, no longer needs it.
    if (!/ABORT/.test(why)) problems.push(`${request.url()}: ${why}`);
  });
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(`${origin}/`) && !/^(data|blob|about):/.test(url)) external.push(url);
  });
  // A slow machine needs long to reach a state.
  page.setDefaultTimeout(120_000);
  await page.setViewport(viewport);
  if (!stores) await page.evaluateOnNewDocument(neverStored);
  await page.evaluateOnNewDocument(chosen, { ...(fine ? {} : { fine: 'no' }), ...(sways ? {} : { swayed: 'yes' }) });
  await before?.(page);
  await page.goto(address + fragment, { waitUntil: 'load' });
  return { page, problems, external, close };
}

/**
 * Answers as if these choices were stored. Nothing is stored, so the visit still counts as the first.
 * @param {Record<string, string>} choices
 */
function chosen(choices) {
  const kept = Storage.prototype.getItem;
  Storage.prototype.getItem = function (name) {
    return kept.call(this, name) ?? choices[name.replace('bubblestone.', '')] ?? null;
  };
}

/** Keeps the page from registering its service worker. */
function neverStored() {
  // An empty page has no service workers.
  if (navigator.serviceWorker) navigator.serviceWorker.register = () => new Promise(() => undefined);
}
