// The frames of the forming's film, before they are encoded. `npm test -- 'wasm build' 'modules as sent'`.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import { build } from 'vite';
import { all, moduleIn } from '../../scripts/lib/headless.mjs';
import { pageModule } from '../../scripts/lib/wasm.mjs';

/** @type {any} */
let module;
/** @type {any} */
let frames;

/** A canvas that remembers the names of what was drawn on it. */
class Canvas {
  name = '';

  getContext() {
    return { canvas: this, putImageData: (/** @type {ImageData} */ { data }) => (this.name = createHash('md5').update(data).digest('hex')) };
  }
}

before(async () => {
  Object.assign(globalThis, { OffscreenCanvas: Canvas });
  module = await moduleIn(pageModule);
  frames = await moduleOf('../../www/take/files/frames.ts');
});

/** Loads a file of the page with its imports. @param {string} path beside this file */
async function moduleOf(path) {
  const entry = fileURLToPath(new URL(path, import.meta.url));
  const built = await build({ configFile: false, logLevel: 'error', build: { write: false, minify: false, lib: { entry, formats: ['es'] } } });
  const [{ output }] = /** @type {any} */ (built);
  return import(`data:text/javascript,${encodeURIComponent(output[0].code)}`);
}

/** All frames of a film, each with its content and duration. @param {string} link */
async function film(link) {
  const studio = new module.Bubblestone(link);
  while (studio.stage() !== 'done') studio.tick(...all);
  const status = studio.status();
  const finished = Object.assign(new Canvas(), { name: 'finished' });
  /** @type {[string, string, number, number][]} */
  const shown = [];
  const look = { side: studio.side(), draw: (/** @type {any} */ context) => studio.draw(context, 'auto') };
  await frames.showForming(studio, { placing: 'planes' }, look, finished, status, (/** @type {Canvas} */ one, other = one, share = 0, times = 1) => shown.push([one.name, other.name, share, times]));
  return { shown, steps: status.steps, planned: frames.framesOf(status.steps) };
}

for (const link of ['size=192&cs=16', 'size=192&cs=9&vs=0.4&stone=skin', 'size=128&cs=40', 'size=192&cs=16&cells=voronoi', 'size=192&cs=16&tile=1']) {
  test(`a film of ${link} has the same frames every time, from the finished picture to the finished picture`, async () => {
    const { shown, steps, planned } = await film(link);
    assert.deepEqual((await film(link)).shown, shown);
    const count = shown.reduce((sum, [, , , times]) => sum + times, 0);
    assert.equal(count, planned);
    assert.ok(count >= 150 && count <= 260, `${count} frames of ${steps} steps`);
    const [first, last] = [shown[0], shown.at(-1)];
    assert.deepEqual([first?.[0], last?.[0]], ['finished', 'finished']);
    assert.ok((last?.[3] ?? 0) >= 60, 'the end is not held');
    assert.ok(shown.every(([, , share]) => share >= 0 && share <= 1));
    const ways = new Set(shown.map(String));
    assert.ok(ways.size > 60 + Math.min(steps, 20), `${ways.size} different frames of ${steps} steps`);
  });
}
