// The static site in dist/, and its sizes.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { host } from './host.mjs';
import { filesOf, firstOf } from './offline.mjs';
import { root, run, say, Stop } from './run.mjs';

export const site = join(root, 'dist');

/**
 * The most that a first visit may transfer until the picture is done, in any language, from a host that compresses with
 * gzip. It catches accidents; `npm run visit` measures what matters (docs/times.md).
 */
const visitBudget = 600_000;

/**
 * Most gzipped bytes of the scripts and styles that all chapters share, and of a chapter in one language with its
 * pictures and the script of its figures.
 */
const learnBudgets = { shared: 45_000, chapter: 60_000 };

/** About how many small pictures of presets are visible at once, on a screen of 1080 lines. */
const thumbsInSight = 8;

/** Vite's build of www/ and pkg/. */
export async function buildSite() {
  say('Building the page into dist/');
  vite();
  weigh();
}

function vite() {
  run(process.execPath, [join(root, 'node_modules', 'vite', 'bin', 'vite.js'), 'build', '--logLevel', 'warn']);
}

/** Builds the site, and again after every change of www/ until the program ends. Resolves when the site is there. */
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
      // Vite has printed the fault. Later the next change may mend it.
      if (code === 'ERROR' && !there) reject(new Stop('The page could not be built.'));
    });
  }).catch(async (failure) => {
    await watcher.close();
    throw failure;
  });
}

/**
 * Serves the site to the person at the keyboard; tests open the same files.
 * @param {number} port the first one to try
 * @param {(path: string) => void} [asked] gets the path of each request
 */
export function serveSite(port, asked) {
  return host(site, { port, asked });
}

/** Prints the gzipped sizes of the files and of a first visit; stops if that is over the budget. */
function weigh() {
  const files = filesOf(site);
  const thumbs = files.filter((path) => path.startsWith('thumbs/'));
  const first = firstOf(site);
  for (const path of files.filter((path) => !thumbs.includes(path))) {
    console.log(`${kilobytes(weightOf(path))}  ${path}${first.includes(path) ? ' *' : ''}`);
  }
  const weights = thumbs.map((path) => weightOf(path)).sort((a, b) => b - a);
  console.log(`${kilobytes(sum(weights))}  ${thumbs.length} small pictures of presets`);
  console.log(`${kilobytes(sum(files.map((path) => weightOf(path))))}  in all (gzipped)`);
  // The words of surfaces and piles (ja-surface, ja-pile) come with the second module.
  const language = files.filter((path) => /^assets\/ja-[\w-]{8}\.js$/.test(path));
  if (!language.length) throw new Stop('The site has no words in Japanese.');
  const visit = sum([...first, ...language].map((path) => weightOf(path))) + sum(weights.slice(0, thumbsInSight));
  console.log(`${kilobytes(visit)}  a first visit in Japanese (* and ${thumbsInSight} small pictures), of at most ${visitBudget / 1000} kB`);
  if (visit > visitBudget) throw new Stop(`A first visit transfers ${visit} bytes gzipped: at most ${visitBudget} are allowed.`);
  weighLearn(files);
}

/** The script of a chapter's figures. */
const FIGURES_OF = /^assets\/learn-of-([a-z-]+)-[\w-]{8}\.js$/;

/** Stops if the chapters' pages are over their budgets. @param {string[]} files of the site */
function weighLearn(files) {
  const scripts = files.filter((path) => path.startsWith('assets/learn-'));
  const own = new Map(scripts.flatMap((path) => (FIGURES_OF.test(path) ? [[path.match(FIGURES_OF)?.[1] ?? '', weightOf(path)]] : [])));
  const shared = sum(scripts.filter((path) => !FIGURES_OF.test(path)).map((path) => weightOf(path)));
  const pages = files.filter((path) => path.startsWith('learn/')).map((path) => ({ path, weight: weightOf(path) + (own.get(path.split('/').at(-2) ?? '') ?? 0) }));
  console.log(`${kilobytes(shared)}  what chapters share, of at most ${learnBudgets.shared / 1000} kB`);
  console.log(`${kilobytes(Math.max(...pages.map(({ weight }) => weight)))}  the largest page of a chapter with its figures, of at most ${learnBudgets.chapter / 1000} kB`);
  if (shared > learnBudgets.shared) throw new Stop(`Chapters share ${shared} bytes gzipped: at most ${learnBudgets.shared} are allowed.`);
  const large = pages.find(({ weight }) => weight > learnBudgets.chapter);
  if (large) throw new Stop(`${large.path} has ${large.weight} bytes gzipped: at most ${learnBudgets.chapter} are allowed.`);
}

/** The bytes of a file as it is sent: gzipped, unless that makes it larger. @param {string} path of a file @returns {number} */
function weightOf(path) {
  const bytes = readFileSync(join(site, path));
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
