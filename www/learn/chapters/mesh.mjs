// Chapter 3. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { over, row } from './math.mjs';

export const mesh = {
  name: 'mesh',
  number: 3,
  title: { en: 'From bubbles to a mesh', ja: 'バブルからメッシュへ' },
  idea: {
    en: 'To join points is easy; to have good points is the work.',
    ja: '点を結ぶのは簡単です。難しいのは、良い場所に点を置くことです。',
  },
  description: {
    en: 'How bubbles become a mesh: Delaunay’s empty circles, the smallest angles of random, evened out and packed points, and cells as the dual.',
    ja: 'バブルはどのようにメッシュになるのか。ドロネーの空円、ランダムな点・ならした点・充填した点の最小角、双対としてのセルを手で確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'earlier3',
      figure: 'dual',
      heading: { en: 'Do the lines cross?', ja: '線は交わるでしょうか' },
      text: {
        en: 'A crowd of round bubbles has come to rest. Join every two that feel each other, those nearer than $w = 1.5$. Do two of the lines ever cross?',
        ja: '円いバブルの群れが静止しました。力の及ぶ二つ、つまり$w = 1.5$より近いものどうしを、すべて線で結びます。線が交わることはあるでしょうか。',
      },
      caption: {
        en: 'Bubbles at rest; the [[mesh]] of their centres, joined to triangles without overlap; and its [[dual]]: around each bubble a cell, with one corner in each triangle.',
        ja: '静止したバブルと、中心を結んで三角形で埋めた[[mesh|メッシュ]]、そして[[dual|双対]]。三角形ごとに角を一つ置くと、バブルのまわりにセルができます。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'Never', ja: '決して交わらない' },
          reply: {
            en: 'In a honeycomb that is so. But a crowd between walls is no perfect honeycomb.',
            ja: '蜂の巣の並びならそのとおりです。けれども、壁に囲まれた群れは、完全な蜂の巣にはなりません。',
          },
        },
        {
          value: 'b',
          text: { en: 'Yes, where four stand nearly in a square', ja: '四つがほぼ正方形に並ぶところで交わる' },
          right: true,
          reply: {
            en: 'Yes. With sides of 1 both diagonals are 1.41, nearer than 1.5. A mesh must choose one of them, and needs a rule.',
            ja: 'そのとおり。辺が1なら対角線は二本とも1.41で、1.5より近くなります。メッシュはその一方を選ばなければならず、それには規則が要ります。',
          },
        },
        {
          value: 'c',
          text: { en: 'Yes, nearly everywhere', ja: 'ほとんど至るところで交わる' },
          reply: {
            en: 'For that a bubble would have to feel those behind its neighbours. In a honeycomb they are at 1.73, and the force ends at 1.5.',
            ja: 'それには、隣の向こうまで力が届かなければなりません。蜂の巣の並びでは1.73にあり、力は1.5で終わります。',
          },
        },
      ],
    },
    {
      kind: 'figure',
      figure: 'three',
      heading: { en: 'Three ways to place points', ja: '点の三通りの置き方' },
      text: {
        en: 'The same outline and the same number of points three times, joined by the same rule. The first are thrown at random. The second are evened out by [[lloyd|Lloyd’s rounds]]: in each, every point moves to the centre of gravity of its [[voronoi|Voronoi cell]], all places that are nearer to it than to any other. The third are bubbles.',
        ja: '同じ輪郭に、同じ数の点を置き、同じ規則で結びます。一つ目はランダムに置いたまま。二つ目は[[lloyd|ロイド法]]でならしたもので、一回ごとに、どの点も自分の[[voronoi|ボロノイ領域]]（ほかのどの点より自分に近い範囲）の重心へ動きます。三つ目はバブルです。',
      },
      caption: {
        en: 'Seventy-two points three times: at random, after four rounds, after five steps of packing. Below, the triangles are counted by their [[smallest-angle|smallest angle]], with the [[median|middle]] as a line: half of them lie below it.',
        ja: '七十二個の点を三通りに置きました。ランダム、ロイド法四回、充填5ステップです。下は三角形を[[smallest-angle|最小角]]ごとに数えたもの。線は[[median|中央値]]で、半数がそれより下にあります。',
      },
    },
    {
      kind: 'mark',
      key: 'middles',
      figure: 'three',
      text: {
        en: 'The random points stay as they are. Mark where the two other middles will be after 20 rounds, and when the bubbles rest. Then raise the rounds, and press play.',
        ja: 'ランダムな点は動きません。ほかの二つの中央値は、ロイド法を20回くり返した後と、バブルが静止した後に、それぞれどこにあるでしょう。印を付けてから、回数を上げ、再生してください。',
      },
      blanks: [{ en: 'Lloyd, in degrees:', ja: 'ロイド法（度）：' }, { en: 'bubbles:', ja: 'バブル：' }],
    },
    {
      kind: 'prediction',
      key: 'flip',
      figure: 'flip',
      heading: { en: 'When does an edge flip?', ja: '辺はいつ入れ替わるでしょう' },
      text: {
        en: 'Two triangles share an edge, a diagonal of their four corners. Move one of the four slowly: at one moment the edge jumps to the other diagonal. When?',
        ja: '二つの三角形に共通の辺は、四つの頂点の対角線です。頂点の一つをゆっくり動かすと、あるとき、もう一方の対角線に入れ替わります。それはいつでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'When the other diagonal is the shorter one', ja: 'もう一方の対角線のほうが短くなったとき' } },
        { value: 'b', text: { en: 'When all four corners lie on one circle', ja: '四つの頂点が一つの円周上に並んだとき' }, right: true },
        { value: 'c', text: { en: 'When a point runs into an edge', ja: '点が辺にぶつかったとき' } },
      ],
      caption: {
        en: 'Twelve points and the edges of [[delaunay|Delaunay’s triangulation]]. The [[empty-circle|circle]] through the corners of the triangle pointed at has no point inside.',
        ja: '十二個の点と、[[delaunay|ドロネー三角形分割]]の辺。指した三角形の[[empty-circle|外接円]]の中には、ほかの点がありません。',
      },
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        {
          en: 'Delaunay’s rule allows no point inside the circle of a triangle. For an edge between two triangles it reads: the two angles that face it add up to at most 180°.',
          ja: 'ドロネーの規則では、三角形の外接円の中に点があってはいけません。二つの三角形に共通の辺でいえば、辺に向かい合う二つの角の和が180°以下ということです。',
        },
        {
          equation: 'a',
          math: `${row('alpha + beta ≤')}<mn>180°</mn>`,
          speech: { en: 'Alpha plus beta is at most 180 degrees.', ja: 'アルファ足すベータは180度以下。' },
        },
        {
          en: 'With all four corners on one circle the sum is 180°, and both diagonals are right. A little farther, only the other one is. Lengths do not decide. Among all ways to join given points, this one has the largest smallest angle. How large can that be? In a triangle with the shortest side $s$ and a circle of radius $R$ the smallest angle $gamma$ faces $s$, so',
          ja: '四つの頂点が一つの円周上に並べば和は180°で、どちらの対角線でもかまいません。その先では、もう一方に替わります。長さは関係ありません。与えられた点の結び方のうち、最も小さい角が最も大きくなるのが、この規則です。では、どこまで大きくなるのでしょう。最も短い辺を$s$、外接円の半径を$R$とすると、最小角$gamma$は$s$に向かい合うので、次の式が成り立ちます。',
        },
        {
          equation: 'b',
          math: `${row('sin gamma =')}${over('s', '2 R')}<mo>.</mo>`,
          speech: { en: 'The sine of gamma equals s over 2 R.', ja: 'サイン・ガンマは、2アール分のエス。' },
        },
        {
          en: 'Read it with bubbles. $s$ says how near two of them are: the push keeps it large. The circle is empty, so $R$ is the size of a hole: where there is room, a bubble comes. If no circle has a radius larger than the shortest side of its triangle, no angle is below 30°. In a honeycomb the radius is 0.58 of the side, and every angle 60°. Random points have close pairs and wide holes, and so thin triangles.',
          ja: 'この式を、バブルに当てはめてみます。$s$は二つのバブルの間隔で、縮みすぎるのを斥力が防ぎます。円の中は空なので、$R$は穴の大きさです。空きがあれば、バブルが増えます。どの三角形でも円の半径が最も短い辺を超えなければ、30°より小さい角はできません。蜂の巣の並びでは半径は辺の0.58倍で、角はすべて60°です。ランダムな点には、近すぎる対も大きな穴もあるので、細い三角形ができます。',
        },
        {
          en: 'Then comes the dual. A bubble with six edges gets a cell with six sides. In a large mesh of triangles the mean is about six, even for random points; good points have six nearly everywhere.',
          ja: '最後に双対です。六本の辺が集まるバブルのセルは六角形になります。大きな三角形メッシュなら、ランダムな点でも平均はほぼ六です。良い点では、ほとんどのところで六になります。',
        },
      ],
    },
    {
      kind: 'not-so',
      key: 'good',
      figure: 'close',
      heading: { en: 'Not so: “Delaunay makes good triangles”', ja: '「ドロネーが良い三角形を作る」のではありません' },
      text: {
        en: 'It moves no point. It only chooses the best edges that the points allow, and the best may be bad. Break it: push two points together.',
        ja: 'ドロネーは点を動かしません。与えられた点に許される最良の辺を選ぶだけで、最良でも悪いことがあります。二つの点を近づけて、壊してみてください。',
      },
      ask: { en: 'Two points come together until they nearly touch. What does the smallest angle do?', ja: '二つの点を、触れそうになるまで近づけます。最小角はどうなるでしょう。' },
      answers: [
        { value: 'a', text: { en: 'It stays above 30°, as edges flip in time', ja: '辺が入れ替わるので、30°より大きいまま' } },
        { value: 'b', text: { en: 'It goes towards 0°', ja: '0°に近づく' }, right: true },
      ],
      caption: {
        en: 'Twelve good points: no angle is below 44°. Any of them can be moved.',
        ja: '良い配置の十二個の点。どの角も44°以上です。点はどれも動かせます。',
      },
    },
    {
      kind: 'exercise',
      figure: 'place',
      key: 'place',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'Be the bubble: eleven points stay where they are. Move the other one so that no angle is below 30°.',
        ja: 'バブルになってみましょう。十一個の点は動きません。残る一つを動かして、30°より小さい角をなくしてください。',
      },
      caption: { en: 'Eleven points, and one in a bad place: the smallest angle is 8°.', ja: '十一個の点と、悪い場所にある一つ。最小角は8°です。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'The paper of 2003 puts the corners of cells in the centres of triangles, not of circles, and says pseudo-Voronoi. Ours does so, and moves them away from larger bubbles.',
          ja: '2003年の論文は、外接円の中心でなく三角形の中心をセルの角とし、疑似ボロノイ分割と呼びます。本プログラムも同様で、さらに大きいバブルから遠ざけます。',
        },
        {
          en: 'The papers of 2000 and 2001 do without Voronoi cells, as these are hard to line up along a road. Ours has them to compare.',
          ja: '2000年と2001年の論文は、道に沿って整列させにくいボロノイ分割を採りません。本プログラムは、比較のために備えています。',
        },
      ],
    },
  ],
  sources: {
    en: 'T. Itoh, K. Miyata, K. Shimada (2003), 5, fig. 3, and 5.2; K. Miyata, T. Itoh, K. Shimada (2000), 2.1; (2001), 2.1.',
    ja: 'T. Itoh, K. Miyata, K. Shimada（2003年）5章 図3、5.2節。K. Miyata, T. Itoh, K. Shimada（2000年）2.1節。宮田一乗、伊藤貴之、嶋田憲司（2001年）2.1節。',
  },
};
