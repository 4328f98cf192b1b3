// Installs Debian packages for programs that rustup and npm cannot bring.
import { readFileSync } from 'node:fs';
import { ask, run, say, tryRun, which } from './run.mjs';

/** Whether this is Debian itself. Its derivatives ship other packages under the same names. */
function isDebian() {
  try {
    return /^ID=debian$/m.test(readFileSync('/etc/os-release', 'utf8')) && Boolean(which('apt-get'));
  } catch {
    return false;
  }
}

/** The words before a command that needs root; undefined if root is out of reach. */
function rootPrefix() {
  if (process.getuid?.() === 0) return [];
  return ask('sudo', ['-n', 'true']) === undefined ? undefined : ['sudo', '-n'];
}

/** Whether Debian packages can be installed without asking a person. */
export function canInstall() {
  return isDebian() && rootPrefix() !== undefined;
}

/** @param {string[]} command */
export function runAsRoot(command) {
  const [program, ...args] = [...(rootPrefix() ?? []), 'env', 'DEBIAN_FRONTEND=noninteractive', ...command];
  run(program, args);
}

let listsAreFresh = false;

function refreshLists() {
  if (listsAreFresh) return;
  const [program, ...args] = [...(rootPrefix() ?? []), 'apt-get', 'update', '-qq'];
  tryRun(program, args); // The lists may be old; the installation itself fails if they are too old.
  listsAreFresh = true;
}

/** @param {string} name */
export function hasPackage(name) {
  refreshLists();
  return Boolean(ask('apt-cache', ['show', '--no-all-versions', name]));
}

/**
 * The package with the highest number in its name, such as lld-22 for lld.
 * @param {string} name
 */
export function newestNumbered(name) {
  refreshLists();
  const found = ask('apt-cache', ['search', '--names-only', `^${name}-[0-9]+$`]) ?? '';
  const numbers = [...found.matchAll(new RegExp(`^${name}-(\\d+) `, 'gm'))].map((match) => Number(match[1]));
  return numbers.length === 0 ? undefined : `${name}-${Math.max(...numbers)}`;
}

/** @param {string[]} names */
export function install(names) {
  refreshLists();
  say(`Installing Debian packages: ${names.join(' ')}`);
  const options = ['-y', '-qq', '--no-install-recommends', '-o', 'Dpkg::Use-Pty=0', '-o', 'DPkg::Lock::Timeout=600'];
  runAsRoot(['apt-get', 'install', ...options, ...names]);
}
