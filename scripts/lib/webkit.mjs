// WebKit, the engine of Safari and of all browsers on iPhones, as Debian has it (WebKitGTK). It is driven by its own
// WebDriver (W3C), because Puppeteer does not speak to it.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { isProgram, Stop, which } from './run.mjs';

/** The packages of Debian that have the programs below. */
const PACKAGES = 'webkit2gtk-driver and xvfb';

/** Milliseconds to wait for the driver, and for a script in a page. */
const STARTED = 30_000;
const SCRIPT = 240_000;

/** The small browser that comes with the driver; undefined if there is none. */
function browser() {
  const folders = which('WebKitWebDriver') ? readdirSync('/usr/lib') : [];
  const names = folders.flatMap((machine) => ['webkitgtk-6.0', 'webkit2gtk-4.1', 'webkit2gtk-4.0'].map((version) => join('/usr/lib', machine, version, 'MiniBrowser')));
  return names.find(isProgram);
}

/** A port that no program uses. */
async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  server.close();
  await once(server, 'close');
  return port;
}

/** A screen in memory: its name, once it is there. */
async function screen() {
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const ended = once(child, 'exit').then(() => Promise.reject(new Stop('Xvfb does not start.')));
  const [number] = await Promise.race([once(/** @type {import('node:stream').Readable} */ (child.stdio[3]), 'data'), ended]);
  return { child, display: `:${String(number).trim()}` };
}

/**
 * Starts WebKit with an empty profile, on a screen in memory. Scripts run in the page; the answer of the second kind is what
 * their promise resolves to.
 */
export async function startWebkit() {
  const binary = browser();
  if (!binary || !which('Xvfb')) throw new Stop(`There is no WebKit to drive. On Debian, the packages ${PACKAGES} have it.`);
  const { child: shown, display } = await screen();
  const home = mkdtempSync(join(tmpdir(), 'bubblestone-webkit-'));
  const port = await freePort();
  /** @type {NodeJS.ProcessEnv} */
  const env = { ...process.env, DISPLAY: display, HOME: home, XDG_RUNTIME_DIR: home };
  // Its sandbox does not start for the superuser, as in most containers.
  if (process.getuid?.() === 0) env['WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS'] = '1';
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], { env, stdio: 'ignore' });

  /** @param {string} method @param {string} path @param {unknown} [body] @returns {Promise<any>} */
  const ask = async (method, path, body = {}) => {
    const answer = await fetch(`http://127.0.0.1:${port}${path}`, method === 'POST' ? { method, body: JSON.stringify(body) } : { method });
    const { value } = /** @type {{ value: any }} */ (await answer.json());
    if (value?.error) throw new Error(`${path}: ${value.error}: ${value.message}`);
    return value;
  };
  const stop = () => {
    driver.kill();
    shown.kill();
    rmSync(home, { recursive: true, force: true, maxRetries: 5 });
  };
  try {
    const end = Date.now() + STARTED;
    while (!(await ask('GET', '/status').catch(() => undefined))) {
      if (Date.now() > end) throw new Stop('The driver of WebKit does not answer.');
      await setTimeout(100);
    }
    const options = { 'webkitgtk:browserOptions': { binary, args: ['--automation'] } };
    const { sessionId, capabilities } = await ask('POST', '/session', { capabilities: { alwaysMatch: options } });
    const session = `/session/${sessionId}`;
    await ask('POST', `${session}/timeouts`, { script: SCRIPT, pageLoad: SCRIPT });
    return {
      version: `${capabilities.browserName} ${capabilities.browserVersion}`,
      open: (/** @type {string} */ url) => ask('POST', `${session}/url`, { url }),
      run: (/** @type {string} */ script, /** @type {unknown[]} */ ...args) => ask('POST', `${session}/execute/sync`, { script, args }),
      promised: (/** @type {string} */ expression, /** @type {unknown[]} */ ...args) =>
        ask('POST', `${session}/execute/async`, { script: `const done = arguments[arguments.length - 1]; Promise.resolve(${expression}).then(done, (error) => done(String(error)));`, args }),
      close: async () => {
        await ask('DELETE', session).catch(() => undefined);
        stop();
      },
    };
  } catch (error) {
    stop();
    throw error;
  }
}
