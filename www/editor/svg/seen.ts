/**
 * The visible ink of a drawing on white paper, as one area.
 *
 * Two neighbouring layers act like one: the upper one covers the lower one, then adds its own area.
 */
import type { Point, Ring } from '../../module/types';
import { areaOf, common, EMPTY, pointsOf, STEPS, union, without, type Area } from './area';
import { boundsOf, placesOf, type Clip, type Drawing, type DrawingPiece } from './drawing';
import { growth, moved } from './matrix';
import { flat, POINTS } from './path';
import { Refusal } from './refusal';
import type { Box } from './shapes';
import { stroked } from './stroke';

/** The error of curves, as a share of the drawing. */
const FLAT = 1 / 6000;

/** A piece farther away than this many times the drawing's size does not belong to it. */
const FAR = 1e6;

/** Most points that are combined at once. */
const AT_ONCE = 20_000;

/** The effect of pieces on the ink below: first the area `covers` is removed, then the area `adds` is added. */
interface Layer {
  covers: Area;
  adds: Area;
}

/** The rings around all ink that no white covers. A drawing that is all white counts as ink. */
export function seen({ pieces, frame, left }: Drawing, progress: (done: number) => void): Ring[] {
  const limits = frame && grown(frame, FAR);
  const near = pieces.filter((piece) => placesOf(piece).every(([x, y]) => Number.isFinite(x + y) && (!limits || inside(x, y, limits))));
  if (near.length < pieces.length) left.far = pieces.length - near.length;
  const extent = extentOf(near, frame);
  if (!extent) return [];
  const board = new Board(extent, frame);
  const area = board.layers(near, progress);
  const white = area.length || near.every(({ paint }) => paint === 'ink') ? area : board.layers(near.map((piece) => ({ ...piece, paint: 'ink' })), progress);
  return board.rings(white);
}

class Board {
  private readonly extent: Box;
  private readonly frame: Box | undefined;
  private readonly step: number;
  private readonly cut = new Map<Clip, Area>();
  private points = 0;

  constructor(extent: Box, frame: Box | undefined) {
    this.extent = extent;
    this.frame = frame;
    this.step = Math.max(extent.width, extent.height) / STEPS;
  }

  rings(area: Area): Ring[] {
    return area.map((path) => path.map(({ x, y }): Point => [this.extent.x + x * this.step, this.extent.y + y * this.step]));
  }

  layers(pieces: DrawingPiece[], progress: (done: number) => void): Area {
    this.points = 0;
    const layers: Layer[] = [];
    let done = 0;
    for (const group of groups(pieces)) {
      let areas: Area[] = [];
      let held = 0;
      const put = (): void => {
        const whole = group.clips.reduce((area, clip) => common(area, this.clip(clip)), union(...areas));
        layers.push(group.paint === 'ink' ? { covers: EMPTY, adds: whole } : { covers: whole, adds: EMPTY });
        [areas, held] = [[], 0];
      };
      for (const piece of group.pieces) {
        const area = this.area(piece);
        areas.push(area);
        held += pointsOf(area);
        progress((0.5 * (done += 1)) / pieces.length);
        if (held > AT_ONCE) put();
      }
      put();
    }
    return together(layers, (part) => progress(0.5 + 0.5 * part)).adds;
  }

  private clip(clip: Clip): Area {
    const known = this.cut.get(clip) ?? union(...clip.pieces.map((piece) => piece.clips.reduce((area, by) => common(area, this.clip(by)), this.area(piece))));
    this.cut.set(clip, known);
    return known;
  }

  private area(piece: DrawingPiece): Area {
    const rings = this.outlines(piece).map((ring) => (this.frame ? cropped(ring, this.frame) : ring)).filter((ring) => ring.length > 2);
    this.points += rings.reduce((sum, ring) => sum + ring.length, 0);
    if (this.points > POINTS) throw new Refusal('too_many_points', { most: POINTS });
    const { x: left, y: top } = this.extent;
    return areaOf(rings, piece.rule, ([x, y]) => [(x - left) / this.step, (y - top) / this.step]);
  }

  private outlines({ runs, matrix, pen }: DrawingPiece): Ring[] {
    const tolerance = this.step * STEPS * FLAT;
    const own = tolerance / (growth(matrix) || 1);
    const placed = (ring: Ring): Ring => ring.map((point) => moved(matrix, point));
    if (!pen) return runs.map((run) => placed(flat(run, own)));
    return runs.flatMap((run) => {
      const line = flat(run, own);
      // A move that draws nothing gives no point.
      if (!run.curves.length && !run.closed) return [];
      return pen.still ? stroked(placed(line), run.closed, pen, tolerance) : stroked(line, run.closed, pen, own).map(placed);
    });
  }
}

interface PieceGroup {
  paint: DrawingPiece['paint'];
  clips: Clip[];
  pieces: DrawingPiece[];
}

/** Runs of pieces with the same paint and the same clips. */
function groups(pieces: DrawingPiece[]): PieceGroup[] {
  const found: PieceGroup[] = [];
  for (const piece of pieces) {
    const last = found.at(-1);
    if (last && last.paint === piece.paint && last.clips.length === piece.clips.length && last.clips.every((clip, k) => clip === piece.clips[k])) last.pieces.push(piece);
    else found.push({ paint: piece.paint, clips: piece.clips, pieces: [piece] });
  }
  return found;
}

/** Combines neighbours pairwise, so that no piece is combined again and again with all below it. */
function together(layers: Layer[], progress: (done: number) => void): Layer {
  const all = layers.length;
  let left = layers;
  while (left.length > 1) {
    const next: Layer[] = [];
    for (let k = 0; k < left.length; k += 2) {
      const [below, above] = [left[k], left[k + 1]] as [Layer, Layer | undefined];
      next.push(above ? { covers: union(below.covers, above.covers), adds: union(without(below.adds, above.covers), above.adds) } : below);
      progress(1 - (left.length - k / 2) / all);
    }
    left = next;
  }
  return left[0] ?? { covers: EMPTY, adds: EMPTY };
}

/** The box of the visible pieces; undefined if nothing is visible in the frame. */
function extentOf(pieces: DrawingPiece[], frame: Box | undefined): Box | undefined {
  const reach = pieces.reduce((most, { pen, matrix }) => Math.max(most, pen ? pen.width * (pen.still ? 1 : growth(matrix)) * Math.max(1, pen.limit) : 0), 0);
  const [left, right, top, bottom] = boundsOf(pieces.flatMap(placesOf));
  const [x, y] = [Math.max(left - reach, frame?.x ?? -Infinity), Math.max(top - reach, frame?.y ?? -Infinity)];
  const width = Math.min(right + reach, frame ? frame.x + frame.width : Infinity) - x;
  const height = Math.min(bottom + reach, frame ? frame.y + frame.height : Infinity) - y;
  return width >= 0 && height >= 0 && Math.max(width, height) > 0 && Number.isFinite(width + height) ? { x, y, width, height } : undefined;
}

function grown({ x, y, width, height }: Box, by: number): Box {
  return { x: x - by * width, y: y - by * height, width: (1 + 2 * by) * width, height: (1 + 2 * by) * height };
}

function inside(x: number, y: number, box: Box): boolean {
  return x >= box.x && y >= box.y && x <= box.x + box.width && y <= box.y + box.height;
}

/** The part of a ring within a frame (Sutherland and Hodgman, 1974). Separate pieces stay joined along the frame. */
function cropped(ring: Ring, { x, y, width, height }: Box): Ring {
  const sides: [axis: 0 | 1, at: number, sense: 1 | -1][] = [[0, x, 1], [0, x + width, -1], [1, y, 1], [1, y + height, -1]];
  return sides.reduce((rest, [axis, at, sense]) => {
    const beyond = (point: Point): boolean => (point[axis] - at) * sense < 0;
    if (!rest.some(beyond)) return rest;
    return rest.flatMap((to, k): Point[] => {
      const from = rest.at(k - 1) ?? to;
      if (beyond(from) === beyond(to)) return beyond(to) ? [] : [to];
      const part = (at - from[axis]) / (to[axis] - from[axis]);
      const edge: Point = [from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part];
      edge[axis] = at;
      return beyond(to) ? [edge] : [edge, to];
    });
  }, ring);
}
