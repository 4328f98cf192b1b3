/** Areas on a grid of whole numbers, free of rounding errors, combined by Clipper (A. Johnson, after Vatti). */
import { Clipper64, ClipperOffset, ClipType, EndType, FillRule, JoinType, type Paths64 } from 'clipper2-ts';
import type { Point, Ring } from '../../module/types';

/** Rings that wind once around their area; holes run the other way. */
export type Area = Paths64;

export type Rule = 'nonzero' | 'evenodd';

export const EMPTY: Area = [];

/** Steps of the grid along a side; the grain of an outline in a link is 64 of them. */
export const STEPS = 2 ** 21;

/** The area that rings enclose by a fill rule; `place` puts their points on the grid. */
export function areaOf(rings: Ring[], rule: Rule, place: (point: Point) => Point): Area {
  const paths = rings.map((ring) =>
    ring.map((point) => {
      const [x, y] = place(point);
      return { x: Math.round(x), y: Math.round(y) };
    }),
  );
  return made(ClipType.Union, paths, EMPTY, rule === 'evenodd' ? FillRule.EvenOdd : FillRule.NonZero);
}

export function union(...areas: Area[]): Area {
  const there = areas.filter((area) => area.length);
  return there.length < 2 ? (there[0] ?? EMPTY) : made(ClipType.Union, there.flat(), EMPTY);
}

export function without(area: Area, other: Area): Area {
  return area.length && other.length ? made(ClipType.Difference, area, other) : area;
}

export function common(area: Area, other: Area): Area {
  return area.length && other.length ? made(ClipType.Intersection, area, other) : EMPTY;
}

/** The area without a border of this width: parts that only touched come apart. */
export function shrunk(area: Area, by: number): Area {
  const offset = new ClipperOffset(2);
  const less: Area = [];
  offset.addPaths(area, JoinType.Miter, EndType.Polygon);
  offset.execute(-by, less);
  return less;
}

function made(what: ClipType, subject: Area, clip: Area, rule = FillRule.NonZero): Area {
  const clipper = new Clipper64();
  const area: Area = [];
  clipper.addSubject(subject);
  clipper.addClip(clip);
  clipper.execute(what, rule, area);
  return area;
}

export function pointsOf(area: Area): number {
  return area.reduce((sum, path) => sum + path.length, 0);
}
