// The code of the chapters' figures in one file, and the golden list of their numbers.
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const list = new URL('../learn.txt', import.meta.url);
const linkList = new URL('../learn-links.txt', import.meta.url);
const entry = fileURLToPath(new URL('figures-entry.mjs', import.meta.url));

/** The code of the figures, of their stops and their readings, as the page has it, in one file. @returns {Promise<string>} */
export async function figuresText() {
  const own = { write: false, ssr: true, target: 'es2022', rolldownOptions: { input: entry, output: /** @type {const} */ ({ format: 'es' }) } };
  const { output } = /** @type {any} */ (await build({ configFile: false, publicDir: false, logLevel: 'warn', build: own }));
  return output[0].code;
}

/** That code, loaded in Node. */
export const figuresCode = async () => import(`data:text/javascript;base64,${Buffer.from(await figuresText()).toString('base64')}`);

/** @param {URL} file */
const linesOf = (file) => readFileSync(file, 'utf8').trim().split('\n');

/** The golden lines. */
export const golden = () => linesOf(list);

/** The golden links. */
export const goldenLinks = () => linesOf(linkList);

/** @param {string[]} lines @param {string[]} links */
export function writeGolden(lines, links) {
  writeFileSync(list, `${lines.join('\n')}\n`);
  writeFileSync(linkList, `${links.join('\n')}\n`);
}

/** The stops of each figure with the hashes of their states. */
export function goldenStops() {
  return golden().map((line) => {
    const [figure = '', stop = '', step = '', ...rest] = line.split(' ');
    return { figure, stop, step, hash: rest.filter((word) => /^[0-9a-f]{16}$/.test(word)).join(' ') };
  });
}
