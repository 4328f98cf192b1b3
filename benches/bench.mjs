// The measurements in WebAssembly under Node, and the same subdivision by the npm package three-subdivide.
import { performance } from 'node:perf_hooks';

/** @typedef {{ name: string, ms: number }} Timing */

/**
 * @param {{ bench?: () => Timing[], bench_mesh?: () => { points: Float32Array, triangles: Uint32Array, stones: number, levels: number } }} module
 *   built with the feature `bench`
 * @returns {Promise<Timing[]>}
 */
export async function run(module) {
  if (!module.bench || !module.bench_mesh) throw new Error('The module has no benchmarks: build it with --features bench.');
  const timings = module.bench();
  const theirs = await threeSubdivide(module.bench_mesh());
  if (theirs) {
    const ours = timings.find(({ name }) => name.startsWith('subdivision'));
    timings.push(theirs);
    if (ours) console.log(`three-subdivide takes ${(theirs.ms / ours.ms).toFixed(0)} times as long for the same subdivision.`);
  } else {
    console.log('three-subdivide is not installed: npm install three three-subdivide lets it be measured beside ours.');
  }
  return timings;
}

/** The two packages in one object, or nothing where they are not installed. */
async function packages() {
  try {
    // One after the other: three-subdivide requires three, which must be loaded by then.
    const three = await import('three');
    return { ...three, ...(await import('three-subdivide')) };
  } catch (error) {
    if (error instanceof Error && 'code' in error && error.code === 'ERR_MODULE_NOT_FOUND') return undefined;
    throw error;
  }
}

/**
 * Subdivides the same stones by three-subdivide, once, after a short warm-up.
 * @param {{ points: Float32Array, triangles: Uint32Array, stones: number, levels: number }} mesh
 * @returns {Promise<Timing | undefined>}
 */
async function threeSubdivide({ points, triangles, stones, levels }) {
  const found = await packages();
  if (!found) return undefined;
  const { BufferAttribute, BufferGeometry, LoopSubdivision } = found;
  const stone = (/** @type {number} */ k) => {
    const stretched = points.map((value, i) => value * (i % 3 === 1 ? 1 + k / stones : i % 3 === 2 ? 0.7 : 1));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(stretched, 3));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    return geometry;
  };
  const refine = (/** @type {import('three').BufferGeometry} */ geometry) =>
    LoopSubdivision.modify(geometry, levels, { split: false, uvSmooth: false, preserveEdges: false, flatOnly: false, maxTriangles: Infinity });
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
