// The benchmarks in WebAssembly under Node, and other programs that do the same work, for comparison.
import { d3Delaunay, d3Polygons, matterJs, threeSubdivide } from './peers.mjs';
import { rapier } from './rapier.mjs';
import { threeFrames } from './three.mjs';

/** @typedef {{ name: string, ms: number }} Timing */
/** @typedef {{ points: Float32Array, triangles: Uint32Array, stones: number, levels: number }} Mesh */

/**
 * @param {{ bench?: () => Timing[], bench_mesh?: () => Mesh, bench_skin?: () => Mesh, bench_hide?: () => import('./three.mjs').Hide, bench_pile?: () => import('./rapier.mjs').Pile, bench_overlaps?: (places: Float64Array) => number[] }} module
 *   built with the feature `bench`
 * @returns {Promise<Timing[]>}
 */
export async function run(module) {
  const { bench_pile: benchPile, bench_overlaps: benchOverlaps } = module;
  if (!module.bench || !module.bench_mesh || !module.bench_skin || !module.bench_hide || !benchPile || !benchOverlaps) throw new Error('The module has no benchmarks: build it with --features bench.');
  const timings = module.bench();
  /** @type {{ ours: string, theirs: string, most: number }[]} */
  const bars = [
    { ours: 'Runge-Kutta step, a thousand of 50000 cells', theirs: 'Runge-Kutta step, a thousand of 500 cells', most: 1.3 },
    { ours: 'mesh to cells, leg, 2000 cells', theirs: 'outline to fitted cells, ring, 2000 cells', most: 6 },
    { ours: '2000 scales of 200 triangles, still with its shadows', theirs: 'light moved, parallel', most: 25 },
    { ours: '2000 scales of 200 triangles, turning', theirs: 'light moved, parallel', most: 5 },
    { ours: 'a thousand of 20000 darts', theirs: 'a thousand of 2000 darts', most: 1.2 },
    { ours: 'refinement of the rice ball, exact', theirs: 'refinement of the rice ball, golden', most: 1 / 5 },
    { ours: 'recipe to finished bodies, rice ball without its picture', theirs: 'recipe to picture, default pavement', most: 15 },
    { ours: 'the house, laid', theirs: 'recipe to picture, default pavement', most: 0.25 },
    { ours: 'a thousand bricks of the house of small bricks', theirs: 'a thousand bricks of the house', most: 1.2 },
    { ours: "from a moved window to the first frame", theirs: 'recipe to picture, default pavement', most: 0.75 },
    { ours: 'house of 256 x 256, turning', theirs: 'light moved, parallel', most: 5 },
    { ours: 'house of small bricks of 256 x 256, turning', theirs: 'light moved, parallel', most: 15 },
    { ours: 'house of 512 x 512, still with its shadows', theirs: 'light moved, parallel', most: 25 },
    { ours: 'house of small bricks of 512 x 512, still with its shadows', theirs: 'light moved, parallel', most: 60 },
    { ours: 'rice ball of 512 x 512, still with its shadows', theirs: 'light moved, parallel', most: 25 },
    { ours: 'rice ball of 256 x 256, turning', theirs: 'light moved, parallel', most: 5 },
  ];
  /** @param {string} ours @param {Timing | undefined} peer @param {number} most */
  const beside = (ours, peer, most) => {
    if (!peer) return;
    if (!timings.some(({ name }) => name === peer.name)) timings.push(peer);
    bars.push({ ours, theirs: peer.name, most });
  };
  for (const count of [400, 3000]) {
    const peer = await d3Delaunay(count);
    for (const outline of ['square', 'ring']) {
      const whole = `outline to fitted cells, ${outline}, ${count} cells`;
      beside(whole, peer, 1);
      bars.push({ ours: `direction field of these, ${outline}, ${count} cells`, theirs: whole, most: 0.1 });
    }
  }
  beside('the house of small bricks, laid', await d3Polygons(100_000), 1);
  beside('Runge-Kutta step, 500 cells', await matterJs(500), 0.4);
  beside('subdivision, 500 stones, 3 times', await threeSubdivide(module.bench_mesh()), 1);
  beside('skin of fig. 14 (a)', await threeSubdivide(module.bench_skin()), 1 / 80);
  const pile = benchPile();
  const physics = await rapier(pile, benchOverlaps);
  beside('a bowl of 1000 pebbles, darts and refinement', physics, 1 / 150);
  beside('a bowl of 1000 pebbles, with the spheres of eight variants', physics, 1 / 40);
  timings.push(...(await threeFrames(module.bench_hide())));
  // A name may end with what else was counted, after a colon.
  const ms = (/** @type {string} */ wanted) => timings.find(({ name }) => name.split(':')[0] === wanted)?.ms ?? NaN;
  console.log('\nAs parts of each other in WebAssembly, and the most that is wanted:');
  for (const { ours, theirs, most } of bars) {
    const ratio = ms(ours) / ms(theirs);
    console.log(`${ratio.toFixed(4).padStart(8)} <= ${most}${ratio <= most ? '' : '  NO'}   ${ours} / ${theirs}`);
  }
  return timings;
}
