// The frames of the film of the forming, before they are encoded, and their order in the file. `npm test --
// 'wasm build' 'modules as sent'`.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import { createFile } from 'mp4box';
import { build } from 'vite';
import { all, moduleIn } from '../../scripts/lib/headless.mjs';
import { pageModule, wholeModule } from '../../scripts/lib/wasm.mjs';

/** @type {any} */
let module;
/** @type {any} */
let frames;

/** A canvas that records the hashes of the pictures drawn on it. */
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

/** The course of the generator at work. @param {any} module @param {any} studio */
const courseOf = (module, studio) => module.generators().find((/** @type {{ word: string }} */ { word }) => word === studio.generator());

/** All frames of a film, each with its content and duration. @param {string} link */
async function film(link) {
  const studio = new module.Bubblestone(link);
  while (studio.stage() !== 'done') studio.tick(...all);
  const status = studio.status();
  const finished = Object.assign(new Canvas(), { name: 'finished' });
  /** @type {[string, string, number, number][]} */
  const shown = [];
  const look = { side: studio.side(), draw: (/** @type {any} */ context) => studio.draw(context, 'auto') };
  await frames.showForming(studio, courseOf(module, studio), look, finished, status, (/** @type {Canvas} */ one, other = one, share = 0, times = 1) => shown.push([one.name, other.name, share, times]));
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

for (const link of ['v=1&make=pile&size=128&c1=pebble&ps=5', 'v=1&make=masonry&building=sheet&size=128']) {
  test(`a film of ${link} shows its bodies one after the other`, async () => {
    const whole = await moduleIn(wholeModule, undefined, 'space');
    const studio = new whole.Bubblestone(link);
    while (studio.stage() !== 'done') studio.tick(...all);
    const [status, course] = [studio.status(), courseOf(whole, studio)];
    const finished = Object.assign(new Canvas(), { name: 'finished' });
    /** @type {number[]} */
    const placed = [];
    /** @type {Set<string>} */
    const stages = new Set();
    // A frame's content is the number of bodies so far.
    const draw = (/** @type {any} */ context) => {
      stages.add(studio.stage());
      context.canvas.name = String(studio.status().steps);
    };
    const look = { side: studio.side(), draw };
    let count = 0;
    await frames.showForming(studio, course, look, finished, status, (/** @type {Canvas} */ _, /** @type {Canvas} */ other = _, share = 0, times = 1) => {
      count += times;
      assert.ok(share >= 0 && share <= 1, `a share of ${share}`);
      if (other.name !== 'finished') placed.push(Number(other.name));
    });
    studio.free();
    // Between these stages, views show no bodies.
    assert.deepEqual([...stages], [course.stepping, 'light']);
    assert.equal(count, frames.framesOf(status.steps));
    assert.ok(count >= 150 && count <= 260, `${count} frames`);
    assert.deepEqual(placed, placed.toSorted((a, b) => a - b));
    assert.ok(new Set(placed).size > 30, `${new Set(placed).size} states of ${status.steps} steps`);
    assert.ok((placed[0] ?? status.steps) < 0.1 * status.steps, `the first of ${status.steps} steps is ${placed[0]}`);
  });
}

/**
 * An encoder like those of some browsers: it delivers frames in the order of decoding. Each third frame comes before
 * the two that precede it.
 */
class Encoder extends EventTarget {
  encodeQueueSize = 0;
  /** @type {{ timestamp: number, duration: number, type: string }[]} */
  waiting = [];

  constructor(/** @type {{ output: (chunk: Chunk, meta: object) => void }} */ { output }) {
    super();
    this.output = output;
  }

  configure() {}

  close() {}

  encode(/** @type {Frame} */ { timestamp, duration }, /** @type {{ keyFrame: boolean }} */ { keyFrame }) {
    this.waiting.push({ timestamp, duration, type: keyFrame ? 'key' : 'delta' });
    if (keyFrame || this.waiting.length === 3) void this.flush();
  }

  async flush() {
    const shown = this.waiting.splice(0);
    const decoded = [...shown.splice(-1), ...shown];
    const description = Uint8Array.of(1, 0x64, 0, 0x28, 0xff, 0xe1, 0, 4, 0x67, 0x64, 0, 0x28, 1, 0, 4, 0x68, 0xee, 0x3c, 0x80);
    for (const frame of decoded) this.output(new Chunk(frame), { decoderConfig: { codec: 'avc1.640028', codedWidth: 720, codedHeight: 720, description } });
  }
}

class Frame {
  constructor(/** @type {unknown} */ _, /** @type {{ timestamp: number, duration: number }} */ { timestamp, duration }) {
    Object.assign(this, { timestamp, duration });
  }

  close() {}
}

class Chunk {
  byteLength = 6;

  constructor(/** @type {object} */ frame) {
    Object.assign(this, frame);
  }

  copyTo(/** @type {Uint8Array} */ bytes) {
    bytes.set([0, 0, 0, 2, this.type === 'key' ? 0x65 : 0x41, 0]);
  }
}

test('frames that come in the order in which they are decoded are in the file, each at its time', async () => {
  Object.assign(globalThis, { VideoEncoder: Encoder, VideoFrame: Frame, EncodedVideoChunk: Chunk });
  const { FilmEncoder } = await moduleOf('../../www/take/files/encoder.ts');
  const encoder = await FilmEncoder.of({ file: 'mp4', codec: 'avc1.640028', track: 'avc', matrix: 'bt709' }, 'turn');
  await encoder.add(new Uint8ClampedArray(4 * 720 * 720), 100);
  const bytes = await (await encoder.finish()).arrayBuffer();
  const file = createFile();
  /** @type {any} */
  let info;
  file.onReady = (found) => (info = found);
  file.appendBuffer(Object.assign(bytes, { fileStart: 0 }));
  file.flush();
  const [{ id, timescale }] = info.videoTracks;
  const samples = file.getTrackSamplesInfo(id);
  const order = samples.map(({ cts }) => Math.round((30 * cts) / timescale));
  assert.deepEqual(order.slice(0, 7), [0, 3, 1, 2, 6, 4, 5]);
  assert.deepEqual(order.toSorted((a, b) => a - b), Array.from({ length: 100 }, (_, k) => k));
  assert.ok(samples.every(({ dts }, k) => k === 0 || dts > (samples[k - 1]?.dts ?? 0)), 'frames are not decoded one after another');
  assert.ok(info.isProgressive, 'it has to be loaded to its end before it plays');
});
