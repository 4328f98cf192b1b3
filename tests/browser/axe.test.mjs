import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { targetDir } from '../../scripts/lib/rust.mjs';
import { kind, sameEverywhere } from './browsers.mjs';
import { desk, low, open } from './harness.mjs';
import { phone } from './page.mjs';
import { enter, states } from './states.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

// The pictures of all states, for people to look at.
const pictures = join(targetDir, 'page-pictures', kind);

const LIGHT = { name: 'desk-light', viewport: desk, dark: false };
const DARK = { name: 'phone-dark', viewport: phone, dark: true };

// The finished picture is checked on both screens, the other states in turn on one of them: each check takes seconds.
const screensOf = (/** @type {string} */ state, /** @type {number} */ turn) => (state === 'done' ? [LIGHT, DARK] : [turn % 2 ? DARK : LIGHT]);

before(async () => {
  mkdirSync(pictures, { recursive: true });
  site = await open();
});

after(() => site?.close());

/** The findings of axe with every rule of these tags, even those that are off by default. */
async function findings(page) {
  await page.evaluate(axe);
  return page.evaluate(async (tags) => {
    const rules = Object.fromEntries(window.axe.getRules(tags).map(({ ruleId }) => [ruleId, { enabled: true }]));
    const { violations, passes } = await window.axe.run(document, { runOnly: { type: 'tag', values: tags }, rules });
    const found = violations.flatMap(({ id, nodes }) =>
      nodes.map(({ html, any, all, none }) => `${id}: ${html.slice(0, 140)} ${[...any, ...all, ...none].map(({ message }) => message).join(' ')}`),
    );
    return { found, count: passes.length };
  }, TAGS);
}

for (const [turn, [name, state]] of Object.entries(states).entries()) {
  for (const { name: screen, ...options } of screensOf(name, turn)) {
    test(`axe finds nothing: ${name}, ${screen}`, sameEverywhere, async () => {
      const viewport = state.space && options.viewport === desk ? low : options.viewport;
      const { page, close } = await enter(site, state, { ...options, viewport });
      await page.screenshot({ path: join(pictures, `${name}-${screen}.png`) });
      const { found, count } = await findings(page);
      // Behind a dialog, or with the picture alone, few rules apply.
      const least = (await page.$('dialog[open]')) ? 20 : state.few ? 12 : 30;
      assert.ok(count > least, `only ${count} rules found something to look at`);
      assert.deepEqual(found, []);
      await close();
    });
  }
}
