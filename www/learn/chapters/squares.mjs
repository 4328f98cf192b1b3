// Chapter 4. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { row } from './math.mjs';

export const squares = {
  name: 'squares',
  number: 4,
  title: { en: 'Why squares line up', ja: '正方形はなぜ並ぶのか' },
  idea: {
    en: 'Four small bubbles on the corners turn a ring of rest into four wells.',
    ja: 'どこでも静止できた輪が、四隅の小さなバブルで四つの井戸に変わります。',
  },
  description: {
    en: 'Why square cells stand in rows and columns: the potential of a square, with four small bubbles on its corners, by hand.',
    ja: '正方形のセルはなぜ縦横に並ぶのか。四隅に小さなバブルを加えた正方形のポテンシャルを、手で確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'earlier4',
      figure: 'nine',
      heading: { en: 'Where may a neighbour rest?', ja: '隣はどこで静止できるでしょう' },
      text: {
        en: 'In chapter 1 the force depends on the distance alone. One bubble is held. Where around it can another come to rest, so that they touch?',
        ja: '第1章の力は距離だけで決まりました。バブルを一つ留めます。もう一つが触れ合って静止できる場所は、そのまわりのどこでしょう。',
      },
      caption: {
        en: 'Nine [[square-cell|square cells]] from one start. Without [[corner-bubble|corner bubbles]] they come to rest as circles would; with them they [[alignment|line up]].',
        ja: '同じところから始めた九つの[[square-cell|四角形粒子]]。[[corner-bubble|隅のバブル]]がなければ円と同じように静止し、あれば格子状に[[alignment|整列]]します。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'In four places: left, right, above, below', ja: '上下左右の四か所' },
          reply: {
            en: 'A curve of the distance knows no left and no right. To single out four places, something must turn with the cell.',
            ja: '距離の曲線には右も左もありません。四か所だけを選ぶには、セルの向きとともに回る何かが必要です。',
          },
        },
        {
          value: 'b',
          text: { en: 'Anywhere on a ring', ja: '輪の上のどこでも' },
          right: true,
          reply: {
            en: 'Yes. The valley at $w = 1$ is equally deep all round. From such a ring no row can come.',
            ja: 'そのとおり。$w = 1$の谷はどの向きにも同じ深さです。このような輪から、列は生まれません。',
          },
        },
        {
          value: 'c',
          text: { en: 'In six places', ja: '六か所' },
          reply: {
            en: 'Six is how many fit around one when all are there. For a single neighbour each place on the ring is as good as any other.',
            ja: '六は、全部そろったときにまわりに収まる数です。隣が一つだけなら、輪の上のどこでも変わりはありません。',
          },
        },
      ],
    },
    {
      kind: 'prediction',
      key: 'from',
      figure: 'wells',
      heading: { en: 'From which weight on?', ja: 'どれだけの重みから' },
      text: {
        en: 'Each square carries four small bubbles on its corners. They count with a [[corner-weight|weight]] between 0 and 1. From which weight on does a neighbour find four places of rest, and no ring?',
        ja: '正方形の四隅に小さなバブルを置きます。その[[corner-weight|重み]]は0から1まで選べます。重みがいくつからなら、静止できる場所は輪でなく四か所になるでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'From 0.41 on, which is √2 − 1', ja: '0.41（√2 − 1）から' } },
        { value: 'b', text: { en: 'From 0.2 on', ja: '0.2から' } },
        { value: 'c', text: { en: 'From any weight above 0', ja: '0より大きければいくつでも' }, right: true },
      ],
      caption: {
        en: 'The potential round a held square, as a map with [[contour|contour lines]] and as a relief. At each edge lies a [[well]]. Drop the second square anywhere and watch it slide.',
        ja: '留めた正方形のまわりのポテンシャルを、[[contour|等値曲線]]の地図と立体の地形に描いたもの。四つの辺の先に[[well|井戸]]があります。二つ目の正方形を置いて、滑る先を見てください。',
      },
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        {
          en: 'Potentials are numbers, so they can be laid over each other: their [[superposition]] is the sum at each place. A square has one at its centre, $psi0$, as a circle has. Four weaker ones, its corner bubbles, sit on the corners:',
          ja: 'ポテンシャルは数なので、場所ごとに足して[[superposition|重ね合わせ]]ることができます。正方形の中心には、円と同じ$psi0$があります。そこに、四隅の弱いポテンシャル、つまり隅のバブルを加えます。',
        },
        {
          equation: '4',
          math: row('psi = psi0 + cw ( psi1 + psi2 + psi3 + psi4 )'),
          speech: {
            en: 'psi equals psi P zero plus root 2 minus 1, times the sum of psi P one, psi P two, psi P three and psi P four.',
            ja: 'プサイは、プサイ・ピー・ゼロ、足す、かっこルート2引く1かける、プサイ・ピー・いち、ピー・に、ピー・さん、ピー・よんの和。',
          },
        },
        {
          en: 'The factor is their weight. Their [[corner-radius|radius]] is $cr r0$, where $r0$ is half a side. Now let a neighbour touch along an edge. Its centre is $r0$ along and $r0$ across from each near corner, and this is exactly where a corner bubble leaves it alone:',
          ja: '係数はその重みです。[[corner-radius|半径]]は$cr r0$で、$r0$は一辺の半分です。隣が辺で触れ合うとき、その中心は近い二つの隅から縦に$r0$、横に$r0$離れています。ちょうどその距離で、隅のバブルの力は0になります。',
        },
        {
          equation: 'a',
          math: row('root2 r0 = cr r0 + r0'),
          speech: {
            en: 'Root 2 r zero equals root 2 minus 1, times r zero, plus r zero.',
            ja: 'ルート2アール・ゼロは、かっこルート2引く1アール・ゼロ足すアール・ゼロ。',
          },
        },
        {
          en: 'So at the middle of an edge nothing pushes and nothing pulls, whatever the weight. Go round to 45°, and the centre comes much too near to one corner, which pushes it off. Between two wells there is now a [[barrier]]: 0.046 $k0$ high with the papers’ weight, 0.009 $k0$ with 0.05, and 0 without. Any weight makes four wells. More weight makes them steeper, and deeper: 0.076 $k0$ instead of 0.048.',
          ja: 'つまり辺の真ん中では、重みがいくつでも、押す力も引く力もありません。45°の方向へ回ると、中心は一つの隅に近づきすぎて押し出されます。井戸と井戸の間に[[barrier|障壁]]ができたのです。その高さは、論文の重みで0.046 $k0$、重み0.05で0.009 $k0$、重み0では0です。どんな重みでも井戸は四つできます。重みを増すと、井戸は急に、深くなります（0.048から0.076 $k0$へ）。',
        },
      ],
    },
    {
      kind: 'figure',
      figure: 'sixty',
      heading: { en: 'Sixty squares', ja: '六十個の正方形' },
      text: {
        en: 'Nobody wrote “row” into the program. Each square looks for the wells of its neighbours, and rows are what they find together.',
        ja: 'プログラムのどこにも「列」とは書かれていません。どの正方形も隣の井戸を探すだけで、その結果として列ができます。',
      },
      caption: {
        en: 'Sixty squares, pushed out of place and let go, without corner bubbles and with them.',
        ja: '場所を乱してから放した六十個の正方形。隅のバブルがない場合と、ある場合。',
      },
    },
    {
      kind: 'not-so',
      key: 'bump',
      figure: 'bump',
      heading: { en: 'Not so: “corners bump into each other”', ja: '「角と角がぶつかる」のではありません' },
      text: {
        en: 'A corner bubble never meets another. It acts on the centre of the neighbour, which is a point. Nor is √2 − 1 a threshold. That number stands in two places and does two things: as the radius it puts the wells where edges touch; as the weight it only makes them deep. Change one at a time, and put the wells in the wrong place.',
        ja: '隅のバブルどうしは、力を及ぼしません。作用する相手は隣の中心、つまり一点です。√2 − 1も境目ではありません。この数は二か所に現れ、役目が違います。半径は、辺が触れ合うところに井戸を置きます。重みは、井戸を深くするだけです。一つずつ変えて、井戸を別の場所に動かしてみてください。',
      },
      ask: { en: 'The weight goes from 0.41 up to 1. Where does the neighbour rest then, at an edge?', ja: '重みを0.41から1に上げます。隣は辺の先のどこで静止するでしょう。' },
      answers: [
        { value: 'a', text: { en: 'Farther away', ja: 'もっと遠く' } },
        { value: 'b', text: { en: 'Nearer', ja: 'もっと近く' } },
        { value: 'c', text: { en: 'At $w = 1$, as before', ja: '前と同じ$w = 1$' }, right: true },
      ],
      caption: {
        en: 'The landscape from above, and cut through the middle of an edge. More weight lowers the well; another radius shifts it.',
        ja: '上から見た地形と、辺の真ん中を通る断面。重みを増すと井戸は下がり、半径を変えると横に動きます。',
      },
    },
    {
      kind: 'exercise',
      figure: 'slide',
      key: 'slide',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'One thing is left to do here: find a place, at least half a side away, from which the square slides into the well on the left.',
        ja: '左の井戸に滑り込むような場所を、井戸から辺の半分以上離れたところに見つけ、正方形を置いてください。',
      },
      caption: { en: 'A square that slid to the nearest well. Where must it start to end on the left?', ja: '最も近い井戸に滑り込んだ正方形。左に行き着くのは、どこから始めたときでしょう。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'In equation (4) a corner pushes with the $k0 / l0$ of the pair. Its own stable distance is shorter, so its potential is 1/√2 of the one in the centre. For two sizes, which the paper leaves open, ours takes the mean of both landscapes.',
          ja: '式(4)の四隅は、対と同じ$k0 / l0$の強さで押します。隅の安定距離は短いので、そのポテンシャルは中央の1/√2倍です。論文が定めていない、大きさの違う対では、二つの地形の平均をとります。',
        },
        {
          en: 'Where the field has no direction, only the central potential acts, as the paper of 2001 says.',
          ja: 'ベクトル場の特異点では、2001年の論文のとおり、中心のポテンシャルだけが働きます。',
        },
      ],
    },
  ],
  sources: {
    en: 'K. Miyata, T. Itoh, K. Shimada (2000), 4.2, eq. (4), figs. 6 (b), 7; (2001), 4, fig. 5; T. Itoh, K. Miyata, K. Shimada (2003), 5.1, fig. 6 (a).',
    ja: 'K. Miyata, T. Itoh, K. Shimada（2000年）4.2節 式(4) 図6(b)、図7。宮田一乗、伊藤貴之、嶋田憲司（2001年）4章 図5。T. Itoh, K. Miyata, K. Shimada（2003年）5.1節 図6(a)。',
  },
};
