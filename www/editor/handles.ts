/** Few handles for a ring of many points: its corners, and smooth ones along its curves, the same whenever the ring is the same. */
import type { Point, Ring } from '../types';
import { nearest, stretchAlong } from './curve';
import type { Figure } from './figures';
import { distance, simplify } from './simplify';

/** Handles on all rings together, about at most. */
const MOST = 300;

/** Radians by which a curve turns at a point at most, and sides of the picture by which its chords are off. */
const TURN = 0.61;
const FLAT = 1 / 650;

/** A curve has so many points and bends by so many radians; else its points are corners. */
const POINTS = 3;
const BEND = 0.05;

/** Radians by which a curve turns from handle to handle, and its length in sides at least. */
const SWEEP = Math.PI / 4;
const LENGTH = 0.05;

/** So much of a sweep more needs no further handle: what a curve turns at its ends is not counted. */
const SPARE = 0.25;

/** A piece so many sides long and so many times as long as the next ones is a straight line beside a curve. */
const STRAIGHT = 0.02;
const LONGER = 2.5;

/** A curve turns the other way once it has done so by this many radians. */
const OTHER_WAY = 0.06;

/** Rings with handles. Where they have far too many corners, the least of them are points of the stretches between. */
export function handled(rings: Ring[], side: number): Figure[] {
  const kept = new Set(simplify(rings, side, MOST).flat());
  for (let sweep = SWEEP; ; sweep *= 1.5) {
    const figures = rings.map((ring) => figureOf(ring, side, kept, sweep));
    if (sweep > 20 || figures.reduce((total, { points }) => total + points.length, 0) <= MOST + 3 * rings.length) return figures;
  }
}

interface Vertex {
  /** Radians by which the ring turns here, with a sign. */
  turn: number;
  /** Length from here to the next one. */
  length: number;
  sort: 'point' | 'corner' | 'smooth';
}

function figureOf(ring: Ring, side: number, kept: Set<Point>, sweep: number): Figure {
  const all = vertices(ring);
  const at = (k: number): Vertex => all[(k + all.length) % all.length] as Vertex;
  all.forEach((vertex, k) => {
    const turn = Math.abs(vertex.turn);
    const flat = turn <= TURN && (turn * Math.min(vertex.length, at(k - 1).length)) / 8 <= FLAT * side;
    if (!flat && kept.has(ring[k] as Point)) vertex.sort = 'corner';
  });
  const marked = (sort?: Vertex['sort']): number[] => [...all.keys()].filter((k) => (sort ? at(k).sort === sort : at(k).sort !== 'point'));
  const runs = (ends: number[]): [from: number, to: number][] => ends.map((from, k) => [from, k + 1 < ends.length ? (ends[k + 1] as number) : (ends[0] as number) + all.length]);
  const inside = (from: number, to: number): Vertex[] => Array.from({ length: to - from - 1 }, (_, k) => at(from + 1 + k));
  for (const [from, to] of runs(marked())) {
    const vertices = inside(from, to);
    if (vertices.length >= POINTS && turning(vertices) >= BEND) bounds(all, from, to, side);
    else for (let k = from + 1; k < to; k += 1) if (kept.has(ring[k % ring.length] as Point)) at(k).sort = 'corner';
  }
  if (!marked().length) {
    bounds(all, 0, all.length, side);
    // A circle's first handle is at the right.
    if (!marked().length) at(nearest(ring.map(([x]) => -x))).sort = 'smooth';
  }
  const ends = marked();
  const least = Math.ceil(3 / ends.length);
  for (const [from, to] of runs(ends)) {
    const vertices = inside(from, to);
    const lengths = [at(from), ...vertices].map(({ length }) => length);
    const most = Math.floor(lengths.reduce((sum, length) => sum + length, 0) / (LENGTH * side));
    const pieces = Math.max(least, Math.min(Math.ceil(turning(vertices) / sweep - SPARE), most));
    for (const k of spread(vertices, lengths, pieces)) at(from + 1 + k).sort = 'smooth';
  }
  const handles = marked();
  const points = handles.map((k) => [...(ring[k] as Point)] as Point);
  const stretches = runs(handles).map(([from, to]) => stretchAlong(Array.from({ length: to - from + 1 }, (_, k) => ring[(from + k) % ring.length] as Point), at(from).sort === 'smooth'));
  return { points, value: 0, stretches };
}

function vertices(ring: Ring): Vertex[] {
  return ring.map((here, k) => {
    const before = ring.at(k - 1) ?? here;
    const next = ring[(k + 1) % ring.length] ?? here;
    const [ux, uy, vx, vy] = [here[0] - before[0], here[1] - before[1], next[0] - here[0], next[1] - here[1]];
    return { turn: Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy), length: distance(here, next), sort: 'point' };
  });
}

function turning(vertices: Vertex[]): number {
  return vertices.reduce((sum, { turn }) => sum + Math.abs(turn), 0);
}

/** Marks where a curve goes over into a straight line or begins to turn the other way. */
function bounds(all: Vertex[], from: number, to: number, side: number): void {
  const at = (k: number): Vertex => all[(k + all.length) % all.length] as Vertex;
  let [way, other, begin] = [0, 0, from];
  for (let k = from + 1; k < to; k += 1) {
    const vertex = at(k);
    const [before, behind] = [at(k - 1).length, vertex.length].sort((a, b) => a - b) as [number, number];
    if (behind > STRAIGHT * side && behind > LONGER * before) vertex.sort = 'smooth';
    if (vertex.turn * way >= 0) {
      // Small turns to and fro count for nothing.
      other = vertex.turn ? 0 : other;
      way ||= Math.sign(vertex.turn);
    } else {
      if (!other) begin = k;
      other += Math.abs(vertex.turn);
      if (other <= OTHER_WAY) continue;
      at(begin).sort = 'smooth';
      [way, other] = [-way, 0];
    }
  }
}

/** The places that divide a curve into so many pieces that are about as long and turn by as much. */
function spread(vertices: Vertex[], lengths: number[], pieces: number): number[] {
  const [turns, length] = [turning(vertices) || 1, lengths.reduce((sum, length) => sum + length, 0)];
  let done = 0;
  const sums = vertices.map(({ turn }, k) => (done += Math.abs(turn) / turns + (lengths[k] ?? 0) / length));
  return Array.from({ length: Math.min(pieces - 1, vertices.length) }, (_, n) => nearest(sums.map((sum) => Math.abs(sum - (2 * (n + 1)) / pieces))));
}
