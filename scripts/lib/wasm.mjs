// The WebAssembly module, built by wasm-pack for the page or for Node, and skipped where nothing has changed.
import { appendFileSync, existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { digest } from './digest.mjs';
import { ask, root, run, say, Stop } from './run.mjs';
import { targetDir, wasmTarget } from './rust.mjs';

/** The folder of the page's first module, which makes only pavements. */
export const pageModule = join(root, 'pkg');

/** The folder of the module that makes everything. */
export const wholeModule = join(root, 'pkg-house');

/**
 * All builds: the folder, the target, and cargo's options. The cargo feature `house` has everything that a first visit does
 * not need.
 */
const BUILDS = {
  /**
   * The module of a first visit. LLVM's own threshold for inlining is 225. With 80 the module is a thirtieth smaller,
   * and a picture takes the same time within the hundredth that can be measured. With 60 it is a fiftieth smaller
   * still, but a picture takes a fiftieth longer. The other module keeps 225, as frames of bodies would be slower by a
   * tenth.
   */
  web: { folder: pageModule, target: 'web', options: ['--no-default-features', '--config', `target.${wasmTarget}.rustflags=["-C", "llvm-args=-inline-threshold=80"]`] },
  house: { folder: wholeModule, target: 'web', options: [] },
  /** The module with measurements. */
  bench: { folder: join(targetDir, 'pkg-bench'), target: 'nodejs', options: ['--features', 'bench'] },
};

// Files and folders that decide the modules.
const sources = ['Cargo.toml', 'Cargo.lock', 'build.rs', 'src', 'benches', 'package-lock.json', 'scripts/lib/wasm.mjs'];

/** The digest of the sources of the modules. @param {NodeJS.ProcessEnv} env of the Rust for WebAssembly */
function digestOfSources(env) {
  const files = sources.flatMap((path) => {
    const at = join(root, path);
    if (!statSync(at).isDirectory()) return [at];
    return readdirSync(at, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name)).sort();
  });
  return `${ask('rustc', ['--version'], env)} ${digest(files)}`;
}

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
  const { folder, target, options } = BUILDS[kind];
  const stamp = join(folder, '.built-from');
  const source = digestOfSources(env);
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === source) return folder;
  say(`Building the WebAssembly module (${kind})`);
  rmSync(folder, { recursive: true, force: true });
  const extra = options.length ? ['--', ...options] : [];
  run('wasm-pack', ['build', '--mode', 'no-install', '--profiling', '--target', target, '--out-dir', folder, ...extra], { env });
  const module = join(folder, 'bubblestone_bg.wasm');
  run('wasm-opt', [module, '-o', module, ...optimizing()], { env });
  if (target === 'web') releasable(folder);
  writeFileSync(stamp, source);
  return folder;
}

/**
 * Adds a function that lets the page drop a module with its memory. An imported script stays for ever, and would hold
 * them.
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
