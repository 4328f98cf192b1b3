// A real browser on the built site, for the tests beside this file.
//
//   const site = await open();
//   const { page, problems } = await site.newPage('#seed=7');
//   ...
//   assert.deepEqual(problems, []);
//   await site.close();
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { allowClipboard, blankPage, kind, launch } from './browsers.mjs';

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
  '.webmanifest': 'application/manifest+json',
};

/**
 * Serves dist/ and starts a browser with an empty profile.
 * @param {object} [options]
 * @param {string[]} [options.flags] more flags for Chromium
 * @param {string} [options.files] another folder than dist/
 */
export async function open({ flags = [], files = dist } = {}) {
  /** The paths of all requests. @type {string[]} */
  const requests = [];
  const server = await serve(files, requests);
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  const origin = `http://127.0.0.1:${port}`;
  /** Chromium is one for all; Firefox is another one for each system. @type {Map<string, ReturnType<typeof launch>>} */
  const launched = new Map();
  /** @param {import('./browsers.mjs').System} system */
  const browserFor = async (system) => {
    const key = kind === 'firefox' ? JSON.stringify(system) : '';
    const browser = launched.get(key) ?? launch(system, flags);
    launched.set(key, browser);
    return (await browser).browser;
  };
  const stop = () => {
    server.closeAllConnections();
    server.close();
  };
  return {
    origin,
    requests,
    /** Ends the host, as if there were no connection any more. */
    stop,
    /** The page's address. */
    address: origin + folder,
    /**
     * A page of its own context, opened at the address with a fragment.
     * @param {string} [fragment] such as `#seed=7`
     * @param {PageOptions} [options]
     */
    newPage: async (fragment = '', options = {}) => {
      const { dark = false, still = false, viewport } = options;
      const system = { dark, still, touch: viewport?.hasTouch ?? false };
      return newPage(await browserFor(system), system, origin, fragment, options);
    },
    /** @param {import('puppeteer-core').Page} page */
    allowClipboard: (page) => allowClipboard(page, origin),
    close: async () => {
      stop();
      for (const browser of launched.values()) await (await browser).close();
    },
  };
}

/**
 * @typedef {object} PageOptions
 * @property {import('puppeteer-core').Viewport} [viewport]
 * @property {boolean} [dark] whether the system asks for a dark page
 * @property {boolean} [still] whether the system asks for less motion
 * @property {(page: import('puppeteer-core').Page) => Promise<unknown>} [before] runs before the page is opened
 */

/**
 * @param {import('puppeteer-core').Browser} browser
 * @param {import('./browsers.mjs').System} system
 * @param {string} origin
 * @param {string} fragment
 * @param {PageOptions} options
 */
async function newPage(browser, system, origin, fragment, { viewport = { width: 1280, height: 800 }, before }) {
  const { page, close } = await blankPage(browser, system);
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
  await before?.(page);
  await page.goto(origin + folder + fragment, { waitUntil: 'load' });
  return { page, problems, external, close };
}

/**
 * A static host on a free port.
 * @param {string} files the folder that it serves
 * @param {string[]} requests gets their paths
 * @returns {Promise<import('node:http').Server>}
 */
function serve(files, requests) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
    const inside = path.startsWith(folder) ? normalize(path.slice(folder.length)) : '..';
    requests.push(inside);
    try {
      if (inside.startsWith('..')) throw new Error('outside');
      const body = await readFile(join(files, inside));
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
