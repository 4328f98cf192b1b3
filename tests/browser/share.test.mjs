import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import jsQR from 'jsqr';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, canvas, click, digest, done, drop, frames, get, message, messages, phone, set, SMALL, steps } from './page.mjs';
import { handed } from './saved.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Opens the dialog as people do. */
async function share(page) {
  await click(page, '#share');
  await page.waitForSelector('#share-dialog[open]');
}

/** The text that a camera would read from the screen. */
async function scanned(page) {
  const { data, width, height } = await page.evaluate(async () => {
    const code = document.querySelector('.qr');
    const { width, height } = code.getBoundingClientRect();
    const picture = new Image();
    const copy = code.cloneNode(true);
    copy.setAttribute('width', String(width));
    copy.setAttribute('height', String(height));
    picture.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
    await picture.decode();
    const canvas = document.createElement('canvas');
    // A dark page surrounds the code.
    canvas.width = Math.round(width) + 40;
    canvas.height = Math.round(height) + 40;
    const context = canvas.getContext('2d');
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(picture, 20, 20, Math.round(width), Math.round(height));
    return { data: Array.from(context.getImageData(0, 0, canvas.width, canvas.height).data), width: canvas.width, height: canvas.height };
  });
  return jsQR.default(Uint8ClampedArray.from(data), width, height)?.data;
}

test('a press beside a dialog closes it; one on its own margin does not, nor does a drag that ends beside it', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await share(page);
  const { left, top, right } = await page.$eval('#share-dialog', (dialog) => dialog.getBoundingClientRect().toJSON());
  const isOpen = async () => {
    await frames(page, 2);
    return (await page.$('#share-dialog[open]')) !== null;
  };
  await page.mouse.click(left + 6, top + 60);
  assert.ok(await isOpen(), 'a press on the margin');
  await page.mouse.move(left + 6, top + 60);
  await page.mouse.down();
  await page.mouse.move(left - 40, top + 60, { steps: 3 });
  await page.mouse.up();
  assert.ok(await isOpen(), 'a drag from the margin to the page');
  await page.mouse.click(right + 40, top + 60);
  assert.ok(!(await isOpen()), 'a press beside it');
  await close();
});

test('on a low screen the button that closes the dialog is in sight, at its beginning and its end', async () => {
  const { page, close } = await site.newPage(SMALL, { viewport: { ...phone, width: 844, height: 390 } });
  await digest(page);
  await click(page, '#save');
  await page.waitForSelector('#save-dialog[open]');
  for (const at of [0, 99_999]) {
    const lies = await page.$eval('#save-dialog', async (dialog, top) => {
      dialog.scrollTo(0, top);
      await new Promise(requestAnimationFrame);
      const button = dialog.querySelector('[data-close]');
      const { left, top: upper, right, bottom } = button.getBoundingClientRect();
      return { in: upper >= 0 && bottom <= innerHeight, free: document.elementFromPoint((left + right) / 2, (upper + bottom) / 2) === button };
    }, at);
    assert.deepEqual(lies, { in: true, free: true }, String(at));
  }
  await close();
});

test('the dialog copies the link, tells what it holds, and gives the focus back', async () => {
  const { page, problems, external, close } = await site.newPage(`${SMALL}&seed=7`);
  await digest(page);
  await site.allowClipboard(page);
  await page.bringToFront();
  await share(page);
  const link = await page.$eval('#share-link', (box) => box.value);
  assert.equal(link, `${site.address}#${await page.evaluate(() => window.bubblestone.link())}`);
  await click(page, '#copy');
  await page.waitForFunction(() => /copied/.test(document.querySelector('#share-dialog [role=status]').textContent));
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), link);
  assert.equal(await page.$eval('#share-holds', (line) => line.textContent), `${link.length} characters: 3 values other than the defaults.`);
  await page.keyboard.press('Escape');
  await frames(page, 2);
  assert.equal(await page.$('#share-dialog'), null);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'share');
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

for (const dark of [false, true]) {
  test(`a camera reads the QR code of a ${dark ? 'dark' : 'light'} page`, sameEverywhere, async () => {
    const { page, problems, close } = await site.newPage(`${SMALL}&seed=77&palette=marble`, { dark });
    await digest(page);
    await share(page);
    assert.equal(await scanned(page), await page.$eval('#share-link', (box) => box.value));
    assert.deepEqual(problems, []);
    await close();
  });
}

test('a link of a hundred points stays short; one too long for a QR code is said to be', sameEverywhere, async () => {
  const ring = (count) => Array.from({ length: count }, (_, k) => {
    const [angle, radius] = [(2 * Math.PI * k) / count, 0.36 + 0.07 * Math.sin(0.9 * k)];
    return [0.5 + radius * Math.cos(angle), 0.5 + radius * Math.sin(angle)];
  });
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const take = async (count) => {
    const before = await page.evaluate(() => window.bubblestone.link());
    const text = JSON.stringify({ size: [1, 1], outer: ring(count) });
    await drop(page, 'ring.json', text, 'application/json');
    await page.waitForFunction((link) => window.bubblestone.link() !== link, { timeout: 60_000 }, before);
    await page.keyboard.press('Escape');
    await digest(page);
  };
  await take(100);
  await share(page);
  const link = await page.$eval('#share-link', (box) => box.value);
  assert.ok(link.length < 2000, `${link.length} characters`);
  assert.match(await page.$eval('#share-holds', (line) => line.textContent), /an outline of 100 points/);
  if (await page.$('.qr')) assert.equal(await scanned(page), link);
  await page.keyboard.press('Escape');
  await frames(page, 2);
  await take(400);
  await share(page);
  assert.match(await page.$eval('#qr-long', (line) => line.textContent), /too long for a QR code/);
  assert.equal(await page.$('.qr'), null);
  assert.deepEqual(problems, []);
  await close();
});

test("the system's share sheet gets the link and the picture, where there is one", sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL, {
    viewport: phone,
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        navigator.canShare = ({ files }) => files.every(({ type }) => type === 'image/png');
        const Plain = File;
        window.File = class extends Plain {
          constructor(...given) {
            super(...given);
            window.made = true;
          }
        };
        navigator.share = async ({ title, url, files }) => {
          window.shared = { title, url, files: files.map(({ name, size }) => [name, size]) };
        };
      }),
  });
  await digest(page);
  await page.tap('#share');
  await page.waitForSelector('#share-system');
  // The browser writes the picture when it is idle.
  await page.waitForFunction(() => window.made);
  await handed(page, () => page.tap('#share-system'), 'shared');
  const { title, url, files } = await page.evaluate(() => window.shared);
  assert.match(title, /^Bubblestone: /);
  assert.equal(url, await page.$eval('#share-link', (box) => box.value));
  assert.equal(files[0][0], 'bubblestone-ring-1-192.png');
  assert.ok(files[0][1] > 1000);
  assert.deepEqual(problems, []);
  await close();
});

test('the embed code shows the picture alone, plays, and leads to the whole page', async () => {
  // The packing takes a hundred and sixty steps, which leaves time to pause.
  const { page, problems, close } = await site.newPage('#size=192&cs=12&vs=0.5&seed=9');
  const planes = await digest(page);
  await set(page, 'palette', 'marble');
  await set(page, 'palette', 'granite');
  await page.waitForFunction(() => document.querySelector('#stored').textContent !== '');
  const stored = await page.evaluate(() => localStorage.getItem('bubblestone.work'));
  await share(page);
  await page.select('#embed-width', '640');
  await page.select('#embed-height', '320');
  const code = await page.$eval('#embed-code', (box) => box.value);
  assert.match(code, /^<iframe .*width="640" height="320"/);
  // Another page embeds it.
  const host = await page.browserContext().newPage();
  await host.setViewport({ width: 800, height: 600 });
  await host.bringToFront();
  await host.setContent(`<!doctype html><title>Host</title>${code}`);
  const element = await host.waitForSelector('iframe');
  const frame = await element.contentFrame();
  await frame.waitForFunction(() => document.documentElement.dataset.stage === 'done', { timeout: 60_000 });
  assert.equal(await frame.evaluate(() => window.bubblestone.digest()), planes);
  const seen = await frame.evaluate(() => {
    const { x, y, width, height } = document.querySelector('#canvas').getBoundingClientRect();
    const visible = [...document.querySelectorAll('button, a, select, input')].filter((each) => each.checkVisibility());
    return { box: [x, y, width, height], visible: visible.map((each) => each.className), scroll: [document.documentElement.scrollHeight, innerHeight] };
  });
  assert.deepEqual(seen.box, [160, 0, 320, 320]);
  // Upright frames are filled as well, although the page has rules for phones.
  await element.evaluate((iframe) => (iframe.height = '640'));
  await frame.waitForFunction(() => innerHeight === 640);
  assert.deepEqual(await frame.evaluate(() => Object.values(document.querySelector('#canvas').getBoundingClientRect().toJSON()).slice(0, 4)), [0, 0, 640, 640]);
  await element.evaluate((iframe) => (iframe.height = '320'));
  await frame.waitForFunction(() => innerHeight === 320);
  assert.deepEqual(seen.visible, ['embed-play', 'embed-home']);
  assert.equal(seen.scroll[0], seen.scroll[1]);
  // A click plays on, another one pauses.
  await frame.click('.embed-play');
  // The pause comes from inside the frame: a click from outside, perhaps from another process, could be too late.
  await frame.evaluate(async () => {
    while (document.documentElement.dataset.stage !== 'packing') await new Promise(requestAnimationFrame);
    document.querySelector('.embed-play').click();
  });
  await frame.waitForFunction(() => document.querySelector('.embed-play').getAttribute('aria-label') === 'Play');
  assert.equal(await frame.evaluate(() => document.documentElement.dataset.stage), 'packing');
  const held = await frame.evaluate(() => window.bubblestone.status().steps);
  await frames(host, 10);
  assert.equal(await frame.evaluate(() => window.bubblestone.status().steps), held);
  assert.equal(await frame.$eval('.embed-play', (button) => button.getAttribute('aria-label')), 'Play');
  const home = await frame.$eval('.embed-home', (link) => link.href);
  assert.equal(home, `${site.address}#${await page.evaluate(() => window.bubblestone.link())}`);
  assert.equal(await page.evaluate(() => localStorage.getItem('bubblestone.work')), stored);
  assert.deepEqual(problems, []);
  await host.close();
  await close();
});

test('an address typed over work of one’s own can be undone; the way back asks nothing', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await set(page, 'palette', 'marble');
  const own = await digest(page);
  await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&stone=flag`);
  await message(page, 'status', /over the work/);
  assert.equal(await get(page, 'stone'), 'flag');
  await page.$eval('.message[data-topic=replaced] .actions button', (button) => button.click());
  assert.equal(await digest(page), own);
  assert.deepEqual(await messages(page), []);
  await click(page, '#dice');
  await digest(page);
  await page.goBack();
  await frames(page, 2);
  assert.equal(await digest(page), own);
  assert.deepEqual(await messages(page), []);
  assert.deepEqual(problems, []);
  await close();
});

test('the seed: the next one, the ones before, and a lock that presets respect', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&seed=4294967295`);
  await digest(page);
  const seed = () => get(page, 'seed');
  assert.equal(await page.$eval('#seed-back', (button) => button.disabled), true);
  await click(page, '#seed-next');
  assert.equal(await seed(), '0');
  await click(page, '#seed-next');
  assert.equal(await seed(), '1');
  await click(page, '#dice');
  const thrown = await seed();
  assert.notEqual(thrown, '1');
  await click(page, '#seed-back');
  assert.equal(await seed(), '1');
  await click(page, '#seed-back');
  assert.equal(await seed(), '0');
  await click(page, '#seed-back');
  assert.equal(await seed(), '4294967295');
  assert.equal(await page.$eval('#seed-back', (button) => button.disabled), true);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'seed-next');
  await set(page, 'seed', '12');
  await click(page, '#seed-lock');
  assert.equal(await page.$eval('#seed-lock', (button) => button.getAttribute('aria-pressed')), 'true');
  await click(page, '[data-preset=tortoise]');
  assert.deepEqual([await seed(), await get(page, 'palette')], ['12', 'tortoise']);
  assert.equal(await page.$eval('[data-preset][aria-current=true]', (button) => button.dataset.preset), 'tortoise');
  await click(page, '#throw');
  await page.waitForFunction(() => window.bubblestone.get('outline') !== 'polygon' || window.bubblestone.get('cs') !== '98', { timeout: 60_000 });
  assert.equal(await seed(), '12');
  // The lock is stored.
  await page.reload();
  await page.waitForFunction(() => 'bubblestone' in window);
  assert.equal(await page.$eval('#seed-lock', (button) => button.getAttribute('aria-pressed')), 'true');
  assert.deepEqual(problems, []);
  await close();
});

test('X throws what is not locked, in one step; the dice of a group throws that group', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(`${SMALL}&palette=marble`);
  await digest(page);
  await all(page);
  const values = () => page.evaluate(() => Object.fromEntries(window.bubblestone.schema.map(({ key, group }) => [key, [group, window.bubblestone.get(key)]])));
  const first = await values();
  const changedGroups = (before, after) => [...new Set(Object.keys(before).filter((key) => before[key][1] !== after[key][1]).map((key) => before[key][0]))];
  const link = await page.evaluate(() => window.bubblestone.link());
  const ofGroup = (name, kind) => page.$$eval('.grouping', (boxes, [title, which]) => boxes.find((box) => box.querySelector('summary span').textContent === title).querySelector(which).click(), [name, kind]);
  await ofGroup('Surface', '.lock');
  await ofGroup('Size', '.lock');
  await page.keyboard.press('x');
  await page.waitForFunction((before) => window.bubblestone.link() !== before, { timeout: 60_000 }, link);
  const second = await values();
  const groups = changedGroups(first, second);
  assert.ok(groups.includes('Relief') && groups.includes('Light'), String(groups));
  assert.ok(!groups.includes('Surface') && !groups.includes('Size'), String(groups));
  assert.equal(second.size[1], '192');
  assert.notEqual(second.outline[1], 'polygon');
  await digest(page);
  assert.ok((await page.evaluate(() => window.bubblestone.status().cells)) <= 1500);
  await click(page, '#undo');
  assert.equal(await page.evaluate(() => window.bubblestone.link()), link);
  await ofGroup('Light', '.dice');
  await page.waitForFunction((before) => window.bubblestone.link() !== before, { timeout: 60_000 }, link);
  assert.deepEqual(changedGroups(first, await values()), ['Light']);
  assert.deepEqual(problems, []);
  await close();
});

test('every throw is valid, and its link says no more than what counts', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  await all(page);
  await click(page, '#step');
  for (let count = 0; count < 25; count += 1) {
    const before = await page.evaluate(() => window.bubblestone.link());
    await page.keyboard.press('x');
    await page.waitForFunction((link) => window.bubblestone.link() !== link, { timeout: 60_000 }, before);
    const { link, shown, area } = await page.evaluate(() => {
      const link = window.bubblestone.link();
      const hidden = [...document.querySelectorAll('.control[hidden]')].map((control) => control.dataset.key);
      return { link, shown: hidden.filter((key) => new RegExp(`(^|&)${key}=`).test(link)), area: window.bubblestone.get('size') };
    });
    assert.deepEqual(shown.filter((key) => key !== 'outline'), [], link);
    assert.equal(area, '192');
    assert.ok(link.length < 500, link);
    assert.deepEqual(await messages(page), []);
  }
  assert.deepEqual(problems, []);
  await close();
});

test('a heavy recipe shows how far it is, and a pause holds it', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage('#size=640&cs=4', {
    before: (fresh) =>
      fresh.evaluateOnNewDocument(() => {
        window.ways = [];
        new MutationObserver((changes) => {
          for (const { target } of changes) if (target.id === 'work') window.ways.push([target.getAttribute('aria-valuetext'), Number(target.getAttribute('aria-valuenow')), target.hidden]);
        }).observe(document, { subtree: true, attributes: true, attributeFilter: ['aria-valuenow', 'hidden'] });
      }),
  });
  // A quick machine makes the first steps before the work counts as long.
  await page.waitForSelector('#work:not([hidden])');
  await page.waitForFunction(() => window.bubblestone?.status().steps > 3);
  await click(page, '#play');
  await frames(page, 3);
  const held = await steps(page);
  assert.equal(await page.$eval('#work', (bar) => bar.hidden), false);
  await frames(page, 10);
  assert.equal(await steps(page), held);
  await click(page, '#play');
  await page.$$eval('#speed input', (radios) => radios.at(-1).click());
  await done(page);
  const ways = await page.evaluate(() => window.ways);
  const numbers = ways.map(([, now]) => now);
  assert.ok(numbers.every((now, k) => k === 0 || now >= numbers[k - 1]), numbers.join(' '));
  assert.ok(new Set(numbers).size >= 10 && numbers.some((now) => now > 80), numbers.join(' '));
  assert.match(ways.find(([, now]) => now > 10)[0], /^Packing, \d+ %$/);
  assert.equal(await page.$eval('#work', (bar) => bar.hidden), true);
  assert.ok((await canvas(page)).colours > 100);
  assert.deepEqual(problems, []);
  await close();
});

test('the words of what is taken away stand in both languages, with the same places for values', sameEverywhere, () => {
  const { en, ja } = JSON.parse(readFileSync(new URL('../../www/strings/take.json', import.meta.url), 'utf8'));
  assert.deepEqual(Object.keys(ja), Object.keys(en));
  const places = (text) => (text.match(/\{\w+\}/g) ?? []).sort();
  for (const key of Object.keys(en)) assert.deepEqual(places(ja[key]), places(en[key]), key);
});
