import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import sharp from 'sharp';
import { filesOf, firstOf, listOf } from '../../scripts/lib/offline.mjs';
import { kind, sameEverywhere } from './browsers.mjs';
import { dist, open } from './harness.mjs';
import { digest, SMALL } from './page.mjs';
import { handed } from './saved.mjs';

// Each test has its own host, whose requests it counts. One more site stays open, so that all tests share a browser.
/** @type {Awaited<ReturnType<typeof open>>} */
let kept;

before(async () => {
  kept = await open();
});

after(() => kept?.close());

/** Waits until the page's root element says `stored`, or `newer` if there is a newer build. */
const told = (page, what) => page.waitForFunction((word) => document.documentElement.dataset.offline === word, { timeout: 60_000 }, what);

/** The hashes of files of the site, as the page receives them. */
const fetched = (page, paths) =>
  page.evaluate(async (names) => {
    const hashes = [];
    for (const name of names) {
      const bytes = await (await fetch(name || './')).arrayBuffer();
      const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
      hashes.push(Array.from(hash.subarray(0, 16), (byte) => byte.toString(16).padStart(2, '0')).join(''));
    }
    return Object.fromEntries(names.map((name, at) => [name, hashes[at]]));
  }, paths);

test('after the first visit all works without a host, and nothing was fetched twice', async (t) => {
  const site = await open();
  t.after(() => site.close());
  const { page, external, close } = await site.newPage(SMALL, { stores: true });
  const planes = await digest(page);
  await told(page, 'stored');
  // The foot of the page mentions it; nothing covers the picture.
  assert.match(await page.$eval('#offline', (text) => text.textContent), /works offline/);
  assert.equal(await page.$('.message'), null);
  // Chromium fetches the tab's icon separately.
  const asked = site.requests.filter((path, at, all) => path !== 'sw.js' && (path !== 'favicon.svg' || all.indexOf(path) === at));
  assert.deepEqual(asked.filter((path, at) => asked.indexOf(path) !== at), []);
  assert.deepEqual(asked.sort(), filesOf(dist));
  site.stop();
  await page.reload({ waitUntil: 'load' });
  assert.equal(await digest(page), planes);
  // Files that the page has not loaded yet.
  const { files } = listOf(dist);
  assert.deepEqual(await fetched(page, Object.keys(files)), files);
  await page.evaluate(() => {
    document.querySelector('#save').click();
    const click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function () {
      if (this.download) window.saved = this.download;
      else click.call(this);
    };
  });
  await page.waitForSelector('#save-maps');
  await handed(page, () => page.$eval('#save-maps', (button) => button.click()));
  assert.match(await page.evaluate(() => window.saved), /-maps-opengl\.zip$/);
  await told(page, 'stored');
  assert.deepEqual(external, []);
  await close();
});

test('until the first picture is done only what it needs is fetched', async (t) => {
  const site = await open();
  t.after(() => site.close());
  const { page, close } = await site.newPage('');
  await digest(page);
  const needed = new Set([...firstOf(dist), 'index.html']);
  const others = site.requests.filter((path) => !needed.has(path) && !path.startsWith('thumbs/'));
  // The script that stores the site.
  assert.ok(others.every((path) => /^assets\/offline-/.test(path)), others.join(' '));
  assert.ok(site.requests.filter((path) => path.startsWith('thumbs/')).length <= 8);
  await close();
});

test('a new build is told, taken at the next visit, and never mixed with the old one', async (t) => {
  const files = mkdtempSync(join(tmpdir(), 'bubblestone-site-'));
  cpSync(dist, files, { recursive: true });
  const site = await open({ files });
  t.after(() => site.close());
  const { page, problems, close } = await site.newPage(SMALL, { stores: true });
  const planes = await digest(page);
  await told(page, 'stored');
  // The next build: its script has another name, and the old script is gone.
  const before = listOf(files);
  const script = before.first.find((path) => path.endsWith('.js'));
  const renamed = script.replace(/-[^-]*\.js$/, '-newbuild.js');
  const rewrite = (path, from, to) => {
    const text = readFileSync(join(files, path), 'utf8');
    assert.ok(text.includes(from), `${path} has no ${from}`);
    writeFileSync(join(files, path), text.replaceAll(from, to));
  };
  cpSync(join(files, script), join(files, renamed));
  rmSync(join(files, script));
  rewrite('index.html', script, renamed);
  const now = listOf(files);
  rewrite('sw.js', JSON.stringify(before), JSON.stringify(now));
  await page.reload({ waitUntil: 'load' });
  assert.equal(await digest(page), planes);
  const shown = () => page.$eval('script[type=module]', (element) => new URL(element.src).pathname.split('/').pop());
  assert.ok(script.endsWith(await shown()), 'the page that was stored is shown at once');
  await told(page, 'newer');
  await page.reload({ waitUntil: 'load' });
  assert.equal(await digest(page), planes);
  assert.ok(renamed.endsWith(await shown()), 'the next visit gets the new one');
  await told(page, 'stored');
  // The old build's files stay for pages that are still open.
  assert.deepEqual(await fetched(page, [script]), { [script]: before.files[script] });
  assert.deepEqual(problems, []);
  await close();
  rmSync(files, { recursive: true });
});

test('a file that is not of this build is not stored', async (t) => {
  const files = mkdtempSync(join(tmpdir(), 'bubblestone-site-'));
  cpSync(dist, files, { recursive: true });
  const style = listOf(files).first.find((path) => path.endsWith('.css'));
  writeFileSync(join(files, style), 'body { margin: 0 }');
  const site = await open({ files });
  t.after(() => site.close());
  const { page, close } = await site.newPage(SMALL, { stores: true });
  await digest(page);
  // The file is requested again, past the browser's own cache, and then given up.
  for (let waited = 0; site.requests.filter((path) => path === style).length < 2; waited += 1) {
    assert.ok(waited < 600, 'it is not asked for again');
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistration()) === undefined, { timeout: 60_000, polling: 200 });
  assert.equal(await page.evaluate(() => document.documentElement.dataset.offline), undefined);
  await close();
  rmSync(files, { recursive: true });
});

test('the page can be installed: its manifest is valid, with icons of the sizes that it names', sameEverywhere, async (t) => {
  const site = await open();
  t.after(() => site.close());
  const { page, close } = await site.newPage(SMALL, { stores: true });
  const href = await page.$eval('link[rel=manifest]', (link) => link.getAttribute('href'));
  const manifest = JSON.parse(readFileSync(join(dist, href), 'utf8'));
  for (const key of ['name', 'short_name', 'theme_color', 'background_color']) assert.match(manifest[key], /\S/, key);
  assert.ok(manifest.short_name.length <= 12);
  assert.deepEqual([manifest.start_url, manifest.scope, manifest.display], ['.', '.', 'standalone']);
  const offered = [];
  for (const { src, sizes, type, purpose = 'any' } of manifest.icons) {
    const { width, height, format } = await sharp(join(dist, src)).metadata();
    assert.deepEqual([`${width}x${height}`, `image/${format}`], [sizes, type], src);
    offered.push(`${sizes} ${purpose}`);
  }
  assert.deepEqual(offered, ['192x192 any', '512x512 any', '512x512 maskable']);
  if (kind === 'chromium') {
    const session = await page.createCDPSession();
    const { errors } = await session.send('Page.getAppManifest');
    assert.deepEqual(errors, []);
    await digest(page);
    await told(page, 'stored');
    const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
    // Test pages run in a context of their own, like a private window.
    assert.deepEqual(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== 'in-incognito'), []);
  }
  await close();
});
