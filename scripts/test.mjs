// `npm test`: all steps, up to the first failure. `npm test -- types lint`: only these steps, without the set-up.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { linesOf } from './lib/costs.mjs';
import { ask, say, start, Stop } from './lib/run.mjs';
import { nativeEnv } from './lib/rust.mjs';
import * as setup from './lib/setup.mjs';

// The two rows of a pair run side by side, as much of a build uses only one core. Each builds in its own folder, as cargo
// locks it. The second pair needs the module. The browsers come last, one kind at a time, as each keeps two cores busy.
const pairs = [
  [['cargo fmt', 'clippy, native', 'cargo doc', 'dependencies'], ['wasm build']],
  [['cargo test', 'types', 'page in Node', 'lint'], ['page build', 'modules as sent', 'clippy, wasm32', 'wasm-pack test']],
];
const browsers = ['tests in Chromium', 'tests in Firefox'];

/** @typedef {import('./lib/costs.mjs').Cost} Cost */

/** The steps that have ended, each with the slowest of its tests. @type {(Cost & { slowest: Cost[] })[]} */
const done = [];
/** @type {Set<import('node:child_process').ChildProcess>} */
const running = new Set();

const named = process.argv.slice(2);
await start(named.length ? () => these(named) : everything);

/** @param {string[]} names */
async function these(names) {
  const { steps } = await import('./lib/steps.mjs');
  for (const name of names) {
    if (!steps[name]) throw new Stop(`There is no step ${name}. These are: ${Object.keys(steps).join('; ')}.`);
    await steps[name]();
  }
}

async function everything() {
  process.on('exit', stopAll);
  for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, () => process.exit(1));
  try {
    await timed('set-up', setUp);
    for (const pair of pairs) await Promise.all(pair.map((row) => inOrder(row, 'pipe')));
    await inOrder(browsers, 'inherit');
    console.log('\nAll tests passed.');
  } finally {
    printCosts();
  }
}

/** Prints the time of each step, with its slowest tests below it. */
function printCosts() {
  for (const step of done) {
    console.log(linesOf([step], ''));
    if (step.slowest.length) console.log(linesOf(step.slowest, '          '));
  }
}

function setUp() {
  setup.checkGivens();
  setup.npmPackages();
  setup.rustLinters();
  const wasm = setup.wasmRust();
  setup.wasmClippy(wasm);
  setup.wasmTools();
  setup.cargoDeny();
  const programs = [setup.browser('chromium'), setup.browser('firefox')];
  console.log(`Native: ${ask('rustc', ['--version'], nativeEnv())}. WebAssembly: ${ask('rustc', ['--version'], wasm)}.`);
  console.log(`Browsers: ${programs.join(', ')}.`);
}

/**
 * Measures the time of some work, and collects the costs that it reports.
 * @param {string} name
 * @param {(tell: (slowest: Cost[]) => void) => unknown} work
 */
async function timed(name, work) {
  say(`== ${name}`);
  const begin = performance.now();
  /** @type {Cost[]} */
  let slowest = [];
  try {
    await work((told) => (slowest = told));
  } finally {
    done.push({ name, seconds: (performance.now() - begin) / 1000, slowest });
  }
}

/** @param {string[]} names @param {'pipe' | 'inherit'} output */
async function inOrder(names, output) {
  for (const name of names) await timed(name, (tell) => step(name, output, tell));
}

/**
 * Runs a step in a process of its own. Piped output is kept until it ends, and then shown whole.
 * @param {string} name
 * @param {'pipe' | 'inherit'} output
 * @param {(slowest: Cost[]) => void} tell
 */
async function step(name, output, tell) {
  const child = spawn(process.execPath, [fileURLToPath(import.meta.url), name], { stdio: ['ignore', output, output, 'ipc'], detached: true });
  running.add(child);
  child.on('message', (slowest) => tell(/** @type {Cost[]} */ (slowest)));
  /** @type {Buffer[]} */
  const shown = [];
  for (const stream of [child.stdout, child.stderr]) stream?.on('data', (piece) => shown.push(piece));
  const [code] = await once(child, 'close');
  // Another step has failed and printed its error.
  if (!running.delete(child)) throw new Stop(`${name} was stopped.`);
  if (shown.length) say(`== ${name} has ended:\n${Buffer.concat(shown).toString().trim()}`);
  if (code === 0) return;
  stopAll();
  throw new Stop(`\`npm test -- '${name}'\` failed.`);
}

/** Stops all running steps with their child processes. */
function stopAll() {
  for (const child of running) {
    if (process.platform === 'win32' || !child.pid) child.kill();
    else process.kill(-child.pid);
  }
  running.clear();
}
