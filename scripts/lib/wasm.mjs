// The WebAssembly module, built by wasm-pack for the page or for Node, and skipped where nothing has changed.
import { appendFileSync, existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { digest } from './digest.mjs';
import { root, run, say, Stop } from './run.mjs';
import { targetDir, wasmTarget, wasmTargetDir } from './rust.mjs';

/** The folder of the page's module, which knows pavements alone. */
export const pageModule = join(root, 'pkg');
/** The module as it is shipped. */
export const packedModule = join(pageModule, 'bubblestone.lzma');
export const nodeModule = join(targetDir, 'pkg-node');

/**
 * The folder of the module that makes everything: the feature `house` of Cargo.toml adds the parts that a first
 * visit does without.
 */
export const wholeModule = join(root, 'pkg-house');
/** As it is sent. */
export const packedWhole = join(wholeModule, 'house.lzma');

/** All builds: their folders, targets, and cargo features. */
const BUILDS = {
  /** The module of a first visit. */
  web: { folder: pageModule, target: 'web', features: [] },
  house: { folder: wholeModule, target: 'web', features: ['house'] },
  nodejs: { folder: nodeModule, target: 'nodejs', features: ['house'] },
  /** With the measurements. */
  bench: { folder: join(targetDir, 'pkg-bench'), target: 'nodejs', features: ['bench', 'house'] },
};

// Files that decide the module, besides the code that cargo compiles.
const recipe = ['Cargo.toml', 'Cargo.lock', 'package-lock.json', 'scripts/lib/wasm.mjs', 'scripts/lib/trim.mjs'];

/**
 * Builds the modules of the site.
 * @param {NodeJS.ProcessEnv} env of the Rust for WebAssembly
 */
export async function buildModules(env) {
  await buildWasm('web', env);
  await buildWasm('house', env);
}

/**
 * Builds a module; returns its folder.
 * @param {keyof typeof BUILDS} kind @param {NodeJS.ProcessEnv} env of the Rust for WebAssembly
 */
export async function buildWasm(kind, env) {
  const { folder, target, features: wanted } = BUILDS[kind];
  const features = wanted.length ? ['--features', wanted.join()] : [];
  const stamp = join(folder, '.built-from');
  say(`Building the WebAssembly module (${kind})`);
  // The very build that wasm-pack asks for, so that nothing is compiled twice.
  run('cargo', ['build', '--lib', '--release', '--target', wasmTarget, ...features], { env });
  const compiled = join(wasmTargetDir, wasmTarget, 'release', 'bubblestone.wasm');
  const source = digest([compiled, ...recipe.map((file) => join(root, file))]);
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === source) return folder;
  rmSync(folder, { recursive: true, force: true });
  const extra = features.length ? ['--', ...features] : [];
  run('wasm-pack', ['build', '--mode', 'no-install', '--profiling', '--target', target, '--out-dir', folder, ...extra], { env });
  const module = join(folder, 'bubblestone_bg.wasm');
  // Only here: this file is read before the npm packages are installed.
  const { trim } = await import('./trim.mjs');
  trim(module);
  run('wasm-opt', [module, '-o', module, ...optimizing()], { env });
  if (target === 'web') {
    await pack(folder, module, kind === 'web' ? 'bubblestone' : 'house');
    releasable(folder);
  }
  writeFileSync(stamp, source);
  return folder;
}

/**
 * Compresses a module as the page loads it: see www/module/lzma.ts.
 * @param {string} folder @param {string} module @param {string} name
 */
async function pack(folder, module, name) {
  const { default: lzma } = await import('lzma');
  writeFileSync(join(folder, `${name}.lzma`), Uint8Array.from(lzma.compress(readFileSync(module), 9)));
}

/**
 * Lets the page drop a module with all its memory: imported scripts stay for ever, and hold their instance.
 * @param {string} folder
 */
function releasable(folder) {
  const glue = join(folder, 'bubblestone.js');
  const views = [...readFileSync(glue, 'utf8').matchAll(/^let (cached\w+Memory0) = null;$/gm)].map(([, name]) => `${name} = `);
  if (!views.length) throw new Stop('The module\'s script is not as it was: its memory could not be let go of.');
  const what = `wasm = wasmModule = wasmInstance = __wbg_init_promise = undefined;\n    ${views.join('')}null;`;
  appendFileSync(glue, `\n/** Lets go of the module and its memory; all that was made with it must be freed before. */\nexport function release() {\n    ${what}\n}\n`);
  appendFileSync(join(folder, 'bubblestone.d.ts'), '\n/** Lets go of the module and its memory; all that was made with it must be freed before. */\nexport function release(): void;\n');
}

/** The arguments of wasm-opt in Cargo.toml for a release. */
function optimizing() {
  const [, words] = /^wasm-opt = \[([^\]]*)\]/m.exec(readFileSync(join(root, 'Cargo.toml'), 'utf8')) ?? [];
  if (words === undefined) throw new Stop('Cargo.toml has no words for wasm-opt.');
  return [...words.matchAll(/"([^"]+)"/g)].map(([, word]) => word);
}
