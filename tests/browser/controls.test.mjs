import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { sameEverywhere } from './browsers.mjs';
import { open } from './harness.mjs';
import { all, canvas, digest, edit, frames, get, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

// Parameters without a control in the panel, which other tests cover.
const NO_CONTROL = new Set(['poly']);

// The context in which a parameter has a visible effect, as part of the link.
const NEEDS = {
  on: 'outline=star',
  pop: 'start=quadtree&cs=9',
  crowd: 'start=quadtree&cs=9',
  room: 'start=quadtree&cs=9',
  given: 'outline=square',
  fend: 'mend=0.5',
  // Without damping cells still move when cooling begins.
  cool: 'mend=0&damp=0',
  parts: 'lines=0,0.3,1,0.6',
  cd: 'kind=rectangle&cb=2',
  gd: 'gb=2',
  ends: 'kind=rectangle&outline=road_straight',
  ba: 'belly=0.7',
  reach: 'dir=constant&strokes=0.1,0.1,0.6,0.9',
  sa: 'stone=skin&sc=1.5',
  flow: 'stone=skin&sc=1.5&dir=constant&strokes=0.9,0.5,0.1,0.5',
};

// A picture of a few cells, as each parameter needs two.
const FEW = '#size=128&cs=14';

// Values that surely change the picture; those that `another` finds by rule might not.
const OTHER = { cs: '21', on: '7', seed: '7', size: '256', crowd: '0.95', room: '0.3', fend: '0', mend: '0', most: '3', cool: '0.5', given: '0.5,0.5,0' };

/** A value other than this one. */
function another(parameter, value) {
  if (parameter.key in OTHER) return OTHER[parameter.key];
  if (parameter.kind === 'choice') {
    return parameter.choices.map((choice) => choice.word).find((choice) => choice !== value && choice !== 'polygon');
  }
  const { min, max } = parameter;
  const number = Number(value);
  const far = number - min > max - number ? min + (number - min) * 0.4 : number + (max - number) * 0.4;
  return parameter.kind === 'int' ? String(Math.round(far)) : far.toFixed(2);
}

test('every control reaches the picture', sameEverywhere, async (t) => {
  // No step here waits for the frames of a forming, which take half of the time.
  const { page, problems, close } = await site.newPage(FEW, { still: true });
  await digest(page);
  const schema = await page.evaluate(() => window.bubblestone.schema);
  await all(page);
  for (const parameter of schema) {
    const { key } = parameter;
    if (NO_CONTROL.has(key)) continue;
    await t.test(key, async () => {
      const rule = parameter.shownFor;
      const needs = NEEDS[key] ?? (rule ? `${rule.key}=${rule.words[0]}` : '');
      await page.evaluate((fragment) => (location.hash = fragment), `${FEW}&seed=${1 + schema.indexOf(parameter)}&${needs}`);
      await frames(page, 1);
      if (key !== 'seed') assert.ok(await page.$eval(`[data-key="${key}"]`, (control) => !control.hidden), 'the control is hidden');
      const before = { planes: await digest(page), ...(await canvas(page)) };
      // Most texts are drawn in the editor; some are typed.
      const isDrawn = parameter.kind === 'text' && !(key in OTHER);
      const value = isDrawn ? 'one more' : another(parameter, await get(page, key));
      if (isDrawn) await edit(page, key);
      else {
        await set(page, key, value);
        if (parameter.kind !== 'text') assert.equal(Number(await get(page, key)) || (await get(page, key)), Number(value) || value);
      }
      await frames(page, 2);
      const now = { planes: await digest(page), ...(await canvas(page)) };
      assert.notEqual(now.hash, before.hash, `${key}=${value} does not change the picture`);
      if (parameter.group === 'Light' || key === 'gloss') assert.equal(now.planes, before.planes, 'light changes the planes');
      else assert.notEqual(now.planes, before.planes, `${key}=${value} does not change the planes`);
      assert.match(await page.evaluate(() => window.bubblestone.link()), new RegExp(`(^|&)${key}=`));
      // A text opens the editor, which covers the other controls.
      if (isDrawn) await page.$eval('#edit-done', (button) => button.click());
    });
  }
  assert.deepEqual(problems, []);
  await close();
});

test('controls that do not apply are hidden', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await all(page);
  const schema = await page.evaluate(() => window.bubblestone.schema);
  const values = Object.fromEntries(await Promise.all(schema.map(async ({ key }) => [key, await get(page, key)])));
  const applies = (key) => {
    const { shownFor } = schema.find((other) => other.key === key);
    if (!shownFor) return true;
    const [value, standard] = [values[shownFor.key], schema.find((other) => other.key === shownFor.key).default];
    const fits = shownFor.words.length ? shownFor.words.includes(value) : String(value) !== String(standard);
    return fits && applies(shownFor.key);
  };
  const rules = schema.filter(({ key, shownFor }) => shownFor && !NO_CONTROL.has(key));
  assert.ok(rules.length > 10);
  for (const { key } of rules) {
    assert.equal(await page.$eval(`[data-key="${key}"]`, (control) => control.hidden), !applies(key), key);
  }
  await close();
});

test('a double click or the reset button goes back to the default', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&dr=0.9`);
  await digest(page);
  const slider = '[data-key=dr] [type=range]';
  await page.$eval('[data-key=dr]', (control) => (control.closest('details').open = true));
  const standard = await page.evaluate(() => window.bubblestone.schema.find((row) => row.key === 'dr').default);
  const isDefault = async () => Number(await get(page, 'dr')) === Number(standard);
  assert.equal(await isDefault(), false);
  await page.$eval(slider, (range) => range.dispatchEvent(new MouseEvent('dblclick', { bubbles: true })));
  assert.equal(await isDefault(), true);
  await set(page, 'dr', '0.77');
  assert.equal(await isDefault(), false);
  await page.$eval('[data-key=dr] .reset', (button) => button.click());
  assert.equal(await isDefault(), true);
  assert.equal(await page.$eval('[data-key=dr] .reset', (button) => getComputedStyle(button).visibility), 'hidden');
  await close();
});

/** The state of a number's control. */
function told(page, key) {
  return page.$eval(`[data-key=${key}]`, (control) => ({
    value: control.querySelector('[type=number]').value,
    changed: control.hasAttribute('data-changed'),
    notch: Number(control.querySelector('[type=range]').style.getPropertyValue('--default')),
    reset: control.querySelector('.reset').title,
    label: control.querySelector('.reset').getAttribute('aria-label'),
  }));
}

test('untouched numbers go over to the defaults of skin and back with the stone', sameEverywhere, async () => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const link = () => page.evaluate(() => window.bubblestone.link());
  const plain = await link();
  const stones = { sv: '1', dr: '0.3', fd: '1.5', af: '2' };
  const skin = { sv: '1.4', dr: '0.05', fd: '1.1', af: '0.1' };
  const shows = async (standards) => {
    for (const [key, standard] of Object.entries(standards)) {
      const { value, changed, reset, label, notch } = await told(page, key);
      assert.deepEqual([value, changed], [standard, false], key);
      assert.match(reset, new RegExp(`^Back to ${standard}( px)?$`));
      assert.match(label, new RegExp(` to ${standard}( px)?$`));
      const { min, max } = await page.evaluate((name) => window.bubblestone.schema.find((row) => row.key === name), key);
      assert.ok(Math.abs(notch - (Number(standard) - min) / (max - min)) < 1e-6, `${key}: the notch is at ${notch}`);
    }
  };
  await shows(stones);
  await set(page, 'stone', 'skin');
  await shows(skin);
  assert.equal(await link(), `${plain}&stone=skin`);
  await set(page, 'stone', 'flag');
  await shows(stones);
  await set(page, 'dr', '0.2');
  await set(page, 'stone', 'skin');
  assert.equal(await get(page, 'dr'), '0.2');
  assert.equal((await told(page, 'dr')).changed, true);
  await set(page, 'stone', 'cobble');
  assert.equal(await link(), `${plain}&dr=0.2`);
  assert.deepEqual(problems, []);
  await close();
});

test('resets of skin go back to the defaults of skin', sameEverywhere, async () => {
  const { page, close } = await site.newPage(`${SMALL}&stone=skin&sv=1&af=2`);
  await digest(page);
  await all(page);
  assert.deepEqual([(await told(page, 'sv')).changed, (await told(page, 'af')).changed, (await told(page, 'dr')).changed], [true, true, false]);
  await page.$eval('[data-key=sv] .reset', (button) => button.click());
  await page.$eval('[data-key=af] [type=range]', (range) => range.dispatchEvent(new MouseEvent('dblclick', { bubbles: true })));
  assert.deepEqual([await get(page, 'sv'), await get(page, 'af')], ['1.4', '0.1']);
  assert.doesNotMatch(await page.evaluate(() => window.bubblestone.link()), /sv=|af=/);
  await close();
});

test('a value out of range is clamped, and the page says so', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await set(page, 'dr', '7');
  assert.equal(await get(page, 'dr'), '1');
  assert.equal(await page.$eval('#p-dr', (box) => box.value), '1');
  assert.match(await page.$eval('#notices', (notices) => notices.textContent), /\b1\b/);
  // The value stays, and the box shows it, after a number that is clamped to the same value, and after no number.
  for (const text of ['9', '']) {
    await set(page, 'dr', text);
    assert.equal(await get(page, 'dr'), '1');
    assert.equal(await page.$eval('#p-dr', (box) => box.value), '1');
  }
  await page.focus('#seed');
  await page.$eval('#seed', (box) => box.select());
  await page.keyboard.type('-7.5');
  await page.keyboard.press('Enter');
  assert.equal(await get(page, 'seed'), '0');
  assert.equal(await page.$eval('#seed', (box) => box.value), '0');
  await close();
});

test('every control has a name, a help text and its symbol', sameEverywhere, async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  const bare = await page.$$eval('.control', (controls) =>
    controls.flatMap((control) =>
      [...control.querySelectorAll('input, select, .wide')]
        .filter((input) => {
          const group = input.type === 'radio' ? input.closest('[role=radiogroup]') : input;
          const help = group.getAttribute('aria-describedby')?.split(' ')[0];
          const named = input.labels?.length || input.getAttribute('aria-label') || input.getAttribute('aria-labelledby');
          return !named || !document.getElementById(help ?? '')?.textContent;
        })
        .map(() => control.dataset.key),
    ),
  );
  assert.deepEqual(bare, []);
  const symbols = await page.evaluate(() => window.bubblestone.schema.filter((row) => row.symbol && document.querySelector(`[data-key="${row.key}"]`)));
  for (const { key, symbol } of symbols) {
    assert.equal(await page.$eval(`[data-key="${key}"] .symbol`, (sign) => sign.textContent), symbol);
  }
  await close();
});
