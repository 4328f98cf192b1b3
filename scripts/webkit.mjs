// `npm run webkit`: compares the planes, bodies and frames of some recipes in WebKit with those that are made natively;
// `npm run webkit -- all`: of all recipes with golden digests. It needs a site in dist/ and packages of Debian
// (scripts/lib/webkit.mjs).
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { digests, frames, masonry, piles, surfaces, varied } from '../tests/common/golden.mjs';
import { host } from './lib/host.mjs';
import { root, start, Stop } from './lib/run.mjs';
import { startWebkit } from './lib/webkit.mjs';

/** The distance in the lists of bodies from one compared recipe to the next. */
const EVERY = process.argv[2] === 'all' ? 1 : 6;

/** Resolves in the page when it has its functions for scripts; the driver limits how long that may take. */
const BEGUN = 'new Promise((done) => { const look = () => ("bubblestone" in window ? done("") : setTimeout(look, 100)); look(); })';

await start(async () => {
  const dist = join(root, 'dist');
  if (!existsSync(join(dist, 'index.html'))) throw new Stop('There is no site in dist/: `npm run build` makes one.');
  const webkit = await startWebkit();
  const server = await host(dist);
  try {
    console.log(webkit.version);
    const wrong = await compared(webkit, server.address);
    if (wrong.length) throw new Stop(`WebKit differs:\n${wrong.join('\n')}`);
    console.log('All are the same in WebKit.');
  } finally {
    server.stop();
    await webkit.close();
  }
});

/**
 * The recipes that differ, each in a line.
 * @param {Awaited<ReturnType<typeof startWebkit>>} webkit
 * @param {string} address
 */
async function compared(webkit, address) {
  const open = async (/** @type {string} */ link) => {
    // A change of the fragment alone would not load the page.
    await webkit.open('about:blank');
    await webkit.open(`${address}#${link}`);
    await webkit.promised(BEGUN);
  };
  /**
   * The text that an expression promises on the page of a link. The driver loses an answer now and then, so there are two tries.
   * @param {string} link @param {string} expression @param {unknown[]} args @returns {Promise<string>}
   */
  const answer = async (link, expression, ...args) => {
    let text = '';
    for (let k = 0; k < 2; k += 1) {
      try {
        await open(link);
        return String(await webkit.promised(expression, ...args));
      } catch (error) {
        text = `no answer (${error instanceof Error ? error.message : error})`;
      }
    }
    return text;
  };
  /** @type {string[]} */
  const wrong = [];
  const check = (/** @type {string} */ what, /** @type {string} */ found, /** @type {string} */ wanted) => {
    console.log(`${found === wanted ? 'same' : 'OTHER'}  ${what}`);
    if (found !== wanted) wrong.push(`${what}: ${found}, not ${wanted}`);
  };
  await open('size=192&cs=16');
  /** @type {{ name: string, link: string }[]} */
  const presets = await webkit.run('return bubblestone.presets.map(({ name, link }) => ({ name, link }))');
  const chosen = EVERY > 1 ? varied(presets) : new Set(presets.map(({ name }) => name));
  for (const [name, digest] of digests.filter(([name]) => chosen.has(name))) {
    check(name, await answer(presets.find((preset) => preset.name === name)?.link ?? '', 'bubblestone.digest()'), digest);
  }
  for (const [digest, link] of [surfaces, piles, masonry].flatMap((list) => list.filter((_, k) => k % EVERY === 0))) {
    check(link, await answer(link, 'bubblestone.digest()'), digest);
  }
  for (const { hash, camera, link } of frames) {
    check(`a frame of ${link}`, await answer(link, 'bubblestone.digest().then(() => bubblestone.frame(arguments[0]))', camera), hash);
  }
  return wrong;
}
