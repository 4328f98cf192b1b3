import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, minify } from 'vite';
import { buildIcons } from './scripts/lib/icons.mjs';
import { learnFiles, learnSources } from './scripts/lib/learn.mjs';
import { licences, packages } from './scripts/lib/licences.mjs';
import { offline } from './scripts/lib/offline.mjs';
import { buildThumbs, generatorsOf, thumbsOfMore } from './scripts/lib/thumbs.mjs';

const here = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));

/** @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/**
 * Writes the English words into the page: `data-t="key title=other"` names an element's text and its
 * attributes. Other languages are filled in by www/base/language.ts.
 */
const words = {
  name: 'words',
  transformIndexHtml: {
    order: /** @type {const} */ ('pre'),
    handler: (/** @type {string} */ html) => {
      const { page } = JSON.parse(readFileSync(here('www/strings/en.json'), 'utf8'));
      const word = (/** @type {string} */ key) => {
        if (!(key in page)) throw new Error(`www/strings/en.json has no words for the page's “${key}”.`);
        return escaped(page[key]);
      };
      return html.replace(/data-t="([^"]*)"([^>]*>)/g, (_, /** @type {string} */ keys, /** @type {string} */ rest) => {
        const parts = keys.split(' ').map((part) => part.split('='));
        const attributes = parts.filter(([, key]) => key).map(([name, key]) => ` ${name}="${word(key)}"`);
        const text = parts.filter(([, key]) => !key).map(([key]) => word(key));
        return `data-t="${keys}"${attributes.join('')}${rest}${text.join('')}`;
      });
    },
  },
};

/** Nothing is painted before the page is complete and in its language: under load, browsers paint unfinished pages. */
const whole = {
  name: 'whole',
  transformIndexHtml: {
    order: /** @type {const} */ ('post'),
    handler: (/** @type {string} */ html) => html.replace('<script type="module"', '$& blocking="render"'),
  },
};

/** The Japanese of the modules' notices: a table has all languages, and a module brings its English itself. */
const notices = {
  name: 'notices',
  /** @param {string} id */
  resolveId: (id) => (id.startsWith('virtual:notices-ja/') ? `\0${id}` : undefined),
  /** @param {string} id */
  load: (id) => {
    const table = id.split('\0virtual:notices-ja/')[1];
    return table && `export default ${JSON.stringify(sentences(table, 'ja'))}`;
  },
};

/** The sentences of a table of notices, by code. @param {string} table @param {'en' | 'ja'} language */
function sentences(table, language) {
  /** @type {Record<string, string>} */
  const words = {};
  let code = '';
  for (const line of readFileSync(here(`src/notice/${table}.txt`), 'utf8').split('\n')) {
    if (/^\w/.test(line)) code = line;
    else if (line.startsWith(`  ${language} `)) words[code] = line.slice(5);
  }
  return words;
}

/** The folder of the second module, which is loaded at first need. */
const house = here('pkg-house');

/**
 * The sentence for a link whose generator is unknown, in English, naming all these generators.
 * @param {{ word: string }[]} generators
 */
function unknownIn(generators) {
  const known = new Intl.ListFormat('en-GB', { type: 'disjunction' }).format(generators.map(({ word }) => word));
  const sentence = sentences('words', 'en')['bad_make']?.replace('{known}', known);
  if (!sentence?.includes(known)) throw new Error('src/notice/words.txt has no sentence that names the known generators.');
  return sentence.replace(/^./, (first) => first.toUpperCase());
}

/**
 * The generators of each module, so that the page can offer them before the module is loaded; and the second module.
 */
const made = {
  name: 'made',
  // The choice of a generator is in the page at its first paint: not every browser waits for the script.
  transformIndexHtml: {
    order: /** @type {const} */ ('post'),
    handler: async (/** @type {string} */ html) => {
      const generators = await generatorsOf([here('pkg'), house]);
      if (generators.length < 2) return html;
      const buttons = generators.map(({ word, title, preset }) => `<button type="button" class="make" data-make="${word}"><img src="thumbs/${preset}.avif" alt="" width="28" height="28" decoding="async"><span>${escaped(title)}</span></button>`);
      return html.replace(/(<nav [^>]*id="makes"[^>]*) hidden>/, (_, tag) => `${tag}>${buttons.join('')}`);
    },
  },
  /** @param {string} id */
  resolveId: (id) => (['virtual:generators', 'virtual:house'].includes(id) ? `\0${id}` : undefined),
  /** @param {string} id */
  load: async (id) => {
    if (id === '\0virtual:generators') {
      const generators = await generatorsOf([here('pkg'), house]);
      return `export default ${JSON.stringify(generators)}; export const unknown = ${JSON.stringify(unknownIn(generators))}`;
    }
    if (id !== '\0virtual:house') return undefined;
    const [script, file] = ['bubblestone.js', 'bubblestone_bg.wasm'].map((name) => JSON.stringify(`${house}/${name}?url`));
    return `import file from ${file}; import script from ${script}; export default { file, script }`;
  },
};

/**
 * Writes the first script into the page itself, with the addresses of files that generators need. These are the first
 * visit's module and, for each generator of the second module, that module and its script. The page's policy names the
 * script's digest.
 */
const begin = {
  name: 'begin',
  transformIndexHtml: {
    order: /** @type {const} */ ('post'),
    /** @param {string} html @param {import('vite').IndexHtmlTransformContext} context */
    handler: async (html, { bundle = {} }) => {
      const { code } = await minify('start.js', readFileSync(here('www/start.js'), 'utf8'));
      const first = addressOf(bundle, `${basename(here('pkg'))}/bubblestone_bg.wasm`);
      const later = ['bubblestone_bg.wasm', 'bubblestone.js'].map((file) => addressOf(bundle, `${basename(house)}/${file}`)).join(' ');
      const others = (await generatorsOf([here('pkg'), house])).filter(({ module }) => module > 0);
      const files = [`data-first="${first}"`, ...others.map(({ word }) => `data-${word}="${later}"`)];
      const digest = createHash('sha256').update(code).digest('base64');
      return html.replace('<!-- www/start.js -->', `<script ${files.join(' ')}>${code}</script>`).replace("script-src 'self'", `$& 'sha256-${digest}'`);
    },
  },
};

/** The address of a file of the site. @param {import('vite').Rolldown.OutputBundle} bundle @param {string} source the end of its path before the build */
function addressOf(bundle, source) {
  const found = Object.values(bundle).find((file) => file.type === 'asset' && file.originalFileNames.some((name) => name.endsWith(source)));
  if (!found) throw new Error(`The site has no file of ${source}.`);
  return `./${found.fileName}`;
}

/** The small pictures of the second module's presets; workers need none. */
const thumbs = {
  name: 'thumbs',
  /** @this {import('rolldown').PluginContext} */
  async generateBundle() {
    for (const { name, bytes } of await thumbsOfMore(house)) {
      this.emitFile({ type: 'asset', fileName: `thumbs/${name}`, source: bytes });
    }
  },
};

/** The pages of the chapters, with scripts and styles of their own. */
const learn = {
  name: 'learn',
  /** @this {import('rolldown').PluginContext} */
  buildStart() {
    for (const file of learnSources()) this.addWatchFile(file);
  },
  /** @this {import('rolldown').PluginContext} @param {unknown} _ @param {import('rolldown').OutputBundle} bundle */
  async generateBundle(_, bundle) {
    const module = addressOf(bundle, `${basename(here('pkg'))}/bubblestone_bg.wasm`).replace('./', '');
    for (const file of await learnFiles({ module, modules: here('pkg'), plugins: [given] })) this.emitFile({ type: 'asset', ...file });
  },
};

// Generated files of the site have to exist before Vite looks for files.
await buildThumbs();
await buildIcons();

/** The page passes the module to the glue code (www/module/load.ts), so the glue code contains no address of it. */
const given = {
  name: 'given',
  /** @param {string} code @param {string} id */
  transform: (code, id) => (/\/pkg(-\w+)?\/bubblestone\.js$/.test(id) ? code.replace("new URL('bubblestone_bg.wasm', import.meta.url)", 'undefined') : undefined),
};

export default defineConfig({
  root: here('www'),
  // Relative, so that the site works from any folder of any host.
  base: './',
  plugins: [words, notices, whole, given, made, begin, thumbs, learn, packages, licences, offline],
  json: { namedExports: true },
  build: {
    outDir: here('dist'),
    emptyOutDir: true,
    target: 'es2022',
    // The module stays a file of its own, however small: browsers compile it while it arrives.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: { index: here('www/index.html'), sw: here('www/service/sw.ts') },
      // A service worker has one fixed address, and its scope is all that it serves.
      output: {
        entryFileNames: ({ name }) => (name === 'sw' ? 'sw.js' : 'assets/[name]-[hash].js'),
        // The page starts with one file, whichever parts of it later files need; code that later files share is one
        // file as well.
        codeSplitting: {
          groups: [
            { name: 'page', tags: ['$initial'], test: (id) => !id.includes('/www/service/') },
            { name: 'late', test: /\/www\/late\// },
          ],
        },
      },
    },
  },
  worker: { format: 'es', plugins: () => [given, made, packages] },
});
