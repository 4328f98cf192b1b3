// Rapier for comparison: a physics engine that drops the same pebbles into the same bowl.
import { performance } from 'node:perf_hooks';
import { installed, randomNumbers } from './peers.mjs';

/** @typedef {{ name: string, ms: number }} Timing */
/**
 * @typedef {object} Pile
 * @property {Float32Array[]} hulls of each variant the points of its convex hull
 * @property {Uint32Array} shapes the variant of each pebble
 * @property {Float64Array} sizes of the pebbles, as factors of their variants
 * @property {number} bound the greatest distance of a surface from its pebble's origin
 * @property {Float32Array} positions of the bowl
 * @property {Uint32Array} triangles
 * @property {number} radius of the bowl
 * @property {number} top of the bowl
 * @property {number[]} overlaps of our pile: the deepest, and the mean
 */

/** Seconds of a step, and the most simulated seconds. */
const STEP = 1 / 60;
const MOST = 20;
/** The most milliseconds that a run may take. */
const PATIENCE = 90_000;
/** Pebbles begin above this inner share of the bowl's radius. */
const WITHIN = 0.75;

/**
 * Drops the pebbles until all sleep.
 * @param {Pile} pile
 * @param {(places: Float64Array) => number[]} overlaps of pebbles, of which each has a place and a quaternion
 * @returns {Promise<Timing | undefined>}
 */
export async function rapier(pile, overlaps) {
  const found = await installed('@dimforge/rapier3d-compat');
  if (!found) return undefined;
  const engine = found.default;
  await engine.init();
  const world = new engine.World({ x: 0, y: -9.81, z: 0 });
  world.timestep = STEP;
  world.createCollider(engine.ColliderDesc.trimesh(pile.positions, pile.triangles));
  world.createCollider(engine.ColliderDesc.cuboid(10 * pile.radius, 1, 10 * pile.radius).setTranslation(0, -1, 0));
  const random = randomNumbers();
  const starts = places(pile);
  const bodies = [...pile.shapes].map((shape, k) => {
    const { x, y, z } = starts[k];
    const turn = [0, 0, 0, 0].map(() => 2 * random() - 1);
    const long = Math.hypot(...turn);
    const [a, b, c, w] = turn.map((v) => v / long);
    const body = world.createRigidBody(engine.RigidBodyDesc.dynamic().setTranslation(x, y, z).setRotation({ x: a, y: b, z: c, w }));
    const hull = engine.ColliderDesc.convexHull(pile.hulls[shape].map((v) => v * pile.sizes[k]));
    if (!hull) throw new Error('Rapier makes no hull of a pebble.');
    world.createCollider(hull, body);
    return body;
  });
  const awake = () => bodies.filter((body) => !body.isSleeping()).length;
  const start = performance.now();
  let steps = 0;
  do {
    world.step();
    steps += 1;
  } while (awake() > 0 && steps * STEP < MOST && performance.now() - start < PATIENCE);
  const ms = performance.now() - start;
  const ends = bodies.map((body) => [body.translation(), body.rotation()]);
  const inside = ends.filter(([{ x, y, z }]) => Math.hypot(x, z) < pile.radius && y > 0).length;
  const theirs = overlaps(Float64Array.from(ends.flatMap(([p, q]) => [p.x, p.y, p.z, q.x, q.y, q.z, q.w])));
  const share = (/** @type {number[]} */ [deepest, mean]) => `${deepest.toFixed(3)} R deepest, ${mean.toFixed(3)} R in the mean`;
  console.log(`Rapier: ${bodies.length} pebbles, ${(steps * STEP).toFixed(1)} s of its time, ${awake()} still awake, ${inside} over the bowl.`);
  console.log(`Inner spheres overlap by ${share(theirs)}; ours by ${share(pile.overlaps)}.`);
  world.free();
  return { name: `rapier, ${bodies.length} convex pebbles dropped into the bowl`, ms };
}

/** Places above the bowl, layer by layer, so far apart that no pebbles touch. @param {Pile} pile */
function places({ shapes, bound, radius, top }) {
  const apart = 2 * bound;
  const rows = Math.floor((WITHIN * radius) / apart);
  const list = [];
  for (let layer = 0; list.length < shapes.length; layer++) {
    for (let i = -rows; i <= rows; i++) {
      for (let j = -rows; j <= rows; j++) {
        if (Math.hypot(i, j) <= rows) list.push({ x: apart * i, y: top + apart * (layer + 0.5), z: apart * j });
      }
    }
  }
  return list;
}
