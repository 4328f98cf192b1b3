// Frames of bodies on a page: waits until they are finished, and reads their pixels and descriptions.

/** @typedef {import('puppeteer-core').Page} Page */

/**
 * Waits until the wanted frame has all pixels, or is in another state. It is refined only on pages that are opened with `fine`.
 * @param {Page} page @param {string} [word]
 */
export const turned = (page, word = 'still') => page.waitForSelector(`#sheet[data-turn="${word}"]`);

/** A hash of a frame, its number of colours, and its sides. @param {Page} page @param {string} [canvas] */
export const frame = (page, canvas = '#turn canvas') =>
  page.$eval(canvas, (element) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (element);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(width, height).getContext('2d'));
    context.drawImage(/** @type {HTMLCanvasElement} */ (element), 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, width, height).data.buffer);
    let hash = 2166136261;
    for (const pixel of pixels) hash = Math.imul(hash ^ pixel, 16777619) >>> 0;
    return { hash, colours: new Set(pixels).size, width, height };
  });

/** The hash of the frame at rest. @param {Page} page @returns {Promise<number>} */
export async function hash(page) {
  await turned(page);
  return (await frame(page)).hash;
}

/** The hash of the first frame at rest that differs from the one with the hash `before`. @param {Page} page @param {number} before */
export async function other(page, before) {
  for (;;) {
    const now = await hash(page);
    if (now !== before) return now;
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
}

/** The sentence about the frame. @param {Page} page */
export const told = (page) => page.$eval('#turn-seen', (text) => text.textContent);

/** Waits until the sentence matches. @param {Page} page @param {RegExp} words */
export const tells = (page, words) => page.waitForFunction((source) => new RegExp(source).test(document.querySelector('#turn-seen')?.textContent ?? ''), {}, words.source);
