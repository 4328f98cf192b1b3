// three.js for comparison: the same bodies in the same light, drawn by a browser without a graphics card.
import { fileURLToPath } from 'node:url';
import { browsers, findBrowser } from '../scripts/lib/browser.mjs';
import { host } from '../scripts/lib/host.mjs';

/** @typedef {{ name: string, ms: number }} Timing */
/**
 * @typedef {object} Hide
 * @property {Float32Array} positions
 * @property {Float32Array} normals
 * @property {Uint8Array} colours
 * @property {Uint32Array} triangles
 * @property {number} width
 * @property {number} height
 * @property {Float32Array} eye
 * @property {Float32Array} target
 * @property {number} lens degrees from the top of the frame to the bottom
 * @property {Float32Array} lamp the unit vector to it
 * @property {Float32Array} middle of the ball around all bodies
 * @property {number} radius
 */

/** Texels along a side of the shadow map, as in ours. */
const TEXELS = 2048;

const flags = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

/** @param {Hide} hide @returns {Promise<Timing[]>} */
export async function threeFrames(hide) {
  const executablePath = findBrowser('chromium');
  if (!executablePath) {
    console.log(`There is no ${browsers.chromium.title}: three.js is not measured beside our frames.`);
    return [];
  }
  const { default: puppeteer } = await import('puppeteer-core');
  const site = await host(fileURLToPath(new URL('../node_modules/three/build/', import.meta.url)));
  const browser = await puppeteer.launch({ browser: 'chrome', executablePath, args: flags, protocolTimeout: 600_000 });
  try {
    const page = await browser.newPage();
    // Any file of the host will do, because it gives the page the host's origin.
    await page.goto(`${site.address}three.module.js`);
    const list = (/** @type {ArrayBufferView<ArrayBuffer>} */ { buffer, byteOffset, byteLength }) =>
      Buffer.from(buffer, byteOffset, byteLength).toString('base64');
    const [still, turning] = await page.evaluate(drawn, {
      ...hide,
      positions: list(/** @type {any} */ (hide.positions)),
      normals: list(/** @type {any} */ (hide.normals)),
      colours: list(/** @type {any} */ (hide.colours)),
      triangles: list(/** @type {any} */ (hide.triangles)),
      eye: [...hide.eye],
      target: [...hide.target],
      lamp: [...hide.lamp],
      middle: [...hide.middle],
      texels: TEXELS,
    });
    return [
      { name: 'three.js in Chromium without a graphics card, a frame with its shadows', ms: still },
      { name: 'three.js in Chromium without a graphics card, a frame', ms: turning },
    ];
  } finally {
    await browser.close();
    site.stop();
  }
}

/**
 * Runs in the page: measures the milliseconds of a frame with new shadows, and of one without.
 * @param {any} hide
 */
async function drawn({ width, height, positions, normals, colours, triangles, eye, target, lens, lamp, middle, radius, texels }) {
  const file = './three.module.js';
  const three = await import(file);
  const bytes = (/** @type {string} */ text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const floats = (/** @type {string} */ text) => new Float32Array(bytes(text).buffer);
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(floats(positions), 3));
  geometry.setAttribute('normal', new three.BufferAttribute(floats(normals), 3));
  geometry.setAttribute('color', new three.BufferAttribute(bytes(colours), 3, true));
  geometry.setIndex(new three.BufferAttribute(new Uint32Array(bytes(triangles).buffer), 1));
  const body = new three.Mesh(geometry, new three.MeshPhongMaterial({ vertexColors: true }));
  body.castShadow = body.receiveShadow = true;
  const light = new three.DirectionalLight(0xffffff, 3);
  const [centre, to] = [middle, lamp].map((v) => new three.Vector3(...v));
  light.position.copy(centre).addScaledVector(to, 2 * radius);
  light.target.position.copy(centre);
  light.castShadow = true;
  light.shadow.mapSize.set(texels, texels);
  light.shadow.bias = -0.002;
  Object.assign(light.shadow.camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: radius / 2, far: 4 * radius });
  const scene = new three.Scene();
  scene.background = new three.Color(0, 0, 1);
  scene.add(body, light, light.target, new three.AmbientLight(0xffffff, 0.6));
  const camera = new three.PerspectiveCamera(lens, width / height, 0.05, 20);
  camera.position.set(...eye);
  camera.lookAt(...target);
  const renderer = new three.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
  renderer.setSize(width, height);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  document.body.replaceChildren(renderer.domElement);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  const frame = (/** @type {boolean} */ hasShadows) => {
    const start = performance.now();
    renderer.shadowMap.needsUpdate = hasShadows;
    renderer.render(scene, camera);
    // Waits until the picture is drawn.
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return performance.now() - start;
  };
  const least = (/** @type {boolean} */ hasShadows) => Math.min(...Array.from({ length: 8 }, () => frame(hasShadows)));
  // The first frames include compiling and uploading.
  for (let k = 0; k < 3; k += 1) frame(true);
  const times = [least(true), least(false)];
  let bodies = 0;
  for (let k = 0; k < pixels.length; k += 4) bodies += Number(pixels[k] > 8);
  if (bodies < (2 / 3) * width * height || renderer.info.render.triangles !== geometry.index.count / 3) {
    throw new Error(`three.js drew ${renderer.info.render.triangles} triangles on ${bodies} pixels: not the bodies that were asked for.`);
  }
  return times;
}
