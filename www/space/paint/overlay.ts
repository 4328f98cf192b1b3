/** Draws painted rows over the frame, where they are visible, and the path of the pointer. */
import { make } from '../../base/dom';
import { shape } from '../../late/svg';
import type { FramePlace } from '../../picture/frames/source';
import type { ModelPlace } from './places';

/** A painted row and its tool's key: a line, or a spot if it has a single place. */
export interface Painted {
  readonly key: string;
  readonly places: readonly ModelPlace[];
}

/** Pieces of a line between two places, because parts of it may be hidden. */
const PIECES = 6;

/** Sizes of an arrow head and of a spot, in pixels. */
const HEAD = 11;
const DOT = 7;

export class Overlay {
  readonly element = make('div', { class: 'paint-over', 'aria-hidden': 'true' });
  private readonly svg = shape('svg');

  constructor() {
    this.element.append(this.svg, make('i', { class: 'paint-cross' }));
  }

  /** Redraws everything; `seen` projects a place to the frame if it is visible. */
  draw(painted: readonly Painted[], seen: (place: ModelPlace) => FramePlace | undefined, path: readonly FramePlace[], key: string): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    const at = ([u, v]: FramePlace): FramePlace => [u * width, v * height];
    const paths: SVGElement[] = [];
    for (const { key: word, places } of painted) {
      const runs = runsOf(places, (place) => {
        const spot = seen(place);
        return spot && at(spot);
      });
      const d = runs.map(lineOf).join('') + (word === 'strokes' ? runs.slice(-1).map(headOf).join('') : '');
      if (d) paths.push(...strokes(word, d));
    }
    if (path.length) paths.push(...strokes(key, lineOf(path.map(at))));
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.svg.replaceChildren(...paths);
  }
}

/** A line on top of a lighter one, visible on any background. */
function strokes(key: string, d: string): SVGElement[] {
  return [shape('path', { class: 'paint-under', d }), shape('path', { class: `paint-line paint-${key}`, d })];
}

/** The visible pieces of a line. */
function runsOf(places: readonly ModelPlace[], seen: (place: ModelPlace) => FramePlace | undefined): FramePlace[][] {
  const [first] = places;
  const all = places.slice(1).flatMap((to, k) => between(places[k] ?? to, to));
  const runs: FramePlace[][] = [[]];
  for (const place of first ? [first, ...all] : []) {
    const spot = seen(place);
    if (spot) runs.at(-1)?.push(spot);
    else if (runs.at(-1)?.length) runs.push([]);
  }
  return runs.filter((run) => run.length > 0);
}

function between(a: ModelPlace, b: ModelPlace): ModelPlace[] {
  return Array.from({ length: PIECES }, (_, k) => {
    const t = (k + 1) / PIECES;
    return [0, 1, 2].map((axis) => Math.round((a[axis] ?? 0) * (1 - t) + (b[axis] ?? 0) * t)) as unknown as ModelPlace;
  });
}

function lineOf(run: readonly FramePlace[]): string {
  const [first] = run;
  if (!first) return '';
  const [x, y] = first;
  if (run.length === 1) return `M${x - DOT} ${y}a${DOT} ${DOT} 0 1 0 ${2 * DOT} 0a${DOT} ${DOT} 0 1 0 ${-2 * DOT} 0`;
  return run.map(([px, py], k) => `${k ? 'L' : 'M'}${px.toFixed(1)} ${py.toFixed(1)}`).join('');
}

/** The arrow head at a line's end. */
function headOf(run: readonly FramePlace[]): string {
  const end = run.at(-1);
  const before = end && run.findLast((spot) => Math.hypot(end[0] - spot[0], end[1] - spot[1]) > HEAD / 2);
  if (!end || !before) return '';
  const way = Math.atan2(end[1] - before[1], end[0] - before[0]);
  const side = (turn: number): string => `${(end[0] - HEAD * Math.cos(way + turn)).toFixed(1)} ${(end[1] - HEAD * Math.sin(way + turn)).toFixed(1)}`;
  return `M${side(0.5)}L${end[0].toFixed(1)} ${end[1].toFixed(1)}L${side(-0.5)}`;
}
