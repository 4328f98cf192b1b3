/**
 * Finds a few handles for a ring of many points. The same ring always gets the same handles.
 *
 * Handles are corners, the ends of straight lines, and smooth points where a curve has turned by 45 degrees.
 */
import type { Point, Ring } from '../../module/types';
import { stretchAlong } from './curve';
import type { Figure } from './figures';
import { distance, nearest } from './plane';
import { simplify } from './simplify';

/** Approximate limit of handles on all rings together. */
const MOST = 300;

/** At a point of a curve, the ring turns by at most TURN radians and its chords are off by at most FLAT sides. */
const TURN = 0.61;
const FLAT = 1 / 650;

/** A curve has at least POINTS points and bends by at least BEND radians. Otherwise its points are corners. */
const POINTS = 3;
const BEND = 0.05;

/** From handle to handle, a curve turns by about SWEEP radians and is at least LENGTH sides long. */
const SWEEP = Math.PI / 4;
const LENGTH = 0.05;

/** A curve needs one more handle only beyond this share of a sweep, as the turns at its ends are not counted. */
const SPARE = 0.25;

/** Beside a curve, a piece is a straight line if it is longer than STRAIGHT sides and LONGER times its neighbour. */
const STRAIGHT = 0.02;
const LONGER = 2.5;

/** A curve bends the other way once it has turned back by this many radians. */
const OTHER_WAY = 0.06;

interface Vertex {
  at: Point;
  /** Radians by which the ring turns here, with a sign. */
  turn: number;
  /** Length from here to the next vertex. */
  length: number;
  /** This vertex may become a handle. */
  kept: boolean;
  /** The kind of handle; undefined at vertices that are no handle, as most are. */
  handle?: 'corner' | 'smooth';
}

/** Vertices from a handle to the next one, both included. */
type Run = Vertex[];

/** Rings with handles. Where there are far too many corners, the smallest become plain points of the stretches. */
export function handled(rings: Ring[], side: number): Figure[] {
  const kept = new Set(simplify(rings, side, MOST).flat());
  for (let sweep = SWEEP; ; sweep *= 1.5) {
    const figures = rings.map((ring) => figureOf(verticesOf(ring, kept), side, sweep));
    if (sweep > 20 || figures.reduce((total, { points }) => total + points.length, 0) <= MOST + 3 * rings.length) return figures;
  }
}

function verticesOf(ring: Ring, kept: Set<Point>): Vertex[] {
  return ring.map((at, k) => {
    const before = ring.at(k - 1) ?? at;
    const next = ring[(k + 1) % ring.length] ?? at;
    const [ux, uy, vx, vy] = [at[0] - before[0], at[1] - before[1], next[0] - at[0], next[1] - at[1]];
    return { at, turn: Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy), length: distance(at, next), kept: kept.has(at) };
  });
}

function figureOf(all: Vertex[], side: number, sweep: number): Figure {
  corners(all, side);
  const begun = runs(all);
  for (const run of begun) bounds(run, side);
  // The first handle of a circle is its rightmost point.
  const right = all[nearest(all.map(({ at }) => -at[0]))];
  if (!begun.length) bounds([...all, ...all.slice(0, 1)], side);
  if (right && !runs(all).length) right.handle = 'smooth';
  const bounded = runs(all);
  for (const run of bounded) divide(run, side, sweep, Math.ceil(3 / bounded.length));
  const last = runs(all);
  return {
    points: last.flatMap(([first]) => (first ? [first.at] : [])),
    value: 0,
    stretches: last.map((run) => stretchAlong(run.map(({ at }) => at), run[0]?.handle === 'smooth')),
  };
}

/** The runs from each handle to the next one. */
function runs(all: Vertex[]): Run[] {
  const first = all.findIndex(({ handle }) => handle);
  if (first < 0) return [];
  const found: Run[] = [];
  for (const vertex of [...all.slice(first), ...all.slice(0, first + 1)]) {
    found.at(-1)?.push(vertex);
    if (vertex.handle) found.push([vertex]);
  }
  return found.slice(0, -1);
}

/** Marks corners: the points that lie on no curve. */
function corners(all: Vertex[], side: number): void {
  all.forEach((vertex, k) => {
    const turn = Math.abs(vertex.turn);
    const off = (turn * Math.min(vertex.length, all.at(k - 1)?.length ?? 0)) / 8;
    if (vertex.kept && (turn > TURN || off > FLAT * side)) vertex.handle = 'corner';
  });
  for (const run of runs(all)) {
    const inside = run.slice(1, -1);
    if (inside.length >= POINTS && turning(inside) >= BEND) continue;
    for (const vertex of inside) if (vertex.kept) vertex.handle = 'corner';
  }
}

function turning(vertices: Vertex[]): number {
  return vertices.reduce((sum, { turn }) => sum + Math.abs(turn), 0);
}

/** Marks where a curve meets a straight line or begins to turn the other way. */
function bounds(run: Run, side: number): void {
  let [way, other] = [0, 0];
  let begin: Vertex | undefined;
  run.slice(1, -1).forEach((vertex, k) => {
    const [shorter, longer] = [Math.min, Math.max].map((end) => end(run[k]?.length ?? 0, vertex.length)) as [number, number];
    if (longer > STRAIGHT * side && longer > LONGER * shorter) vertex.handle = 'smooth';
    if (vertex.turn * way >= 0) {
      // Small turns back and forth are ignored.
      if (vertex.turn) other = 0;
      way ||= Math.sign(vertex.turn);
      return;
    }
    if (!other) begin = vertex;
    other += Math.abs(vertex.turn);
    if (other <= OTHER_WAY || !begin) return;
    begin.handle = 'smooth';
    [way, other] = [-way, 0];
  });
}

/** Divides a curve into at least `least` pieces that are about equal in length and turn. */
function divide(run: Run, side: number, sweep: number, least: number): void {
  const inside = run.slice(1, -1);
  const [turns, length] = [turning(inside), run.slice(0, -1).reduce((sum, vertex) => sum + vertex.length, 0)];
  const pieces = Math.max(least, Math.min(Math.ceil(turns / sweep - SPARE), Math.floor(length / (LENGTH * side))));
  let done = 0;
  const sums = inside.map(({ turn }, k) => (done += Math.abs(turn) / (turns || 1) + (run[k]?.length ?? 0) / length));
  for (let n = 1; n < pieces; n += 1) {
    const vertex = inside[nearest(sums.map((sum) => Math.abs(sum - (2 * n) / pieces)))];
    if (vertex) vertex.handle = 'smooth';
  }
}
