import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { canvas, click, digest, done, frames, phone, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

test('a pavement forms before the eyes, without errors or external requests', async () => {
  const { page, problems, external, close } = await site.newPage('', {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        window.words = [];
        new MutationObserver(() => {
          window.built ??= document.querySelectorAll('#controls .control').length;
          const words = document.querySelectorAll('#subtitle [data-shown]').length;
          if (words !== (window.words.at(-1) ?? 0)) window.words.push(words);
        }).observe(document, {
          attributes: true,
          subtree: true,
          attributeFilter: ['data-stage', 'data-shown'],
        });
      }),
  });
  await done(page);
  assert.match(await page.title(), /Bubblestone/);
  const { colours, side } = await canvas(page);
  assert.equal(side, 512);
  assert.ok(colours > 100, `${colours} colours are a blank canvas`);
  // Bubbles push each other, settle, and turn to stone. Scripts see the end of it before the visitor does.
  await page.waitForFunction(() => window.words.at(-1) === 3);
  assert.deepEqual(await page.evaluate(() => window.words), [1, 2, 3]);
  assert.equal(await page.evaluate(() => window.built), 0, 'the picture has to wait for the panel');
  assert.match(await digest(page), /^[0-9a-f]{16,}$/);
  assert.ok((await page.$$('#controls .control')).length > 0);
  assert.deepEqual(problems, []);
  assert.deepEqual(external, []);
  await close();
});

/**
 * Records layout shifts: what moved, and its area and distance as shares of the screen. Firefox does not measure them.
 */
function watchShifts() {
  window.shifts = [];
  if (PerformanceObserver.supportedEntryTypes.includes('layout-shift')) {
    new PerformanceObserver((list) => {
      for (const { value, sources } of list.getEntries()) {
        window.shifts.push({ value, of: sources.map(({ node }) => node?.id || node?.className) });
      }
    }).observe({ type: 'layout-shift', buffered: true });
    return;
  }
  /** @type {Map<Element, DOMRect>} */
  let before = new Map();
  const look = () => {
    const now = new Map();
    for (const element of document.querySelectorAll('body *')) {
      const box = element.getBoundingClientRect();
      if (!element.checkVisibility() || box.width * box.height === 0 || box.top >= innerHeight || box.left >= innerWidth) continue;
      now.set(element, box);
      const old = before.get(element);
      const far = old ? Math.hypot(old.x - box.x, old.y - box.y) : 0;
      if (far >= 3) {
        const size = (box.width * box.height) / (innerWidth * innerHeight);
        window.shifts.push({ value: (size * far) / Math.max(innerWidth, innerHeight), of: element.id || element.className });
      }
    }
    before = now;
    requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

for (const [name, viewport] of Object.entries({
  'desk': { width: 1280, height: 800 },
  'phone': { width: 390, height: 844, isMobile: true, hasTouch: true },
})) {
  test(`nothing jumps while the page comes up on a ${name}`, async () => {
    const { page, close } = await site.newPage(SMALL, {
      viewport,
      before: async (fresh) => {
        await fresh.evaluateOnNewDocument(watchShifts);
        // While scripts load slowly, some browsers paint an incomplete page.
        await fresh.setRequestInterception(true);
        fresh.on('request', async (request) => {
          if (/\/assets\/.*\.js$/.test(request.url())) await new Promise((resolve) => setTimeout(resolve, 400));
          await request.continue();
        });
      },
    });
    await digest(page);
    await frames(page, 5);
    const shifts = await page.evaluate(() => window.shifts);
    const sum = shifts.reduce((total, { value }) => total + value, 0);
    assert.ok(sum < 0.01, JSON.stringify(shifts));
    // A shift that is made on purpose proves that the recorder sees shifts.
    await page.evaluate(() => (document.querySelector('#frame').style.marginTop = '90px'));
    await page.waitForFunction((count) => window.shifts.length > count, { timeout: 60_000 }, shifts.length);
    await close();
  });
}

test('the state of the work is told in words and numbers', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await frames(page, 2);
  assert.match(await page.$eval('#count-cells', (value) => value.textContent), /^[1-9]\d*$/);
  assert.match(await page.$eval('#count-steps', (value) => value.textContent), /^[1-9]\d*$/);
  const times = await page.$$eval('.pipeline .time', (all) => all.map((time) => time.textContent));
  assert.ok(times.length > 0 && times.length === (await page.$$('.pipeline li')).length, 'each stage has its time');
  for (const time of times) assert.match(time, /ms$/);
  await page.waitForFunction(() => /cells after \d+ steps/.test(document.querySelector('#live').textContent));
  await close();
});

test('a digest is told when its picture is shown, also where drawing is slow', async () => {
  const slow = () => {
    const { putImageData } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.putImageData = function (...given) {
      for (const begin = performance.now(); performance.now() < begin + 60; );
      putImageData.apply(this, given);
    };
  };
  const { page, close } = await site.newPage(SMALL, { before: (fresh) => fresh.evaluateOnNewDocument(slow) });
  await digest(page);
  for (const [key, value] of Object.entries({ hs: '60', el: '70', seed: '9' })) {
    const before = await canvas(page);
    await set(page, key, value);
    // Polled in every frame, so that the answer comes as early as possible.
    const [told, later] = await page.evaluate(async () => {
      const shown = () => document.querySelector('#canvas').toDataURL();
      let told = '';
      const tell = () => (told ||= shown());
      while (!told) {
        void window.bubblestone.digest().then(tell);
        await new Promise(requestAnimationFrame);
      }
      for (let left = 4; left > 0; left -= 1) await new Promise(requestAnimationFrame);
      return [told, shown()];
    });
    assert.ok(told === later, `${key}: told before it was drawn`);
    assert.notEqual((await canvas(page)).hash, before.hash, key);
  }
  await close();
});

test('every view draws something of its own', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const views = await page.$$eval('#view option', (options) => options.map((option) => option.value));
  /** @type {Map<number, string>} */
  const seen = new Map();
  for (const view of views) {
    if (view === 'auto') continue;
    await page.select('#view', view);
    await digest(page);
    const { hash } = await canvas(page);
    assert.ok(!seen.has(hash), `${view} looks like ${seen.get(hash)}`);
    seen.set(hash, view);
  }
  for (const view of ['picture', 'packed', 'cells', 'mesh']) assert.ok([...seen.values()].includes(view), `${view} is not offered`);
  assert.deepEqual(problems, []);
  await close();
});

test('presets open with their figures', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const presets = await page.evaluate(() => window.bubblestone.presets);
  assert.equal((await page.$$('[data-preset]')).length, presets.length);
  const machines = new Map(presets.filter(({ timing }) => timing).map((preset) => [preset.timing.machine, preset]));
  assert.equal(machines.size, 2, 'pavements and skins were measured on different machines');
  for (const [machine, { name, group, timing, link }] of machines) {
    await page.$$eval('.rail h2 button', (all, title) => all.find((heading) => heading.textContent === title).click(), group);
    await click(page, `[data-preset="${name}"]`);
    await digest(page);
    await frames(page, 2);
    const caption = await page.$eval('#caption', (text) => text.textContent);
    const [first, second] = timing.parts.map(({ seconds }) => seconds);
    assert.ok(caption.includes(`paper ${first} s and ${second} s, here `), caption);
    assert.match(caption, /here [\d.]+ s and [\d.]+ s\.$/);
    assert.ok((await page.$eval('#caption .seconds', (text) => text.title)).includes(machine));
    assert.equal(await page.evaluate(() => window.bubblestone.link()), link);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('each preset has a small picture, and only those in sight are fetched', async () => {
  /** @type {string[]} */
  const fetched = [];
  const { page, problems, close } = await site.newPage(SMALL, {
    before: async (fresh) => {
      fresh.on('response', (response) => {
        if (response.url().includes('/thumbs/')) fetched.push(response.url());
      });
    },
  });
  await digest(page);
  const images = '[data-preset] img';
  const arrived = () => page.$$eval(images, (all) => all.filter((image) => image.naturalWidth === 144).length);
  await page.waitForFunction((all) => [...document.querySelectorAll(all)].some((image) => image.naturalWidth === 144), { timeout: 60_000 }, images);
  const total = await page.$$eval(images, (all) => all.length);
  const made = new Set(await page.$$eval('.make img', (all) => all.map((image) => image.src)));
  const ofPresets = fetched.filter((address) => !made.has(address));
  assert.ok(ofPresets.length < 8, `${ofPresets.length} are fetched at once`);
  for (const heading of await page.$$('.rail h2 button')) {
    await heading.click();
    await page.$$eval(images, async (all) => {
      for (const image of all.filter((each) => each.offsetParent)) {
        image.scrollIntoView({ block: 'nearest' });
        while (!image.complete || !image.src) await new Promise(requestAnimationFrame);
      }
    });
  }
  assert.equal(await arrived(), total);
  // The choice of generators also shows pictures of presets.
  const shown = await page.$$eval('[data-preset] img, .make img', (all) => all.map((image) => image.src));
  // The last response may be reported after its picture is visible.
  for (let waited = 0; new Set(fetched).size < new Set(shown).size && waited < 600; waited += 1) await new Promise((resolve) => setTimeout(resolve, 100));
  assert.deepEqual(new Set(fetched), new Set(shown));
  assert.deepEqual(problems, []);
  await close();
});

test('one group of presets is unfolded, with the preset that is shown in sight', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const presets = await page.evaluate(() => window.bubblestone.presets.map(({ name, group, link }) => ({ name, group, link })));
  const groups = [...new Set(presets.map(({ group }) => group))];
  assert.deepEqual(await page.$$eval('.rail h2 button', (all) => all.map((heading) => heading.textContent)), groups);
  const open = () => page.$$eval('.rail h2 [aria-expanded=true]', (all) => all.map((heading) => heading.textContent));
  assert.deepEqual(await open(), [groups[0]]);
  for (const title of groups) {
    await page.$$eval('.rail h2 button', (all, text) => all.find((heading) => heading.textContent === text).click(), title);
    assert.deepEqual(await open(), [title]);
    const shown = await page.$$eval('[data-preset]', (all) => all.filter((button) => button.offsetParent).map((button) => button.dataset.preset));
    const names = presets.filter(({ group }) => group === title).map(({ name }) => name);
    // The preset with which the page opens comes first.
    assert.deepEqual(shown, [...names.filter((name) => name === 'lane'), ...names.filter((name) => name !== 'lane')]);
  }
  const last = presets.filter(({ group }) => group === groups[0]).at(-1);
  await page.evaluate((fragment) => (location.hash = fragment), last.link);
  await page.waitForSelector(`[data-preset="${last.name}"][aria-current]`, { timeout: 60_000 });
  assert.deepEqual(await open(), [groups[0]]);
  // It scrolls into view in the next frame.
  await page.waitForFunction(() => {
    const button = document.querySelector('.rail [aria-current]');
    const [box, frame] = [button.getBoundingClientRect(), button.closest('ul').getBoundingClientRect()];
    return box.height > 0 && box.top >= frame.top - 1 && box.bottom <= frame.bottom + 1;
  });
  assert.deepEqual(problems, []);
  await close();
});

for (const [name, viewport] of Object.entries({ desk: { width: 1280, height: 800 }, phone })) {
  test(`on a ${name} the presets begin with the one that is shown, and the sentence of the forming lies on no tool`, async () => {
    const { page, close } = await site.newPage('', { viewport });
    await page.waitForSelector('#subtitle[data-on] [data-shown]');
    await page.waitForSelector('.rail [aria-current]');
    const seen = await page.evaluate(() => {
      const line = document.querySelector('#subtitle .seen').getBoundingClientRect();
      const covered = [...document.querySelectorAll('button, select, input, .pipeline')].filter((tool) => {
        const box = tool.getBoundingClientRect();
        return box.width && box.left < line.right && box.right > line.left && box.top < line.bottom && box.bottom > line.top;
      });
      const button = document.querySelector('.rail [aria-current]');
      const { scrollTop, scrollLeft } = button.closest('ul');
      return { covered: covered.map(({ id, className }) => id || className), scrolled: [scrollTop, scrollLeft], first: button.parentElement.previousElementSibling === null, inSight: line.height > 0 && line.bottom <= innerHeight };
    });
    assert.deepEqual(seen, { covered: [], scrolled: [0, 0], first: true, inSight: true });
    await close();
  });
}

test('who asks for less motion gets the finished picture only', async () => {
  const { page, close } = await site.newPage('', { still: true });
  await done(page);
  assert.equal(await page.$eval('#speed :checked', (radio) => radio.parentElement.textContent), 'Max');
  assert.ok((await canvas(page)).colours > 100);
  await close();
});
