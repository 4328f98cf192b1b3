// Chapter 5. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { row } from './math.mjs';
import { arrowSum, fourFoldSum } from './sums.mjs';

export const whichWay = {
  name: 'which-way',
  number: 5,
  title: { en: 'Which way?', ja: 'どちら向き？' },
  idea: {
    en: 'A square looks the same after a quarter turn, so directions cannot be averaged as arrows.',
    ja: '正方形は90度回しても同じなので、向きを矢印として平均することはできません。',
  },
  description: {
    en: 'Which way squares stand in a road: the sum of the sides as arrows, four-fold angles, and quarter turns counted on a walk.',
    ja: '道の中で正方形はどちらを向くのか。辺を矢印として足す式、角度を4倍する方法、一周して数える90度回転を手で確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'earlier5',
      figure: 'quarter',
      heading: { en: 'Where are the wells now?', ja: '井戸はどこにあるでしょう' },
      text: {
        en: 'A square has four wells, one beyond each side. Turn it by 90° about its centre. Where are the wells now?',
        ja: '正方形には、四つの辺の先に井戸がありました。中心のまわりに90°回すと、井戸はどこにあるでしょう。',
      },
      caption: {
        en: 'A square with its wells and its arrow, turned, and its [[four-fold|four-fold arrow]], which turns four times as fast. After 90° the square looks as before. Its own arrow does not, but the four-fold one does.',
        ja: '井戸や矢印ごと回した正方形と、四倍の速さで回る[[four-fold|四倍角の矢印]]。90°回すと正方形は元と同じに見えます。二つの矢印のうち元に戻るのは、四倍角の矢印だけです。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'At four new places', ja: '新しい四つの場所' },
          reply: {
            en: 'Each well has moved, but to the place of the next one. The four places are the old ones.',
            ja: '一つ一つの井戸は動きましたが、行き先は次の井戸の場所です。四つの場所は変わりません。',
          },
        },
        {
          value: 'b',
          text: { en: 'Where they were', ja: '元の場所' },
          right: true,
          reply: {
            en: 'Yes. A neighbour cannot tell the turned square from the old one. An arrow drawn on it would show the turn.',
            ja: 'そのとおり。隣から見れば、回す前の正方形と区別できません。矢印なら区別できます。',
          },
        },
        {
          value: 'c',
          text: { en: 'Beyond the corners', ja: '角の先' },
          reply: {
            en: 'That takes half as much, a turn by 45°.',
            ja: 'それは半分の45°回したときです。',
          },
        },
      ],
    },
    {
      kind: 'prediction',
      key: 'middle',
      figure: 'road',
      heading: { en: 'Along, across, nowhere?', ja: '沿うか、横切るか、それとも' },
      text: {
        en: 'A [[direction-field|direction field]] has a direction for squares at each place. The paper of 2000 takes the sides as arrows, one behind the other round the outline, divides each by its squared distance, and adds them. In the middle of a straight road the sum points …',
        ja: '[[direction-field|ベクトル場]]は、各点で正方形の向きを定めます。2000年の論文は、輪郭を一周する辺を矢印とみなし、距離の2乗で割って足します。まっすぐな道の真ん中で、この和はどちらを向くでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'along the road', ja: '道に沿う' } },
        { value: 'b', text: { en: 'across the road', ja: '道を横切る' } },
        { value: 'c', text: { en: 'nowhere', ja: 'どこも向かない（和が0になる）' }, right: true },
      ],
      caption: {
        en: 'A road, five times as long as wide, and a point near one side: the arrow of each [[segment]], their sum as printed, and the four-fold sum. Move the point to the middle.',
        ja: '長さが幅の5倍の道と、片側に近い点。各[[segment|線分]]の矢印と、論文の式による和、そして四倍角の和。点を真ん中へ動かしてください。',
      },
    },
    {
      kind: 'prediction',
      key: 'pieces',
      figure: 'pieces',
      tells: true,
      heading: { en: 'Ten pieces', ja: '十等分すると' },
      text: {
        en: 'One side is cut into ten equal pieces, and the road keeps its shape. Which sum changes in the middle?',
        ja: '一つの辺を十本に分けます。道の形は変わりません。真ん中で変わるのは、どちらの和でしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'Neither: the shape is the same', ja: '形が同じなので、どちらも変わらない' } },
        { value: 'b', text: { en: 'The printed one', ja: '論文の式による和' }, right: true },
        { value: 'c', text: { en: 'Both', ja: '両方' } },
      ],
      caption: {
        en: 'The road again, with a point in its middle, and both sums. Cut its upper side.',
        ja: '同じ道と、真ん中の点での二つの和。上の辺を切ってみてください。',
      },
    },
    {
      kind: 'prediction',
      key: 'turns',
      figure: 'walk',
      heading: { en: 'Once around', ja: 'ぐるりと一周' },
      text: {
        en: 'In a round place squares follow the wall, and somewhere inside they cannot agree. Walk round all such places, and watch the cross that shows the direction. By how many quarter turns has it turned at the end?',
        ja: '円い広場では正方形が壁に沿い、内側のどこかで向きが合わなくなります。そのような場所をすべて囲んで一周すると、向きを示す十字は、90°を何回分回るでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'None', ja: '0回' } },
        { value: 'b', text: { en: 'One', ja: '1回' } },
        { value: 'c', text: { en: 'Four', ja: '4回' }, right: true },
      ],
      caption: {
        en: 'A walk in a round place, the cross on it, and how far it has turned. This walk leaves the middle outside, and counts 0.',
        ja: '円い広場での一周と、その上の十字、そして十字の回った角度。この道筋は中心を囲まず、0回です。',
      },
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        { en: 'This is the printed sum, with $n$ sides $si$ at the distances $di$:', ja: '論文の式はこうです。$n$は辺の数、$si$は各辺の矢印、$di$はそこまでの距離です。' },
        { equation: '1', ...arrowSum },
        {
          en: 'The two sides of a road are opposite arrows. In the middle both are equally near and cancel. Only the ends leave a little, and that points across. Nor does the shape alone decide: $si$ counts as a whole, at the distance of its nearest place. Cut it, and the far pieces count less. Both faults go if the angle is multiplied by four, and each bit of a side has its own distance $r$:',
          ja: '道の両側の矢印は逆向きで、真ん中では距離が等しく、打ち消し合います。残るのは両端のわずかな分で、道を横切る向きです。また、この和は形だけでは決まりません。$si$は、最も近い点の距離で丸ごと数えられるので、切れば遠い部分の重みが減ります。角度を4倍し、辺のどの部分にもその場所の距離$r$を使えば、どちらの問題もなくなります。',
        },
        { equation: 'a', ...fourFoldSum },
        {
          en: 'Opposite arrows, and those at right angles, are now one arrow. A quarter of the sum’s angle is the direction. Its [[certainty]] is the length of the sum over those of its terms: 1 where all agree, 0 where nothing is decided. Such a place is a [[singular-point|singular point]]. A walk around it counts $q$ quarter turns, a whole number; its [[index]] is $q / 4$. Around all that lie in an outline without holes, the count is',
          ja: 'これで、逆向きの矢印も直角の矢印も、同じ一本になります。和の角度を4で割ったものが向きです。和の長さを各項の長さの合計で割ると[[certainty|確かさ]]になり、すべてが一致すれば1、決まらなければ0です。0になる点が[[singular-point|特異点]]です。そのまわりを一周して数えた90°回転の回数$q$は整数で、$q / 4$を[[index|指数]]といいます。穴のない輪郭の中の特異点をすべて囲むと、回数は次のとおりです。',
        },
        {
          equation: 'b',
          math: row('q = 4 − k'),
          speech: { en: 'q equals 4 minus k.', ja: 'キュー、イコール、4引くケー。' },
        },
        {
          en: 'with $k$ square corners and no other sharp ones; corners that point inwards count as −1. Along a round wall the cross turns once, which is four quarters; a square corner hides one of them. So a disc has four, and a square none. A round hole takes four away: a ring has none.',
          ja: '$k$は直角の角の数で、内側へ折れる角は−1と数えます（ほかに尖った角はないとします）。円い壁に沿えば十字はちょうど一回転、つまり4回分回ります。直角の角は、そのうち1回分を隠します。だから円板では4回、正方形では0回です。円い穴があれば4回分減り、環では0回になります。',
        },
      ],
    },
    {
      kind: 'not-so',
      key: 'halfway',
      figure: 'halfway',
      heading: { en: 'Not so: “halfway between 10° and 80° is 45°”', ja: '「10°と80°の中間は45°」ではありません' },
      text: {
        en: 'For arrows it is. To a square 80° is −10°. Turn the [[stroke|strokes]], painted lines that lead the rows. Then find two angles whose halfway is 45° after all.',
        ja: '矢印ならそのとおりです。けれども、正方形にとって80°は−10°と同じです。列を導くために引いた[[stroke|線]]を回してみてください。中間が本当に45°になる二つの角度も探してみましょう。',
      },
      ask: { en: 'One stroke at 10°, one at 80°: halfway between them squares stand …', ja: '10°と80°に線を引くと、その中間で正方形の向きは…' },
      answers: [
        { value: 'a', text: { en: 'at 45°', ja: '45°' } },
        { value: 'b', text: { en: 'at 0°, which is also 90°', ja: '0°（90°でも同じ）' }, right: true },
        { value: 'c', text: { en: 'in any direction: they cannot agree', ja: '決まらない' } },
      ],
      caption: {
        en: 'Strokes at 10° and 30°, and squares between them at about 20°, as with arrows. Turn the upper stroke on to 80°.',
        ja: '10°と30°の線と、その間におよそ20°で並ぶ正方形。ここまでは矢印と同じです。上の線を80°まで回してください。',
      },
    },
    {
      kind: 'exercise',
      figure: 'fork',
      key: 'fork',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'This fork has six square corners. Find a walk that does not count 0. Equation (b) says beforehand how much there is to find.',
        ja: 'この三差路には直角の角が六つあります。0回にならない道筋を見つけてください。何回になるかは、式(b)で前もって分かります。',
      },
      caption: { en: 'Three roads meet. This walk stays in one of them, and counts 0.', ja: '三本の道の出会うところ。この道筋は一本の中にあり、0回です。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'The paper of 2001 prints lengths in (1): their sum is a number and has no direction. The paper of 2000 has arrows.',
          ja: '2001年の論文の式(1)は長さの和で、数なので向きがありません。2000年の論文では矢印の和です。',
        },
        {
          en: 'Theirs keeps arrows on a grid and interpolates them. Ours does so with four-fold arrows.',
          ja: '論文は格子点の矢印を補間します。本プログラムは、四倍角の矢印を補間します。',
        },
      ],
    },
  ],
  sources: {
    en: 'K. Miyata, T. Itoh, K. Shimada (2000), 4.1, eq. (1), fig. 5; (2001), 4, eq. (1).',
    ja: 'K. Miyata, T. Itoh, K. Shimada（2000年）4.1節 式(1) 図5。宮田一乗、伊藤貴之、嶋田憲司（2001年）4章 式(1)。',
  },
};
