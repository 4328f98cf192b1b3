// Other programs, measured for comparison: npm packages that do a part of the same work in JavaScript.
import { performance } from 'node:perf_hooks';

/** @typedef {{ name: string, ms: number }} Timing */

/** Rounds of Lloyd's relaxation: about as many as the cells need to look even. */
const ROUNDS = 50;
const SIDE = 512;

/**
 * Lloyd's relaxation of random points in a square with d3-delaunay.
 * @param {number} count
 */
export const d3Delaunay = (count) =>
  d3(count, `${ROUNDS} rounds of Lloyd's relaxation, ${count} points`, (points, voronoi) => {
    for (let round = 0; round < ROUNDS; round++) {
      const cells = voronoi(points);
      for (let i = 0; i < count; i++) moveToCentroid(points, i, cells.cellPolygon(i));
    }
  });

/**
 * The Voronoi polygons of random points in a square with d3-delaunay.
 * @param {number} count
 */
export const d3Polygons = (count) =>
  d3(count, `polygons of ${count} points`, (points, voronoi) => {
    const cells = voronoi(points);
    for (let i = 0; i < count; i++) cells.cellPolygon(i);
  });

/**
 * Times work on random points in a square with d3-delaunay, if it is installed.
 * @param {number} count @param {string} name
 * @param {(points: Float64Array, voronoi: (points: Float64Array) => any) => void} work
 * @returns {Promise<Timing | undefined>}
 */
async function d3(count, name, work) {
  const found = await installed('d3-delaunay');
  if (!found) return undefined;
  const ms = shortest(7, () => {
    const random = randomNumbers();
    const points = Float64Array.from({ length: 2 * count }, () => SIDE * random());
    return () => work(points, (places) => new found.Delaunay(places).voronoi([0, 0, SIDE, SIDE]));
  });
  return { name: `d3-delaunay, ${name}`, ms };
}

/** @param {Float64Array} points @param {number} i @param {[number, number][] | null} ring closed */
function moveToCentroid(points, i, ring) {
  if (!ring) return;
  let [x, y, area] = [0, 0, 0];
  for (let k = 0; k + 1 < ring.length; k++) {
    const [a, b] = [ring[k], ring[k + 1]];
    const cross = a[0] * b[1] - b[0] * a[1];
    x += (a[0] + b[0]) * cross;
    y += (a[1] + b[1]) * cross;
    area += 3 * cross;
  }
  if (area === 0) return;
  points[2 * i] = x / area;
  points[2 * i + 1] = y / area;
}

/**
 * One step of matter-js, with squares that just fit into a box and begin slightly displaced.
 * @param {number} count
 * @returns {Promise<Timing | undefined>}
 */
export async function matterJs(count) {
  const steps = 60;
  const found = await installed('matter-js');
  if (!found) return undefined;
  const { Bodies, Body, Composite, Engine } = found.default;
  const size = 20;
  const columns = Math.ceil(Math.sqrt(count));
  const side = columns * size;
  const ms = shortest(3, () => {
    const random = randomNumbers();
    const engine = Engine.create({ gravity: { x: 0, y: 0 } });
    const squares = Array.from({ length: count }, (_, k) => {
      const place = (/** @type {number} */ index) => size * (index + 0.5 + 0.2 * (random() - 0.5));
      const square = Bodies.rectangle(place(k % columns), place(Math.floor(k / columns)), size, size);
      Body.setAngle(square, 0.2 * (random() - 0.5));
      return square;
    });
    const walls = [-size, side + size].flatMap((at) => [
      Bodies.rectangle(at, side / 2, 2 * size, 2 * side, { isStatic: true }),
      Bodies.rectangle(side / 2, at, 2 * side, 2 * size, { isStatic: true }),
    ]);
    Composite.add(engine.world, [...squares, ...walls]);
    for (let k = 0; k < 10; k++) Engine.update(engine, 1000 / 60);
    return () => {
      for (let k = 0; k < steps; k++) Engine.update(engine, 1000 / 60);
    };
  });
  return { name: `matter-js, a step of ${count} squares in a box`, ms: ms / steps };
}

/**
 * Subdivides the same stones by three-subdivide, once, after a short warm-up.
 * @param {{ points: Float32Array, triangles: Uint32Array, stones: number, levels: number }} mesh
 * @returns {Promise<Timing | undefined>}
 */
export async function threeSubdivide({ points, triangles, stones, levels }) {
  // These imports follow each other, because three-subdivide needs three to be loaded.
  const three = await installed('three');
  const subdivide = three && (await installed('three-subdivide'));
  if (!subdivide) return undefined;
  const { BufferAttribute, BufferGeometry } = three;
  const stone = (/** @type {number} */ k) => {
    const stretched = points.map((value, i) => value * (i % 3 === 1 ? 1 + k / stones : i % 3 === 2 ? 0.7 : 1));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(stretched, 3));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    return geometry;
  };
  const refine = (/** @type {import('three').BufferGeometry} */ geometry) =>
    subdivide.LoopSubdivision.modify(geometry, levels, { split: false, uvSmooth: false, preserveEdges: false, flatOnly: false, maxTriangles: Infinity });
  for (let k = 0; k < 5; k++) refine(stone(k));
  const geometries = Array.from({ length: stones }, (_, k) => stone(k));
  const start = performance.now();
  let made = 0;
  for (const geometry of geometries) made += refine(geometry).getAttribute('position').count / 3;
  const ms = performance.now() - start;
  const wanted = (stones * triangles.length * 4 ** levels) / 3;
  if (made !== wanted) throw new Error(`three-subdivide made ${made} triangles instead of ${wanted}.`);
  return { name: `three-subdivide, ${stones} stones, ${levels} times`, ms };
}

/** A package; undefined if it is not installed. @param {string} name */
export async function installed(name) {
  try {
    return await import(name);
  } catch (error) {
    if (!(error instanceof Error && 'code' in error && error.code === 'ERR_MODULE_NOT_FOUND')) throw error;
    console.log(`${name} is not installed: npm ci lets it be measured beside ours.`);
    return undefined;
  }
}

/**
 * The shortest of several runs in milliseconds; each is prepared first.
 * @param {number} runs @param {() => () => void} prepare
 */
function shortest(runs, prepare) {
  let least = Infinity;
  for (let k = 0; k < runs; k++) {
    const run = prepare();
    const start = performance.now();
    run();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

/** Random numbers in 0..1, the same ones from each call of this function (mulberry32). */
export function randomNumbers() {
  let state = 1;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
