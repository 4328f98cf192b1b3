// Chooses the Rust for each build: the one on PATH for native code, the first one that has the target for WebAssembly.
import { readFileSync, readdirSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { ask, isProgram, root, Stop, which } from './run.mjs';

export const wasmTarget = 'wasm32-unknown-unknown';

/** The folder of a distribution's programs, where a second Rust may be beside rustup's. */
export const systemBin = '/usr/bin';

/** The folder of cargo's builds. A folder inside it is kept for WebAssembly, so that two compilers never share one. */
export const targetDir = process.env.CARGO_TARGET_DIR ?? join(root, 'target');
const wasmTargetDir = join(targetDir, 'wasm');

/** The folder in which `cargo install` puts programs. */
export const cargoBin = join(process.env.CARGO_HOME ?? join(homedir(), '.cargo'), 'bin');

/** The folder in which the set-up puts a prebuilt cargo-deny. */
export const cargoDenyFolder = join(targetDir, 'tools', 'cargo-deny');

const linkerVariable = 'CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER';

/** The version of a package in Cargo.lock. @param {string} name */
export function lockedVersion(name) {
  const lock = readFileSync(join(root, 'Cargo.lock'), 'utf8');
  const version = new RegExp(`name = "${name}"\\r?\\nversion = "([^"]+)"`).exec(lock)?.[1];
  if (!version) throw new Stop(`Cargo.lock has no package ${name}: run \`cargo update\` and commit the file.`);
  return version;
}

/** The oldest Rust that builds this crate. */
export function neededRust() {
  return /^rust-version = "([^"]+)"/m.exec(readFileSync(join(root, 'Cargo.toml'), 'utf8'))?.[1] ?? '1.85';
}

/** Whether a rustc exists and is new enough. @param {string} [rustc] */
export function isRecent(rustc = 'rustc') {
  const [, major, minor] = /^rustc (\d+)\.(\d+)/.exec(ask(rustc, ['--version']) ?? '') ?? [];
  const [neededMajor, neededMinor] = neededRust().split('.').map(Number);
  return Number(major) > neededMajor || (Number(major) === neededMajor && Number(minor) >= neededMinor);
}

/** A PATH with cargo's programs after the caller's own, so that tools installed by cargo are found. @param {string[]} first */
function pathWith(...first) {
  return [...first, join(root, 'node_modules', '.bin'), process.env.PATH ?? '', cargoBin, join(cargoDenyFolder, 'bin')].join(delimiter);
}

/** The environment of native builds. */
export function nativeEnv() {
  return { ...process.env, PATH: pathWith() };
}

/**
 * The environment in which cargo can build for WebAssembly, or undefined where no Rust has the target.
 * @returns {NodeJS.ProcessEnv | undefined}
 */
export function wasmEnv() {
  for (const folder of ['', systemBin]) {
    const rustc = folder ? join(folder, 'rustc') : 'rustc';
    if (folder && !isProgram(rustc)) continue;
    if (!isRecent(rustc) || !hasWasmStd(rustc)) continue;
    const linker = wasmLinker(rustc);
    if (linker === undefined) continue;
    return {
      ...process.env,
      PATH: folder ? pathWith(folder) : pathWith(),
      CARGO_TARGET_DIR: wasmTargetDir,
      ...(linker && { [linkerVariable]: linker }),
    };
  }
  return undefined;
}

/** Whether a rustc has the standard library for WebAssembly. @param {string} rustc */
function hasWasmStd(rustc) {
  const folder = wasmLibraries(rustc);
  if (!folder) return false;
  try {
    return readdirSync(folder).some((file) => /^libstd-.*\.rlib$/.test(file));
  } catch {
    return false;
  }
}

/** The folder in which a rustc looks for the libraries of the target. @param {string} rustc */
export function wasmLibraries(rustc) {
  return ask(rustc, ['--print', 'target-libdir', '--target', wasmTarget]);
}

/**
 * The linker to name to cargo; empty where rustc brings its own, undefined where there is none.
 * @param {string} rustc
 */
function wasmLinker(rustc) {
  if (process.env[linkerVariable]) return process.env[linkerVariable];
  const sysroot = ask(rustc, ['--print', 'sysroot']) ?? '';
  const host = /^host: (.+)$/m.exec(ask(rustc, ['-vV']) ?? '')?.[1] ?? '';
  const suffix = process.platform === 'win32' ? '.exe' : '';
  if (isProgram(join(sysroot, 'lib', 'rustlib', host, 'bin', `rust-lld${suffix}`))) return '';
  if (which('wasm-ld')) return 'wasm-ld';
  return newestSystemLinker();
}

function newestSystemLinker() {
  try {
    const found = readdirSync(systemBin).filter((file) => /^wasm-ld-\d+$/.test(file));
    return found.sort((a, b) => Number(b.slice(8)) - Number(a.slice(8)))[0];
  } catch {
    return undefined;
  }
}
