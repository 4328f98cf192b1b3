// `npm run visit`: the time that a first visitor waits, in Chromium with a processor four times slower than this one, with
// a usual connection and with a slow one. The page marks its progress (www/base/marks.ts). docs/times.md has results.
//
// It needs a site in dist/: `npm run build`. If folders of other builds are named, it visits all sites in turn.
import { existsSync, mkdtempSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { findBrowser } from './lib/browser.mjs';
import { host } from './lib/host.mjs';
import { root, say, start, Stop } from './lib/run.mjs';

/** Rounds; each goes through all visits, so that other work of the machine slows all of them alike. */
const ROUNDS = 5;

/**
 * The machines: a connection (bits per second, milliseconds to the host and back), the host's compression, and the factor
 * of a slower processor. Every host has gzip, and many have brotli as well.
 * @type {Record<string, { bits: number, latency: number, coding: import('./lib/host.mjs').Coding, slower: number }>}
 */
const machines = {
  '9 Mbit/s, 100 ms': { bits: 9e6, latency: 100, coding: 'gzip', slower: 4 },
  '1.6 Mbit/s, 150 ms': { bits: 1.6e6, latency: 150, coding: 'gzip', slower: 4 },
  '1.6 Mbit/s, 150 ms, brotli': { bits: 1.6e6, latency: 150, coding: 'br', slower: 4 },
};

const VASE = '#v=1&make=surface&form=vase&cn=900&stone=flag';

/** The links, each with the mark that ends its visit. */
const links = { 'the page': { link: '', last: 'made' }, 'a pavement': { link: '#v=1&seed=2', last: 'picture' }, 'a vase of 900 tiles': { link: VASE, last: 'picture' }, 'a rice ball': { link: '#v=1&make=pile', last: 'picture' } };

/** The marks of the page, in their order. */
const marks = /** @type {const} */ (['cells', 'frame', 'made', 'picture']);

/** @typedef {Partial<Record<typeof marks[number] | 'kB', number>>} Times */

const flags = ['--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

await start(async () => {
  const sites = [join(root, 'dist'), ...process.argv.slice(2)];
  const missing = sites.find((site) => !existsSync(join(site, 'index.html')));
  if (missing) throw new Stop(`There is no site in ${missing}: \`npm run build\` makes one in dist/.`);
  const program = findBrowser('chromium');
  if (!program) throw new Stop('There is no Chromium: `npm test` names the package, CHROME_PATH the program.');
  /** By site, machine and link. @type {Map<string, Times[]>} */
  const all = new Map();
  for (let round = 0; round < ROUNDS; round += 1) {
    say(`Round ${round + 1} of ${ROUNDS}`);
    for (const site of sites) await visits(program, site, (name, times) => all.set(name, [...(all.get(name) ?? []), times]));
  }
  print(all);
});

/**
 * Opens all links on all machines once, each in a browser with an empty profile.
 * @param {string} program
 * @param {string} site
 * @param {(name: string, times: Times) => void} tell
 */
async function visits(program, site, tell) {
  for (const [machine, { coding, ...speeds }] of Object.entries(machines)) {
    const server = await host(site, { coding });
    try {
      for (const [title, { link, last }] of Object.entries(links)) {
        tell(`${relative(root, site)}: ${title}, ${machine}`, await visit(program, server.address + link, last, speeds));
      }
    } finally {
      server.stop();
    }
  }
}

/**
 * @param {string} executablePath
 * @param {string} address
 * @param {string} last the mark that ends the visit
 * @param {Omit<typeof machines[string], 'coding'>} speeds
 * @returns {Promise<Times>} milliseconds since the page was requested, and kB transferred until the last mark
 */
async function visit(executablePath, address, last, { bits, latency, slower }) {
  const { default: puppeteer } = await import('puppeteer-core');
  const userDataDir = mkdtempSync(join(tmpdir(), 'bubblestone-visit-'));
  const browser = await puppeteer.launch({ executablePath, userDataDir, args: flags, protocolTimeout: 240_000 });
  try {
    const page = await browser.newPage();
    const devtools = await page.createCDPSession();
    await devtools.send('Network.enable');
    await devtools.send('Network.setBypassServiceWorker', { bypass: true });
    await devtools.send('Network.emulateNetworkConditions', { offline: false, latency, downloadThroughput: bits / 8, uploadThroughput: bits / 8 });
    await devtools.send('Emulation.setCPUThrottlingRate', { rate: slower });
    let bytes = 0;
    devtools.on('Network.loadingFinished', ({ encodedDataLength }) => (bytes += encodedDataLength));
    await page.goto(address, { waitUntil: 'domcontentloaded' });
    const made = await page.evaluate(markedUntil, last, [...marks]);
    return { ...made, kB: bytes / 1000 };
  } finally {
    await browser.close();
    await rm(userDataDir, { recursive: true, force: true, maxRetries: 20, retryDelay: 100 });
  }
}

/**
 * Runs in the page. Returns the times of the marks, once the last one exists.
 * @param {string} last
 * @param {string[]} names
 * @returns {Promise<Record<string, number>>}
 */
function markedUntil(last, names) {
  return new Promise((resolve) => {
    const observer = new PerformanceObserver(() => {
      if (!performance.getEntriesByName(last).length) return;
      observer.disconnect();
      resolve(Object.fromEntries(names.flatMap((name) => performance.getEntriesByName(name).map(({ startTime }) => [name, startTime]))));
    });
    observer.observe({ type: 'mark', buffered: true });
  });
}

/** Prints the median, the least and the greatest value of the rounds. @param {Map<string, Times[]>} all */
function print(all) {
  for (const [name, rounds] of all) {
    console.log(`\n${name}`);
    for (const key of [...marks, /** @type {const} */ ('kB')]) {
      const sorted = rounds.map((times) => times[key]).filter((value) => value !== undefined).sort((a, b) => a - b);
      if (!sorted.length) continue;
      const shown = (/** @type {number | undefined} */ value = 0) => (key === 'kB' ? value.toFixed(0) : (value / 1000).toFixed(2));
      console.log(`  ${key.padEnd(8)}${shown(sorted[sorted.length >> 1]).padStart(6)} ${key === 'kB' ? '  ' : 's '} (${shown(sorted[0])} to ${shown(sorted.at(-1))})`);
    }
  }
}
