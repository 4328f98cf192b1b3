// The golden digests that the native tests write, for tests of the WebAssembly modules.
import { readFileSync } from 'node:fs';

/** @param {string} name @returns {string[]} its lines */
const lines = (name) => readFileSync(new URL(`../${name}`, import.meta.url), 'utf8').trim().split('\n');

/** Each preset of pavements with its digest. */
export const digests = lines('digests.txt').map((line) => /** @type {[name: string, digest: string]} */ (line.split(' ')));

/** Digests of surfaces with their links. */
export const surfaces = lines('surfaces.txt').map((line) => /** @type {[digest: string, link: string]} */ (line.split(' ')));

/** Digests of piles with their links. */
export const piles = lines('piles.txt').map((line) => /** @type {[digest: string, link: string]} */ (line.split(' ')));
export const masonry = lines('masonry.txt').map((line) => /** @type {[digest: string, link: string]} */ (line.split(' ')));

/** Hashes of frames, each with its camera (empty for the usual one) and its link. */
export const frames = lines('frames.txt').map((line) => {
  const [hash = '', camera = '', link = ''] = line.split(' ');
  return { hash, camera: camera === '-' ? '' : camera, link };
});

/**
 * The names of a few presets, for places where all would take too long. Together they use every choice of words that
 * some preset uses, except colours, patterns and outlines, or as many of these as `count` presets can.
 * @param {{ name: string, link: string }[]} presets
 * @param {number} [count]
 * @returns {Set<string>} their names
 */
export function varied(presets, count = 10) {
  const chosen = new Set();
  const left = new Set(presets.flatMap(({ link }) => choicesOf(link)));
  while (chosen.size < count && left.size) {
    const gain = (/** @type {{ link: string }} */ { link }) => choicesOf(link).filter((choice) => left.has(choice)).length;
    const best = presets.reduce((a, b) => (gain(b) > gain(a) ? b : a));
    chosen.add(best.name);
    for (const choice of choicesOf(best.link)) left.delete(choice);
  }
  return chosen;
}

/** The choices of a link, as `kind=circle`. @param {string} link */
const choicesOf = (link) => link.split('&').filter((part) => /^(?!palette|ground|outline|pattern)\w+=[a-z]\w*$|^tile=1$/.test(part));
