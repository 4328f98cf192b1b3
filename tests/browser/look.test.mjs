// The tools for a closer look, used as people do.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, done, frames, get, message, phone, set, SMALL, SQUARE, steps, tool } from './page.mjs';
import { box, drag, listening, spot } from './sheet.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('the sun is dragged: only the light is worked out anew, in one step of the history', async () => {
  const { page, problems, close } = await listening(site, SQUARE);
  const before = await canvas(page);
  const times = () => page.evaluate(() => Object.entries(window.bubblestone.status().ms).filter(([stage]) => stage !== 'shading'));
  const others = await times();
  const taken = await steps(page);
  await page.keyboard.press('l');
  await page.waitForSelector('#light-sun', { visible: true });
  const sun = await box(page, '#light-sun');
  // Halfway to the horizon, to the right.
  await drag(page, { x: sun.x + sun.width / 2, y: sun.y + sun.height / 2 }, await spot(page, 0.5 + 0.23, 0.5));
  assert.equal(await page.$eval('html', (html) => html.dataset.stage !== 'packing'), true);
  await page.mouse.up();
  await done(page);
  const [az, el] = [Number(await get(page, 'az')), Number(await get(page, 'el'))];
  assert.ok(Math.abs(((az + 180) % 360) - 180) < 3 && Math.abs(el - 45) < 3, `${az}, ${el}`);
  assert.match(await page.evaluate(() => window.bubblestone.link()), /az=/);
  assert.notEqual((await canvas(page)).hash, before.hash);
  const now = await times();
  assert.deepEqual(now, others);
  assert.equal(await steps(page), taken);
  await page.keyboard.press('l');
  await click(page, '#undo');
  await done(page);
  assert.deepEqual([await get(page, 'az'), await get(page, 'el')], ['225', '42']);
  assert.equal(await page.$eval('#undo', (undo) => undo.disabled), true);
  assert.deepEqual(problems, []);
  await close();
});

test('the sun and the lamp are moved by arrow keys', sameEverywhere, async () => {
  const { page, close } = await listening(site, SQUARE);
  await click(page, '#light-button');
  await page.waitForSelector('#light-sun', { visible: true });
  await page.focus('#light-sun');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  assert.deepEqual([await get(page, 'az'), await get(page, 'el')], ['228', '45']);
  assert.match(await page.$eval('#light-sun', (sun) => sun.getAttribute('aria-valuetext')), /228°.*45°/);
  // A filter would cover the whole picture. Painting that takes seconds without a graphics card.
  const filters = await page.$$eval('.light-layer svg *', (parts) => parts.map((part) => getComputedStyle(part).filter));
  assert.deepEqual([...new Set(filters)], ['none']);
  await page.evaluate(() => [...document.querySelectorAll('.light-kinds input')].at(-1).click());
  assert.equal(await get(page, 'light'), 'point');
  await page.focus('#light-lamp');
  await page.keyboard.press('ArrowDown');
  assert.equal(await get(page, 'ly'), '0.22');
  await page.focus('#light-bulb');
  await page.keyboard.press('ArrowUp');
  assert.equal(await get(page, 'lz'), '0.42');
  await done(page);
  const lamp = await box(page, '#light-lamp');
  const to = await spot(page, 0.7, 0.6);
  await drag(page, { x: lamp.x + lamp.width / 2, y: lamp.y + lamp.height / 2 }, to);
  await page.mouse.up();
  assert.ok(Math.abs(Number(await get(page, 'lx')) - 0.7) < 0.02 && Math.abs(Number(await get(page, 'ly')) - 0.6) < 0.02);
  await page.keyboard.press('Escape');
  await page.focus('#light-bulb');
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#light-bulb', (bulb) => bulb.checkVisibility()), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'light-button');
  await close();
});

/** The module's numbers of the cell at a place of the sheet. */
function probe(page, fx, fy) {
  return page.evaluate(
    (x, y) => {
      const { size, wanted, sides, neighbours, area } = window.bubblestone.probe(x * 192, y * 192);
      return { size: `${size.toFixed(1)}, asked ${wanted.toFixed(1)}`, sides: String(sides), neighbours: String(neighbours), area: area.toFixed(0) };
    },
    fx,
    fy,
  );
}

const card = (page) => page.$$eval('.cell-card div', (rows) => Object.fromEntries(rows.map(({ children: [name, value] }) => [name.textContent.toLowerCase(), value.textContent])));

test('the cell under the pointer is told, in the numbers of the module, and never while points are moved', async () => {
  const { page, close } = await listening(site);
  const at = await spot(page, 0.42, 0.55);
  await page.mouse.move(at.x, at.y);
  await page.waitForSelector('.cell-card', { visible: true });
  const told = await card(page);
  const { size, sides, neighbours, area } = await probe(page, 0.42, 0.55);
  assert.deepEqual({ size: told.size, sides: told.sides, neighbours: told.neighbours, area: told.area }, { size, sides, neighbours, area });
  const outline = await box(page, '#cells path');
  assert.ok(outline.x <= at.x && at.x <= outline.right && outline.y <= at.y && at.y <= outline.bottom);
  await click(page, '#edit-outline');
  await page.mouse.move(at.x + 3, at.y);
  await frames(page, 15);
  assert.equal(await page.$eval('.cell-card', (element) => element.checkVisibility()), false);
  await close();
});

test('arrow keys walk from cell to cell and say what each is', sameEverywhere, async () => {
  const { page, close } = await listening(site);
  await page.focus('#cells');
  const said = () => page.$eval('#cell-said', (text) => text.textContent);
  const places = [];
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowDown']) {
    await page.keyboard.press(key);
    places.push(await box(page, '#cells path'));
    assert.match(await said(), /Size [\d.]+, asked [\d.]+.*Sides \d+/);
  }
  const [a, b, c, d] = places.map(({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 }));
  assert.ok(b.x > a.x + 5 && c.x > b.x + 5 && d.y > c.y + 5, JSON.stringify([a, b, c, d]));
  // No cell lies beyond the boundary.
  for (let k = 0; k < 20; k += 1) await page.keyboard.press('ArrowRight');
  assert.equal(await said(), 'No cell is there.');
  await page.keyboard.press('ArrowLeft');
  assert.match(await said(), /Size/);
  await close();
});

/** Waits until the canvas shows a picture whose hash is not in the set, and adds its hash. @param {Set<number>} seen */
async function unseen(page, seen, what) {
  for (let tries = 0; tries < 600; tries += 1) {
    const { hash } = await canvas(page);
    if (!seen.has(hash)) return seen.add(hash);
    await frames(page, 1);
  }
  assert.fail(`${what} looks like another picture`);
}

/** Waits until the compared picture equals the page's own. */
const alike = (page) => page.waitForFunction(() => document.querySelector('.other').toDataURL() === document.querySelector('#canvas').toDataURL());

test('layers are drawn over the picture, each with a sentence, and the canvas keeps its place', sameEverywhere, async () => {
  const { page, problems, close } = await listening(site);
  const place = await box(page, '#canvas');
  await page.keyboard.press('o');
  await page.waitForSelector('#layers', { visible: true });
  assert.deepEqual(await box(page, '#canvas'), place);
  const seen = new Set([(await canvas(page)).hash]);
  const check = (word) => page.$eval(`#layers [value=${word}]`, (input) => input.click());
  const layers = ['size', 'packed', 'energy', 'cells', 'mesh', 'direction'];
  for (const word of layers) {
    await page.$eval(`#layers [type=checkbox][value=${word}]`, (input) => input.click());
    await unseen(page, seen, word);
  }
  assert.equal((await page.$$('.layers-legend dt')).length, layers.length + 1, 'the layers and what lies below them');
  await check('albedo');
  await unseen(page, seen, 'albedo');
  assert.equal(await page.$eval('#view', (select) => select.value), 'albedo');
  await page.keyboard.press('9');
  assert.equal(await page.$eval('#layers [value=size]', (input) => input.disabled), true);
  await page.focus('#layers [value=potential]');
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('#layers', (layers) => layers.hidden), true);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'layers-button');
  assert.deepEqual(problems, []);
  await close();
});

test('a caption tells what colours mean in each view of planes', sameEverywhere, async () => {
  const { page, problems, close } = await listening(site);
  const caption = () => page.$eval('#caption', (element) => element.textContent);
  const captions = new Set([await caption()]);
  const views = ['height', 'normals', 'ids', 'albedo', 'roughness', 'ao', 'paper'];
  for (const view of views) {
    await page.select('#view', view);
    await page.waitForFunction((told) => !told.includes(document.querySelector('#caption').textContent), {}, [...captions]);
    captions.add(await caption());
    if (view === 'height') assert.ok(Number(/([\d.]+) px/.exec(await caption())?.[1]) > 3, await caption());
  }
  assert.equal(captions.size, views.length + 1, 'no two captions are the same');
  assert.deepEqual(problems, []);
  await close();
});

test('what shows nothing says why, beside the picture and in its layer, until there is something', sameEverywhere, async () => {
  const { page, problems, close } = await listening(site, SMALL);
  const absent = () => page.$$eval('#caption .absent', (spans) => spans.map((span) => span.textContent));
  assert.deepEqual(await absent(), []);
  await click(page, '#layers-button');
  await page.waitForSelector('#layers', { visible: true });
  const turn = (word) => page.$eval(`#layers [type=checkbox][value=${word}]`, (input) => input.click());
  await turn('cells');
  await turn('singularities');
  await page.waitForSelector('#caption .absent');
  const [sentence] = await absent();
  assert.match(sentence, /no singular point/);
  const legend = await page.$$eval('.layers-legend dd', (notes) => notes.map((note) => note.textContent));
  assert.deepEqual(
    legend.map((note) => note.includes(sentence)),
    [false, false, true],
  );
  await set(page, 'outline', 'star');
  await page.waitForSelector('#caption .absent', { hidden: true });
  await digest(page);
  assert.deepEqual(await absent(), []);
  assert.equal((await page.$$eval('.layers-legend dd', (notes) => notes.map((note) => note.textContent))).some((note) => note.includes(sentence)), false);
  assert.deepEqual(problems, []);
  await close();
});

test('plots follow the packing, in points and in words', sameEverywhere, async () => {
  const { page, problems, close } = await listening(site);
  const place = await box(page, '#canvas');
  await click(page, '#plots-button');
  await page.waitForSelector('#plots canvas', { visible: true });
  assert.deepEqual(await box(page, '#canvas'), place);
  const said = (id) => page.$eval(`#${id} .plot-said`, (text) => text.textContent);
  const inked = (id) =>
    page.$eval(`#${id} canvas`, (plot) => {
      const { data } = plot.getContext('2d').getImageData(0, 0, plot.width, plot.height);
      let sum = 0;
      for (let k = 3; k < data.length; k += 4) sum = (sum * 31 + data[k] * k) % 1e9;
      return sum;
    });
  const ids = ['plot-energy', 'plot-move', 'plot-size', 'plot-angle'];
  for (const id of ids) assert.notEqual(await inked(id), 0);
  const taken = await steps(page);
  assert.ok((await said('plot-energy')).startsWith(`After ${taken} steps`));
  assert.match(await said('plot-size'), /^\d+ % of \d+ cells/);
  assert.deepEqual(await page.$$eval('#plot-energy .plot-key span', (names) => names.map((name) => name.textContent)), ['sum', 'pairs', 'walls', 'motion']);
  const before = await inked('plot-energy');
  await click(page, '#step');
  await page.waitForFunction(() => window.bubblestone.stage !== 'done' && document.documentElement.dataset.stage === 'packing');
  for (let k = 0; k < 3; k += 1) await click(page, '#step');
  await page.waitForFunction(() => /^After 3 steps/.test(document.querySelector('#plot-energy .plot-said').textContent));
  assert.notEqual(await inked('plot-energy'), before);
  await set(page, 'kind', 'circle');
  await page.waitForFunction(() => /^Round cells/.test(document.querySelector('#plot-angle .plot-said').textContent));
  assert.equal(await page.$eval('#plot-angle canvas', (plot) => plot.checkVisibility({ visibilityProperty: true })), false);
  assert.deepEqual(problems, []);
  await close();
});

test('the picture is repeated side by side, and cells are told of in each', sameEverywhere, async () => {
  const { page, problems, close } = await listening(site, '#size=192&cs=16&tile=1');
  await page.keyboard.press('t');
  await page.waitForSelector('.tiles', { visible: true });
  assert.equal(await page.$eval('#tile-word', (word) => word.textContent), '2 × 2');
  const [same, side] = await page.$eval('.tiles', (tiles) => {
    const half = tiles.width / 2;
    const part = (x, y) => tiles.getContext('2d').getImageData(x * half, y * half, half, half).data.join();
    return [[part(1, 0), part(0, 1), part(1, 1)].every((other) => other === part(0, 0)), tiles.width];
  });
  assert.ok(same);
  assert.equal(side, 384);
  const at = await spot(page, 0.75, 0.75);
  await page.mouse.move(at.x, at.y);
  await page.waitForSelector('.cell-card', { visible: true });
  const { size } = await probe(page, 0.5, 0.5);
  assert.equal((await card(page)).size, size);
  const outline = await box(page, '#cells path');
  assert.ok(outline.x <= at.x && at.x <= outline.right);
  await page.keyboard.press('t');
  await page.waitForFunction(() => document.querySelector('.tiles').width === 576);
  await page.keyboard.press('t');
  assert.equal(await page.$eval('.tiles', (tiles) => tiles.hidden), true);
  // Editing, repeats and comparisons exclude each other: the one that was started last stays.
  await tool(page, 'strokes');
  await page.keyboard.press('t');
  await page.waitForSelector('.tiles', { visible: true });
  assert.equal(await page.$eval('#editor', (layer) => layer.hidden), true);
  await page.keyboard.press('v');
  await page.waitForSelector('#divider', { visible: true });
  assert.equal(await page.$eval('.tiles', (tiles) => tiles.hidden), true);
  await page.keyboard.press('t');
  await page.waitForSelector('#divider', { hidden: true });
  assert.equal(await page.$eval('.tiles', (tiles) => tiles.hidden), false);
  assert.deepEqual(problems, []);
  await close();
});

test('another recipe is compared under a divider, made beside the shown one', async () => {
  const { page, problems, close } = await listening(site);
  const shown = await digest(page);
  const other = () => page.$eval('.other', (element) => element.toDataURL().length + element.toDataURL().slice(-400));
  const settled = () => page.waitForFunction(() => document.querySelector('.compare-progress')?.textContent === '', { timeout: 60_000 });
  await page.keyboard.press('v');
  await page.waitForSelector('#divider', { visible: true });
  await settled();
  const voronoi = await other();
  assert.notEqual(voronoi, await page.$eval('#canvas', (element) => element.toDataURL().length + element.toDataURL().slice(-400)));
  assert.equal(await digest(page), shown);
  assert.equal(await get(page, 'cells'), 'fitted');
  // The keyboard moves the divider. The second picture is visible left of it.
  const clip = () => page.$eval('.other', (element) => getComputedStyle(element).clipPath);
  const before = await clip();
  for (let k = 0; k < 10; k += 1) await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#divider', (divider) => divider.value), '60');
  assert.notEqual(await clip(), before);
  await page.select('#compare-with', 'before');
  // The previous recipe equals the page's own, so both pictures are alike in every view.
  await alike(page);
  const picture = new Set([(await canvas(page)).hash]);
  await page.keyboard.press('3');
  await unseen(page, picture, 'the view of cells');
  await alike(page);
  await page.select('#compare-with', 'link');
  await page.type('#compare-link', 'https://example.org/#nonsense=1');
  await page.keyboard.press('Tab');
  await message(page, 'status', /nonsense/);
  // A message about the link leaves its field uncovered.
  await click(page, '#compare-link', { count: 3 });
  await page.keyboard.type('https://example.org/#size=192&cs=24');
  await page.keyboard.press('Tab');
  await settled();
  assert.notEqual(await other(), voronoi);
  await page.focus('#divider');
  await page.keyboard.press('Escape');
  assert.equal(await page.$eval('.other', (element) => element.checkVisibility()), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'compare-button');
  assert.deepEqual(problems, []);
  await close();
});

test('on a phone everything for looking closer can be touched, and nothing is wider than the screen', async () => {
  const { page, close } = await listening(site, SQUARE, { viewport: phone });
  const place = await box(page, '#canvas');
  for (const id of ['light', 'layers', 'plots', 'compare']) await page.$eval(`#${id}-button`, (button) => button.click());
  for (const selector of ['#light-sun', '#layers', '#plots canvas', '#divider']) await page.waitForSelector(selector, { visible: true });
  // The page scrolls to the plots, and the picture shrinks: measure it when it is large again.
  const measured = await page.waitForFunction(
    (side) => {
      window.scrollTo({ top: 0, behavior: 'instant' });
      if (document.querySelector('#canvas').getBoundingClientRect().width !== side) return undefined;
      const inside = '.frame, .look-tools, #layers, #plots';
      const seen = [...document.querySelectorAll(inside)].flatMap((part) => [...part.querySelectorAll('*')]).filter((element) => element.checkVisibility());
      const targets = seen.filter((element) => element.matches('button, input, select, [role=slider]'));
      const label = (element) => (element.matches('[type=radio], [type=checkbox]') ? element.closest('label') : element);
      const name = (element) => element.outerHTML.slice(0, 90);
      const touched = (element) => element.getBoundingClientRect();
      return {
        small: targets.map(label).filter((element) => touched(element).width < 43.5 || touched(element).height < 43.5).map(name),
        wide: seen.filter((element) => !element.closest('svg') && touched(element).right > innerWidth + 0.5).map(name),
      };
    },
    {},
    place.width,
  );
  const { small, wide } = await measured.jsonValue();
  assert.deepEqual(small, []);
  assert.deepEqual(wide, []);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});
