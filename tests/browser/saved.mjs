// What the page saves, opened by the tests.
import assert from 'node:assert/strict';
import { unzipSync } from 'fflate';
import { click, SMALL } from './page.mjs';

/** @typedef {Awaited<ReturnType<typeof import('./harness.mjs').open>>} Site */
/** @typedef {import('puppeteer-core').Page} Page */
/** @typedef {Window & { saved?: { name: string, blob: Blob } | undefined }} Keeping */

/** A page that keeps the files it hands over. @param {Site} site @param {string} [fragment] */
export async function opened(site, fragment = SMALL) {
  return site.newPage(fragment, { before: (fresh) => fresh.evaluateOnNewDocument(keeping) });
}

/** Runs in the page: keeps the files that it hands over. */
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

/** Opens the dialog of all that can be saved. @param {Page} page */
export async function dialog(page) {
  await click(page, '#save');
  await page.waitForSelector('#save-dialog[open]');
}

/** Chooses of the dialog's lists. @param {Page} page @param {Record<string, string>} chosen values by ids */
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

/** Clicks a button of the dialog; answers the file's name and bytes. @param {Page} page @param {string} button @param {Record<string, string>} [chosen] */
export async function saved(page, button, chosen = {}) {
  await page.evaluate(() => (/** @type {Keeping} */ (window).saved = undefined));
  await dialog(page);
  await choose(page, chosen);
  await click(page, button);
  await page.waitForFunction(() => /** @type {Keeping} */ (window).saved, { timeout: 120_000 });
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

/** What is in a zip file. @param {{ bytes: Uint8Array }} file */
export const files = ({ bytes }) => unzipSync(bytes);
