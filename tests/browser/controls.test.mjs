import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { open } from './harness.mjs';
import { canvas, digest, frames, get, set, SMALL } from './page.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

// Not controls of the panel, or with nothing to choose: tested elsewhere.
const NO_CONTROL = new Set(['poly', 'kind']);

// What a parameter needs before it can be seen in the picture.
const NEEDS = {
  on: { outline: 'star' },
  pop: { start: 'quadtree' },
};

// Values that are sure to differ, where half the way to the end is not.
const OTHER = { cs: '21', on: '7', seed: '7', size: '256' };

/** Another value than this one. */
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

test('every control reaches the picture', async (t) => {
  const { page, problems, close } = await site.newPage(SMALL);
  await digest(page);
  const schema = await page.evaluate(() => window.bubblestone.schema);
  await page.$$eval('details', (all) => all.forEach((details) => (details.open = true)));
  for (const parameter of schema) {
    const { key } = parameter;
    if (NO_CONTROL.has(key)) continue;
    await t.test(key, async () => {
      await page.evaluate((fragment) => (location.hash = fragment), `${SMALL}&seed=${1 + schema.indexOf(parameter)}`);
      await frames(page, 1);
      const needs = { ...(parameter.shownFor && { [parameter.shownFor.key]: parameter.shownFor.words[0] }), ...NEEDS[key] };
      for (const [other, word] of Object.entries(needs)) await set(page, other, word);
      if (key !== 'seed') assert.ok(await page.$eval(`[data-key="${key}"]`, (control) => !control.hidden), 'the control is hidden');
      const before = { planes: await digest(page), ...(await canvas(page)) };
      const value = another(parameter, await get(page, key));
      await set(page, key, value);
      assert.equal(Number(await get(page, key)) || (await get(page, key)), Number(value) || value);
      const now = { planes: await digest(page), ...(await canvas(page)) };
      assert.notEqual(now.hash, before.hash, `${key}=${value} does not change the picture`);
      if (parameter.stage === 'shading') assert.equal(now.planes, before.planes, 'light changes the planes');
      else assert.notEqual(now.planes, before.planes, `${key}=${value} does not change the planes`);
      assert.match(await page.evaluate(() => window.bubblestone.link()), new RegExp(`(^|&)${key}=`));
    });
  }
  assert.deepEqual(problems, []);
  await close();
});

test('controls that do not apply are hidden', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  const rules = await page.evaluate(() => window.bubblestone.schema.filter((row) => row.shownFor && row.kind !== 'text'));
  assert.ok(rules.length > 3);
  for (const { key, shownFor } of rules) {
    const applies = shownFor.words.includes(await get(page, shownFor.key));
    assert.equal(await page.$eval(`[data-key="${key}"]`, (control) => control.hidden), !applies, key);
  }
  await close();
});

test('a double click or the reset button goes back to the default', async () => {
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

test('a value out of range is clamped, and the page says so', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  await set(page, 'dr', '7');
  assert.equal(await get(page, 'dr'), '1');
  assert.equal(await page.$eval('#p-dr', (box) => box.value), '1');
  assert.match(await page.$eval('#notices', (notices) => notices.textContent), /\b1\b/);
  await page.focus('#seed');
  await page.$eval('#seed', (box) => box.select());
  await page.keyboard.type('-7.5');
  await page.keyboard.press('Enter');
  assert.equal(await get(page, 'seed'), '0');
  assert.equal(await page.$eval('#seed', (box) => box.value), '0');
  await close();
});

test('every control has a name, a help text and its symbol', async () => {
  const { page, close } = await site.newPage(SMALL);
  await digest(page);
  const bare = await page.$$eval('.control', (controls) =>
    controls.flatMap((control) =>
      [...control.querySelectorAll('input, select')]
        .filter((input) => {
          const group = input.type === 'radio' ? input.closest('[role=radiogroup]') : input;
          const help = group.getAttribute('aria-describedby')?.split(' ')[0];
          const named = input.labels?.length || input.getAttribute('aria-label');
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
