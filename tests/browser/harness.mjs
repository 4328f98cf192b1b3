// A real Chromium on the built site, for the tests beside this file.
//
//   const site = await open();
//   const { page, problems } = await site.newPage('#seed=7');
//   ...
//   assert.deepEqual(problems, []);
//   await site.close();
import { mkdtempSync, rmSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import puppeteer from 'puppeteer-core';
import { findBrowser } from '../../scripts/lib/browser.mjs';

const dist = fileURLToPath(new URL('../../dist/', import.meta.url));

// Not the root of the host: the site has to work from any folder.
const folder = '/any/folder/';

const contentTypes = {
  '.avif': 'image/avif',
  '.css': 'text/css',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

const chromiumFlags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  // Pages of a test go on painting while another page is in front.
  '--disable-background-timer-throttling',
  '--disable-backgrounding-occluded-windows',
  '--disable-renderer-backgrounding',
];

/**
 * Serves dist/ and starts a browser with an empty profile.
 * @param {{ flags?: string[] }} [options] more flags for Chromium
 */
export async function open({ flags = [] } = {}) {
  const server = await serve();
  const profile = mkdtempSync(join(tmpdir(), 'bubblestone-browser-'));
  const browser = await launch(profile, flags).catch((error) => {
    server.close();
    throw error;
  });
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const origin = `http://127.0.0.1:${port}`;
  return {
    browser,
    origin,
    /** The page's address. */
    address: origin + folder,
    /**
     * A page of its own context, opened at the address with a fragment.
     * @param {string} [fragment] such as `#seed=7`
     * @param {PageOptions} [options]
     */
    newPage: (fragment = '', options = {}) => newPage(browser, origin, fragment, options),
    close: async () => {
      await browser.close();
      server.closeAllConnections();
      server.close();
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

/**
 * @typedef {object} PageOptions
 * @property {import('puppeteer-core').Viewport} [viewport]
 * @property {boolean} [dark] whether the system asks for a dark page
 * @property {(page: import('puppeteer-core').Page) => Promise<unknown>} [before] runs before the page is opened
 */

/**
 * @param {import('puppeteer-core').Browser} browser
 * @param {string} origin
 * @param {string} fragment
 * @param {PageOptions} options
 */
async function newPage(browser, origin, fragment, { viewport = { width: 1280, height: 800 }, dark, before }) {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  /** Errors on the console, uncaught errors, failed requests. @type {string[]} */
  const problems = [];
  /** Requests to anything but the site itself. @type {string[]} */
  const external = [];
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('requestfailed', (request) => problems.push(`${request.url()}: ${request.failure()?.errorText}`));
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(`${origin}/`) && !/^(data|blob|about):/.test(url)) external.push(url);
  });
  await page.setViewport(viewport);
  if (dark !== undefined) {
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }]);
  }
  await before?.(page);
  await page.goto(origin + folder + fragment, { waitUntil: 'load' });
  return { page, problems, external, close: () => context.close() };
}

/** @param {string} profile @param {string[]} flags */
async function launch(profile, flags) {
  const executablePath = findBrowser();
  if (!executablePath) throw new Error('No Chromium: name its program in CHROME_PATH.');
  return puppeteer.launch({
    executablePath,
    userDataDir: profile,
    args: [...chromiumFlags, ...flags],
    protocolTimeout: 240_000,
    timeout: 120_000,
  });
}

/** A static host of dist/ on a free port. @returns {Promise<import('node:http').Server>} */
function serve() {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    const inside = path.startsWith(folder) ? normalize(path.slice(folder.length)) : '..';
    try {
      if (inside.startsWith('..')) throw new Error('outside');
      const body = await readFile(join(dist, inside));
      response.writeHead(200, { 'content-type': contentTypes[extname(inside)] ?? 'application/octet-stream' });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(0, '127.0.0.1', () => resolve(server));
  });
}
