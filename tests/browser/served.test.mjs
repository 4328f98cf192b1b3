// The site as `npm start` serves it: every lazy part of the page loads, with its styles and without an error.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { filesOf, firstOf } from '../../scripts/lib/offline.mjs';
import { serveSite, site as dist } from '../../scripts/lib/site.mjs';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { BALL, click, digest, drop, message, SMALL, tool } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open({ serve: (asked) => serveSite(0, asked) });
});

after(() => site?.close());

/** Opens the page. @param {string} query with the fragment @param {string} [language] */
async function visit(query, language = 'en') {
  const opened = await site.newPage(query, {
    before: (fresh) => fresh.evaluateOnNewDocument((spoken) => localStorage.setItem('bubblestone.language', spoken), language),
  });
  await digest(opened.page);
  return opened;
}

/** Turns the fine picture on, which is off in tests. */
async function fine(page) {
  await click(page, '#layers-button');
  await click(page, '#fine');
}

/** The element that a part adds, and styles that only this part gives it; `close` is clicked to hide the part again. */
const parts = [
  { name: 'zoom', act: (page) => click(page, '#zoom-in'), of: '.walk svg', styles: { position: 'absolute' }, close: '#zoom-fit' },
  { name: 'light', act: (page) => click(page, '#light-button'), of: '.light-layer', styles: { position: 'absolute', top: '0px' }, close: '#light-button' },
  { name: 'layers', act: (page) => click(page, '#layers-button'), of: '#layers', styles: { overflow: 'auto', width: '304px' }, close: '#layers-button' },
  { name: 'fine', act: (page) => fine(page), of: '.fine', styles: { position: 'absolute', pointerEvents: 'none' }, close: '#layers-button' },
  { name: 'plots', act: (page) => click(page, '#plots-button'), of: '.plot canvas', styles: { display: 'block' }, close: '#plots-button' },
  { name: 'tile', act: (page) => click(page, '#tile-button'), of: '.tiles', styles: { position: 'absolute' } },
  { name: 'compare', act: (page) => click(page, '#compare-button'), of: '#divider', styles: { position: 'absolute', marginLeft: '0px' }, close: '#compare-button' },
  { name: 'turn', act: (page) => click(page, '#turn-button'), of: '#sheet[data-turn=fine] .turn', styles: { position: 'absolute' }, close: '#turn-end' },
  { name: 'frame', act: (page) => page.evaluate(() => window.bubblestone.frame()), of: '#sheet', styles: {} },
  { name: 'keys', act: (page) => click(page, '#keys-button'), of: '#keys[open]', styles: { position: 'fixed' }, close: '#keys form button' },
  { name: 'share', act: (page) => click(page, '#share'), of: '#share-dialog', styles: { position: 'fixed', width: '560px' }, close: '[data-close]' },
  { name: 'save', act: (page) => click(page, '#save'), of: '#save-dialog', styles: { position: 'fixed', width: '560px' }, close: '[data-close]' },
  { name: 'letters', act: (page) => tool(page, 'text'), of: '#text-dialog', styles: { position: 'fixed' }, close: '#leave-letters' },
  { name: 'import', act: (page) => tool(page, 'import'), of: '#outline-text', styles: { display: 'block' }, close: 'dialog[open] #leave-import' },
  { name: 'editor', act: (page) => tool(page, 'outline'), of: '.handle', styles: { position: 'absolute' } },
  { name: 'chance', act: (page) => click(page, '#throw'), of: '#undo:enabled', styles: {} },
];

test('every part that is loaded late comes, with its styles', sameEverywhere, async () => {
  const { page, problems, close } = await visit(SMALL);
  for (const { name, act, of, styles, close: way } of parts) {
    await act(page);
    await page.waitForSelector(of);
    const seen = await page.$eval(
      of,
      (element, properties) => {
        const computed = getComputedStyle(element);
        return Object.fromEntries(properties.map((property) => [property, computed[property]]));
      },
      Object.keys(styles),
    );
    assert.deepEqual(seen, styles, name);
    if (way) await click(page, way);
  }
  await drop(page, 'mine.json', JSON.stringify({ program: 'Bubblestone', recipe: `${SMALL.slice(1)}&seed=5` }), 'application/json');
  await message(page, 'status', /mine\.json/);
  await digest(page);
  await drop(page, 'shape.svg', '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h7v7H1z"/></svg>', 'image/svg+xml');
  await page.waitForFunction(() => window.bubblestone.get('outline') === 'polygon', { timeout: 60_000 });
  await digest(page);
  await click(page, '#save');
  await click(page, '#save-maps');
  await message(page, 'status', /maps-opengl\.zip is saved/);
  // The model keeps the few cells of this surface.
  await page.evaluate((fragment) => (location.hash = fragment), BALL);
  await page.waitForSelector('.make[data-make=surface][aria-current]');
  await drop(page, 'wedge.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n', '');
  await message(page, 'status', /wedge\.obj is open/);
  // A compared surface is drawn by frames in a canvas of its own.
  await click(page, '#compare-button');
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => name.includes('/canvas-')));
  assert.deepEqual(problems, []);
  await close();
  const embedded = await visit(`?embed${SMALL}`);
  assert.equal(await embedded.page.$eval('.embed-play', (button) => getComputedStyle(button).position), 'absolute');
  assert.deepEqual(embedded.problems, []);
  await embedded.close();
  const japanese = await visit(`${SMALL}&view=cells`, 'ja');
  assert.equal(await japanese.page.$eval('html', (html) => html.lang), 'ja');
  assert.deepEqual(japanese.problems, []);
  await japanese.close();
  const inSpace = await visit(BALL, 'ja');
  await digest(inSpace.page);
  await inSpace.page.select('#language', 'en');
  await inSpace.page.waitForFunction(() => document.documentElement.lang === 'en' && document.title.startsWith('Bubblestone'));
  assert.deepEqual(inSpace.problems, []);
  await inSpace.close();
  const first = firstOf(dist);
  // A film takes long; film.test.mjs makes one. learn-pages.test.mjs opens the chapters.
  const late = filesOf(dist).filter((path) => path.startsWith('assets/') && !first.includes(path) && !/\/(film|turn-film|encoder|learn)-/.test(path));
  assert.deepEqual(late.filter((path) => !site.requests.includes(path)), [], 'not asked for');
});

test('the page leads to the licences of all packages in it', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  const address = await page.$eval('[data-t=libraries]', (link) => link.href);
  const answer = await fetch(address);
  assert.equal(answer.headers.get('content-type'), 'text/plain; charset=utf-8');
  const text = await answer.text();
  // The file names a package of the page's bundle, one of a worker's, and one inside another package.
  for (const words of [/^uplot [\d.]+, MIT\nSource: https:/m, /^mediabunny [\d.]+, MPL-2\.0\nSource: https:.*\n\nMozilla Public License Version 2\.0/m, /^htmlparser2 [\d.]+, MIT/m]) assert.match(text, words);
  await close();
});

test('where a port is taken the next one is', sameEverywhere, async () => {
  const { port } = new URL(site.origin);
  const other = await serveSite(Number(port));
  assert.ok(Number(new URL(other.origin).port) > Number(port));
  assert.equal((await fetch(other.address)).headers.get('content-type'), 'text/html; charset=utf-8');
  assert.equal((await fetch(`${other.address}%2e%2e/package.json`)).status, 404);
  other.stop();
});
