// The glossary, in the order in which chapters use the terms.

/** @typedef {{ key: string, symbol?: string, chapter: string, name: { en: string, ja: string }, text: { en: string, ja: string } }} Term */

/** @type {Term[]} */
export const terms = [
  {
    key: 'bubble', chapter: 'two-bubbles',
    name: { en: 'bubble', ja: 'バブル（粒子）' },
    text: { en: 'A point that pushes and pulls its neighbours. Its circle shows the room it wants. The papers also say particle or cell.', ja: '隣を押したり引いたりする点。円は求める広さを表す。論文では「粒子」とも呼ぶ。' },
  },
  {
    key: 'force', symbol: 'f', chapter: 'two-bubbles',
    name: { en: 'force', ja: '力' },
    text: { en: 'What one bubble does to another, along the line between their centres. Above 0 it pushes, below 0 it pulls.', ja: '中心を結ぶ線に沿って、一つのバブルがもう一つに及ぼす作用。正なら押し、負なら引く。' },
  },
  {
    key: 'potential', symbol: 'psi', chapter: 'two-bubbles',
    name: { en: 'potential', ja: 'ポテンシャル' },
    text: { en: 'The energy of a pair at a distance: the work that the force has still to give. Its slope is the force with the other sign.', ja: 'ある距離にある対のエネルギー。力がこれからなしうる仕事。傾きの符号を変えたものが力になる。' },
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
    text: { en: 'A step that looks at the force four times: at its start, twice in its middle, at its end. The papers use it.', ja: '刻みの初め、途中で二度、終わりの計四回、力を求めて進む方法。論文で使われている。' },
  },
];
