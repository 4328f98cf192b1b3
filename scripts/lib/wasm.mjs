// The WebAssembly module, built by wasm-pack for the page or for Node, and skipped where nothing has changed.
import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { digest } from './digest.mjs';
import { root, run, say, Stop } from './run.mjs';
import { targetDir, wasmTarget, wasmTargetDir } from './rust.mjs';

/** Where the page's module, Node's and the one with the benchmarks are. */
export const pageModule = join(root, 'pkg');
/** The page's module as it is sent. */
export const packedModule = join(pageModule, 'bubblestone.lzma');
export const nodeModule = join(targetDir, 'pkg-node');
const benchModule = join(targetDir, 'pkg-bench');

// What decides the module beside the code that cargo compiled.
const recipe = ['Cargo.toml', 'Cargo.lock', 'package-lock.json', 'scripts/lib/wasm.mjs', 'scripts/lib/trim.mjs', 'scripts/lib/locations.mjs'];

/**
 * Builds the module; answers its folder.
 * @param {'web' | 'nodejs' | 'bench'} kind bench: for Node, with the benchmarks
 * @param {NodeJS.ProcessEnv} env of the Rust for WebAssembly
 */
export async function buildWasm(kind, env) {
  const folder = { web: pageModule, nodejs: nodeModule, bench: benchModule }[kind];
  const target = kind === 'web' ? 'web' : 'nodejs';
  const features = kind === 'bench' ? ['--features', 'bench'] : [];
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
  if (kind === 'web') await pack(module);
  writeFileSync(stamp, source);
  return folder;
}

/** What the page loads: see www/module/lzma.ts. @param {string} module */
async function pack(module) {
  const { default: lzma } = await import('lzma');
  writeFileSync(packedModule, Uint8Array.from(lzma.compress(readFileSync(module), 9)));
}

/** What Cargo.toml tells wasm-opt to do with a release. */
function optimizing() {
  const [, words] = /^wasm-opt = \[([^\]]*)\]/m.exec(readFileSync(join(root, 'Cargo.toml'), 'utf8')) ?? [];
  if (words === undefined) throw new Stop('Cargo.toml has no words for wasm-opt.');
  return [...words.matchAll(/"([^"]+)"/g)].map(([, word]) => word);
}
