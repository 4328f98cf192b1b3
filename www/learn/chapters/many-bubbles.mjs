// Chapter 2. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { over, row, under } from './math.mjs';

export const manyBubbles = {
  name: 'many-bubbles',
  number: 2,
  title: { en: 'Many bubbles', ja: 'たくさんのバブル' },
  idea: {
    en: 'The same force, summed over neighbours, brings a crowd to rest: in a valley, not in the deepest.',
    ja: '隣どうしの力を足し合わせると、群れ全体が静止します。ただし、行き着く谷は最も深い谷とは限りません。',
  },
  description: {
    en: 'How a crowd of bubbles comes to rest: forces of all neighbours, energies, and why the program finds a good packing, not the best.',
    ja: 'たくさんのバブルはどのように静止するのか。隣からの力の和とエネルギー、そして見つかるのが最良でなく十分に良い充填であるわけを確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'earlier2',
      figure: 'crowd',
      heading: { en: 'Does it feel the next but one?', ja: '隣の隣まで力は届くでしょうか' },
      text: {
        en: 'Three bubbles stand in a row and touch: from the first to the third it is $w = 2$. What does the third do to the first?',
        ja: '三つのバブルが一列に並んで触れ合っています。一番目と三番目の距離は$w = 2$です。三番目は一番目にどんな力を及ぼすでしょう。',
      },
      caption: {
        en: 'A crowd at its start. Each bubble sums the pushes and pulls of its [[neighbour|neighbours]] to one arrow, its [[net-force|net force]]. A [[wall]] acts by the same curve. $E$ is the [[energy]] of all, in units of $k0$, as in chapter 1.',
        ja: '動き出す前の群れ。バブルは[[neighbour|近接粒子]]からの斥力と引力を一本の矢印、[[net-force|合力]]にまとめます。[[wall|壁]]も同じ曲線に従って力を及ぼします。$E$は全体の[[energy|エネルギー]]で、単位は第1章と同じ$k0$です。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'It pulls, more weakly than the second', ja: '二番目より弱く引く' },
          reply: {
            en: 'A pull that fades without end would reach all of them. This one ends: from 1.5 on it is exactly 0.',
            ja: 'どこまでも続く引力なら、弱くても全部に届きます。この引力には終わりがあり、1.5から先ではちょうど0です。',
          },
        },
        {
          value: 'b',
          text: { en: 'Nothing', ja: '力を及ぼさない' },
          right: true,
          reply: {
            en: 'Yes: from 1.5 on the force is 0. In a honeycomb the next but one is at 1.73, so a bubble feels only the six around it.',
            ja: 'そのとおり。1.5から先では力は0です。蜂の巣のように並んでも、隣の隣までは1.73あるので、まわりの六つの力しか受けません。',
          },
        },
        {
          value: 'c',
          text: { en: 'It pushes, through the second', ja: '二番目を通して押す' },
          reply: {
            en: 'The second passes nothing on: it pushes only if it moves nearer itself. Forces act between two centres.',
            ja: '二番目は力を伝えません。自分が近づいてはじめて押します。力は二つの中心の間に働くものです。',
          },
        },
      ],
    },
    {
      kind: 'prediction',
      key: 'same',
      figure: 'two-starts',
      heading: { en: 'Will both end alike?', ja: '同じところに落ち着くでしょうか' },
      text: {
        en: 'The same outline, forces and number of bubbles: only the [[first-places|first places]] differ. Let both run until they rest, and compare their pictures and their energy, the sum of all potentials. What will you see?',
        ja: '輪郭も力も個数も同じで、[[first-places|初期位置]]だけが違います。両方を静止するまで動かし、絵とエネルギー（ポテンシャルの合計）を比べると、どうなるでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'The same picture twice', ja: '同じ絵が二つ' } },
        { value: 'b', text: { en: 'Two pictures, one energy', ja: '絵は違うが、エネルギーは同じ' } },
        { value: 'c', text: { en: 'Two pictures, two energies', ja: '絵もエネルギーも違う' }, right: true },
      ],
      caption: {
        en: 'Two crowds with different first places in one outline, side by side, and their energy step by step.',
        ja: '同じ輪郭の中で、初期位置だけが違う二つの群れと、ステップごとのエネルギー。',
      },
    },
    {
      kind: 'prediction',
      key: 'falls',
      figure: 'energy',
      heading: { en: 'Downhill all the way?', ja: 'ずっと下り坂でしょうか' },
      text: {
        en: 'A crowd settles. Its pairs end with less energy than they began with. Does their energy fall at every step?',
        ja: '群れが落ち着くと、対のエネルギーの和は初めより小さくなります。では、どのステップでも減っているでしょうか。',
      },
      answers: [
        { value: 'a', text: { en: 'Yes, at every step', ja: 'はい、どのステップでも減る' } },
        { value: 'b', text: { en: 'No, at some steps it rises', ja: 'いいえ、増えるステップもある' }, right: true },
      ],
      caption: {
        en: 'The first steps of a shaken crowd. The pairs lose energy, and most of it is now motion; the sum of all falls slowly. Step on: how will the pairs go on?',
        ja: '揺さぶった群れの最初の数ステップ。対のエネルギーは減り、その大半が運動に変わりました。合計はゆっくり減っています。一歩ずつ進めてください。対のエネルギーは、この先どうなるでしょう。',
      },
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        {
          en: 'The force is that of chapter 1. Bubble $i$ takes it from each neighbour $j$ along the arrow $nij$, which has length 1 and points from $j$ to $i$, and adds all of these:',
          ja: '力そのものは第1章と同じです。バブル$i$は隣のバブル$j$から、$j$から$i$へ向かう長さ1の矢印$nij$に沿って力を受け、それをすべて足し合わせます。',
        },
        {
          equation: 'a',
          math: `${row('Fi =')}${under('∑', 'j ≠ i')}${row('f ( wij ) nij')}`,
          speech: {
            en: 'The force f i equals the sum over all j other than i of f of w i j, times the unit vector n i j.',
            ja: '力エフ・アイは、アイ以外のすべてのジェーについての、エフ・オブ・ダブリュー・アイ・ジェーかける単位ベクトル、エヌ・アイ・ジェーの和。',
          },
        },
        {
          en: 'All terms beyond 1.5 are 0. A few neighbours are left, and walls, which add their terms. So twice as many bubbles make twice the work, not four times. The sum moves the bubble, by the equation of chapter 1, now one for each:',
          ja: '1.5より遠い項はすべて0です。残るのは数個の隣と、近くの壁からの力だけなので、バブルが二倍でも計算は四倍でなく二倍ですみます。この和が、第1章の運動方程式に従って、それぞれのバブルを動かします。',
        },
        {
          equation: '5',
          math: `${row('m x..i + c x.i = Fi')}`,
          speech: {
            en: 'm times the acceleration of x i, plus c times the velocity of x i, equals the force f i.',
            ja: 'エムかけるエックス・アイの加速度、足すシーかけるエックス・アイの速度、イコール力エフ・アイ。',
          },
        },
        {
          en: 'At rest every left side is 0, and so is every sum. Not every force: pushes and pulls remain, and cancel at each bubble.',
          ja: '静止すれば左辺はすべて0、力の和もすべて0です。一つ一つの力が0とは限りません。斥力と引力は残り、各バブルのところで打ち消し合っています。',
        },
        {
          en: 'One number shows that rest must come. Add the energy of all pairs, of walls and of motion to $E$. By (5) it changes only through the damping:',
          ja: 'なぜ必ず静止するのかは、一つの数で分かります。対、壁、運動のエネルギーをすべて足して$E$とします。(5)から、それを変えるのは減衰だけです。',
        },
        {
          equation: 'b',
          math: `${over('d E', 'd t')}${row('= − c')}${under('∑', 'i')}<msup><mrow><mo stretchy="false">|</mo>${row('x.i')}<mo stretchy="false">|</mo></mrow><mn>2</mn></msup>`,
          speech: {
            en: 'The rate of change of E equals minus c times the sum over all i of the squared speed of x i.',
            ja: 'イーの変化率は、マイナス、シーかける、すべてのアイについてのエックス・アイの速さの2乗の和。',
          },
        },
        {
          en: 'Squares are never negative: $E$ can only fall. A part of it may rise. A moving bubble runs a little way up the next slope, as a swing does, and turns motion into energy of pairs. An energy that only falls, on a ground with a floor, comes to an end: nearly always in a valley, called a [[local-minimum|local minimum]].',
          ja: '2乗は負にならないので、$E$は減るばかりです。ただし、その一部は増えることがあります。動いているバブルは、ブランコのように次の坂を少し駆け上がり、運動を対のエネルギーに変えます。底のあるところで減りつづければ、いつか終わります。行き着く先はまず例外なく谷で、これを[[local-minimum|極小解]]といいます。',
        },
      ],
    },
    {
      kind: 'not-so',
      key: 'best',
      figure: 'best',
      heading: { en: 'Not so: “the program finds the best packing”', ja: '「プログラムは最良の充填を見つける」のではありません' },
      text: {
        en: 'There are many valleys, and the crowd stops in the first. To find the deepest, one would have to know them all; other methods search for hours. The paper of 2001 says it plainly: a local minimum is enough, since the impression hardly differs, and it is there after 30 to 200 [[iteration|iterations]]. Find a better one by hand.',
        ja: '谷はたくさんあり、群れは最初に行き着いた谷で止まります。最も深い谷を知るには、すべての谷を調べなければなりません。何時間もかける手法もあります。2001年の論文は、石畳には極小解で十分だとはっきり述べています。見た目の印象に大差はなく、30〜200回の[[iteration|反復計算]]で得られるからです。もっと良い谷を、手で探してみてください。',
      },
      ask: { en: 'Is the packing in the figure the best one?', ja: '図の充填は最良でしょうか。' },
      answers: [
        { value: 'a', text: { en: 'Yes: it is at rest, so nothing is better', ja: 'はい。静止しているので、これより良いものはない' } },
        { value: 'b', text: { en: 'No: another start ends lower', ja: 'いいえ。別の初期位置から、もっと低い谷に着く' }, right: true },
      ],
      caption: {
        en: 'A packing at rest, and the energy at which each start that you tried has ended.',
        ja: '静止した充填と、これまでに試した初期位置が行き着いたエネルギー。',
      },
    },
    {
      kind: 'exercise',
      figure: 'quiet',
      key: 'quiet',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'This crowd swings too long. Choose the damping so that it comes to rest within 40 steps.',
        ja: 'この群れは、いつまでも揺れています。減衰を選んで、40ステップ以内に静止させてください。',
      },
      caption: { en: 'Too little damping: the crowd still moves at the last step.', ja: '減衰が足りず、最後のステップでもまだ動いている群れ。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'The papers end a run when all moves are small. Ours asks for small forces, too.',
          ja: '論文は、すべての移動量が小さくなれば計算を終えます。本プログラムは、力も小さいことを確かめます。',
        },
        {
          en: 'The papers hold particles on the boundary. Ours has soft walls, and every cell moves.',
          ja: '論文は領域境界線上の粒子を固定します。本プログラムは柔らかい壁を使い、すべてのセルが動きます。',
        },
      ],
    },
  ],
  sources: {
    en: 'K. Miyata, T. Itoh, K. Shimada (2001), 2.2, 4 and 6; (2000), 4.3, eq. (5); T. Itoh, K. Miyata, K. Shimada (2003), 5.1.',
    ja: '宮田一乗、伊藤貴之、嶋田憲司（2001年）2.2節、4章、6章。K. Miyata, T. Itoh, K. Shimada（2000年）4.3節 式(5)。T. Itoh, K. Miyata, K. Shimada（2003年）5.1節。',
  },
};
