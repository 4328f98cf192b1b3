// `npm test`: everything, in order, ending at the first failure.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, root, run, say, start } from './lib/run.mjs';
import { nativeEnv, wasmTarget } from './lib/rust.mjs';
import * as setup from './lib/setup.mjs';
import { buildSite } from './lib/site.mjs';
import { buildWasm } from './lib/wasm.mjs';

/** @type {{ name: string, seconds: number }[]} */
const done = [];

await start(async () => {
  try {
    const { native, wasm, programs, hasWasmClippy } = await step('set-up', setUp);
    await step('cargo fmt', () => run('cargo', ['fmt', '--check'], { env: native, otherwise: 'Run `cargo fmt`.' }));
    await step('clippy, native', () => clippy(['--all-targets'], native));
    await step('clippy, wasm32', () => wasmLint(wasm, hasWasmClippy));
    await step('cargo test', () => run('cargo', ['test'], { env: native }));
    await step('wasm-pack test', () => wasmTest(wasm));
    await step('wasm build', () => buildWasm('web', wasm));
    await step('types', types);
    await step('lint', () => tool('eslint', 'bin/eslint.js', ['--max-warnings', '0', '.']));
    await step('page build', buildSite);
    await step('tests in Chromium', () => browserTests('chromium', programs));
    await step('tests in Firefox', () => browserTests('firefox', programs));
    console.log('\nAll tests passed.');
  } finally {
    for (const { name, seconds } of done) console.log(`${seconds.toFixed(1).padStart(8)} s  ${name}`);
  }
});

/**
 * Runs one step and notes how long it took.
 * @template T
 * @param {string} name
 * @param {() => T} work
 */
async function step(name, work) {
  say(`== ${name}`);
  const begin = performance.now();
  try {
    return await work();
  } finally {
    done.push({ name, seconds: (performance.now() - begin) / 1000 });
  }
}

function setUp() {
  setup.checkGivens();
  setup.npmPackages();
  setup.rustLinters();
  const wasm = setup.wasmRust();
  const hasWasmClippy = setup.wasmClippy(wasm);
  setup.wasmTools();
  const programs = { CHROME_PATH: setup.browser('chromium'), FIREFOX_PATH: setup.browser('firefox') };
  const native = nativeEnv();
  // wasm-pack first builds with the profile dev and then tests with the profile test: alike, they build once.
  for (const profile of ['DEV', 'TEST']) {
    wasm[`CARGO_PROFILE_${profile}_OPT_LEVEL`] = '2';
    wasm[`CARGO_PROFILE_${profile}_DEBUG`] = '0';
  }
  console.log(`Native: ${ask('rustc', ['--version'], native)}. WebAssembly: ${ask('rustc', ['--version'], wasm)}.`);
  console.log(`Browsers: ${Object.values(programs).join(', ')}.`);
  return { native, wasm, programs, hasWasmClippy };
}

/** @param {string[]} what @param {NodeJS.ProcessEnv} env */
function clippy(what, env) {
  run('cargo', ['clippy', ...what, '--', '-D', 'warnings'], { env });
}

/** @param {NodeJS.ProcessEnv} env @param {boolean} hasClippy */
function wasmLint(env, hasClippy) {
  const what = ['--lib', '--tests', '--target', wasmTarget];
  if (hasClippy) return clippy(what, env);
  console.log('The Rust for WebAssembly has no clippy here: its code is compiled with warnings denied instead.');
  const deny = `target.${wasmTarget}.rustflags=["-D", "warnings"]`;
  run('cargo', ['check', ...what, '--config', deny], { env });
}

/** @param {NodeJS.ProcessEnv} env */
function wasmTest(env) {
  const hasFiles = readdirSync(join(root, 'tests')).some((file) => file.endsWith('.rs'));
  // Named one by one: examples and benches are for the native build only.
  const what = ['--lib', ...(hasFiles ? ['--test', '*'] : [])];
  run('wasm-pack', ['test', '--node', '--mode', 'no-install', '--', ...what], { env });
}

function types() {
  for (const project of ['tsconfig.json', 'www/service/tsconfig.json', 'tsconfig.node.json']) {
    tool('typescript', 'bin/tsc', ['--noEmit', '-p', project]);
  }
}

/** @param {string} name of the npm package @param {string} program in it @param {string[]} args */
function tool(name, program, args) {
  run(process.execPath, [join(root, 'node_modules', name, program), ...args]);
}

/** @param {import('./lib/browser.mjs').Kind} kind @param {NodeJS.ProcessEnv} programs */
function browserTests(kind, programs) {
  const folder = join(root, 'tests', 'browser');
  const files = readdirSync(folder)
    .filter((file) => file.endsWith('.test.mjs'))
    .sort()
    .map((file) => join(folder, file));
  const env = { ...process.env, ...programs, BROWSER: kind };
  run(process.execPath, ['--test', '--test-concurrency=2', '--test-timeout=1500000', '--test-reporter=spec', ...files], { env });
}
