// The film of the forming: browsers make it, play it, and share it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createFile } from 'mp4box';
import { sameEverywhere } from './browsers.mjs';
import { low, open } from './harness.mjs';
import { click, digest, message, phone, SMALL } from './page.mjs';
import { handed, keeping } from './saved.mjs';
import { turned } from './turned.mjs';

/** @type {Awaited<ReturnType<typeof open>>} */
let site;

before(async () => {
  site = await open();
});

after(() => site?.close());

/** The picture's place in a frame of the film: x, y, side. */
const SQUARE = [0, 0, 1080];
const UPRIGHT = [28, 356, 1024];

/**
 * A page that keeps the files it saves.
 * @param {string} fragment
 * @param {{ shares?: boolean, films?: boolean, viewport?: import('puppeteer-core').Viewport }} [options]
 */
const opened = (fragment, { shares = false, films = true, viewport } = {}) =>
  site.newPage(fragment, { ...(viewport && { viewport }), before: (fresh) => fresh.evaluateOnNewDocument(keeping).then(() => fresh.evaluateOnNewDocument(able, shares, films)) });

/**
 * Runs in the page: gives it the system's sharing, which keeps the files, or takes films away.
 * @param {boolean} shares
 * @param {boolean} films
 */
function able(shares, films) {
  navigator.canShare = ({ files = [] }) => shares && files.every(({ type }) => /^(image|video)\//.test(type));
  if (shares) navigator.share = async (data) => (window.shared = data);
  if (!films) delete window.VideoEncoder;
}

/** The bytes of a file in the page. @param {import('puppeteer-core').Page} page @param {string} where such as `saved.blob` */
async function bytesOf(page, where) {
  const text = await page.evaluate(async (path) => {
    const reader = new FileReader();
    const blob = path.split('.').reduce((whole, part) => whole[part], window);
    await new Promise((resolve) => {
      reader.onload = resolve;
      reader.readAsDataURL(blob);
    });
    return reader.result;
  }, where);
  const { type, data = '' } = /^data:(?<type>[^;]*);base64,(?<data>.*)$/.exec(text)?.groups ?? {};
  return { type, bytes: Buffer.from(data, 'base64') };
}

/** Plays a film in another page. Returns its length, its size, and coarse pictures of its first and last frame. */
async function played(page, { type, bytes }, box) {
  const player = await page.browserContext().newPage();
  await player.bringToFront();
  await player.evaluate(meaning);
  const found = await player.evaluate(playing, `data:${type};base64,${bytes.toString('base64')}`, box);
  await player.close();
  return found;
}

/** Runs in a page: defines the mean colours of 24 by 24 parts of a picture. */
function meaning() {
  window.coarse = (picture, x, y, side) => {
    const context = new OffscreenCanvas(side, side).getContext('2d');
    context.drawImage(picture, x, y, side, side, 0, 0, side, side);
    const { data } = context.getImageData(0, 0, side, side);
    const [sums, counts] = [new Array(24 * 24 * 3).fill(0), new Array(24 * 24 * 3).fill(0)];
    for (let k = 0; k < data.length; k += 1) {
      const [channel, pixel] = [k % 4, Math.floor(k / 4)];
      const part = Math.floor((24 * Math.floor(pixel / side)) / side) * 24 + Math.floor((24 * (pixel % side)) / side);
      if (channel === 3) continue;
      sums[3 * part + channel] += data[k];
      counts[3 * part + channel] += 1;
    }
    return sums.map((sum, k) => sum / counts[k]);
  };
}

/** Runs in a page: plays a film. */
async function playing(url, [x, y, side]) {
  const video = document.createElement('video');
  video.muted = true;
  video.src = url;
  await new Promise((resolve, reject) => {
    video.onloadeddata = resolve;
    video.onerror = () => reject(new Error(video.error.message));
  });
  const coarse = [];
  for (const time of [0, video.duration - 0.01]) {
    const seeked = new Promise((resolve) => (video.onseeked = resolve));
    video.currentTime = time;
    await seeked;
    // A decoded frame may reach the page after its event. Until then all pixels are black.
    let seen = [0];
    while (!seen.some((value) => value > 0)) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      seen = window.coarse(video, x, y, side);
    }
    coarse.push(seen);
  }
  return { length: video.duration, size: [video.videoWidth, video.videoHeight], coarse };
}

/** The coarse picture of the file that is saved at four times the side. Films are made from such a picture. */
async function coarsePicture(page) {
  await page.$eval('#save', (key) => key.click());
  await page.waitForSelector('#save-png-4');
  await handed(page, () => page.$eval('#save-png-4', (key) => key.click()));
  await page.evaluate(meaning);
  return page.evaluate(async () => {
    const picture = await createImageBitmap(window.saved.blob);
    window.saved = undefined;
    return window.coarse(picture, 0, 0, picture.width);
  });
}

/** The mean difference per channel, with its sign. */
function off(one, other) {
  return [0, 1, 2].map((channel) => {
    const here = (list) => list.filter((_, k) => k % 3 === channel);
    const [a, b] = [here(one), here(other)];
    return a.reduce((sum, value, k) => sum + value - b[k], 0) / a.length;
  });
}

/** The mean of the absolute differences. */
const apart = (one, other) => one.reduce((sum, value, k) => sum + Math.abs(value - other[k]), 0) / one.length;

function assertSame(picture, frames) {
  for (const [which, frame] of frames.entries()) {
    const [mean, channels] = [apart(picture, frame), off(picture, frame)];
    assert.ok(mean < 3 && channels.every((value) => Math.abs(value) < 2), `${which ? 'the last' : 'the first'} frame is ${mean} off, by channels ${channels}`);
  }
}

/**
 * Facts about an MP4 file, read by another library: its codec, and the durations and the number of its frames. @param
 * {Buffer} bytes
 */
function readMp4(bytes) {
  const file = createFile();
  const buffer = Object.assign(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), { fileStart: 0 });
  let info;
  file.onReady = (found) => (info = found);
  file.appendBuffer(buffer);
  file.flush();
  const [track] = info.videoTracks;
  const samples = file.getTrackSamplesInfo(track.id);
  return { codec: track.codec, brand: info.brands[0], starts: info.isProgressive, longest: Math.max(...samples.map(({ duration }) => duration / track.timescale)), count: samples.length, first: samples[0].is_sync };
}

test('a film of the forming loops from the finished picture to the finished picture', async () => {
  const { page, problems, external, close } = await opened(`${SMALL}&palette=terracotta`);
  const planes = await digest(page);
  const picture = await coarsePicture(page);
  await click(page, '#save');
  await page.waitForSelector('#save-film:enabled');
  const word = await page.$eval('#save-film', (key) => key.textContent);
  await handed(page, () => click(page, '#save-film'));
  const { name } = await page.evaluate(() => window.saved);
  const film = await bytesOf(page, 'saved.blob');
  assert.equal(name, `bubblestone-ring-1-square.${word.toLowerCase()}`);
  assert.equal(film.type, `video/${word.toLowerCase()}`);
  assert.equal(await digest(page), planes);
  const { length, size, coarse } = await played(page, film, SQUARE);
  assert.ok(length > 5 && length < 9, `${length} s`);
  assert.deepEqual(size, [1080, 1080]);
  assertSame(picture, coarse);
  if (word === 'MP4') {
    const { codec, starts, longest, count, first } = readMp4(film.bytes);
    assert.match(codec, /^avc1\./);
    assert.ok(starts, 'it has to be loaded to its end before it plays');
    assert.ok(first && Math.abs(longest - 1 / 30) < 1e-3 && Math.abs(count / 30 - length) < 0.1, `${count} frames of ${longest} s`);
  }
  assert.deepEqual([problems, external], [[], []]);
  await close();
});

test('a film of the turntable goes round once, and loops', sameEverywhere, async () => {
  // The film is saved as an animation, which has a third of the frames.
  const { page, problems, close } = await opened('#size=128&cs=26&camera=20,50', { films: false, viewport: low });
  await digest(page);
  await turned(page);
  await click(page, '#save');
  await page.waitForSelector('#save-turn-film:enabled');
  await handed(page, () => click(page, '#save-turn-film'));
  assert.equal(await page.evaluate(() => window.saved.name), 'bubblestone-ring-1-turn.gif');
  await page.evaluate(meaning);
  const { count, loops, size, coarse } = await page.evaluate(async () => {
    const decoder = new ImageDecoder({ data: await window.saved.blob.arrayBuffer(), type: 'image/gif' });
    await Promise.all([decoder.tracks.ready, decoder.completed]);
    const { frameCount, repetitionCount } = decoder.tracks.selectedTrack;
    const found = { count: frameCount, loops: repetitionCount === Infinity, size: [0, 0], coarse: [] };
    for (const frameIndex of [0, frameCount / 2, frameCount - 1]) {
      const { image } = await decoder.decode({ frameIndex });
      found.size = [image.displayWidth, image.displayHeight];
      found.coarse.push(window.coarse(image, 0, 0, image.displayWidth));
    }
    return found;
  });
  assert.deepEqual([count, loops, size], [60, true, [360, 360]]);
  const [first, half, last] = coarse;
  // The step from the last frame to the first is like all others.
  assert.ok(apart(first, last) < apart(first, half) / 3, `the last frame is ${apart(first, last)} off the first one, that half round ${apart(first, half)}`);
  assert.deepEqual(problems, []);
  await close();
});

test('phones share the picture alone, and a film that is made first, or stopped', sameEverywhere, async () => {
  const { page, problems, close } = await opened(SMALL, { shares: true, viewport: phone });
  await digest(page);
  const picture = await coarsePicture(page);
  const shared = async (act) => {
    await handed(page, act, 'shared');
    return page.evaluate(() => Object.entries(window.shared).map(([key, value]) => [key, key === 'files' ? value.map(({ name, type }) => [name, type]) : value]));
  };
  const share = async (button) => {
    await page.tap('#share');
    await page.waitForSelector(button);
    await page.$eval(button, (key) => key.scrollIntoView({ block: 'center' }));
    await page.tap(button);
  };
  assert.deepEqual(await shared(() => share('#share-picture')), [['files', [['bubblestone-ring-1-192.png', 'image/png']]]]);
  await page.$eval('#share-dialog [data-close]', (close) => close.click());
  await share('#share-upright');
  await page.waitForSelector('#stop-files');
  await page.$eval('#stop-files', (stop) => stop.click());
  await message(page, 'status', /was stopped/);
  while (page.workers().length) await new Promise((ended) => page.once('workerdestroyed', ended));
  await handed(page, () => share('#share-upright'), '#share-film');
  const [[, [[name, type]]]] = await shared(() => page.tap('#share-film'));
  assert.match(`${name} ${type}`, /^bubblestone-ring-1-upright\.(mp4|webm) video\/\1$/);
  assert.equal(await page.evaluate(() => window.saved), undefined);
  await page.tap('#keep-film');
  assert.equal(await page.evaluate(() => window.saved.name), name);
  const { size, coarse } = await played(page, await bytesOf(page, 'saved.blob'), UPRIGHT);
  assert.deepEqual(size, [1080, 1920]);
  assertSame(picture, coarse);
  assert.deepEqual(problems, []);
  await close();
});

test('where no film can be made, the dialogs tell so, and the animation stays', async () => {
  const { page, problems, close } = await opened(SMALL, { shares: true, films: false });
  await digest(page);
  await click(page, '#save');
  await page.waitForSelector('#save-film[hidden]');
  assert.equal(await page.$eval('#shape', (shape) => shape.checkVisibility()), false);
  assert.match(await page.$eval('section:has(#save-gif) .take-note', (note) => note.textContent), /this browser makes no films/);
  assert.ok(await page.$eval('#save-gif', (key) => key.checkVisibility()));
  await page.$eval('#save-dialog [data-close]', (key) => key.click());
  await click(page, '#share');
  await page.waitForSelector('#share-picture');
  assert.equal(await page.$('#share-square'), null);
  assert.deepEqual(problems, []);
  await close();
});
