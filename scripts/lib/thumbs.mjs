// The small pictures of presets, and of the words of choices, in www/public/thumbs/. The page's module draws each
// preset at its full size, and the picture is scaled down. All are made only after a change that can affect them.
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { digest } from './digest.mjs';
import { all, Canvas, moduleIn } from './headless.mjs';
import { root, say, Stop } from './run.mjs';
import { pageModule } from './wasm.mjs';

/** The folder of the pictures. */
const thumbs = join(root, 'www', 'public', 'thumbs');

/** The side in pixels. The page shows pictures half as large, so that they are sharp on screens of double density. */
const side = 144;

/** About 1.4 kB each. A higher effort than 3 takes ten times as long, and files are no smaller. */
const coding = { quality: 30, effort: 3 };

/**
 * The generators of these modules, each with the first module that has it and the preset whose picture stands for it.
 * @param {string[]} folders
 */
export async function generatorsOf(folders) {
  /** @type {{ word: string, title: string, module: number, preset: string, link: string, offers: string[] }[]} */
  const all = [];
  for (const [place, folder] of folders.entries()) {
    const { generators, presets } = await moduleIn(folder);
    for (const { word, title, offers } of generators()) {
      if (all.some((one) => one.word === word)) continue;
      const [first] = /** @type {{ name: string, link: string }[]} */ (presets(word));
      all.push({ word, title, module: place, preset: first?.name ?? '', link: first?.link ?? '', offers });
    }
  }
  return all;
}

/** Makes the pictures if they are out of date. */
export async function buildThumbs() {
  const stamp = join(root, 'www', '.thumbs-made-from');
  const source = digest(sources());
  if (existsSync(thumbs) && existsSync(stamp) && readFileSync(stamp, 'utf8') === source) return;
  say('Making the small pictures of the presets');
  for (const old of [stamp, thumbs]) rmSync(old, { recursive: true, force: true });
  mkdirSync(thumbs, { recursive: true });
  const begin = performance.now();
  const module = await moduleIn(pageModule);
  const files = await thumbsOf(module, 'pavement');
  for (const { name, bytes } of files) writeFileSync(join(thumbs, `${name}.avif`), bytes);
  const bytes = files.reduce((sum, file) => sum + file.bytes.length, 0);
  const seconds = (performance.now() - begin) / 1000;
  console.log(`${files.length} of ${(bytes / 1000 / files.length).toFixed(1)} kB each, in ${seconds.toFixed(0)} s`);
  writeFileSync(stamp, source);
}

/**
 * The pictures of the presets that a later module adds. They are kept until the program's sources change.
 * @param {string} folder of that module
 */
export async function thumbsOfMore(folder) {
  const source = digest([...filesIn('src'), ...others, join(root, 'Cargo.lock')]);
  const all = (await generatorsOf([pageModule, folder])).filter((one) => one.module > 0);
  const files = [];
  for (const { word } of all) {
    const kept = join(root, 'www', '.thumbs', word);
    const stamp = join(kept, 'made-from');
    if (!existsSync(stamp) || readFileSync(stamp, 'utf8') !== source) {
      rmSync(kept, { recursive: true, force: true });
      const module = await moduleIn(folder);
      const made = [...(await thumbsOf(module, word, '&size=192')), ...(await samplesOf(module, word))];
      mkdirSync(kept, { recursive: true });
      for (const { name, bytes } of made) writeFileSync(join(kept, `${name}.avif`), bytes);
      writeFileSync(stamp, source);
    }
    const names = readdirSync(kept).filter((name) => name.endsWith('.avif'));
    files.push(...names.map((name) => ({ name, bytes: readFileSync(join(kept, name)) })));
  }
  return files;
}

/**
 * The pictures of a generator's presets. One is encoded while the next one is drawn.
 * @param {any} module
 * @param {string} word of the generator
 * @param {string} [smaller] the end of links for a smaller picture: scenes look the same at any size
 */
async function thumbsOf({ presets, Bubblestone }, word, smaller = '') {
  const list = /** @type {{ name: string, link: string, view: string }[]} */ (presets(word));
  return Promise.all(
    list.map(({ name, link, view }) => {
      const studio = new Bubblestone(link + smaller);
      return encoded(name, view ? seen(studio, name, new URLSearchParams(view)) : picture(studio, name));
    }),
  );
}

/**
 * The pictures of the words of a generator's choices, by its rules for samples. A picture's name is
 * GENERATOR-CHOICE-WORD.
 * @param {any} module
 * @param {string} make the word of the generator
 */
async function samplesOf({ generators, schema, Bubblestone }, make) {
  const { samples, stepping } = generators().find((/** @type {{ word: string }} */ one) => one.word === make);
  const files = [];
  for (const { key, choices } of schema(make)) {
    for (const { word } of choices) {
      const rule = ruleOf(samples, key, word);
      if (!rule || rule.keys[0] !== key) continue;
      const name = `${make}-${key}-${word}`;
      const studio = new Bubblestone(`make=${make}&size=192&${rule.link}&${key}=${word}`);
      files.push(encoded(name, picture(studio, name, rule.view, rule.view && stepping), 0.72));
    }
  }
  return Promise.all(files);
}

/**
 * @param {{ keys: string[], words: string[], without: string[], link: string, view: string }[]} samples
 * @param {string} key of the choice
 * @param {string} word
 */
function ruleOf(samples, key, word) {
  return samples.find(({ keys, words, without }) => keys.includes(key) && !without.includes(word) && (!words.length || words.includes(word)));
}

/**
 * A small picture as a file.
 * @param {string} name
 * @param {import('./headless.mjs').Pixels} pixels
 * @param {number} [part] the share of the side, around the middle, that is kept
 */
async function encoded(name, { data, width, height }, part = 1) {
  // Imported here, as this file is read before the npm packages are installed.
  const { default: sharp } = await import('sharp');
  const kept = Math.round(width * part);
  const corner = Math.round((width - kept) / 2);
  const shown = sharp(data, { raw: { width, height, channels: 4 } }).removeAlpha();
  const middle = shown.extract({ left: corner, top: corner, width: kept, height: kept });
  return { name, bytes: await middle.resize(side, side, { kernel: 'lanczos3' }).avif(coding).toBuffer() };
}

const others = ['scripts/lib/thumbs.mjs', 'package-lock.json'].map((file) => join(root, file));

/** @param {string} folder */
function filesIn(folder) {
  const entries = readdirSync(join(root, folder), { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}

/**
 * Everything that the pictures of planes depend on: the planes of all presets, by their digests, which tests compare, and
 * the code that draws planes. Other changes of the module need no new pictures.
 */
function sources() {
  const folders = ['recipe', 'generators', 'material', 'heightfield'].map((name) => join('src', name));
  return [...folders.flatMap(filesIn), join(root, 'tests', 'digests.txt'), ...others];
}

/**
 * @param {any} studio that has the recipe of a preset
 * @param {string} name of the preset
 * @param {URLSearchParams} asked the words of its view: a step at which the work stops, a view, a camera, a plane that cuts
 * @returns {import('./headless.mjs').Pixels}
 */
function seen(studio, name, asked) {
  const step = Number(asked.get('step') ?? Infinity);
  studio.tick(all[0], 0);
  work(studio, name, () => studio.stage() === 'done' || studio.status().steps >= step, step < Infinity ? 1 : all[1]);
  const width = studio.side();
  const cut = asked.get('cut');
  const how = ['fine', 'floor', asked.get('view') ?? 'auto', ...(cut ? [`whole=${cut}`] : [])].join('+');
  for (;;) {
    const { pixels, done } = studio.turn('', asked.get('camera') ?? '', width, width, how, all[0]);
    if (!done) continue;
    studio.free();
    return { data: new Uint8ClampedArray(pixels), width, height: width };
  }
}

/**
 * Works on a recipe until `isEnough` returns true.
 * @param {any} studio
 * @param {string} name of the preset or sample
 * @param {() => boolean} isEnough
 * @param {number} steps at a time
 */
function work(studio, name, isEnough, steps) {
  while (!isEnough()) {
    if (studio.stage() === 'error') throw new Stop(`The recipe of ${name} gives no picture: ${studio.problem()?.text}`);
    studio.tick(all[0], steps);
  }
}

/**
 * @param {any} studio that has the recipe of a preset or a sample
 * @param {string} name of the preset or sample
 * @param {string} [view]
 * @param {string} [until] a stage before which the work may end
 * @returns {import('./headless.mjs').Pixels} its finished picture
 */
function picture(studio, name, view = '', until = '') {
  work(studio, name, () => ['done', until].includes(studio.stage()), until ? 0 : all[1]);
  const canvas = new Canvas();
  studio.draw(canvas, view || 'picture');
  studio.free();
  return canvas.pixels;
}
