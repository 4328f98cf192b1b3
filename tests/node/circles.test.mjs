// No files import each other in a circle, neither what runs nor types: a reader of a file never has to know two at once.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative, resolve } from 'node:path';
import { test } from 'node:test';

const root = join(import.meta.dirname, '..', '..');

/** Every script of these folders. */
const files = ['www', 'package', 'scripts', 'tests']
  .flatMap((folder) => readdirSync(join(root, folder), { recursive: true }).map((path) => join(root, folder, String(path))))
  .filter((file) => /(?<!\.d)\.(ts|mjs|js)$/.test(file) && !file.includes('node_modules'));

const known = new Set(files);

/**
 * A statement at the start of a line, whose names may fill several lines; or a call of `import`, in code or in the type
 * of a comment.
 */
const IMPORT = /^(?:import|export)\s(?:[^'"`;=]*?\sfrom\s)?['"](\.[^'"]*)['"]|\bimport\(['"](\.[^'"]*)['"]\)/gm;

/** The addresses of files that a text imports, types included. @param {string} text */
const addressesIn = (text) => Array.from(text.matchAll(IMPORT), ([, stated, called]) => stated ?? called ?? '');

/** The file at an address, as bundlers find it. @param {string} from @param {string} address */
function fileAt(from, address) {
  const path = resolve(dirname(from), address.replace(/\?.*$/, ''));
  return [path, `${path}.ts`, path.replace(/\.js$/, '.ts'), `${path}.d.ts`, path.replace(/\.js$/, '.d.ts')].find((file) => known.has(file) || existsSync(file));
}

/** @param {string} file */
const importsOf = (file) => addressesIn(readFileSync(file, 'utf8')).map((address) => ({ address, to: fileAt(file, address) }));

/** Each circle as the files along it, the first one again at its end. @param {Map<string, string[]>} graph */
function circlesIn(graph) {
  /** @type {string[][]} */
  const circles = [];
  /** @type {Set<string>} */
  const left = new Set();
  /** @param {string} file @param {string[]} way the files before it */
  const visit = (file, way) => {
    if (way.includes(file)) return void circles.push([...way.slice(way.indexOf(file)), file]);
    if (left.has(file)) return;
    for (const next of graph.get(file) ?? []) visit(next, [...way, file]);
    left.add(file);
  };
  for (const file of graph.keys()) visit(file, []);
  return circles;
}

const imports = new Map(files.map((file) => [file, importsOf(file)]));

test('circles of any length are found, and nothing else', () => {
  const graph = new Map(Object.entries({ a: ['b', 'c'], b: ['c'], c: ['d'], d: ['b'], e: ['e', 'a'] }));
  assert.deepEqual(circlesIn(graph), [['b', 'c', 'd', 'b'], ['e', 'e']]);
});

test('imports of every kind are seen', () => {
  const text = [
    "import a from './a';", "import type { B,\n  C } from './b';", "export * from './c';", "import './d.css';", "import other from 'other';",
    // In two pieces, or this file would import it.
    `const e = () => ${'import'}('./e');`, `/** @type {${'import'}('./f.mjs').F} */`,
  ].join('\n');
  assert.deepEqual(addressesIn(text), ['./a', './b', './c', './d.css', './e', './f.mjs']);
});

test('every address leads to a file', () => {
  // Builds make the modules beside the page, and the package's script has its module in the same folder only when it is packed.
  const lost = [...imports].flatMap(([file, all]) => all.filter(({ address, to }) => !to && !/\/(pkg[\w-]*|target)\/|^\.\/bubblestone\.js$/.test(address)).map(({ address }) => `${relative(root, file)}: ${address}`));
  assert.deepEqual(lost, []);
});

test('no files import each other in a circle', () => {
  const graph = new Map([...imports].map(([file, all]) => [file, all.flatMap(({ to }) => (to ? [to] : []))]));
  const circles = circlesIn(graph).map((way) => way.map((file) => relative(root, file)).join(' → '));
  assert.deepEqual(circles, []);
});
