// Chapter 1. In a text, [[term|words]] leads to a term of the glossary, and $w = 1$ is a formula.
import { cases, fenced, over, raised, row } from './math.mjs';

const w3 = raised('w', 3);
const w2 = raised('w', 2);
const near = row('0 ≤ w ≤ 1.5');
const far = row('w ≥ 1.5');

export const twoBubbles = {
  name: 'two-bubbles',
  number: 1,
  title: { en: 'Two bubbles', ja: '二つのバブル' },
  idea: {
    en: 'One curve decides: push when near, pull when a little apart, nothing from 1.5 on.',
    ja: '一本の曲線がすべてを決めます。近ければ押し、少し離れれば引き、1.5から先では何もしません。',
  },
  description: {
    en: 'How two bubbles push and pull each other: the force and the potential of the bubble mesh, by hand.',
    ja: '二つのバブルはどのように押し合い、引き合うのか。バブルメッシュの力とポテンシャルを手で確かめます。',
  },
  blocks: [
    {
      kind: 'question',
      key: 'made',
      figure: 'top',
      heading: { en: 'What is this made of?', ja: 'これは何からできているでしょう' },
      text: {
        en: 'Nobody drew these stones. What did the program place first?',
        ja: '石を描いた人はいません。プログラムは、まず何を置いたのでしょうか。',
      },
      caption: {
        en: 'A finished pavement, taken apart from left to right: stones, cells, [[bubble|bubbles]], and at last two of them.',
        ja: 'できあがった石畳を、左から右へほどきました。石、セル、[[bubble|バブル]]、そして最後に二つのバブルが残ります。',
      },
      answers: [
        {
          value: 'a',
          text: { en: 'Stones that were cut one by one', ja: '一つずつ切り出した石' },
          reply: {
            en: 'A mason sees where the next stone fits. Here no stone had a place before all of them had one.',
            ja: '職人には、次の石の収まる場所が見えています。ここでは、すべての場所が決まるまで、どの石の場所も決まりません。',
          },
        },
        {
          value: 'b',
          text: { en: 'Bubbles that push and pull', ja: '押し合い、引き合うバブル' },
          right: true,
          reply: {
            en: 'Yes. They pushed and pulled until they came to rest. Then a cell was made around each, and a stone in each cell.',
            ja: 'そのとおりです。バブルが押し合い、引き合って落ち着いた後に、まわりにセルが、セルの中に石ができました。',
          },
        },
        {
          value: 'c',
          text: { en: 'A photograph, cut along its joints', ja: '目地に沿って切り抜いた写真' },
          reply: {
            en: 'A photograph has the stones that it has. These fit any outline, at any size, and no two are alike.',
            ja: '写真には、写っている石しかありません。ここの石は、どんな輪郭にも、どんな大きさにも収まり、同じ形は二つとありません。',
          },
        },
      ],
    },
    {
      kind: 'figure',
      figure: 'pair',
      heading: { en: 'The pair', ja: 'バブルの対' },
      text: {
        en: 'A bubble is a point with a [[force]] around it. Its circle shows the room it wants. The distance $w$ of two bubbles is counted so that their circles touch at $w = 1$. Move one bubble, and watch the arrows.',
        ja: 'バブルは、まわりに[[force|力]]を及ぼす点です。円は、そのバブルの求める広さを表します。二つの間の距離$w$は、円が触れ合うときに$w = 1$となるように測ります。片方を動かして、矢印を見てください。',
      },
      caption: {
        en: 'Two bubbles and the force on each; below them the force over the distance $w$, then the [[potential]], an energy. The dot is this pair. Forces are in units of $k0 / l0$, energies in $k0$, both as they are at [[stiffness]] 1. These signs are explained below.',
        ja: '二つのバブルと、それぞれに働く力。下は距離$w$に対する力、次は[[potential|ポテンシャル]]（エネルギー）。丸い印がこの対の位置です。力の単位は$k0 / l0$、エネルギーの単位は$k0$（[[stiffness|ばね定数]]が1のときの値）で、意味は後の本文で説明します。',
      },
    },
    {
      kind: 'prediction',
      key: 'far',
      figure: 'let-go',
      heading: { en: 'What will it do?', ja: 'どうなるでしょう' },
      text: {
        en: 'One bubble is held. The other is pulled to $w = 1.6$ and let go.',
        ja: '片方のバブルを留め、もう片方を$w = 1.6$まで引いてから放します。',
      },
      answers: [
        { value: 'a', text: { en: 'It drifts off', ja: '離れていく' } },
        { value: 'b', text: { en: 'It stays', ja: 'そのまま止まっている' }, right: true },
        { value: 'c', text: { en: 'It comes back', ja: '戻ってくる' } },
      ],
      caption: {
        en: 'A pair that was let go at $w = 0.6$. Its track runs down with time: it swings, and comes to [[rest]] where the circles touch.',
        ja: '$w = 0.6$から放した対。線は上から下へ、距離の時間変化を表します。揺れながら、円が触れ合うところで[[rest|静止]]します。',
      },
    },
    {
      kind: 'mark',
      key: 'near',
      figure: 'let-go',
      text: {
        en: 'Now without [[damping]], the drag that slows them ($c = 0$): how near may they start and not part for good? Mark it on the curve. Then try.',
        ja: '次は[[damping|減衰]]（動きを弱める抵抗）を$c = 0$にします。どこまで近づけて放しても、離れずにすむでしょうか。曲線に印を付けてから、試してください。',
      },
      blanks: [{ en: '$w =$', ja: '$w =$' }],
    },
    {
      kind: 'why',
      heading: { en: 'Why', ja: 'なぜ' },
      parts: [
        {
          en: 'Two bubbles of any size are compared by one number. Their [[stable-distance|stable distance]] $l0$ is half the sum of both diameters; the [[ratio]] $w = l / l0$ tells how many stable distances lie between the centres. At $w = 1$ the circles touch. The force is',
          ja: '大きさの違うバブルでも、一つの数で比べられます。二つの直径の平均を[[stable-distance|安定距離]]$l0$とし、中心間の距離$l$をこれで割った[[ratio|距離の比]]$w = l / l0$を使います。$w = 1$で円が触れ合います。力は次の式です。',
        },
        {
          equation: '2',
          math: `${row('f ( w ) =')}${cases([[`${over('k0', 'l0')}${fenced(`${over('5', '4')}${w3}<mo>−</mo>${over('19', '8')}${w2}<mo>+</mo>${over('9', '8')}`)}<mo>,</mo>`, near], ['<mn>0</mn><mo>,</mo>', far]])}`,
          speech: {
            en: 'f of w equals k zero over l zero, times the bracket: five quarters w cubed, minus nineteen eighths w squared, plus nine eighths, for w from 0 to 1.5; and 0 for w from 1.5 on.',
            ja: 'エフ・オブ・ダブリューは、ダブリューが0から1.5までのとき、エル・ゼロ分のケー・ゼロかける、かっこ、4分の5ダブリューの3乗、引く8分の19ダブリューの2乗、足す8分の9、かっことじ。1.5以上のとき0。',
          },
        },
        {
          en: 'Read it from left to right. At $w = 0$ it is a [[repulsion|push]] of 9/8, in units of $k0 / l0$. It falls to 0 at $w = 1$. Then comes a [[attraction|pull]], and from 1.5 on nothing: the bubble at 1.6 had no reason to move. Close to $w = 1$ the curve is nearly straight, as a spring’s is. The stiffness $k0$ says how steep: the slope is $− k0 / l0$.',
          ja: '左から読みます。$w = 0$では$k0 / l0$を単位として9/8の[[repulsion|斥力]]です。だんだん弱まり、$w = 1$で0になります。その先は[[attraction|引力]]、1.5から先は0です。1.6に置いたバブルには、動く理由がなかったのです。$w = 1$の近くでは曲線はほぼ直線で、ばねと変わりません。傾きは$− k0 / l0$で、ばね定数$k0$が大きいほど急です。',
        },
        {
          en: 'The work against this force, summed from 1.5 inwards, is the potential:',
          ja: 'この力に逆らってする仕事を1.5から内側へ足し合わせると、ポテンシャルになります。',
        },
        {
          equation: '3',
          math: `${row('psi ( w ) =')}${cases([[`<mo>−</mo>${row('k0')}${fenced(`${over('5', '16')}${raised('w', 4)}<mo>−</mo>${over('19', '24')}${w3}<mo>+</mo>${over('9', '8')}${row('w')}<mo>−</mo>${over('153', '256')}`)}<mo>,</mo>`, near], ['<mn>0</mn><mo>,</mo>', far]])}`,
          speech: {
            en: 'psi of w equals minus k zero times the bracket: five sixteenths w to the fourth, minus nineteen twenty-fourths w cubed, plus nine eighths w, minus 153 over 256, for w from 0 to 1.5; and 0 for w from 1.5 on.',
            ja: 'プサイ・オブ・ダブリューは、ダブリューが0から1.5までのとき、マイナス、ケー・ゼロかける、かっこ、16分の5ダブリューの4乗、引く24分の19ダブリューの3乗、足す8分の9ダブリュー、引く256分の153、かっことじ。1.5以上のとき0。',
          },
        },
        {
          en: 'It is a valley with its floor at $w = 1$, only 0.048 $k0$ deep, and a plain beyond 1.5. At $w = 0.718$ the wall is as high as the plain. Without damping no energy is lost: what starts higher than the plain leaves the valley for good.',
          ja: 'これは谷です。底は$w = 1$にあり、深さはわずか0.048 $k0$。1.5から先は平地で、$w = 0.718$では壁が平地と同じ高さになります。減衰がなければエネルギーは失われません。平地より高いところから出発すると、谷を出て戻りません。',
        },
        {
          en: 'Force moves the bubble by the [[equation-of-motion|equation of motion]], with a [[mass]] $m$ and the damping $c$, which takes energy away until all is at rest:',
          ja: 'バブルは[[equation-of-motion|運動方程式]]に従って動きます。$m$は[[mass|質量]]、$c$は減衰で、エネルギーを奪って、やがてバブルを静止させます。',
        },
        {
          equation: '5',
          math: row('m x.. + c x. = F'),
          speech: {
            en: 'm times the acceleration of x, plus c times the velocity of x, equals the force f.',
            ja: 'エムかけるエックスの加速度、足すシーかけるエックスの速度、イコール力エフ。',
          },
        },
      ],
    },
    {
      kind: 'not-so',
      key: 'broken',
      figure: 'not-so',
      heading: { en: 'Not so: “a spring, the farther the stronger”', ja: '「遠いほど強いばね」ではありません' },
      text: {
        en: 'A spring would pull harder the farther it is drawn. This pull is strongest at $w = 19/15$: 0.145, about an eighth of the strongest push. Then it fades, so a bubble never tugs at those behind its neighbours. Nor does every run come to rest. A computer walks in [[time-step|steps of time]]; [[euler|explicit Euler]] trusts the force at the start of a step for all of it. Make the step longer, and break it.',
        ja: 'ばねなら、伸ばすほど強く引きます。けれども、この引力が最も強いのは$w = 19/15$で、その大きさ0.145は最も強い斥力のおよそ8分の1です。その先では弱まるので、隣の向こうにいるバブルまで引くことはありません。また、この力があれば必ず落ち着くわけでもありません。計算は[[time-step|時間刻み]]ごとに進み、[[euler|陽的オイラー法]]は刻みの初めの力を刻みの終わりまで使います。刻みを大きくして、壊してみてください。',
      },
      ask: { en: 'What will explicit Euler do with a step of 1.0?', ja: '刻みを1.0にすると、陽的オイラー法はどうなるでしょう。' },
      answers: [
        { value: 'a', text: { en: 'It rests', ja: '静止する' } },
        { value: 'b', text: { en: 'It swings for ever', ja: '揺れつづける' } },
        { value: 'c', text: { en: 'It flies apart', ja: '飛び離れる' }, right: true },
      ],
      caption: {
        en: 'Damping 0.5. With a step of 0.2 Euler rests, with 0.55 it swings for ever, with 1.0 it flies apart, where [[runge-kutta|Runge–Kutta]] rests.',
        ja: '減衰は0.5。陽的オイラー法は、刻み0.2では静止し、0.55ではいつまでも揺れ、1.0では飛び散ります。同じ1.0でも[[runge-kutta|ルンゲ・クッタ法]]なら静止します。',
      },
    },
    {
      kind: 'exercise',
      figure: 'exercise',
      key: 'still',
      heading: { en: 'Your turn', ja: '練習' },
      text: {
        en: 'This pair swings past and back. Choose the damping so that it rests within 30 steps and never swings past.',
        ja: 'この対は行き過ぎては戻ります。減衰を選び、一度も行き過ぎずに30ステップ以内に静止させてください。',
      },
      caption: { en: 'Too little damping: the pair swings past the stable distance. One number is left to you.', ja: '減衰が足りず、安定距離を行き過ぎる対。残る数は一つ、あなたが決めます。' },
    },
    {
      kind: 'ours',
      heading: { en: 'Ours and theirs', ja: '論文と本プログラム' },
      lines: [
        {
          en: 'The paper prints $k0 / l0$ before the bracket of (3). Work is force over a length, so the factor is $k0$.',
          ja: '論文では(3)のかっこの前が$k0 / l0$です。仕事は力に長さをかけたものなので、ここでは$k0$としました。',
        },
        {
          en: 'The papers solve (5) by Runge–Kutta. Ours uses semi-implicit Euler, which moves a bubble with its new velocity: a quarter of the work, and bubbles come to rest as well.',
          ja: '論文は(5)をルンゲ・クッタ法で解きます。本プログラムは、更新した速度で位置を進める半陰的オイラー法を使います。計算は四分の一で、同じように静止します。',
        },
      ],
    },
  ],
  sources: {
    en: 'K. Miyata, T. Itoh, K. Shimada (2000), 4.2, eqs. (2), (3), fig. 6 (a), and 4.3, eq. (5); T. Itoh, K. Miyata, K. Shimada (2003), 5.1, fig. 5 (a).',
    ja: 'K. Miyata, T. Itoh, K. Shimada（2000年）4.2節 式(2)(3) 図6(a)、4.3節 式(5)。T. Itoh, K. Miyata, K. Shimada（2003年）5.1節 図5(a)。',
  },
};
