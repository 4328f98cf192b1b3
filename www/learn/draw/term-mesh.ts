/** The small pictures of the terms of meshes, by the module's triangles and cells. Places are units of 120 x 80. */
import type { Place } from '../figures/place';
import { at, circle, line } from './plate';
import { inRows, polygonsIn } from './rows';
import { asked, closed, dot, HEIGHT, listed, MIDDLE, placed, ring, WIDTH, type Draw } from './small';
import type { Bubbles, Studio } from './studio';

/** A recipe with points of a picture as its cells. */
const given = (points: readonly Place[]): string => `outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&given=${listed(points).map((place) => `${place},0`).join(';')}`;

/** Points, triangles with their angles and circles, and cells, of a recipe. */
interface Joined {
  readonly points: ReadonlyMap<number, Place>;
  readonly triangles: readonly { readonly corners: readonly Place[]; readonly angles: readonly number[]; readonly centre: Place; readonly radius: number }[];
  readonly cells: ReadonlyMap<number, readonly Place[]>;
  readonly angles: Float64Array;
}

function joinedOf(module: Bubbles, recipe: string): Joined {
  const [joined] = asked(module, recipe, 1, (studio) => {
    while (!studio.joinCells(100));
    return read(studio);
  });
  if (!joined) throw new Error(`${recipe} has no mesh.`);
  return joined;
}

function read(studio: Studio): Joined {
  const side = studio.side();
  const place = (x = 0, y = 0): Place => placed([x / side, y / side]);
  const points = new Map(inRows(studio.joined('points'), 3).map(([id = 0, x, y]) => [id, place(x, y)]));
  const triangles = inRows(studio.joined('triangles'), 10).map(([a = 0, b = 0, c = 0, alpha = 0, beta = 0, gamma = 0, , x, y, radius = 0]) => ({
    corners: [a, b, c].map((id) => points.get(id) ?? MIDDLE),
    angles: [alpha, beta, gamma],
    centre: place(x, y),
    radius: (radius / side) * WIDTH,
  }));
  const cells = new Map(polygonsIn(studio.joined('cells')).map(([id, corners]) => [id, inRows(corners, 2).map(([x, y]) => place(x, y))]));
  return { points, triangles, cells, angles: studio.joined('angles') };
}

/** A point in the middle, six around it, and more at the sides. */
const POINTS: readonly Place[] = [[60, 42], [83, 40], [73, 61], [48, 62], [37, 41], [49, 21], [72, 21], [104, 24], [105, 58], [14, 56], [15, 25], [94, 5], [27, 5], [60, 3], [94, 77], [25, 77], [61, 79]];

const edges = ({ triangles }: Joined, kind: string): string => triangles.map(({ corners }) => closed(corners, kind)).join('');
const dots = ({ points }: Joined): string => [...points.values()].map((place) => dot(place, 'centre', 2)).join('');

const mesh: Draw = (module) => {
  const joined = joinedOf(module, given(POINTS));
  return `${edges(joined, 'cell')}${dots(joined)}`;
};

/** The mesh behind, and the cells of the middle over it. */
const dual: Draw = (module) => {
  const joined = joinedOf(module, given(POINTS));
  const ids = [...joined.points.keys()];
  const cells = ids.slice(1, 7).map((id) => closed(joined.cells.get(id) ?? [], 'cell'));
  return `${edges(joined, 'stable')}${cells.join('')}${closed(joined.cells.get(ids[0] ?? 0) ?? [], 'bubble own')}${dot(MIDDLE, 'centre', 2)}`;
};

/** Scattered points in the whole picture. */
const SCATTERED = `outline=polygon&poly=${listed([[2, 2], [118, 2], [118, 78], [2, 78]]).join(',')}&size=256&kind=circle&cs=60&seed=4&start=random&count=9&pop=off&cells=lloyd`;

/** Voronoi cells, and each point's way to its next place. */
const lloyd: Draw = (module) => {
  const [now, next] = ['0', '1'].map((rounds) => joinedOf(module, `${SCATTERED}&rounds=${rounds}`));
  if (!now || !next) return '';
  const ways = [...now.points].map(([id, from]) => {
    const to = next.points.get(id) ?? from;
    return `${dot(from, 'centre', 2)}${line(from, to, 'now')}${dot(to, 'here', 3)}`;
  });
  return `${[...now.cells.values()].map((cell) => closed(cell, 'cell')).join('')}${ways.join('')}`;
};

const voronoi: Draw = (module) => {
  const joined = joinedOf(module, `${SCATTERED}&rounds=0`);
  const [own = 0] = [...joined.points].sort(([, a], [, b]) => Math.hypot(a[0] - MIDDLE[0], a[1] - MIDDLE[1]) - Math.hypot(b[0] - MIDDLE[0], b[1] - MIDDLE[1])).map(([id]) => id);
  return `${[...joined.cells.values()].map((cell) => closed(cell, 'cell')).join('')}${closed(joined.cells.get(own) ?? [], 'bubble own')}${dots(joined)}`;
};

/** A triangle with the wedge of its smallest angle. */
const smallest: Draw = (module) => {
  const { triangles: [triangle] } = joinedOf(module, given([[16, 66], [104, 66], [78, 18]]));
  if (!triangle) return '';
  const { corners, angles } = triangle;
  const least = angles.indexOf(Math.min(...angles));
  const [tip, a, b] = [0, 1, 2].map((k) => corners[(least + k) % 3] ?? MIDDLE) as [Place, Place, Place];
  const toward = ([x, y]: Place): Place => {
    const far = Math.hypot(x - tip[0], y - tip[1]) / 26;
    return [tip[0] + (x - tip[0]) / far, tip[1] + (y - tip[1]) / far];
  };
  const [from, to] = [toward(a), toward(b)];
  const sweep = (from[0] - tip[0]) * (to[1] - tip[1]) > (from[1] - tip[1]) * (to[0] - tip[0]) ? 1 : 0;
  return `<path class="bubble own" d="M${at(tip[0])} ${at(tip[1])}L${at(from[0])} ${at(from[1])}A26 26 0 0 ${sweep} ${at(to[0])} ${at(to[1])}z"/>${closed(corners, 'curve')}`;
};

/** The smallest angles of a mesh of random points in classes, and the line at their median. */
const median: Draw = (module) => {
  const { angles: [middle = 0, ...counts] } = joinedOf(module, 'outline=square&size=256&kind=circle&cs=18&seed=2&start=random&count=150&pop=off');
  const most = Math.max(...counts);
  const [left, width] = [9, (WIDTH - 18) / counts.length];
  const bars = counts.map((count, k) => {
    const [x, high] = [left + k * width, (56 * count) / most];
    return `<path class="bar-of" d="M${at(x)} ${at(HEIGHT - 10 - high)}h${at(width)}v${at(high)}h${at(-width)}z"/>`;
  });
  const x = left + (middle / 60) * (WIDTH - 18);
  return `${bars.join('')}${line([left, HEIGHT - 10], [WIDTH - 9, HEIGHT - 10], 'axis')}${line([x, 6], [x, HEIGHT - 5], 'curve')}`;
};

/** Two triangles, and the circles through their corners. */
const delaunay: Draw = (module) => {
  const joined = joinedOf(module, given([[22, 46], [58, 20], [62, 62], [100, 35]]));
  return `${joined.triangles.map(({ centre, radius }) => ring(centre, radius, 'stable')).join('')}${edges(joined, 'curve')}${dots(joined)}`;
};

/** A mesh, the circle of its middle triangle, and the radius. */
const emptyCircle: Draw = (module) => {
  const joined = joinedOf(module, given([[38, 58], [82, 58], [58, 12], [14, 26], [104, 22], [60, 75]]));
  const [triangle] = [...joined.triangles].sort((a, b) => Math.hypot(a.centre[0] - MIDDLE[0], a.centre[1] - MIDDLE[1]) - Math.hypot(b.centre[0] - MIDDLE[0], b.centre[1] - MIDDLE[1]));
  if (!triangle) return '';
  const { centre, radius, corners } = triangle;
  return `${edges(joined, 'stable')}${circle(centre, radius, 'bubble own')}${closed(corners, 'curve')}${line(centre, corners[0] ?? MIDDLE, 'now')}${dot(centre, 'here', 3)}${dots(joined)}`;
};

export const MESH_TERMS: Readonly<Record<string, Draw>> = {
  mesh,
  dual,
  lloyd,
  voronoi,
  'smallest-angle': smallest,
  median,
  delaunay,
  'empty-circle': emptyCircle,
};
