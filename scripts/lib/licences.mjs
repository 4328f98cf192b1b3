// The licences of the npm packages that are in the site, as a file of the site.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** The file's name. */
const FILE = 'licences.txt';

/** The folders of all packages that a part of the site holds. Workers are bundled before the page is written. @type {Set<string>} */
const folders = new Set();

/** A Vite plugin for each bundle. */
export const packages = {
  name: 'packages',
  /** @param {unknown} _ @param {import('rolldown').OutputBundle} bundle */
  generateBundle(_, bundle) {
    for (const part of Object.values(bundle)) {
      const modules = part.type === 'chunk' ? part.moduleIds.filter((id) => id.includes('/node_modules/')) : [];
      for (const id of modules) folders.add(folderOf(id));
    }
  },
};

/** A Vite plugin for the page's bundle, after `packages`. */
export const licences = {
  name: 'licences',
  /** @this {import('rolldown').PluginContext} */
  generateBundle() {
    const entries = [...folders].sort().map(entryOf);
    this.emitFile({ type: 'asset', fileName: FILE, source: `The page holds these npm packages, unchanged.\n${entries.join('')}` });
  },
};

/**
 * The folder of a module's package: the nearest one whose package.json has a version, as packages may hold others
 * without one. @param {string} id
 */
function folderOf(id) {
  for (let folder = dirname(id.replace(/^\0|\?.*$/g, '')); ; folder = dirname(folder)) {
    const file = join(folder, 'package.json');
    if (existsSync(file) && JSON.parse(readFileSync(file, 'utf8')).version) return folder;
    if (folder === dirname(folder)) throw new Error(`${id} is of no package.`);
  }
}

/** A package's name, where its source is, and its licence. @param {string} folder */
function entryOf(folder) {
  const { name, version, license, repository } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const text = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  if (!text) throw new Error(`${name} has no licence.`);
  const source = String(repository?.url ?? repository).replace(/^(git\+)?\w+:/, 'https:').replace(/\.git$/, '');
  return `\n${'-'.repeat(80)}\n${name} ${version}, ${license}\nSource: ${source}\n\n${readFileSync(join(folder, text), 'utf8').trim()}\n`;
}
