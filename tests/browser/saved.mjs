// Saves files by the page's dialog, and reads them.
import assert from 'node:assert/strict';
import { unzipSync } from 'fflate';
import { click, SMALL } from './page.mjs';

/** @typedef {Awaited<ReturnType<typeof import('./harness.mjs').open>>} Site */
/** @typedef {import('puppeteer-core').Page} Page */
/** @typedef {Window & { saved?: { name: string, blob: Blob } | undefined }} Keeping */

/** A page that records the files that it hands over. @param {Site} site @param {string} [fragment] */
export async function opened(site, fragment = SMALL) {
  return site.newPage(fragment, { before: (fresh) => fresh.evaluateOnNewDocument(keeping) });
}

/** Runs in the page: records the files that it hands over. */
export function keeping() {
  const page = /** @type {Keeping} */ (window);
  /** @type {Map<string, any>} */
  const blobs = new Map();
  const create = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    const url = create(blob);
    blobs.set(url, blob);
    return url;
  };
  HTMLAnchorElement.prototype.click = function () {
    page.saved = { name: this.download, blob: blobs.get(this.href) };
  };
}

/** Opens the dialog for saving. @param {Page} page */
export async function dialog(page) {
  await click(page, '#save');
  await page.waitForSelector('#save-dialog[open]');
}

/** Chooses values in the dialog's lists. @param {Page} page @param {Record<string, string>} chosen values by ids */
export async function choose(page, chosen) {
  for (const [id, value] of Object.entries(chosen)) {
    await page.$eval(
      `#${id}`,
      (control, text) => {
        /** @type {HTMLSelectElement} */ (control).value = text;
        control.dispatchEvent(new Event('change'));
      },
      value,
    );
  }
}

/**
 * Runs an action that makes a file, and waits until the page hands the file over. Fails with the page's own sentence
 * if the page refuses.
 * @param {Page} page
 * @param {() => Promise<unknown>} act
 * @param {string} what the property of `window` that will hold the file, or a selector of the element that will offer
 * it
 */
export async function handed(page, act, what = 'saved') {
  await page.evaluate((name) => {
    Reflect.set(window, name, undefined);
    for (const note of document.querySelectorAll('.message')) note.setAttribute('data-old', '');
  }, what);
  await act();
  const end = await page.waitForFunction(
    (name) => {
      const isThere = name.startsWith('#') ? document.querySelector(name) : Reflect.get(window, name);
      const refusal = document.querySelector(':is([role=alert] .message, [data-topic=files], [data-topic=busy], [data-topic=trouble]):not([data-old], :has(progress, .actions))');
      return isThere ? { refused: '' } : refusal && { refused: refusal.querySelector('p')?.textContent };
    },
    { timeout: 240_000, polling: 100 },
    what,
  );
  assert.deepEqual(await end.jsonValue(), { refused: '' });
}

/**
 * Clicks a button of the dialog. Returns the file's name and bytes.
 * @param {Page} page
 * @param {string} button
 * @param {Record<string, string>} [chosen]
 */
export async function saved(page, button, chosen = {}) {
  await dialog(page);
  await choose(page, chosen);
  await handed(page, () => click(page, button));
  const { name, text } = await page.evaluate(async () => {
    const { name, blob } = /** @type {Keeping} */ (window).saved ?? { name: '', blob: new Blob() };
    const reader = new FileReader();
    await new Promise((resolve) => {
      reader.onload = resolve;
      reader.readAsDataURL(blob);
    });
    return { name, text: String(reader.result) };
  });
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'save', 'the focus is lost');
  return { name, bytes: new Uint8Array(Buffer.from(text.slice(text.indexOf(',') + 1), 'base64')) };
}

/** The content of a ZIP file. @param {{ bytes: Uint8Array }} file */
export const files = ({ bytes }) => unzipSync(bytes);
