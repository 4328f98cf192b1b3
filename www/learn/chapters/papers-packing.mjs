// Papers and differences, continued: corner potentials, motion, placement, population.
import { at, JAPANESE, PAVEMENTS, SKINS } from './cite.mjs';
import { row, under } from './math.mjs';

const CORNERS = row('psi = psi0 + cw ( psi1 + psi2 + psi3 + psi4 )');
const CORNERS_SPEECH = {
  en: 'psi equals psi P zero plus root 2 minus 1, times the sum of psi P one, psi P two, psi P three and psi P four.',
  ja: 'プサイは、プサイ・ピー・ゼロ、足す、かっこルート2引く1かける、プサイ・ピー・いち、ピー・に、ピー・さん、ピー・よんの和。',
};

/** @type {import('./types.mjs').Difference[]} */
export const packingDifferences = [
  {
    key: 'corners', chapter: 'squares', isMisprint: true,
    heading: { en: 'Equation (4): what is added to what', ja: '式(4)：何に何を足すのか' },
    from: { en: `${PAVEMENTS.en}4.2, eq. (4); ${SKINS.en}5.1`, ja: `${PAVEMENTS.ja}4.2節 式(4)。${SKINS.ja}5.1節` },
    printed: { math: CORNERS, speech: CORNERS_SPEECH },
    ours: {
      math: row('root2 r0 = cr r0 + r0'),
      speech: { en: 'Root 2 r zero equals root 2 minus 1, times r zero, plus r zero.', ja: 'ルート2アール・ゼロは、かっこルート2引く1アール・ゼロ足すアール・ゼロ。' },
    },
    note: {
      en: 'The equation stands as it is; ours adds what its radius means. The text of 2003 adds the corners “to the original potential field Ψ”, where it means the central one. The paper gives a corner bubble the radius $cr r0$; we read from it that a corner and a neighbour’s centre are at rest at $root2 r0$, their distance when the edges touch. A corner has the pair’s $k0 / l0$, so its potential is 1/√2 of the one in the centre. For two sizes ours takes the mean of both views.',
      ja: '式はこのままで、半径の意味だけを補います。2003年の本文は四隅を「もとのポテンシャル場Ψに」足すと書いていますが、もとの場は中央のΨのことです。論文は四隅のバブルの半径を$cr r0$とします。これを、隅と隣の中心とがつり合う距離が$root2 r0$、つまり辺が触れ合うときの距離になる、と読みました。隅の強さは対の$k0 / l0$なので、そのポテンシャルは中央の1/√2倍です。大きさが違う対では、両方から見た平均をとります。',
    },
    task: {
      question: { en: 'A square with half side $r0$ touches another along an edge. How far is its centre from the nearest corner of the other?', ja: '一辺の半分が$r0$の正方形が、もう一つと辺で触れ合っています。その中心から、相手の最も近い隅までの距離は。' },
      answer: { en: '$r0$ along and $r0$ across: $root2 r0$.', ja: '縦に$r0$、横に$r0$なので、$root2 r0$です。' },
    },
    see: { figure: 'wells', words: { en: 'The landscape round a square', ja: '正方形のまわりの地形' } },
  },
  {
    key: 'five-forces', chapter: 'squares',
    heading: { en: 'Five forces, or five potentials?', ja: '足すのは五つの力か、五つのポテンシャルか' },
    from: at(JAPANESE, '4, fig. 5', '4章 図5'),
    printed: { text: { en: 'The repulsion is five cubic functions laid over each other, with maxima at the centre and the four corners.', ja: '斥力は「四角形粒子の中心点および4頂点に極大点を持つ5個の3次関数を重ね合わせたもの」。' } },
    ours: { math: CORNERS, speech: CORNERS_SPEECH },
    note: {
      en: 'Forces have directions: their five strengths, added as numbers, are no force. Potentials are numbers, and may be added. They are of the fourth degree; the force is the slope of their sum.',
      ja: '力には向きがあるので、五つの強さを数として足しても力にはなりません。ポテンシャルは数なので足せます。こちらは4次関数で、その和の傾きが力です。',
    },
    see: { figure: 'wells', words: { en: 'The sum, as contours', ja: '重ね合わせの等値曲線' } },
  },
  {
    key: 'motion', chapter: 'many-bubbles',
    heading: { en: 'Equation (5): the motion, and its end', ja: '式(5)：運動とその終わり' },
    from: { en: `${PAVEMENTS.en}4.3, eq. (5); ${SKINS.en}5.1`, ja: `${PAVEMENTS.ja}4.3節 式(5)。${SKINS.ja}5.1節` },
    printed: {
      math: `${row('m x..i ( t ) + c x.i ( t ) = Fi ( t ) ,')}<mspace width="0.6em"/><mrow><mi>i</mi><mo>=</mo><mn>1</mn><mo>,</mo><mo>…</mo><mo>,</mo><mi>n</mi></mrow>`,
      speech: { en: 'm times the acceleration of x i, plus c times the velocity of x i, equals the force f i, for i from 1 to n.', ja: 'エムかけるエックス・アイの加速度、足すシーかけるエックス・アイの速度、イコール力エフ・アイ。アイは1からエヌまで。' },
    },
    ours: { text: { en: 'The same equation, solved by semi-implicit Euler. The run ends when all forces and all moves are small, after 200 steps at the latest. From step 101 on the steps become shorter, and small moves are enough. A look at the population that changes it puts off the end.', ja: '同じ式を半陰的オイラー法で解きます。すべての力と移動量が小さくなれば終わり、遅くとも200ステップで終わります。101ステップ目からは刻みを短くしていき、移動量が小さければ終わります。個数の調査で増減があれば、まだ終わりません。' } },
    note: {
      en: 'The papers take Runge–Kutta, and end when the displacements of an iteration are small. Near a turning point a swinging cell moves little, so ours asks for small forces, too. The figures of the chapters leave out shorter steps and other help.',
      ja: '論文はルンゲ・クッタ法を使い、一回の反復での移動量が小さくなれば終わります。揺れるセルは折り返しでもほとんど動かないので、本プログラムは力も小さいことを求めます。章の図では、刻みを短くするなどの工夫を外しています。',
    },
    see: { figure: 'energy', words: { en: 'The energies of a run', ja: '計算中のエネルギー' } },
  },
  {
    key: 'walls', chapter: 'many-bubbles',
    heading: { en: 'Cells on the boundary', ja: '領域境界線上の粒子' },
    from: at(JAPANESE, '4', '4章'),
    printed: { text: { en: 'Particles are put on the boundary lines, too, and these do not move.', ja: '「領域境界線上の粒子は不動であり、領域内部の粒子は可動である」。' } },
    ours: { text: { en: 'By default a soft wall keeps the edges of the cells on the boundary, by the curve of a pair and twice as strong, and every cell moves. Walls then have an energy of their own.', ja: '既定では、対と同じ曲線で二倍の強さの柔らかい壁が、セルの縁を境界線上に保ち、すべてのセルが動きます。そのため、壁のエネルギーも数えます。' } },
    note: {
      en: 'Fixed particles (edge=on) fit triangle meshes, whose nodes lie on the boundary. Stones should end there instead.',
      ja: '固定した粒子（edge=on）は、境界線上に節点をもつ三角形メッシュに向いています。石は境界で終わるほうが自然です。',
    },
    see: { figure: 'crowd', words: { en: 'A crowd between walls', ja: '壁に囲まれた群れ' } },
  },
  {
    key: 'octree', chapter: 'how-many', isMisprint: true,
    heading: { en: 'An octree in a plane', ja: '平面の八分木' },
    from: at(PAVEMENTS, '4.3', '4.3節'),
    printed: { text: { en: 'The first cells come from “octree subdivision”.', ja: '最初の配置は「octree（八分木）による分割」で作る。' } },
    ours: { text: { en: 'A quadtree (start=quadtree); by default a front that follows the rows.', ja: '四分木を使います（start=quadtree）。既定では、列に沿って前線を進めて置きます。' } },
    note: {
      en: 'Halving a box in each direction makes eight parts in space, and four in a plane. The pavement is plane, so the tree has four children at each node.',
      ja: '箱を各方向に半分にすると、空間では八つ、平面では四つになります。石畳は平面なので、木の節点から出る枝は四本です。',
    },
    task: {
      question: { en: 'How many parts has a square after three halvings in both directions?', ja: '正方形を縦横に半分にすることを三回くり返すと、いくつに分かれますか。' },
      answer: { en: '4 × 4 × 4 = 64; eight children at a node would give 512.', ja: '4 × 4 × 4 = 64個です。八分木なら512個になります。' },
    },
    see: { link: 'v=1&outline=plaza&start=quadtree&view=packed&step=0', words: { en: 'Cells at first from a quadtree, in the studio', ja: '四分木による最初の配置（スタジオ）' } },
  },
  {
    key: 'population', chapter: 'how-many',
    heading: { en: 'Who comes, and who goes', ja: '増やす規則、減らす規則' },
    from: { en: `${PAVEMENTS.en}4.3; ${SKINS.en}5.1`, ja: `${PAVEMENTS.ja}4.3節。${SKINS.ja}5.1節` },
    printed: {
      math: `${under('min', 'j')}${row('wij > b')}<mo>,</mo><mspace width="0.6em"/>${under('min', 'j')}${row('wij < a')}`,
      speech: { en: 'A cell comes beside i if the smallest w i j is greater than b; i goes if the smallest w i j is less than a.', ja: 'ダブリュー・アイ・ジェーの最小値がビーより大きければ、アイのそばに増やす。エーより小さければ、アイを減らす。' },
    },
    ours: {
      math: `${under('min', 'j')}${row('wp ≥ b')}<mo>,</mo><mspace width="0.6em"/>${under('min', 'j')}${row('wij < a')}`,
      speech: { en: 'A cell comes at a place p if the smallest w p j is at least b; i goes if the smallest w i j is less than a.', ja: '場所ピーでのダブリュー・ピー・ジェーの最小値がビー以上なら、そこに増やす。アイの最小値がエーより小さければ、アイを減らす。' },
    },
    note: {
      en: 'A cell beside a gap still touches its other neighbours, which keep its smallest $w$ near 1: the printed rule hardly ever adds one. Ours looks at the empty places round a cell, four for squares and six for round cells. The first formula is our writing of the sentence in the paper, which leaves both values to the user.',
      ja: '空きの隣のセルも、ほかの側では隣と触れ合っているので、$w$の最小値は1の近くにとどまり、印刷された規則ではほとんど増えません。本プログラムはセルのまわりの空いた場所（正方形は四つ、円は六つ）を調べます。左の式は、論文の文章を式にしたものです。二つの値は利用者が決めます。',
    },
    see: { figure: 'hole', words: { en: 'A hole under both rules', ja: '穴に対する二つの規則' } },
  },
];
