// The glossary, in the order in which chapters use the terms.
import { chapters } from './contents.mjs';
import { meshTerms, wayTerms } from './terms-mesh-way.mjs';

/** All terms, also those of chapters to come. @type {import('./types.mjs').Term[]} */
const all = [
  {
    key: 'bubble', chapter: 'two-bubbles',
    name: { en: 'bubble', ja: 'バブル（粒子）' },
    text: { en: 'A point that pushes and pulls its neighbours. Its circle shows the room it wants. The papers also say particle or cell.', ja: '隣を押したり引いたりする点。円は求める広さを表す。論文では「粒子」とも呼ぶ。' },
  },
  {
    key: 'force', symbol: 'f', chapter: 'two-bubbles',
    name: { en: 'force', ja: '力' },
    text: { en: 'The push or pull of one bubble on another, along the line between their centres. Above 0 it pushes, below 0 it pulls.', ja: '中心を結ぶ線に沿って、一つのバブルがもう一つに及ぼす作用。正なら押し、負なら引く。' },
  },
  {
    key: 'potential', symbol: 'psi', chapter: 'two-bubbles',
    name: { en: 'potential', ja: 'ポテンシャル' },
    text: { en: 'The energy of a pair at a distance: the work that the force does while the two move apart to where it ends. Its slope is the force with the other sign.', ja: 'ある距離にある対のエネルギー。力の届かない距離まで離れる間に、力がする仕事に等しい。傾きの符号を変えたものが力になる。' },
  },
  {
    key: 'damping', symbol: 'c', chapter: 'two-bubbles',
    name: { en: 'damping', ja: '減衰（粘性減衰）' },
    text: { en: 'A drag against the motion, as in honey. It takes energy away, so that the bubbles come to rest.', ja: '蜂蜜の中のように、動きに逆らう抵抗。エネルギーを奪い、バブルを静止させる。' },
  },
  {
    key: 'stable-distance', symbol: 'l0', chapter: 'two-bubbles',
    name: { en: 'stable distance', ja: '安定距離' },
    text: { en: 'The distance of two centres at which the circles touch: half the sum of the diameters. No force acts there.', ja: '円が触れ合うときの中心間の距離。二つの直径の平均に等しく、ここでは力が働かない。' },
  },
  {
    key: 'ratio', symbol: 'w', chapter: 'two-bubbles',
    name: { en: 'ratio of distances', ja: '距離の比' },
    text: { en: 'The distance of two centres, counted in stable distances. 1: they touch. Below 1: they overlap.', ja: '中心間の距離を安定距離で割った値。1なら触れ合い、1より小さければ重なる。' },
  },
  {
    key: 'repulsion', symbol: 'f', chapter: 'two-bubbles',
    name: { en: 'repulsion', ja: '斥力' },
    text: { en: 'The push of two bubbles that are too near: w is less than 1.', ja: '近すぎる二つのバブル（wが1より小さい）が押し合う力。' },
  },
  {
    key: 'attraction', symbol: 'f', chapter: 'two-bubbles',
    name: { en: 'attraction', ja: '引力' },
    text: { en: 'The pull of two bubbles that are a little apart: w is between 1 and 1.5.', ja: '少し離れた二つのバブル（wが1と1.5の間）が引き合う力。' },
  },
  {
    key: 'stiffness', symbol: 'k0', chapter: 'two-bubbles',
    name: { en: 'stiffness (spring constant)', ja: 'ばね定数' },
    text: { en: 'How steeply the force changes at the stable distance. Large: stiff, quick swings.', ja: '安定距離での力の変わり方の急さ。大きいほど硬く、速く揺れる。' },
  },
  {
    key: 'equation-of-motion', symbol: 'x', chapter: 'two-bubbles',
    name: { en: 'equation of motion', ja: '運動方程式' },
    text: { en: 'Mass times acceleration plus damping times velocity is the force. From where a bubble is, it tells where it goes.', ja: '質量×加速度＋減衰×速度＝力。今の位置と速度から、次の動きを定める。' },
  },
  {
    key: 'mass', symbol: 'm', chapter: 'two-bubbles',
    name: { en: 'mass', ja: '質量' },
    text: { en: 'How slowly a bubble follows a force. It sits at the bubble’s centre.', ja: '力に対する動きにくさ。バブルの中心にあるとみなす。' },
  },
  {
    key: 'rest', chapter: 'two-bubbles',
    name: { en: 'rest', ja: '静止' },
    text: { en: 'No bubble moves any more, as all forces on it cancel. For a pair: w = 1, or too far apart to feel each other.', ja: '力がつり合い、どのバブルも動かない状態。対ならw = 1、または力の届かない距離。' },
  },
  {
    key: 'time-step', chapter: 'two-bubbles',
    name: { en: 'time step', ja: '時間刻み' },
    text: { en: 'How much time passes from one computed state to the next. Short: exact but slow. Too long: wrong.', ja: '一回の計算で進める時間。小さいほど正確だが遅く、大きすぎると誤る。' },
  },
  {
    key: 'euler', chapter: 'two-bubbles',
    name: { en: 'explicit Euler', ja: '陽的オイラー法' },
    text: { en: 'The simplest way to take a step: the force at its start is used for all of it.', ja: '最も簡単な数値積分法。刻みの初めの力を、終わりまでそのまま使う。' },
  },
  {
    key: 'runge-kutta', chapter: 'two-bubbles',
    name: { en: 'Runge–Kutta (fourth order)', ja: 'ルンゲ・クッタ法（4次）' },
    text: { en: 'A step that looks at the force four times: at its start, twice in its middle, at its end. The papers use it.', ja: '刻みの初めに一度、真ん中で二度、終わりに一度、計四回力を求めて進む方法。論文で使われている。' },
  },
  {
    key: 'neighbour', symbol: 'w', chapter: 'many-bubbles',
    name: { en: 'neighbour', ja: '近接粒子（隣）' },
    text: { en: 'A bubble that is nearer than 1.5 stable distances, so that a force acts.', ja: '安定距離の1.5倍より近く、力の及ぶバブル。' },
  },
  {
    key: 'net-force', symbol: 'f', chapter: 'many-bubbles',
    name: { en: 'net force', ja: '合力' },
    text: { en: 'The sum of all forces on one bubble, as an arrow. At rest it is 0.', ja: '一つのバブルが受けるすべての力の和。矢印で表す。静止していれば0。' },
  },
  {
    key: 'wall', chapter: 'many-bubbles',
    name: { en: 'wall', ja: '壁（領域境界線）' },
    text: { en: 'The boundary of the outline. By the force of a pair it pushes who sticks out, and holds who is near.', ja: '領域の境界。対と同じ力で、はみ出したバブルを押し、近くのバブルを引き留める。' },
  },
  {
    key: 'first-places', symbol: 'x', chapter: 'many-bubbles',
    name: { en: 'first places', ja: '初期位置' },
    text: { en: 'Where the bubbles stand at step 0. Which valley a crowd ends in depends on them.', ja: 'ステップ0でのバブルの場所。群れがどの谷に行き着くかは、これで変わる。' },
  },
  {
    key: 'energy', symbol: 'E', chapter: 'many-bubbles',
    name: { en: 'energy', ja: 'エネルギー' },
    text: { en: 'That of the pairs is the sum of all potentials. With that of walls and motion it falls until all is at rest.', ja: '対のエネルギーは、ポテンシャルの和。壁と運動の分を加えた合計は、静止するまで減りつづける。' },
  },
  {
    key: 'local-minimum', chapter: 'many-bubbles',
    name: { en: 'local minimum', ja: '極小解' },
    text: { en: 'The floor of one valley: any small move costs energy. Another valley may be deeper.', ja: '一つの谷の底。少しでも動けばエネルギーが増える。ほかにもっと深い谷があるかもしれない。' },
  },
  {
    key: 'iteration', chapter: 'many-bubbles',
    name: { en: 'iteration', ja: '反復計算' },
    text: { en: 'One round of the same work: all forces, then all moves. Also called a step.', ja: 'すべての力を求め、すべてを動かす計算の一回分。ステップともいう。' },
  },
  ...meshTerms,
  {
    key: 'square-cell', chapter: 'squares',
    name: { en: 'square cell', ja: '四角形粒子' },
    text: { en: 'A cell with a direction and four corners. Its centre moves; its sides follow the direction field.', ja: '向きと四隅をもつ粒子。動くのは中心で、辺の向きはベクトル場に従う。' },
  },
  {
    key: 'alignment', chapter: 'squares',
    name: { en: 'line up (alignment)', ja: '整列' },
    text: { en: 'To stand in rows and columns, edge to edge.', ja: '縦横に、格子状に並ぶこと。' },
  },
  {
    key: 'contour', chapter: 'squares',
    name: { en: 'contour line', ja: '等値曲線' },
    text: { en: 'All places of one height: here, of one potential.', ja: '同じ高さの場所を結んだ線。ここではポテンシャルの値が等しい。' },
  },
  {
    key: 'well', symbol: 'psi', chapter: 'squares',
    name: { en: 'well', ja: '井戸' },
    text: { en: 'A place of least potential, with higher ground on all sides.', ja: 'まわりのどこよりもポテンシャルが低い場所。' },
  },
  {
    key: 'superposition', symbol: 'psi', chapter: 'squares',
    name: { en: 'superposition', ja: '重ね合わせ' },
    text: { en: 'Several potentials in one place, added.', ja: '同じ場所のいくつかのポテンシャルを足し合わせること。' },
  },
  {
    key: 'corner-bubble', symbol: 'psi1', chapter: 'squares',
    name: { en: 'corner bubble', ja: '隅のバブル（副ポテンシャル）' },
    text: { en: 'A small potential on a corner of a square, as of a bubble. It acts on the centres of neighbours, not on their corners.', ja: '正方形の隅に置く小さなバブルのポテンシャル。隣の隅ではなく、隣の中心に作用する。' },
  },
  {
    key: 'corner-weight', symbol: 'cw', chapter: 'squares',
    name: { en: 'weight (of the corners)', ja: '重み（隅の）' },
    text: { en: 'By how much corner bubbles count. It makes the wells deep.', ja: '隅のバブルの効き方。井戸の深さを決める。' },
  },
  {
    key: 'corner-radius', symbol: 'cr', chapter: 'squares',
    name: { en: 'radius (of the corners)', ja: '半径（隅の）' },
    text: { en: 'How large corner bubbles are, in half sides. It says where the wells are.', ja: '隅のバブルの大きさ。一辺の半分を単位とする。井戸の場所を決める。' },
  },
  {
    key: 'barrier', chapter: 'squares',
    name: { en: 'barrier', ja: '障壁' },
    text: { en: 'How much the lowest way from one well to the next rises above the well.', ja: '一つの井戸から次の井戸へ移るときに越える、最も低い峠の高さ。井戸の底から測る。' },
  },
  ...wayTerms,
  {
    key: 'crowded', symbol: 'a', chapter: 'how-many',
    name: { en: 'crowded', ja: '過密' },
    text: { en: 'Too near to a neighbour: the smallest w is below a threshold.', ja: '隣に近すぎること。wの最小値がしきい値より小さい。' },
  },
  {
    key: 'empty-place', symbol: 'b', chapter: 'how-many',
    name: { en: 'empty place', ja: '空いた場所' },
    text: { en: 'A place beside a cell where another would touch, and far enough from all.', ja: '隣のセルと触れ合う場所で、ほかのどのセルからも十分に遠いところ。' },
  },
  {
    key: 'smallest-w', symbol: 'wij', chapter: 'how-many',
    name: { en: 'smallest w', ja: 'wの最小値' },
    text: { en: 'The distance to the nearest neighbour, in stable distances.', ja: '最も近い隣までの距離を安定距離で割った値。' },
  },
  {
    key: 'threshold', chapter: 'how-many',
    name: { en: 'threshold', ja: 'しきい値' },
    text: { en: 'A number with which another is compared, to decide yes or no.', ja: 'はい・いいえを決めるために比べる値。' },
  },
  {
    key: 'population', symbol: 'n', chapter: 'how-many',
    name: { en: 'population', ja: '個数' },
    text: { en: 'How many cells there are. It changes while they move.', ja: 'セルの数。動いている間に増減する。' },
  },
  {
    key: 'quadtree', chapter: 'how-many',
    name: { en: 'quadtree', ja: '四分木' },
    text: { en: 'A square cut into four, and each part again where needed: a quick first guess.', ja: '正方形を四つに分け、必要なところをさらに四つに分けていく木。初めの配置の見当に使う。' },
  },
  {
    key: 'honeycomb', chapter: 'how-many',
    name: { en: 'honeycomb', ja: '蜂の巣状の並び' },
    text: { en: 'Round cells with six around each: the closest packing in a plane.', ja: '円のまわりに六つずつ並ぶ配置。平面での最密充填。' },
  },
];

/** The terms of the chapters that exist. */
export const terms = all.filter(({ chapter }) => chapters.some(({ name }) => name === chapter));
