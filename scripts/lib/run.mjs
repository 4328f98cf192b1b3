// Runs other programs and reports on them. It uses Node's own modules only, as it runs before `npm ci`.
import { spawnSync } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** A failure whose message is for the user: it is printed without a stack. */
export class Stop extends Error {}

/** The stream for messages of set-up and builds: 1 is the standard output, 2 the standard error. */
let chatter = 1;

/** Reserves the standard output for a command's answer. */
export function keepOutputForAnswer() {
  chatter = 2;
}

/** Prints a line about the next action. @param {string} line */
export function say(line) {
  const talk = chatter === 1 ? console.log : console.error;
  talk(`\n> ${line}`);
}

/**
 * Runs a program with its output shown, and stops if it fails.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv, cwd?: string, otherwise?: string }} [options]
 */
export function run(program, args, { env = process.env, cwd = root, otherwise } = {}) {
  const failure = tryRun(program, args, { env, cwd });
  if (failure) throw new Stop(otherwise ?? `\`${program} ${args.join(' ')}\` failed: ${failure}.`);
}

/**
 * Runs a program with its output shown. Returns the reason of a failure, or an empty string.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: NodeJS.ProcessEnv, cwd?: string }} [options]
 */
export function tryRun(program, args, { env = process.env, cwd = root } = {}) {
  const { error, status, signal } = spawnSync(program, args, {
    env,
    cwd,
    stdio: ['ignore', chatter, 2],
    shell: needsShell(program),
  });
  if (error) return 'code' in error && error.code === 'ENOENT' ? `${program} is not installed` : error.message;
  if (signal) return `ended by ${signal}`;
  return status === 0 ? '' : `exit code ${status}`;
}

/**
 * Returns the trimmed output of a program; undefined if it is missing or fails.
 * @param {string} program
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} [env]
 * @returns {string | undefined}
 */
export function ask(program, args, env = process.env) {
  const { error, status, stdout } = spawnSync(program, args, {
    env,
    cwd: root,
    encoding: 'utf8',
    maxBuffer: 2 ** 26,
    stdio: ['ignore', 'pipe', 'ignore'],
    shell: needsShell(program),
  });
  return error || status !== 0 ? undefined : stdout.trim();
}

/**
 * The path of a program found on a PATH; undefined if it is not there.
 * @param {string} program
 * @param {string} [path]
 */
export function which(program, path = process.env.PATH ?? '') {
  const suffix = process.platform === 'win32' ? '.exe' : '';
  return path
    .split(delimiter)
    .filter(Boolean)
    .map((folder) => join(folder, program + suffix))
    .find(isProgram);
}

/** @param {string} file */
export function isProgram(file) {
  try {
    accessSync(file, constants.X_OK);
    return statSync(file).isFile();
  } catch {
    return false;
  }
}

/**
 * Runs a script's main function: a Stop is printed as its sentence, and the exit code is 1.
 * @param {() => unknown} main
 */
export async function start(main) {
  try {
    await main();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`\n${error.message}`);
    process.exitCode = 1;
  }
}

// npm and npx are batch files on Windows, which only a shell can start.
/** @param {string} program */
function needsShell(program) {
  return process.platform === 'win32' && program === 'npm';
}
