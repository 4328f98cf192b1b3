// The static site in dist/, and what it weighs.
import { readdirSync, readFileSync } from 'node:fs';
import { extname, join, relative } from 'node:path';
import { gzipSync } from 'node:zlib';
import { root, run, say, Stop } from './run.mjs';

export const site = join(root, 'dist');

/** The most that the WebAssembly module may weigh, gzipped. */
const wasmBudget = 320_000;

/** Vite's build of www/ and pkg/. */
export async function buildSite() {
  say('Building the page into dist/');
  run(process.execPath, [join(root, 'node_modules', 'vite', 'bin', 'vite.js'), 'build', '--logLevel', 'warn']);
  weigh();
}

/** Prints the gzipped size of each file; stops when the module is over its budget. */
function weigh() {
  const files = readdirSync(site, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name));
  const sizes = files.map((file) => ({ file, size: gzipSync(readFileSync(file), { level: 9 }).length }));
  const total = sizes.reduce((sum, { size }) => sum + size, 0);
  const wasm = sizes.filter(({ file }) => extname(file) === '.wasm').reduce((sum, { size }) => sum + size, 0);
  for (const { file, size } of sizes) console.log(`${kilobytes(size)}  ${relative(site, file)}`);
  console.log(`${kilobytes(wasm)}  WebAssembly, of at most ${wasmBudget / 1000} kB`);
  console.log(`${kilobytes(total)}  in all (gzipped)`);
  if (wasm > wasmBudget) {
    throw new Stop(`The WebAssembly module is ${wasm} bytes gzipped: at most ${wasmBudget} are allowed.`);
  }
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(1).padStart(8)} kB`;
}
