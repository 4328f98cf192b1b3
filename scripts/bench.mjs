// `npm run bench`: the same benchmarks natively and in WebAssembly under Node, side by side.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { nativeEnv } from './lib/rust.mjs';
import { root, say, start, Stop } from './lib/run.mjs';
import * as setup from './lib/setup.mjs';
import { buildWasm } from './lib/wasm.mjs';

/** @typedef {{ name: string, ms: number }} Timing */

const nativePart = join(root, 'examples', 'bench.rs');
const wasmPart = join(root, 'benches', 'bench.mjs');

await start(async () => {
  for (const file of [nativePart, wasmPart]) {
    if (!existsSync(file)) throw new Stop(`There is no ${file.slice(root.length + 1)}: there are no benchmarks to run.`);
  }
  setup.checkGivens();
  setup.npmPackages();
  const env = setup.wasmRust();
  setup.wasmTools();
  const folder = await buildWasm('bench', env);
  const native = runNative();
  const wasm = await runWasm(folder);
  print(native, wasm);
});

/** Reads one JSON object per line; other lines are for people. @returns {Timing[]} */
function runNative() {
  say('Running the benchmarks natively');
  const { status, stdout } = spawnSync('cargo', ['run', '--release', '--example', 'bench'], {
    cwd: root,
    env: nativeEnv(),
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  if (status !== 0) throw new Stop('The native benchmarks failed.');
  return stdout
    .split('\n')
    .filter((line) => line.startsWith('{'))
    .map((line) => JSON.parse(line));
}

/** @param {string} folder of the module @returns {Promise<Timing[]>} */
async function runWasm(folder) {
  say('Running the benchmarks in WebAssembly under Node');
  const module = createRequire(import.meta.url)(join(folder, 'bubblestone.js'));
  const { run: runAll } = await import(pathToFileURL(wasmPart).href);
  return runAll(module);
}

/** @param {Timing[]} native @param {Timing[]} wasm */
function print(native, wasm) {
  const names = [...new Set([...native, ...wasm].map(({ name }) => name))];
  const width = Math.max(9, ...names.map((name) => name.length));
  console.log(`\n${'benchmark'.padEnd(width)}   native ms     wasm ms  wasm/native`);
  for (const name of names) {
    const times = [native, wasm].map((list) => list.find((timing) => timing.name === name)?.ms);
    const ratio = times[0] !== undefined && times[1] !== undefined ? (times[1] / times[0]).toFixed(2) : '-';
    const columns = times.map((ms) => (ms === undefined ? '-' : ms.toFixed(3)).padStart(12));
    console.log(`${name.padEnd(width)}${columns.join('')}${ratio.padStart(13)}`);
  }
}
