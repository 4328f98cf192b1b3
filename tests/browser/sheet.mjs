// Pointer actions on the picture.
import { digest, frames, SQUARE } from './page.mjs';

/** @typedef {import('puppeteer-core').Page} Page */

/**
 * A page with a finished picture that already reacts to the pointer.
 * @param {Awaited<ReturnType<typeof import('./harness.mjs').open>>} site
 * @param {string} [fragment]
 * @param {import('./harness.mjs').PageOptions} [options]
 */
export async function listening(site, fragment = SQUARE, options = {}) {
  const opened = await site.newPage(fragment, options);
  await digest(opened.page);
  if (!options.viewport?.hasTouch) {
    const { x, y } = await box(opened.page, '#sheet');
    await opened.page.mouse.move(x + 5, y + 5);
    await opened.page.waitForSelector('.cell-card', { hidden: true });
    await opened.page.waitForSelector('#cells svg');
  }
  return opened;
}

/** The box of an element in the window. @param {Page} page @param {string} selector */
export function box(page, selector) {
  return page.$eval(selector, (element) => element.getBoundingClientRect().toJSON());
}

/** A place of the sheet on the screen, from fractions of its sides. @param {Page} page @param {number} fx @param {number} fy */
export async function spot(page, fx, fy) {
  const { x, y, width, height } = await box(page, '#sheet');
  return { x: x + fx * width, y: y + fy * height };
}

/**
 * Drags, and keeps the button down.
 * @param {Page} page
 * @param {{ x: number, y: number }} from
 * @param {{ x: number, y: number }} to
 */
export async function drag(page, from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 2 });
  await page.mouse.move(to.x, to.y, { steps: 2 });
  await frames(page, 2);
}
