// The static site in dist/, and its size.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { host } from './host.mjs';
import { filesOf, firstOf } from './offline.mjs';
import { root, run, say, Stop } from './run.mjs';
import { targetDir } from './rust.mjs';

export const site = join(root, 'dist');

/** The site for tests of several generators: its second module has a specimen. */
export const specimenSite = join(targetDir, 'site-specimen');

/**
 * The size limit of each WebAssembly module, packed: the one of a first visit, and the one with all generators, which
 * loads when it is first needed. docs/size.md says how they are kept small.
 */
const moduleBudgets = { bubblestone: 337_000, house: 640_000 };

/** The most bytes that a first visit may transfer until the picture is done. */
const visitBudget = 400_000;

/** The number of small pictures in sight at once, on a screen of 1080 lines. */
const thumbsInSight = 8;

/** Builds www/ and pkg/ by Vite. */
export async function buildSite() {
  say('Building the page into dist/');
  vite();
  weigh();
}

/** Builds the same with the specimen's module. */
export async function buildSpecimenSite() {
  say('Building the page with a specimen');
  vite({ BUBBLESTONE_HOUSE: 'specimen', BUBBLESTONE_SITE: specimenSite });
  weighModules(specimenSite);
}

/** @param {NodeJS.ProcessEnv} [more] */
function vite(more) {
  run(process.execPath, [join(root, 'node_modules', 'vite', 'bin', 'vite.js'), 'build', '--logLevel', 'warn'], { env: { ...process.env, ...more } });
}

/** Builds the same, and again after every change of www/ until the program ends. Resolves when the site exists. */
export async function keepBuilt() {
  say('Building the page into dist/');
  const { build } = await import('vite');
  const config = { configFile: join(root, 'vite.config.mjs'), logLevel: /** @type {const} */ ('warn'), build: { watch: {} } };
  const watcher = /** @type {import('rolldown').RolldownWatcher} */ (await build(config));
  let there = false;
  await new Promise((resolve, reject) => {
    watcher.on('event', ({ code }) => {
      if (code === 'BUNDLE_END' && there) say('Built anew: browsers that have stored the page show it from their second reload on');
      if (code === 'BUNDLE_END') resolve((there = true));
      // Vite has printed the error. In later builds, the next change may correct it.
      if (code === 'ERROR' && !there) reject(new Stop('The page could not be built.'));
    });
  }).catch(async (failure) => {
    await watcher.close();
    throw failure;
  });
}

/**
 * Serves the site. The tests open the same files.
 * @param {number} port the first one to try
 * @param {(path: string) => void} [asked] gets the path of each request
 */
export function serveSite(port, asked) {
  return host(site, { port, asked });
}

/**
 * Prints the gzipped size of each file, and the bytes that a first visit transfers. Stops if those exceed the budget.
 */
function weigh() {
  const files = filesOf(site);
  const thumbs = files.filter((path) => path.startsWith('thumbs/'));
  const inSight = (thumbsInSight / thumbs.length) * sum(thumbs.map((path) => weightOf(path)));
  const first = firstOf(site);
  for (const path of files.filter((path) => !thumbs.includes(path))) {
    console.log(`${kilobytes(weightOf(path))}  ${path}${first.includes(path) ? ' *' : ''}`);
  }
  console.log(`${kilobytes(sum(thumbs.map((path) => weightOf(path))))}  ${thumbs.length} small pictures of presets`);
  console.log(`${kilobytes(sum(files.map((path) => weightOf(path))))}  in all (gzipped)`);
  const visit = Math.round(sum(first.map((path) => weightOf(path))) + inSight);
  console.log(`${kilobytes(visit)}  a first visit (* and ${thumbsInSight} small pictures), of at most ${visitBudget / 1000} kB`);
  weighModules(site);
  if (visit > visitBudget) throw new Stop(`A first visit transfers ${visit} bytes gzipped: at most ${visitBudget} are allowed.`);
}

/** Stops if a module exceeds its own budget. @param {string} folder of a site */
function weighModules(folder) {
  for (const path of filesOf(folder)) {
    const [, name] = /\b(\w+)-[^/]*\.lzma$/.exec(path) ?? [];
    if (!name) continue;
    const weight = weightOf(path, folder);
    const budget = moduleBudgets[/** @type {keyof typeof moduleBudgets} */ (name)];
    console.log(`${kilobytes(weight)}  WebAssembly, ${name}, of at most ${budget / 1000} kB`);
    if (!(weight <= budget)) throw new Stop(`The WebAssembly module ${name} is ${weight} bytes packed: at most ${budget} are allowed.`);
  }
}

/**
 * The gzipped size; files that are compressed already are sent as they are.
 * @param {string} path of a file
 * @param {string} [folder] its site
 * @returns {number} bytes, gzipped
 */
function weightOf(path, folder = site) {
  const bytes = readFileSync(join(folder, path));
  return Math.min(bytes.length, gzipSync(bytes, { level: 9 }).length);
}

/** @param {number[]} numbers */
function sum(numbers) {
  return numbers.reduce((total, number) => total + number, 0);
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(1).padStart(8)} kB`;
}
