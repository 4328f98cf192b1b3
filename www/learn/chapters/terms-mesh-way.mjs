// The terms of chapters 3 and 5, in the order in which the chapters use them.

/** @type {import('./types.mjs').Term[]} */
export const meshTerms = [
  {
    key: 'mesh', chapter: 'mesh',
    name: { en: 'mesh', ja: 'メッシュ' },
    text: { en: 'Points joined by edges to triangles or quadrilaterals, which are its elements and fill an area without overlap.', ja: '点を辺で結び、領域を三角形や四角形（要素）で重なりなく埋めたもの。点は節点ともいう。' },
  },
  {
    key: 'dual', chapter: 'mesh',
    name: { en: 'dual', ja: '双対' },
    text: { en: 'The mesh turned inside out: a corner for each element, a cell for each point, and across each edge a side.', ja: 'メッシュを裏返したもの。要素ごとに角、点ごとにセルがあり、辺ごとに、それと交わる辺が一本ある。' },
  },
  {
    key: 'lloyd', chapter: 'mesh',
    name: { en: 'Lloyd’s rounds (relaxation)', ja: 'ロイド法' },
    text: { en: 'Every point moves to the centre of gravity of its Voronoi cell; then again, and again. It evens points out.', ja: 'どの点も自分のボロノイ領域の重心へ動かす、をくり返す方法。点の配置が均等になっていく。' },
  },
  {
    key: 'voronoi', chapter: 'mesh',
    name: { en: 'Voronoi cell', ja: 'ボロノイ領域' },
    text: { en: 'All places that are nearer to this point than to any other.', ja: 'ほかのどの点よりも、その点に近い場所の全体。' },
  },
  {
    key: 'smallest-angle', symbol: 'gamma', chapter: 'mesh',
    name: { en: 'smallest angle', ja: '最小角' },
    text: { en: 'That of one triangle, 60° at most. The larger it is, the better the triangle serves a mesh.', ja: '一つの三角形の最も小さい角。最大でも60°。大きいほど、メッシュに良い三角形。' },
  },
  {
    key: 'median', chapter: 'mesh',
    name: { en: 'median (the middle)', ja: '中央値' },
    text: { en: 'Half of all values lie below it, half above.', ja: '値を小さい順に並べたときの真ん中の値。半数がそれより下にある。' },
  },
  {
    key: 'delaunay', symbol: 'alpha', chapter: 'mesh',
    name: { en: 'Delaunay’s triangulation', ja: 'ドロネー三角形分割' },
    text: { en: 'The way to join points to triangles in which every circle through a triangle’s corners is empty.', ja: 'どの三角形の外接円の中にもほかの点がないような、点の結び方。' },
  },
  {
    key: 'empty-circle', symbol: 'R', chapter: 'mesh',
    name: { en: 'empty circle (circumcircle)', ja: '空円（外接円）' },
    text: { en: 'The circle through the three corners of a triangle, with no point inside. Its radius is the size of a hole.', ja: '三角形の三つの頂点を通り、中にほかの点がない円。半径は穴の大きさを表す。' },
  },
];

/** @type {import('./types.mjs').Term[]} */
export const wayTerms = [
  {
    key: 'four-fold', symbol: 'v4', chapter: 'which-way',
    name: { en: 'four-fold arrow', ja: '四倍角の矢印' },
    text: { en: 'An arrow at four times the angle of a direction. Directions that are a quarter turn apart have the same one.', ja: '向きの角度を4倍した矢印。90°ずつ違う向きは、同じ矢印になる。' },
  },
  {
    key: 'direction-field', symbol: 'v', chapter: 'which-way',
    name: { en: 'direction field', ja: 'ベクトル場（整列方向）' },
    text: { en: 'A direction at each place, which the sides of the squares there follow.', ja: '各点で定まる向き。四角形粒子の辺がそれに従って整列する。' },
  },
  {
    key: 'segment', symbol: 'si', chapter: 'which-way',
    name: { en: 'segment', ja: '線分' },
    text: { en: 'A straight piece of the outline, as an arrow. All of them run round the outline one after another.', ja: '領域境界線を作るまっすぐな一本。矢印とみなし、順につなぐと輪郭を一周する。' },
  },
  {
    key: 'certainty', symbol: 'v4', chapter: 'which-way',
    name: { en: 'certainty', ja: '確かさ' },
    text: { en: 'The length of a sum of arrows over the lengths of its terms: 1 if all agree, 0 if they cancel.', ja: '矢印の和の長さを、各項の長さの合計で割った値。すべて一致すれば1、打ち消し合えば0。' },
  },
  {
    key: 'singular-point', chapter: 'which-way',
    name: { en: 'singular point', ja: '特異点' },
    text: { en: 'A place without a direction. Around it rows of squares cannot all agree.', ja: '向きの定まらない点。そのまわりでは、列の向きが合わなくなる。' },
  },
  {
    key: 'index', symbol: 'q', chapter: 'which-way',
    name: { en: 'index', ja: '指数' },
    text: { en: 'By how much the direction turns on one walk around, in whole turns. Positive: the way the walk goes. With q quarter turns it is q/4.', ja: '一周する間に向きが回った量。一回転を1とし、道筋と同じ回り方なら正。90°回転がq回分なら、指数はq/4。' },
  },
  {
    key: 'stroke', chapter: 'which-way',
    name: { en: 'stroke', ja: '線（ストローク）' },
    text: { en: 'A painted line that rows of squares follow. It acts as a segment does.', ja: '列を導くために引いた線。線分と同じように働く。' },
  },
];
