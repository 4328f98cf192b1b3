// Papers and differences: how directions are summed over the outline, and kept between the nodes of a grid.
import { at, JAPANESE, PAVEMENTS } from './cite.mjs';
import { arrowSum, fourFoldSum, lengthSum } from './sums.mjs';

/** @type {import('./types.mjs').Difference[]} */
export const directionDifferences = [
  {
    key: 'direction', chapter: 'which-way',
    heading: { en: 'Equation (1): the direction at a point', ja: '式(1)：一点での整列方向' },
    from: at(PAVEMENTS, '4.1, eq. (1), fig. 5', '4.1節 式(1) 図5'),
    printed: arrowSum,
    ours: fourFoldSum,
    note: {
      en: 'The segments run round the outline, so the two sides of a road have opposite arrows and cancel in its middle. Ours turns each arrow into its four-fold angle first, as a square looks the same after a quarter turn, and weights it along the whole segment. The printed weight takes the nearest place for all of a segment, so it changes when a side is cut into pieces; ours does not. The printed power is 2; ours is 4, and can be set to 2 or 3 (dp). Along a long wall the weights add up: with 2, a wall twice as far has half the weight, with 4 an eighth. So rows follow the nearer wall.',
      ja: '線分は輪郭を一周するので、道の両側の矢印は逆向きで、中央で打ち消し合います。正方形は90度回しても同じなので、本プログラムはまず角度を4倍し、線分全体に沿って重みをかけます。論文の重みは、線分全体を最も近い点の距離で測るため、辺を細かく切ると変わります。本プログラムの重みは変わりません。論文のべき指数は2、本プログラムは4で、2と3も選べます（dp）。長い壁に沿って重みを足すと、距離が2倍の壁の重みは、2なら2分の1、4なら8分の1になります。そのため、列は近いほうの壁に沿います。',
    },
    see: { figure: 'road', words: { en: 'Both sums in a road', ja: '道の中での二つの和' } },
  },
  {
    key: 'scalar-sum', chapter: 'which-way', isMisprint: true,
    heading: { en: 'The same equation with lengths: a sum without direction', ja: '同じ式で、長さの和：向きのない和' },
    from: at(JAPANESE, '4, eq. (1)', '4章 式(1)'),
    printed: lengthSum,
    ours: fourFoldSum,
    note: {
      en: 'The text says that |s| is the length of a segment. Lengths are numbers, so their sum is a number, and no vector v can come of it. The paper of 2000 has the vectors themselves.',
      ja: '本文によれば|s|は線分の長さです。長さは数なので、和も数になり、ベクトルvは得られません。2000年の論文では、線分のベクトルそのものを足しています。',
    },
    task: {
      question: { en: 'A point stands in the middle of a square. Work out both sums of (1), with lengths and with vectors.', ja: '正方形の中心に点があります。式(1)の和を、長さの場合とベクトルの場合について求めましょう。' },
      answer: { en: 'With side s and distance s/2 each term is 4/s: lengths give 4/s, a number; the four vectors go round and give 0. Neither tells a direction. In the figure each term has a quarter of the whole.', ja: '辺をs、距離をs/2とすると各項の大きさは4/s。長さの和は数4/sになり、四つのベクトルは一周して0になります。どちらからも向きは分かりません。図では、各項の長さは全体の4分の1です。' },
    },
    see: { link: 'fig=pieces&outline=polygon&size=256&kind=square&poly=0.4,0.4,0.6,0.4,0.6,0.6,0.4,0.6&at=0.5,0.5', words: { en: 'Four equal lengths in the middle of a square, and the sum of the vectors', ja: '正方形の中心での等しい四つの長さと、ベクトルの和' } },
  },
  {
    key: 'between-nodes', chapter: 'which-way',
    heading: { en: 'Between the nodes of the grid', ja: '格子点の間' },
    from: at(PAVEMENTS, '4.1', '4.1節'),
    printed: { text: { en: 'Directions are stored at the nodes of a background grid. Inside a grid cell the direction is “calculated by linearly interpolating the directions at the four grid nodes”.', ja: '整列方向は背景格子の節点に置き、格子の内側では四つの節点の方向を線形補間する（原文は英語）。' } },
    ours: { text: { en: 'The four-fold arrows are stored and interpolated, and the angle is divided by four at the end.', ja: '角度を4倍した矢印を節点に置いて補間し、最後に角度を4で割ります。' } },
    note: {
      en: 'Two nodes on either side of a road’s middle line have opposite arrows, although their squares look alike. Halfway between them the interpolated arrow is 0, or points anywhere. The four-fold arrows of both nodes are the same.',
      ja: '道の中央線をはさむ二つの節点では、正方形は同じ向きなのに矢印は逆向きです。補間した矢印は、その間で0になるか、思わぬ向きになります。角度を4倍した矢印なら、二つの節点で一致します。',
    },
    see: { figure: 'halfway', words: { en: 'Halfway between two directions', ja: '二つの方向の中間' } },
  },
];
