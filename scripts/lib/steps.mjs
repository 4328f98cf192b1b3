// The steps of `npm test`. Each needs the set-up and the builds of the steps before it.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { pipeline } from 'node:stream/promises';
import { run as test } from 'node:test';
import { spec } from 'node:test/reporters';
import { pathToFileURL } from 'node:url';
import { browsers } from './browser.mjs';
import { tellCosts } from './costs.mjs';
import { ask, root, run, Stop } from './run.mjs';
import { nativeEnv, neededRust, targetDir, wasmEnv, wasmTarget } from './rust.mjs';
import { clippyMatches } from './setup.mjs';
import { buildSite } from './site.mjs';
import { buildModules } from './wasm.mjs';

/** The only native tests that run in WebAssembly, too. */
const testsInWasm = ['--test', 'properties', '--test', 'hostile'];

/**
 * Settings of cargo for builds that serve one run: no data for incremental builds and no debug information. A panic
 * names its line all the same.
 */
const singleBuild = { CARGO_INCREMENTAL: '0', CARGO_PROFILE_TEST_DEBUG: '0' };

/** The tests under Node that compare many digests or films of the built modules: they take long, and have a step of their own. */
const ofModules = ['shipped', 'film'].map((name) => `${name}.test.mjs`);

/** @type {Record<string, () => unknown>} */
export const steps = {
  'cargo fmt': () => run('cargo', ['fmt', '--check'], { env: nativeEnv(), otherwise: 'Run `cargo fmt`.' }),
  'clippy, native': clippyNative,
  'cargo test': cargoTest,
  'cargo doc': () => run('cargo', ['doc', '--no-deps'], { env: { ...forNative(), RUSTDOCFLAGS: '-D warnings' } }),
  dependencies,
  'wasm build': () => buildModules(forWasm()),
  'page build': buildSite,
  types,
  'page in Node': () => nodeTests(inNode((file) => !ofModules.includes(file)), 'Node'),
  lint: () => tool('eslint', 'bin/eslint.js', ['--max-warnings', '0', '.']),
  'modules as sent': () => nodeTests(inNode((file) => ofModules.includes(file)), 'Node'),
  'clippy, wasm32': () => wasmLint(forWasm()),
  'wasm test': () => wasmTest(forWasm()),
  'tests in Chromium': () => browserTests('chromium'),
  'tests in Firefox': () => browserTests('firefox'),
};

function forNative() {
  return { ...nativeEnv(), ...singleBuild };
}

function forWasm() {
  const env = wasmEnv();
  if (!env) throw new Stop('There is no Rust for WebAssembly: `npm run setup` brings it.');
  return { ...env, ...singleBuild };
}

function clippyNative() {
  clippy(['--all-targets'], forNative());
  // The configuration of a first visit's module.
  clippy(['--lib', '--no-default-features'], forNative());
}

/** @param {string[]} what @param {NodeJS.ProcessEnv} env */
function clippy(what, env) {
  run('cargo', ['clippy', ...what, '--', '-D', 'warnings'], { env });
}

/** Runs the native tests and notes how long each test program took: cargo prints its name, and the program its time. */
async function cargoTest() {
  // The step of clippy compiles the examples.
  const costs = [...(await cargoTests('--tests')), ...(await cargoTests('--doc'))];
  await tellCosts(costs);
}

/** @param {string} which */
async function cargoTests(which) {
  const child = spawn('cargo', ['test', which], { env: forNative(), cwd: root, stdio: ['ignore', 'pipe', 'pipe'] });
  const text = { said: '', told: '' };
  child.stdout.on('data', (piece) => (process.stdout.write(piece), (text.said += piece)));
  child.stderr.on('data', (piece) => (process.stderr.write(piece), (text.told += piece)));
  const [code] = await once(child, 'close');
  const seconds = [...text.said.matchAll(/^test result: .*finished in ([\d.]+)s$/gm)].map(([, time]) => Number(time));
  const names = [...text.told.matchAll(/^ *(?:Running (.+) \(.+\)|(Doc-tests .+))$/gm)].map(([, program, docs]) => program ?? docs ?? '');
  if (code !== 0) throw new Stop(`\`cargo test ${which}\` failed: exit code ${code}.`);
  return names.map((name, at) => ({ name, seconds: seconds[at] ?? 0 }));
}

/** @param {NodeJS.ProcessEnv} env */
function wasmLint(env) {
  // All features, as no other step builds the benchmarks of piles for WebAssembly. The tests are linted natively.
  const what = ['--lib', '--all-features', '--target', wasmTarget];
  if (clippyMatches(env)) return clippy(what, env);
  console.log('The Rust for WebAssembly has no clippy here: its code is compiled with warnings denied instead.');
  const deny = `target.${wasmTarget}.rustflags=["-D", "warnings"]`;
  run('cargo', ['check', ...what, '--config', deny], { env });
}

/**
 * Tests for WebAssembly alone: the interface to JavaScript, and `usize` of 32 bits, whose overflow is checked here. They
 * make pavements only, so the first visit's configuration serves, which is built in half the time. Cargo is called as
 * `wasm-pack test --node` calls it, which first builds all other test programs, too.
 * @param {NodeJS.ProcessEnv} env
 */
function wasmTest(env) {
  const runner = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: 'wasm-bindgen-test-runner', WASM_BINDGEN_TEST_ONLY_NODE: '1' };
  run('cargo', ['test', '--target', wasmTarget, '--no-default-features', ...testsInWasm], { env: { ...env, ...runner } });
}

/** Checks licences, sources and duplicates of dependencies, and that none needs a newer Rust than Cargo.toml does. */
function dependencies() {
  const env = nativeEnv();
  run('cargo', ['deny', '--all-features', 'check', '-D', 'warnings', 'bans', 'licenses', 'sources'], { env });
  const { packages } = JSON.parse(ask('cargo', ['metadata', '--format-version', '1', '--locked'], env) ?? '{}');
  /** @param {string} version */
  const number = (version) => version.split('.').reduce((sum, part, at) => sum + Number(part) / 1000 ** at, 0);
  const newer = packages.filter((/** @type {{ rust_version?: string }} */ { rust_version }) => rust_version && number(rust_version) > number(neededRust()));
  for (const { name, version, rust_version } of newer) console.log(`${name} ${version} needs Rust ${rust_version}`);
  if (newer.length) throw new Stop(`Cargo.toml promises Rust ${neededRust()}: take other versions, or promise less.`);
  console.log(`${packages.length} packages build with Rust ${neededRust()}.`);
}

function types() {
  for (const project of ['tsconfig.json', 'www/service/tsconfig.json', 'package/tsconfig.json', 'tsconfig.node.json']) {
    tool('typescript', 'bin/tsc', ['--noEmit', '-p', project]);
  }
}

/** @param {string} name of the npm package @param {string} program in it @param {string[]} args */
function tool(name, program, args) {
  run(process.execPath, [join(root, 'node_modules', name, program), ...args]);
}

// The longest tests start first, the longest one at the head, so that none of them runs alone at the end.
const long = ['learn-pages', 'masonry', 'axe', 'models', 'fine', 'turn', 'surface', 'pile', 'film', 'import', 'makes', 'language', 'share', 'files', 'layout', 'learn-which-way'].map(
  (name) => `${name}.test.mjs`,
);

/**
 * The number of processes that share the test files of a browser. Each process starts its own browsers: with fewer
 * processes there are fewer starts, with more of them all end at about the same time. Firefox takes three seconds to start.
 */
const PROCESSES = { chromium: 20, firefox: 9 };

/** @param {import('./browser.mjs').Kind} kind */
async function browserTests(kind) {
  const folder = join(root, 'tests', 'browser');
  const others = readdirSync(folder).filter((file) => file.endsWith('.test.mjs') && !long.includes(file));
  process.env.BROWSER = kind;
  const made = join(targetDir, 'browser-tests');
  rmSync(made, { recursive: true, force: true });
  mkdirSync(made, { recursive: true });
  const count = PROCESSES[kind];
  const bundles = Array.from({ length: count }, (_, k) => [...long, ...others].filter((_, at) => at % count === k));
  const files = bundles.map((names, k) => {
    const file = join(made, `${kind}-${k}.test.mjs`);
    writeFileSync(file, names.map((name) => `import '${pathToFileURL(join(folder, name)).href}';\n`).join(''));
    return file;
  });
  // Three files at a time keep two cores busy, because each of them waits now and then.
  await nodeTests(files, browsers[kind].title, 3);
}

/**
 * The files of tests under Node, as the folder has them, so that a new one runs, too.
 * @param {(file: string) => boolean} wanted
 */
function inNode(wanted) {
  const folder = join(root, 'tests', 'node');
  return readdirSync(folder).filter((file) => file.endsWith('.test.mjs') && wanted(file)).map((file) => join(folder, file));
}

/** @param {string[]} files @param {string} where @param {number} [concurrency] files at a time */
async function nodeTests(files, where, concurrency = 2) {
  const events = test({ files, concurrency, timeout: 1_500_000 });
  let failed = 0;
  events.on('test:fail', () => (failed += 1));
  /** @type {import('./costs.mjs').Cost[]} */
  const costs = [];
  // Files end with an event of their own name.
  events.on('test:complete', ({ name, nesting, file = '', details }) => {
    const path = relative(root, file);
    if (!nesting) costs.push({ name: name === file ? path : `${path}: ${name}`, seconds: details.duration_ms / 1000 });
  });
  await pipeline(events, new spec(), process.stdout, { end: false });
  await tellCosts(costs);
  if (failed) throw new Stop(`Tests failed in ${where}.`);
}
