// `npm test`: all steps, up to the first failure. `npm test -- types lint`: only these steps, without the set-up.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';
import { linesOf } from './lib/costs.mjs';
import { ask, say, start, Stop } from './lib/run.mjs';
import { nativeEnv } from './lib/rust.mjs';
import * as setup from './lib/setup.mjs';

/** A step, the step that it waits for, and the build folder that cargo locks for it. @typedef {{ name: string, after?: string, folder?: string }} Step */

/**
 * The steps in the order in which they begin. Two run side by side, because most of a build uses only one core. Long steps
 * come first, so that both sides end at about the same time.
 * @type {Step[]}
 */
const builds = [
  { name: 'cargo fmt' },
  { name: 'wasm build', folder: 'wasm' },
  { name: 'clippy, native', folder: 'native' },
  { name: 'cargo test', folder: 'native' },
  { name: 'page build', after: 'wasm build' },
  { name: 'wasm test', folder: 'wasm' },
  { name: 'modules as sent', after: 'wasm build' },
  { name: 'clippy, wasm32', folder: 'wasm' },
  { name: 'cargo doc', folder: 'native' },
  { name: 'lint', after: 'wasm build' },
  { name: 'types', after: 'wasm build' },
  { name: 'page in Node', after: 'wasm build' },
  { name: 'dependencies' },
];

/** The steps that come last. They run one after the other, because each uses two cores. */
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
    await sideBySide(builds);
    for (const name of browsers) await one(name, 'inherit');
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

/** Runs steps, two at a time, each as early as possible. @param {Step[]} steps */
async function sideBySide(steps) {
  const waiting = [...steps];
  /** @type {Map<Step, Promise<void>>} */
  const active = new Map();
  /** @param {Step} step */
  const canRun = ({ after, folder }) =>
    (!after || done.some(({ name }) => name === after)) && ![...active.keys()].some((other) => folder && other.folder === folder);
  try {
    while (waiting.length || active.size) {
      const next = active.size < 2 ? waiting.find(canRun) : undefined;
      if (!next) await Promise.race(active.values());
      else {
        waiting.splice(waiting.indexOf(next), 1);
        active.set(next, one(next.name, 'pipe').finally(() => active.delete(next)));
      }
    }
  } finally {
    await Promise.allSettled(active.values());
  }
}

/** @param {string} name of a step @param {'pipe' | 'inherit'} output */
function one(name, output) {
  return timed(name, (tell) => step(name, output, tell));
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
