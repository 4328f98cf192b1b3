// Chapter 6. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { row, under } from './math.mjs';

export const howMany = {
  name: 'how-many',
  number: 6,
  title: { en: 'How many?', ja: 'いくつ置くのか' },
  idea: {
    en: 'Nobody says how many cells: the crowded leave, room is filled.',
    ja: '数はだれも決めません。混めば減り、空けば増えます。',
  },
  description: {
    en: 'How the number of cells comes about: who is crowded goes, and an empty place is filled. Thresholds, a hole, and runs that never rest.',
    ja: 'セルの数はどのように決まるのか。混んだところでは減り、空いたところでは増える規則を、しきい値や穴で確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'earlier6',
      figure: 'crowded',
      heading: { en: 'One is taken out', ja: '一つ抜き取ると' },
      text: {
        en: 'Round bubbles stand in a [[honeycomb]], each at $w = 1$ from six others. One is taken out. What do its six neighbours do?',
        ja: '円いバブルが[[honeycomb|蜂の巣状]]に並び、それぞれ六つの隣と$w = 1$で触れ合っています。一つを抜き取ると、まわりの六つはどうするでしょう。',
      },
      caption: {
        en: 'Too few at the start, and too many. The [[crowded]] ones go, an [[empty-place|empty place]] is filled. Below: who came and who went.',
        ja: '初めの個数が少なすぎる場合と、多すぎる場合。[[crowded|過密]]なものは去り、[[empty-place|空いた場所]]は埋まります。下は、増減の記録です。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'They rush in and close the hole', ja: '集まって穴をふさぐ' },
          reply: {
            en: 'A pull ends at 1.5. Across the hole the others are at 1.73 and 2, so nothing pulls them in.',
            ja: '引力は1.5で終わります。穴の向こうの相手までは1.73か2あるので、引き寄せるものはありません。',
          },
        },
        {
          value: 'b',
          text: { en: 'Nothing', ja: '何もしない' },
          right: true,
          reply: {
            en: 'Yes. At $w = 1$ the force is 0: the one that went did nothing to them. A hole stays until somebody fills it.',
            ja: 'そのとおり。$w = 1$の力は0で、抜けた一つは何もしていませんでした。穴は、だれかが埋めるまで残ります。',
          },
        },
        {
          value: 'c',
          text: { en: 'They fly apart', ja: '飛び散る' },
          reply: {
            en: 'For that they would have to be pressed. At $w = 1$ nobody pushes.',
            ja: '飛び散るのは、押し合っていた場合です。$w = 1$では、だれも押していません。',
          },
        },
      ],
    },
    {
      kind: 'prediction',
      key: 'hole',
      figure: 'hole',
      heading: { en: 'Does the rule see the hole?', ja: '規則は穴に気づくでしょうか' },
      text: {
        en: 'Every ten steps the program looks at all cells, and some come or go. The papers’ rule: a cell comes beside another that is far from its nearest neighbour. One cell is missing among cells at rest. Does the rule bring one?',
        ja: 'プログラムは10ステップごとにすべてのセルを調査し、増やしたり減らしたりします。論文の規則は「最も近い隣までが遠いセルのそばに、一つ増やす」です。静止したセルの中に、一つ欠けたところがあります。この規則で一つ増えるでしょうか。',
      },
      answers: [
        { value: 'a', text: { en: 'Yes, one comes', ja: 'はい、一つ増える' } },
        { value: 'b', text: { en: 'No, none comes', ja: 'いいえ、増えない' }, right: true },
      ],
      caption: {
        en: 'The same hole twice: under the papers’ rule, which looks at the [[smallest-w|smallest w]] of each cell, and under ours, which looks at the hole.',
        ja: '同じ穴に対する二つの規則。論文の規則は各セルの[[smallest-w|wの最小値]]を、本プログラムの規則は穴そのものを見ます。',
      },
    },
    {
      kind: 'prediction',
      key: 'never',
      figure: 'never',
      heading: { en: 'Break it', ja: '壊してみる' },
      text: {
        en: 'Two [[threshold|thresholds]] decide. A cell goes if its nearest neighbour is nearer than $a$; another comes beside it if that neighbour is at $b$ or farther. Let them cross: $a = 0.95$ and $b = 0.85$. What will happen?',
        ja: '二つの[[threshold|しきい値]]が増減を決めます。最も近い隣が$a$より近いセルは去り、$b$以上離れているセルのそばには一つ増えます。これを逆転させて、$a = 0.95$、$b = 0.85$とします。どうなるでしょう。',
      },
      answers: [
        { value: 'a', text: { en: 'It rests after the first look', ja: '一度の調査で落ち着く' } },
        { value: 'b', text: { en: 'It rests with more cells', ja: 'セルが増えて落ち着く' } },
        { value: 'c', text: { en: 'Cells come and go at every look', ja: '調査のたびに増えたり減ったりする' }, right: true },
      ],
      caption: {
        en: 'A run whose thresholds leave room between them: it comes to rest. Each dot is a cell at its smallest $w$. Move the thresholds over each other.',
        ja: '二つのしきい値の間に余裕がある計算。静止します。点は各セルの$w$の最小値です。しきい値を動かして、逆転させてください。',
      },
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        {
          en: 'At the start nobody can know the [[population]]. The papers begin with a good guess, by a [[quadtree]], and correct it on the way. Up to step 100 our program looks at each cell $i$ every ten steps, and when all are at rest. A cell goes if its nearest neighbour is too near:',
          ja: '[[population|個数]]は、初めには分かりません。論文は[[quadtree|四分木]]で見当をつけ、計算の途中で直します。本プログラムは、100ステップまで、10ステップごとと全体が静止したときに、各セル$i$を調べます。最も近い隣が近すぎるセルは去ります。',
        },
        {
          equation: 'a',
          math: `${under('min', 'j ≠ i')}${row('wij < a')}`,
          speech: {
            en: 'The smallest w i j over all j other than i is less than a.',
            ja: 'アイ以外のすべてのジェーについてのダブリュー・アイ・ジェーの最小値は、エーより小さい。',
          },
        },
        {
          en: 'The most crowded go first, and never two neighbours at once: where one goes, the other has room. For coming, the paper of 2003 turns the test round: beside a cell whose smallest $w$ is larger than a value. But cells at a hole touch others behind them, so their smallest $w$ stays near 1. The test finds who is lonely. A hole is not lonely. So ours asks the place $p$ itself:',
          ja: '最も混んだものから去り、隣り合う二つが同時に去ることはありません。一つが去れば、もう一つには余裕ができるからです。増やすときは、2003年の論文はこれを裏返し、$w$の最小値がある値より大きいセルのそばに置きます。けれども、穴の縁のセルは後ろの隣と触れ合っているので、$w$の最小値は1の近くにとどまります。この規則で見つかるのは孤立したセルで、穴ではありません。そこで本プログラムは、場所$p$そのものを調べます。',
        },
        {
          equation: 'b',
          math: `${under('min', 'j')}${row('wp ≥ b')}`,
          speech: {
            en: 'The smallest w p j over all j is at least b.',
            ja: 'すべてのジェーについてのダブリュー・ピー・ジェーの最小値は、ビー以上。',
          },
        },
        {
          en: 'Places are tried where a neighbour would touch: four round a square, six round a bubble. With $a$ well below $b$ there is peace between them. If they cross, a cell between them is too near and too far at once: it must go, and it calls for another. For round cells our own $b$, 0.63, is below $a$, 0.74: ten steps pass between looks, and in these all six neighbours make room.',
          ja: '調べるのは、隣が触れ合うはずの場所です。正方形なら四つ、円なら六つあります。$a$が$b$より十分に小さければ、その間は平穏です。逆転すると、その間のセルは近すぎると同時に遠すぎることになり、自分は去って、別のセルを呼びます。円では、本プログラムの$b$は0.63で、$a$の0.74より小さくなっています。次に調べるまでの10ステップの間に、まわりの六つが場所を空けるからです。',
        },
      ],
    },
    {
      kind: 'not-so',
      key: 'count',
      figure: 'count',
      heading: { en: 'Not so: “the number is area over size squared”', ja: '「個数は面積÷大きさの2乗」ではありません' },
      text: {
        en: 'Far from all walls it would nearly do: a square of size $d$ takes $d²$, a round cell in a honeycomb 0.87 of it. But cells come whole. An arm of the outline that is a little too narrow for two rows holds one, and the rest of its area holds nothing. With smaller cells it suddenly holds two. Area knows nothing of that.',
        ja: '壁から遠ければ、だいたい合います。大きさ$d$の正方形一つの面積は$d²$、蜂の巣状に並んだ円ではその0.87倍です。けれども、セルは丸ごとしか置けません。二列には少し狭い腕には一列しか入らず、残りの面積は使えません。セルを小さくすると、急に二列入ります。面積だけでは、それは分かりません。',
      },
      ask: { en: 'A U and a square have the same area. With cells of 34 pixels the U holds 13 and the square 19. With cells of 28 pixels the U holds …', ja: 'U字形と正方形の面積は同じです。セルの大きさが34ピクセルなら、U字形に13個、正方形に19個入ります。28ピクセルにすると、U字形に入るのは正方形と比べて…' },
      answers: [
        { value: 'a', text: { en: 'just as many as the square', ja: '同じ数' } },
        { value: 'b', text: { en: 'more than the square', ja: '正方形より多い' }, right: true },
        { value: 'c', text: { en: 'fewer than the square', ja: '正方形より少ない' } },
      ],
      caption: {
        en: 'Two outlines of one area, with their cells at rest. The bars: how many there are, and area over size squared, which is 17.3 for both.',
        ja: '面積の等しい二つの輪郭と、静止したセル。棒は実際の個数と、面積÷大きさの2乗（どちらも17.3）です。',
      },
    },
    {
      kind: 'exercise',
      figure: 'right-number',
      key: 'right',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'Be the good guess: choose the number at the start so that nobody comes and nobody goes.',
        ja: 'よい見当をつけてください。一つも増えず、一つも減らないように、初めの個数を選びましょう。',
      },
      caption: { en: 'A start with too few: some come. Which number needs no correction?', ja: '初めの個数が少なく、途中で増えた計算。直さずにすむ個数はいくつでしょう。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'The paper leaves both thresholds to the user. Ours has values for each kind: $a$ is 0.66 for squares and 0.74 for round cells, $b$ is 0.72 and 0.63.',
          ja: '論文は二つのしきい値を利用者に任せます。本プログラムには種類ごとの値があり、$a$は正方形0.66、円0.74、$b$は0.72と0.63です。',
        },
        {
          en: 'The paper of 2000 says octree. In a plane a node has four children: a quadtree.',
          ja: '2000年の論文には八分木とありますが、平面では枝は四つ、四分木です。',
        },
      ],
    },
  ],
  sources: {
    en: 'K. Miyata, T. Itoh, K. Shimada (2000), 4.3; T. Itoh, K. Miyata, K. Shimada (2003), 5.1.',
    ja: 'K. Miyata, T. Itoh, K. Shimada（2000年）4.3節。T. Itoh, K. Miyata, K. Shimada（2003年）5.1節。',
  },
};
