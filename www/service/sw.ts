/**
 * The service worker. It stores the site's files, so that the page works offline from the second visit on.
 *
 * Each build has its own cache. A file enters it only with the contents that the build gave it, so a page never gets parts
 * of two builds. A new build is stored while the old one is shown, and used from the next visit on.
 */

/** The build replaces this. */
declare const SITE: {
  version: string;
  /**
   * The first half of each file's SHA-256, in hexadecimal, by path. A page's path is its folder's, '' for the studio.
   */
  files: Record<string, string>;
  /** The files that the page needs at its start. */
  first: string[];
};

const worker = self as unknown as ServiceWorkerGlobalScope;
const { scope } = worker.registration;

// The host may serve other sites, too.
const PREFIX = `bubblestone ${scope} `;
const CACHE = PREFIX + SITE.version;

worker.addEventListener('install', (event) => {
  void worker.skipWaiting();
  event.waitUntil(store(SITE.first));
});

worker.addEventListener('activate', (event) => {
  event.waitUntil(takeOver());
});

worker.addEventListener('fetch', (event) => {
  const path = pathOf(event.request);
  if (path !== undefined) event.respondWith(answer(path, event.request));
});

/** A page sends the path of its own script, which names its build, and asks to store all remaining files. */
worker.addEventListener('message', (event: ExtendableMessageEvent) => {
  const isOld = !(String(event.data) in SITE.files);
  const reply = (what: string): void => event.source?.postMessage(what);
  if (isOld) reply('newer');
  const stored = store(Object.keys(SITE.files)).then(() => {
    if (!isOld) reply('stored');
  });
  // Files that fail now are stored another time.
  event.waitUntil(stored.catch(() => undefined));
});

async function takeOver(): Promise<void> {
  const others = (await caches.keys()).filter((name) => name.startsWith(PREFIX) && name !== CACHE);
  // Pages of the previous build may still be open.
  for (const name of others.slice(0, -1)) await caches.delete(name);
  await worker.clients.claim();
}

/** The path of a request that may be stored. */
function pathOf({ method, url }: Request): string | undefined {
  if (method !== 'GET' || !url.startsWith(scope)) return undefined;
  const path = new URL(url).pathname.slice(new URL(scope).pathname.length).replace(/(^|\/)index\.html$/, '$1');
  return path in SITE.files || path.startsWith('assets/') ? path : undefined;
}

async function answer(path: string, request: Request): Promise<Response> {
  const url = scope + path;
  // Files of other builds have other names, as names contain a hash of the contents.
  if (!(path in SITE.files)) return (await caches.match(url)) ?? fetch(request);
  const cache = await caches.open(CACHE);
  const stored = (await cache.match(url)) ?? (await bring(path).catch(() => undefined));
  return stored ?? fetch(request);
}

/** Stores files one after another, so that they slow nothing down. */
async function store(paths: string[]): Promise<void> {
  const cache = await caches.open(CACHE);
  for (const path of paths) {
    if (!(await cache.match(scope + path)) && !(await bring(path))) throw new Error(`${path} is of another build.`);
  }
}

/**
 * Puts a file into the cache: from an older cache, from the browser's own cache, or from the host. The browser's own
 * cache has the files that the page loaded.
 */
async function bring(path: string): Promise<Response | undefined> {
  const url = scope + path;
  const sources = [
    () => caches.match(url),
    () => fetch(url, { cache: 'force-cache', priority: 'low' }),
    () => fetch(url, { cache: 'reload', priority: 'low' }),
  ];
  for (const source of sources) {
    const found = await source();
    if (!found?.ok) continue;
    const bytes = await found.arrayBuffer();
    if ((await digest(bytes)) !== SITE.files[path]) continue;
    const headers = new Headers(found.headers);
    headers.delete('vary');
    const response = new Response(bytes, { headers });
    await (await caches.open(CACHE)).put(url, response.clone());
    return response;
  }
  return undefined;
}

async function digest(bytes: ArrayBuffer): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(hash.subarray(0, 16), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
