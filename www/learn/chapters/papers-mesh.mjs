// Papers and differences: from packed cells to a mesh, and from the mesh to cells.
import { at, JAPANESE, PAVEMENTS, SKINS } from './cite.mjs';

/** @type {import('./types.mjs').Difference[]} */
export const meshDifferences = [
  {
    key: 'hexahedral', chapter: 'mesh', isMisprint: true,
    heading: { en: 'A polygon with six corners', ja: '六つの角をもつ多角形' },
    from: at(SKINS, '5, fig. 3', '5章 図3'),
    printed: { text: { en: 'The result consists of “quadrilateral or hexahedral polygons”.', ja: '結果は「四角形または六面体（hexahedral）の多角形」からなる（原文は英語）。' } },
    ours: { text: { en: 'Quadrilaterals or hexagons.', ja: '四角形または六角形。' } },
    note: {
      en: 'A hexahedron is a solid with six faces, such as a cube. The figure shows hexagons, which are meant.',
      ja: '六面体は、立方体のように六つの面をもつ立体です。図にあるのは六角形で、それが正しい意味です。',
    },
    task: {
      question: { en: 'Six triangles meet at a bubble’s centre. How many corners has its cell?', ja: 'バブルの中心に六つの三角形が集まっています。そのセルの角はいくつですか。' },
      answer: { en: 'One in each triangle: six. The cell is a hexagon.', ja: '三角形ごとに一つなので、六つ。セルは六角形です。' },
    },
    see: { figure: 'dual', words: { en: 'A mesh and its cells', ja: 'メッシュとセル' } },
  },
  {
    key: 'centres', chapter: 'mesh',
    heading: { en: 'Voronoi cells, or nearly', ja: 'ボロノイ領域か、その仲間か' },
    from: at(SKINS, '5.2, figs. 3, 7', '5.2節 図3、図7'),
    printed: { text: { en: 'A pseudo-Voronoi tessellation joins “the center of each mesh element to the centers of all adjacent mesh elements”. The captions of the figures say Voronoi.', ja: '疑似ボロノイ分割は「各メッシュ要素の中心と、隣り合う要素の中心」を結ぶ。図の説明ではボロノイと呼んでいる（原文は英語）。' } },
    ours: { text: { en: 'A cell’s corner is the mean of an element’s corners. Where sizes differ, it lies farther from the larger cells. Voronoi cells are made, too, to compare (cells=voronoi).', ja: 'セルの角は、要素の頂点の平均に置きます。大きさが違えば、大きい粒子から遠ざけます。比較のために、ボロノイ領域も作れます（cells=voronoi）。' } },
    note: {
      en: 'The corners of a Voronoi cell are the centres of the circles through three points. In a triangle with an obtuse angle this centre lies outside. The mean, weighted or not, always lies inside. In an equilateral triangle both are one point: the better the points, the smaller the difference.',
      ja: 'ボロノイ領域の角は、三点を通る円の中心です。鈍角三角形では、その中心は三角形の外に出ます。頂点の平均は、重みを付けても必ず内側にあります。正三角形では、外接円の中心と頂点の平均は一致します。点の配置が良いほど、差は小さくなります。',
    },
    see: { figure: 'dual', words: { en: 'A mesh and its cells', ja: 'メッシュとセル' } },
  },
  {
    key: 'circumellipse', chapter: 'mesh',
    heading: { en: 'A circle for stretched cells', ja: '細長い粒子のための円' },
    from: at(SKINS, '5.2', '5.2節'),
    printed: { text: { en: 'The triangulation of elliptic cells “uses circumellipses defined by the user-given directionality and anisotropy, instead of circumcircles”.', ja: '楕円粒子の三角形分割では、外接円の代わりに、与えられた方向と異方性で決まる外接楕円を使う（原文は英語）。' } },
    ours: { text: { en: 'The circles come first. Then an edge is flipped if the angles that face it, measured as the stretched cells there see them, add up to more than 180°.', ja: 'まず外接円で結びます。次に、向かい合う角を、その場の細長い粒子の尺度で測り、和が180°を超える辺を入れ替えます。' } },
    note: {
      en: 'Where length and width are the same, both rules are the one with circles. Where the direction turns within a few cells, no ellipse fits all corners, and flips could go on for ever: ours stops after four for each triangle, on average.',
      ja: '縦横の長さが等しければ、どちらも外接円の規則と同じです。数個の粒子の間で方向が大きく変わるところでは、全部の頂点に合う楕円がなく、入れ替えが終わらないことがあります。本プログラムは、三角形一つあたり平均四回で打ち切ります。',
    },
    see: { link: 'v=1&outline=annulus&kind=ellipse&ca=2&cs=34&view=packed+mesh', words: { en: 'Ellipses and their mesh, in the studio', ja: '楕円とそのメッシュ（スタジオ）' } },
  },
  {
    key: 'no-voronoi', chapter: 'mesh',
    heading: { en: 'Why not Voronoi cells?', ja: 'なぜボロノイ分割ではないのか' },
    from: { en: `${PAVEMENTS.en}2.1; ${JAPANESE.en}2.1`, ja: `${PAVEMENTS.ja}2.1節。${JAPANESE.ja}2.1節` },
    printed: { text: { en: 'With the Voronoi diagram “it is difficult to align each divided subarea”; it is isotropic in general, and for isotropic stones it may take the place of the packing.', ja: '「一般に等方的な分割パターンの生成となり」、目的を満たさない。等方的な石畳なら、充填の代わりに使える。' } },
    ours: { text: { en: 'The packing. Voronoi cells of random points are there to compare, plain or evened out by Lloyd’s rounds (cells=voronoi, cells=lloyd).', ja: '充填を使います。比較のため、ランダムな点のボロノイ領域と、それをロイド法でならしたものも作れます（cells=voronoi、cells=lloyd）。' } },
    note: {
      en: 'Lloyd’s rounds make good triangles in the end, too, by many small steps. But a point that moves to the centre of gravity of its cell knows no direction, so no rows come of it.',
      ja: 'ロイド法も、少しずつ回数を重ねれば良い三角形になります。しかし、領域の重心へ動く点に向きはなく、列は生まれません。',
    },
    see: { figure: 'three', words: { en: 'Three ways to place points', ja: '点の三通りの置き方' } },
  },
];
