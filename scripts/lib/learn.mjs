// The pages of the chapters (www/learn): static HTML in each language, with the figures' pictures, which the module itself
// makes. Their scripts and styles are a bundle of their own, so that the studio's first visit has nothing of them.
import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { build, minify } from 'vite';
import { chapters } from '../../www/learn/chapters/contents.mjs';
import { terms } from '../../www/learn/chapters/terms.mjs';
import { chapterPage } from './learn-chapter.mjs';
import { contentsPage, glossaryPage, guidePage, sheetPage } from './learn-extras.mjs';
import { moduleIn } from './headless.mjs';
import { papersPage } from './learn-papers.mjs';
import { root } from './run.mjs';

const folder = join(root, 'www', 'learn');

/** The sources whose change makes the pages anew. The texts, however, are read only once. */
export function learnSources() {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return files.map(({ parentPath, name }) => join(parentPath, name));
}

/** Where the pages' files stand in the site. The figures of a chapter are a script of its own, learn-of-CHAPTER. */
const files = { entryFileNames: 'assets/learn-[hash].js', chunkFileNames: 'assets/learn-[name]-[hash].js', assetFileNames: 'assets/learn-[hash][extname]' };

/**
 * The bundle of the pages' scripts and styles, as files.
 * @param {import('vite').Plugin[]} plugins
 */
async function scripts(plugins) {
  const { output } = await bundled({ plugins, rolldownOptions: { input: join(folder, 'page.ts'), output: files } });
  return output.map((file) => ({ fileName: file.fileName, source: file.type === 'chunk' ? file.code : file.source, isEntry: file.type === 'chunk' && file.isEntry }));
}

/** The browser's code that draws figures, bundled for Node. */
async function drawing() {
  const { output } = await bundled({ ssr: true, rolldownOptions: { input: join(folder, 'built.ts'), output: { format: 'es' } } });
  return import(`data:text/javascript;base64,${Buffer.from(output[0].code).toString('base64')}`);
}

/**
 * @param {{ plugins?: import('vite').Plugin[], ssr?: boolean, rolldownOptions: import('vite').BuildOptions['rolldownOptions'] }} options
 * @returns {Promise<import('rolldown').RolldownOutput>}
 */
async function bundled({ plugins = [], ...options }) {
  const own = { write: false, target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false }, ...options };
  return /** @type {any} */ (await build({ configFile: false, root: join(root, 'www'), publicDir: false, base: './', logLevel: 'warn', plugins, build: own }));
}

/** The script at the head of each page, and its digest for the page's policy. */
async function startScript() {
  const { code } = await minify('start.js', readFileSync(join(folder, 'start.js'), 'utf8'));
  return { code, digest: createHash('sha256').update(code).digest('base64') };
}

/**
 * All files of the chapters' pages.
 * @param {object} options
 * @param {string} options.module the module's address in the site
 * @param {string} options.modules its folder
 * @param {import('vite').Plugin[]} [options.plugins] of the scripts' bundle
 */
export async function learnFiles({ module, modules, plugins = [] }) {
  const [own, draw, start] = [await scripts(plugins), await drawnIn(modules), await startScript()];
  const site = {
    module,
    start,
    script: own.find(({ isEntry }) => isEntry)?.fileName ?? '',
    styles: own.filter(({ fileName }) => fileName.endsWith('.css')).map(({ fileName }) => fileName),
    draw,
  };
  const made = /** @type {const} */ (['en', 'ja']).flatMap((language) => [
    contentsPage(site, language),
    glossaryPage(site, language, terms),
    guidePage(site, language, chapters),
    papersPage(site, language),
    ...chapters.flatMap((chapter) => [chapterPage(site, language, chapter), sheetPage(site, language, chapter)]),
  ]);
  return [...own.map(({ fileName, source }) => ({ fileName, source })), ...made];
}

/** Drawings of the pages, made by the module in a folder. @param {string} modules */
async function drawnIn(modules) {
  const [built, module] = [await drawing(), await moduleIn(modules)];
  return {
    figure: (/** @type {string} */ name, /** @type {string} */ language) => built.stillOf(module, name, language),
    link: (/** @type {string} */ name) => built.studioLinkOf(name),
    state: (/** @type {string} */ name, /** @type {Record<string, string>} */ values) => stateOf(figureIn(built, name), values),
    answers: (/** @type {string} */ name, /** @type {string} */ key, /** @type {string} */ language) => built.answersOf(name, key, language),
    term: (/** @type {string} */ key) => built.termOf(module, key),
  };
}

/** @param {any} built @param {string} name */
function figureIn({ FIGURES }, name) {
  const found = FIGURES.find((/** @type {any} */ figure) => figure.name === name);
  if (!found) throw new Error(`There is no figure ${name}.`);
  return found;
}

/** A figure's state in an address: its recipe with other values, and perhaps a step. @param {any} figure @param {Record<string, string>} values */
function stateOf(figure, { step, ...values }) {
  const words = new Map(figure.recipe.split('&').map((/** @type {string} */ word) => word.split(/=(.*)/s)));
  for (const [key, value] of Object.entries(values)) for (const word of wordsOf(figure, words, key, value)) words.set(...word);
  const changed = [...words].map(([key, value]) => `${key}=${value}`);
  return [`fig=${figure.name}`, ...(Object.keys(values).length ? changed : []), ...(step === undefined ? [] : [`step=${step}`])].join('&');
}

/**
 * The words of a recipe for a value of a handle, which may be kept in a list.
 * @param {any} figure
 * @param {Map<string, string>} words the recipe's
 * @param {string} key
 * @param {string} value
 * @returns {[string, string][]}
 */
function wordsOf(figure, words, key, value) {
  const listed = figure.handles.find((/** @type {any} */ handle) => handle.key === key)?.listed;
  if (!listed) return [[key, value]];
  const numbers = (words.get(listed.list) ?? '').split(',').map(Number);
  const points = Array.from({ length: numbers.length / 2 }, (_, k) => [numbers[2 * k], numbers[2 * k + 1]]);
  return Object.entries(listed.write(Number(value), points));
}
