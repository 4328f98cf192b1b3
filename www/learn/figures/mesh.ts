/**
 * The figures of chapter 3, "From bubbles to a mesh" (Itoh, Miyata and Shimada, Generating Organic Textures with Controlled
 * Anisotropy and Directionality, 2003, sections 5 and 5.2; Miyata, Itoh and Shimada, A Method for Generating Pavement Textures
 * Using the Square Packing Technique, 2001, section 2.1). Points by hand are given bubbles without walls, before any step.
 */
import { AT_REST, ofFirst, restOf } from './crowds';
import type { AngleRow, Ask, Figure, Language, NumberHandle, PointHandle, Seen, Stop, Trace, Words } from './figure';
import { acrossOf, edgesAt, isInner, leastOf, lengthOf, nearestEdge, nearestPoint, sumOf, worstOf, type JoinedCells } from './joined';
import { DAMPING, inWords, joined, number, sentence, START } from './words';

const SHARES: Words = { en: 'picture sides', ja: '（画像の一辺を1とする）' };

const point = { kind: 'point', unit: SHARES, origin: [0, 0], scale: 1, from: 0, to: 1, stride: 0.01, fine: 0.002, coarse: 0.1, digits: 3, plates: [0] } as const;

const LOOK: PointHandle = { ...point, key: 'at', name: { en: 'Look at', ja: '見るところ' } };
/** The outline begins at 0.047: a point outside of it is not there. */
const POINT: PointHandle = { ...point, key: 'given', name: { en: 'Point', ja: '点' }, from: 0.05, to: 0.95, fine: 0.001 };

const counted = { kind: 'number', unit: { en: '', ja: '' }, symbol: '', stride: 1, fine: 1, coarse: 10, digits: 0 } as const;

const ROUNDS: NumberHandle = { ...counted, key: 'rounds', name: { en: 'Lloyd’s rounds', ja: 'ロイド法の回数' }, from: 0, to: 50 };
const SEED: NumberHandle = { ...counted, key: 'seed', name: { en: 'Other points', ja: '別の点' }, from: 1, to: 99 };
const SIZE: NumberHandle = { ...counted, key: 'cs', name: { en: 'Cell size', ja: 'セルの大きさ' }, unit: { en: 'pixels', ja: 'ピクセル' }, stride: 2, fine: 1, from: 32, to: 64 };

/** The reader's marks, with the rows that they stand in. */
const ROWS: readonly AngleRow[] = [
  { name: { en: 'Random', ja: 'ランダム' }, letter: 'R', packing: 0, always: 0 },
  { name: { en: 'Lloyd', ja: 'ロイド法' }, letter: 'L', packing: 1, always: 0 },
  { name: { en: 'Packed', ja: '充填' }, letter: 'P', packing: 0 },
];

const MARKS: readonly NumberHandle[] = ROWS.map(({ letter }, k) => ({
  kind: 'number', key: k ? `mark-${k}` : 'mark', symbol: letter, name: { en: 'Mark', ja: '印' },
  unit: { en: 'degrees', ja: '度' }, from: 0, to: 60, stride: 1, fine: 0.5, coarse: 10, digits: 1, plates: [3],
}));

/** A layer with a name. */
const layer = (key: string, step: number, en: string, ja: string): Stop => ({ key, name: { en, ja }, find: () => step });

/** The step at which the packing rests. */
const RESTS: Stop = { ...AT_REST, find: ofFirst(restOf) };

const joinedOf = ({ traces: [trace] }: Seen): JoinedCells | undefined => trace?.joined(0);

/** The layers in words. */
const LAYERS: readonly Words[] = [
  { en: 'Shown are the bubbles.', ja: 'バブルだけを見せています。' },
  { en: 'Shown is the mesh of their centres.', ja: '中心を結んだメッシュを見せています。' },
  { en: 'Shown is one cell in the mesh.', ja: 'メッシュの上に、一つのセルを見せています。' },
  { en: 'Shown are one cell and those around it.', ja: '一つのセルと、そのまわりのセルを見せています。' },
  { en: 'Shown are all cells.', ja: 'すべてのセルを見せています。' },
];

function toldDual(seen: Seen, language: Language): string {
  const [trace] = seen.traces;
  const made = trace?.joined(seen.step);
  const own = made && nearestPoint(made, seen.at);
  if (!made || own === undefined) return '';
  const inner = [...made.points.keys()].filter((id) => isInner(made, id));
  const six = inner.filter((id) => edgesAt(made, id) === 6).length;
  const [n, edges, sides] = [made.points.size, edgesAt(made, own), (made.cells.get(own)?.length ?? 0) / 2];
  const all = inWords(language, `${n} bubbles and ${n} cells.`, `バブルは${n}個、セルも${n}個です。`);
  const one = isInner(made, own)
    ? inWords(language, `The marked bubble has ${edges} edges, and its cell ${sides} sides.`, `印のバブルには${edges}本の辺が集まり、そのセルは${sides}角形です。`)
    : inWords(language, 'The marked bubble is at the border, where the outline cuts its cell.', '印のバブルは縁にあり、セルは輪郭で切られています。');
  const most = inWords(language, `Of the ${inner.length} bubbles inside, ${six} have six edges.`, `内側の${inner.length}個のうち、${six}個には辺が六本あります。`);
  const layer = LAYERS[seen.step];
  return joined(language, all, layer?.[language] ?? '', one, most, inWords(language, 'Look at another bubble, or go through the layers.', 'ほかのバブルを見るか、層を順に重ねてみてください。'));
}

/** The medians of the three rows. */
function mediansOf({ traces, step }: Seen): number[] {
  return ROWS.map(({ packing, always }) => traces[packing]?.joined(always ?? step).median ?? 0);
}

const roundsOf = ({ traces: [trace] }: Seen): number => Number(trace?.value('rounds') ?? 0);

/** Whether the packing rests at this step. */
const isAtRest = ({ traces: [trace], step }: Seen): boolean => trace !== undefined && step >= (restOf(trace) ?? Infinity);

/** Rounds after which Lloyd's points are even. */
const ENOUGH = 20;

const middles: Ask = {
  key: 'middles',
  answers: {},
  ...sentence<[r: string, l: string, p: string, marks: readonly string[]]>(
    (seen) => {
      if (roundsOf(seen) < ENOUGH || !isAtRest(seen)) return undefined;
      const [r = 0, l = 0, p = 0] = mediansOf(seen);
      const marks = seen.at.some((angle) => angle > 0) ? seen.at.map((angle) => (angle > 0 ? number(angle, 0) : '–')) : [];
      return [number(r, 0), number(l, 0), number(p, 0), marks];
    },
    [['00', '00', '00', ['00', '00', '00']]],
    (language, r, l, p, marks) =>
      joined(
        language,
        inWords(language, `The middles: random ${r}°, Lloyd ${l}°, packed ${p}°.`, `中央値は、ランダム${r}°、ロイド法${l}°、充填${p}°でした。`),
        marks.length ? inWords(language, `You marked ${marks.join(', ')}.`, `あなたの印は${marks.join('、')}です。`) : '',
        inWords(language, 'The same rule joined all three: only the places differ.', '結び方は三つとも同じで、違うのは点の場所だけです。'),
      ),
  ),
};

function toldThree(seen: Seen, language: Language): string {
  const { traces: [trace], step } = seen;
  const [r, l, p] = mediansOf(seen).map((angle) => number(angle, 1));
  const n = trace?.joined(0).points.size ?? 0;
  const now = isAtRest(seen) ? inWords(language, 'at rest', '静止') : inWords(language, `at step ${step}`, `${step}ステップ`);
  const stand = inWords(
    language,
    `${n} points each. Half of the triangles have a smallest angle below ${r}° at random, below ${l}° after ${roundsOf(seen)} of Lloyd’s rounds, and below ${p}° in the packing ${now}.`,
    `点はどれも${n}個です。最小角の中央値は、ランダムで${r}°、ロイド法${roundsOf(seen)}回で${l}°、充填（${now}）で${p}°です。`,
  );
  const isDone = roundsOf(seen) >= ENOUGH && isAtRest(seen);
  return joined(language, stand, isDone ? inWords(language, 'Try other points.', '別の点でも試してください。') : inWords(language, 'Set your marks, raise the rounds to 20, and let the bubbles come to rest.', '印を付けてから、回数を20に上げ、バブルを静止まで動かしてください。'));
}

const flip: Ask = {
  key: 'flip',
  answers: {
    a: { en: 'it flips when the other diagonal is the shorter one', ja: 'もう一方の対角線のほうが短くなったとき' },
    b: { en: 'it flips when all four corners lie on one circle', ja: '四つの頂点が一つの円周上に並んだとき' },
    c: { en: 'it flips when a point runs into an edge', ja: '点が辺にぶつかったとき' },
  },
  ...sentence<[sum: string, was: string, is: string, isLonger: boolean]>(
    ({ traces: [trace] }) => {
      const found = trace?.flip;
      if (!found) return undefined;
      const { points, before, sum } = found;
      const [was, is] = [lengthOf(points, before.ends), lengthOf(points, acrossOf(before))];
      return [number(sum, 1), number(was, 3), number(is, 3), is > was];
    },
    [['000.0', '0.000', '0.000', true], ['000.0', '0.000', '0.000', false]],
    (language, sum, was, is, isLonger) =>
      joined(
        language,
        inWords(
          language,
          `The edge flipped where its facing angles reached ${sum}°: all four corners lay on one circle.`,
          `向かい合う角の和が${sum}°になったとき、辺が入れ替わりました。四つの頂点は一つの円の上にありました。`,
        ),
        isLonger
          ? inWords(language, `The new edge is ${is} long, the old one ${was}: the longer one won.`, `新しい辺の長さは${is}、元の辺は${was}で、長いほうが選ばれています。`)
          : inWords(language, `The new edge is ${is} long, the old one ${was}: the shorter one won, by chance.`, `新しい辺の長さは${is}、元の辺は${was}です。今回はたまたま短いほうが選ばれました。`),
      ),
  ),
};

function toldFlip(seen: Seen, language: Language): string {
  const made = joinedOf(seen);
  const edge = made && nearestEdge(made, [seen.at[0] ?? 0, seen.at[1] ?? 0]);
  if (!made || !edge) return '';
  const [a, b] = edge.facing.map(({ angle }) => number(angle, 1));
  const [sum, own, other] = [number(sumOf(edge), 1), number(lengthOf(made.points, edge.ends), 3), number(lengthOf(made.points, acrossOf(edge)), 3)];
  const [p, q] = edge.ends;
  return joined(
    language,
    inWords(language, `${made.points.size} points, ${made.triangles.length} triangles.`, `点は${made.points.size}個、三角形は${made.triangles.length}個です。`),
    inWords(
      language,
      `The marked edge joins points ${p + 1} and ${q + 1}. The angles that face it are ${a}° and ${b}°, together ${sum}°. It is ${own} long, the other diagonal ${other}.`,
      `印の辺は点${p + 1}と点${q + 1}を結びます。向かい合う角は${a}°と${b}°で、和は${sum}°です。長さは${own}、もう一方の対角線は${other}です。`,
    ),
    inWords(language, 'Move one of its four corners slowly, or look at another edge.', '四つの頂点の一つをゆっくり動かすか、別の辺を見てください。'),
  );
}

/** Angles below this, and two points nearer than this, are as bad as the question asks for. */
const THIN = 5;
const NEAR = 0.04;

/** The least distance of two joined points. */
const apartOf = ({ triangles }: JoinedCells): number => Math.min(...triangles.map(({ shortest }) => shortest));

const good: Ask = {
  key: 'good',
  answers: { a: { en: 'it stays above 30°', ja: '30°より大きいまま' }, b: { en: 'it goes towards 0°', ja: '0°に近づく' } },
  ...sentence<[apart: string, angle: string]>(
    (seen) => {
      const made = joinedOf(seen);
      return !made || leastOf(made) >= THIN || apartOf(made) >= NEAR ? undefined : [number(apartOf(made), 3), number(leastOf(made), 1)];
    },
    [['0.000', '00.0']],
    (language, apart, angle) =>
      inWords(
        language,
        `${apart} apart, and the smallest angle is ${angle}°. Delaunay’s edges are the best ones here: no other way to join these points is better.`,
        `間隔${apart}で、最小角は${angle}°です。それでもドロネーの辺は最良で、この点ではどう結んでもこれより良くなりません。`,
      ),
  ),
};

/** The smallest angle that the exercise asks for. */
const WANTED = 30;

/** The point that is moved, counted from 0. */
const MOVED = 9;

/** The hole among the eleven points that stay: its middle and its radius, in shares of the picture's side. */
const HOLE = { x: 0.61, y: 0.6, radius: 0.2 } as const;

const place: Ask = {
  key: 'place',
  answers: {},
  ...sentence<[angle: string, isInHole: boolean]>(
    (seen) => {
      const made = joinedOf(seen);
      const [x, y] = made?.points.get(MOVED) ?? [];
      if (!made || x === undefined || y === undefined || leastOf(made) < WANTED) return undefined;
      return [number(leastOf(made), 1), Math.hypot(x - HOLE.x, y - HOLE.y) < HOLE.radius];
    },
    [['00.0', true], ['00.0', false]],
    (language, angle, isInHole) =>
      joined(
        language,
        inWords(language, `Done: the smallest angle is ${angle}° now.`, `できました。最小角は${angle}°です。`),
        isInHole
          ? inWords(language, 'The point has gone into the hole, where a bubble would come.', '点は穴の中、バブルなら増えるはずの場所に入りました。')
          : inWords(language, 'In the hole, where a bubble would come, it would be larger.', 'バブルなら増えるはずの穴の中では、もっと大きくなります。'),
      ),
  ),
};

/** The triangle with the smallest angle, in words. */
const toldLeast = (hint: Words) => (seen: Seen, language: Language): string => {
  const made = joinedOf(seen);
  const worst = made && worstOf(made);
  if (!made || !worst) return '';
  const [angle, s, radius] = [number(leastOf(made), 1), number(worst.shortest, 3), number(worst.radius, 3)];
  return joined(
    language,
    inWords(language, `${made.points.size} points, ${made.triangles.length} triangles. The smallest angle of all is ${angle}°.`, `点は${made.points.size}個、三角形は${made.triangles.length}個です。最小角は${angle}°です。`),
    inWords(language, `In that triangle the shortest side is ${s}, and the radius of the circle ${radius}.`, `その三角形の最も短い辺は${s}、外接円の半径は${radius}です。`),
    hint[language],
  );
};

/** Points by hand, as many as the figure has. */
const isByHand = (count: number) => (trace: Trace): boolean => trace.points('given').length === count && trace.value('pop') === 'off' && trace.value('edge') === 'open' && trace.value('kind') === 'circle';

/** Points as bubbles without walls; two that are near each other stay where they are, as no step is made. */
const byHand = (places: string): string => `outline=square&size=256&kind=circle&cs=12&edge=open&pop=off&given=${places.split(' ').map((xy) => `${xy},0`).join(';')}`;

const BY_HAND = { fits: isByHand(12), packings: [{}], last: 0, opens: 0, steps: 'step', stops: [], more: [] } as const;

const FREE_PLATES: Figure['plates'] = [
  { draw: 'delaunay', packing: 0, marked: 'smallest', title: { en: 'Twelve points', ja: '十二個の点' } },
  { draw: 'inscribed', packing: 0, title: { en: 'The thinnest triangle, magnified', ja: 'いちばん細い三角形（拡大）' } },
];

const isCrowd = ({ value }: Trace): boolean => value('kind') === 'circle' && value('outline') === 'square' && Number(value('size')) === 256;

export const MESHES: readonly Figure[] = [
  {
    name: 'dual', fits: (trace) => isCrowd(trace) && Number(trace.value('cs')) >= 32, at: [0.5, 0.5], recipe: 'outline=square&size=256&kind=circle&cs=38&seed=2&start=random&damp=1',
    packings: [{}], last: 4, opens: 4, steps: 'layer', plates: [{ draw: 'dual', packing: 0 }],
    stops: [layer('bubbles', 0, 'Bubbles', 'バブル'), layer('mesh', 1, 'Mesh', 'メッシュ'), layer('one', 2, 'One cell', '一つ'), layer('around', 3, 'Around it', 'まわり'), layer('all', 4, 'All', 'すべて')],
    handles: [LOOK], more: [SIZE, SEED], asks: [], told: toldDual,
  },
  {
    name: 'three', fits: (trace) => isCrowd(trace) && Number(trace.value('cs')) >= 24 && trace.value('start') === 'random' && Number(trace.value('count')) <= 80, at: [0, 0, 0],
    recipe: 'outline=square&size=256&kind=circle&cs=28&seed=1&start=random&count=72&pop=off&damp=1&rounds=4', packings: [{}, { cells: 'lloyd', most: '1' }],
    last: 200, opens: 5, steps: 'step', joinsFirst: true,
    plates: [
      { draw: 'mesh', packing: 0, always: 0, title: { en: 'At random', ja: 'ランダム' } },
      { draw: 'mesh', packing: 1, always: 0, title: { en: 'Lloyd', ja: 'ロイド法' }, note: (seen, language) => inWords(language, `${roundsOf(seen)} ${roundsOf(seen) === 1 ? 'round' : 'rounds'}`, `${roundsOf(seen)}回`) },
      { draw: 'mesh', packing: 0, title: { en: 'Packed', ja: '充填' }, note: (seen, language) => (isAtRest(seen) ? inWords(language, 'at rest', '静止') : inWords(language, `step ${seen.step}`, `${seen.step}ステップ`)) },
      { draw: 'angles', packing: 0, angles: ROWS, title: { en: 'Triangles by their smallest angle', ja: '最小角ごとの三角形の数' }, note: (_seen, language) => inWords(language, 'line: the middle', '線：中央値') },
    ],
    stops: [START, RESTS], handles: [ROUNDS, ...MARKS], more: [SEED, DAMPING], asks: [middles], told: toldThree,
  },
  {
    name: 'flip', ...BY_HAND, at: [0.515, 0.3], hasFlips: true,
    recipe: byHand('0.86,0.52 0.74,0.8 0.46,0.87 0.2,0.72 0.13,0.45 0.28,0.19 0.6,0.13 0.82,0.28 0.42,0.42 0.62,0.36 0.38,0.66 0.66,0.62'),
    plates: [
      { draw: 'delaunay', packing: 0, marked: 'edge', title: { en: 'Twelve points', ja: '十二個の点' } },
      { draw: 'facing', packing: 0, title: { en: 'The angles that face the edge', ja: '辺に向かい合う角' } },
    ],
    handles: [LOOK, POINT], asks: [flip], told: toldFlip,
  },
  {
    name: 'close', ...BY_HAND, at: [], plates: FREE_PLATES,
    recipe: byHand('0.868,0.496 0.786,0.739 0.569,0.863 0.32,0.809 0.155,0.613 0.152,0.374 0.312,0.197 0.56,0.153 0.78,0.265 0.589,0.613 0.363,0.526 0.546,0.36'),
    handles: [POINT], asks: [good], told: toldLeast({ en: 'Push two points together.', ja: '二つの点を近づけてください。' }),
  },
  {
    name: 'place', ...BY_HAND, at: [], plates: FREE_PLATES,
    recipe: byHand('0.879,0.491 0.798,0.748 0.577,0.873 0.32,0.806 0.147,0.601 0.14,0.37 0.302,0.207 0.557,0.162 0.785,0.26 0.5,0.35 0.365,0.53 0.543,0.349'),
    handles: [{ ...POINT, rows: [MOVED] }], asks: [place], told: toldLeast({ en: 'Move point 10 to a better place.', ja: '点10を、もっと良い場所へ動かしてください。' }),
  },
];
