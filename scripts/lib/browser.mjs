// Finds the browsers that the tests drive.
import { isProgram, which } from './run.mjs';

/** @typedef {'chromium' | 'firefox'} Kind */

/**
 * Names, folders and Debian packages of the browsers. The first package that Debian has is enough. Chromium's headless
 * shell is Chromium without its own windows, menus and services: it opens a page in two thirds of the processor's time.
 */
export const browsers = {
  chromium: {
    title: 'Chromium (or Google Chrome)',
    variable: 'CHROME_PATH',
    names: ['chromium-headless-shell', 'chrome-headless-shell', 'chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome'],
    places: ['/Applications/Google Chrome.app/Contents/MacOS/Google Chrome', '/Applications/Chromium.app/Contents/MacOS/Chromium'],
    packages: ['chromium-headless-shell', 'chromium'],
  },
  firefox: {
    title: 'Firefox',
    variable: 'FIREFOX_PATH',
    names: ['firefox-esr', 'firefox'],
    places: ['/Applications/Firefox.app/Contents/MacOS/firefox'],
    packages: ['firefox-esr'],
  },
};

/** Debian's packages of the fonts that both browsers need. */
export const fonts = ['fonts-liberation', 'fonts-ipafont-gothic'];

/**
 * The program of a browser: the one that its variable names, or one found; undefined if there is none.
 * @param {Kind} kind
 */
export function findBrowser(kind) {
  const { variable, names, places } = browsers[kind];
  const named = process.env[variable];
  if (named) return isProgram(named) ? named : undefined;
  return names.map((name) => which(name)).find(Boolean) ?? places.find(isProgram);
}
