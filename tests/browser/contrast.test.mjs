import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { all, digest, edit, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** Texts whose contrast with their background is below 4.5, by WCAG 2's formula. */
function faint() {
  const parse = (text) => {
    const [r, g, b, a = 1] = text.match(/[\d.]+/g).map(Number);
    return { r, g, b, a };
  };
  const over = (top, below) => {
    const mix = (x, y) => x * top.a + y * (1 - top.a);
    return { r: mix(top.r, below.r), g: mix(top.g, below.g), b: mix(top.b, below.b), a: 1 };
  };
  const light = ({ r, g, b }) => {
    const [x, y, z] = [r, g, b].map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const ground = (element) => {
    const layers = [];
    for (let at = element; at; at = at.parentElement) layers.push(parse(getComputedStyle(at).backgroundColor));
    return layers.reverse().reduce((below, top) => over(top, below), { r: 255, g: 255, b: 255, a: 1 });
  };
  const found = [];
  let count = 0;
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
    const field = element.matches('input[type=number], select');
    if ((!own && !field) || !element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) || element.disabled) continue;
    const back = ground(element);
    const text = over(parse(getComputedStyle(element).color), back);
    const [high, low] = [light(text), light(back)].sort((a, b) => b - a);
    const ratio = (high + 0.05) / (low + 0.05);
    count += 1;
    if (ratio < 4.5) found.push(`${ratio.toFixed(2)}: ${element.outerHTML.slice(0, 90)}`);
  }
  return { found, count };
}

for (const dark of [false, true]) {
  test(`every text can be read on a ${dark ? 'dark' : 'light'} page`, async () => {
    const { page, close } = await site.newPage(`${SMALL}&junk=1`, { dark });
    await digest(page);
    await all(page);
    await page.evaluate(() => {
      for (const details of document.querySelectorAll('details')) details.open = true;
      for (const control of document.querySelectorAll('.control')) {
        control.hidden = false;
        control.toggleAttribute('data-changed', true);
      }
      document.querySelector('#alerts').append(document.querySelector('#notices .message').cloneNode(true));
    });
    await edit(page, 'spots');
    await page.hover('[data-key=cs]');
    const { found, count } = await page.evaluate(faint);
    assert.ok(count > 100, `only ${count} texts`);
    assert.deepEqual(found, []);
    const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert.equal(ground[0] < 128, dark);
    await close();
  });
}
