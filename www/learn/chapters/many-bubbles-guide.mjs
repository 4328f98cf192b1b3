// Chapter 2 in the teacher's guide. A state is a figure with other values than those that it opens with.

export const manyBubblesGuide = {
  aims: [
    { en: 'Add forces as arrows, and say from the sum which way a bubble will go.', ja: '力を矢印として足し、その和からバブルの動く向きを言える。' },
    { en: 'Tell the energy of the pairs from the sum of all energies, and say which of them must fall.', ja: '対のエネルギーと全エネルギーを区別し、必ず減るのはどちらかを言える。' },
    { en: 'Explain why a local minimum is found, why it depends on the start, and why it is good enough.', ja: '見つかるのが極小解であること、それが初期位置によること、それで十分なことを説明できる。' },
  ],
  before: [
    { en: 'Chapter 1: push, pull, potential, damping.', ja: '第1章（斥力、引力、ポテンシャル、減衰）。' },
    { en: 'To add two arrows. For the equations: the sign for a sum.', ja: '二つの矢印の足し方。式には、和の記号Σ。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–4', { en: 'Free play with the crowd: look at one bubble, then at all.', ja: '群れの図で自由に遊ぶ。一つを見て、全体を見る。' }],
        ['4–7', { en: 'Three in a row: does the third act on the first?', ja: '一列の三つ。三番目は一番目に力を及ぼすか。' }],
        ['7–16', { en: 'Two starts: predict, argue, try.', ja: '二つの初期位置。予想、討論、実験。' }],
        ['16–20', { en: 'Is it the best? Each group tries three starts; the lowest number wins nothing but a clap.', ja: '最良か。各班が三通り試し、最も低い班に拍手。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–10', { en: 'Free play with the crowd; bend the outline. Collect what was noticed.', ja: '群れの図で遊び、輪郭を曲げる。気づきを集める。' }],
        ['10–15', { en: 'Three in a row.', ja: '一列の三つ。' }],
        ['15–28', { en: 'Two starts: predict, argue, try.', ja: '二つの初期位置。予想、討論、実験。' }],
        ['28–42', { en: 'Does the energy fall at every step? Hunt for a step at which the pairs gain.', ja: 'エネルギーは毎回減るか。対が増えるステップを探す。' }],
        ['42–52', { en: 'The sum of forces, equation (5), and why E cannot rise.', ja: '力の和、式(5)、Eが増えない理由。' }],
        ['52–60', { en: 'Is it the best? The exercise is homework.', ja: '最良か。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–30', { en: 'Coins on a tray: shake, let go, draw. Then free play with the crowd.', ja: '盆の上の硬貨を揺すって並べ、写す。それから群れの図で遊ぶ。' }],
        ['30–70', { en: 'Three in a row, and two starts, with the sheet.', ja: '一列の三つと二つの初期位置を、プリントで。' }],
        ['70–110', { en: 'The energies. Derive the rate of E from (5): multiply by the velocity and add up.', ja: 'エネルギー。(5)に速度をかけて足し、Eの変化率を導く。' }],
        ['110–140', { en: 'Is it the best? Draw all energies that the class has found along one line.', ja: '最良か。クラスで見つけたエネルギーを一本の線の上に並べる。' }],
        ['140–165', { en: 'The exercise; then read section 2.2 of the paper of 2001.', ja: '練習。2001年の論文の2.2節を読む。' }],
        ['165–180', { en: 'Where else is good and quick better than best? Collect examples.', ja: '「最良」より「十分に良くて速い」がよいのは、ほかにどんなときか。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'Three in a row: what does the third do to the first?', ja: '一列の三つ。三番目は一番目にどんな力を及ぼすか' },
      right: { en: 'b. Nothing: they are at w = 2, and the force ends at 1.5.', ja: 'b。力を及ぼさない。距離はw = 2で、力は1.5までしか届かない。' },
      thoughts: [
        [{ en: 'a, a weaker pull:', ja: 'a（弱く引く）：' }, { en: 'thinks of gravity, which never ends.', ja: '重力のように、力はどこまでも届くと考えている。' }],
        [{ en: 'c, a push through the second:', ja: 'c（二番目を通して押す）：' }, { en: 'thinks of wagons in a row, which hand a push on.', ja: '列車の連結のように、押す力が伝わると考えている。' }],
      ],
    },
    {
      question: { en: 'Different first places, one outline: how do they end?', ja: '輪郭が同じで初期位置が違うと、どう終わるか' },
      right: { en: 'c. They differ in both, picture and energy.', ja: 'c。絵もエネルギーも違う。' },
      thoughts: [
        [{ en: 'a, the same picture:', ja: 'a（同じ絵）：' }, { en: 'thinks that there is one best packing, and that it must be found.', ja: '最良の充填が一つあり、必ずそこに着くと考えている。' }],
        [{ en: 'b, one energy:', ja: 'b（エネルギーは同じ）：' }, { en: 'thinks that rest means the same for all: as low as possible.', ja: '静止すればどれも同じ最低の高さだと考えている。' }],
      ],
    },
    {
      question: { en: 'Does the energy of the pairs fall at every step?', ja: '対のエネルギーは、毎回減るか' },
      right: { en: 'b. No. The sum with walls and motion does; the pairs gain when motion carries bubbles uphill.', ja: 'b。いいえ。必ず減るのは壁と運動を含めた合計。動きの勢いで坂を上れば、対の分は増える。' },
      thoughts: [
        [{ en: 'a, yes:', ja: 'a（はい）：' }, { en: 'sees where it begins and where it ends, and takes the way for straight.', ja: '初めと終わりを見て、途中もまっすぐ下ると考えている。' }],
      ],
    },
    {
      question: { en: 'Is the packing in the figure the best one?', ja: '図の充填は最良か' },
      right: { en: 'b. No: another start ends lower.', ja: 'b。いいえ。別の初期位置から、もっと低い谷に着く。' },
      thoughts: [
        [{ en: 'a, yes:', ja: 'a（はい）：' }, { en: 'takes rest for proof: what no push can improve must be best. It is best only among its neighbours.', ja: '静止を証拠とみている。少し動かしても良くならないのは、近くで最良というだけである。' }],
      ],
    },
  ],
  wrong: [
    { en: 'A bubble at rest is thought to be free of forces. Look at one near a wall: its arrows cancel.', ja: '静止していれば力を受けていないと思う。壁際の一つを見せる。矢印が打ち消し合っている。' },
    { en: 'Small differences of energy are taken for errors. Start again: the same start ends in the same number, digit by digit.', ja: 'エネルギーの小さな差を誤差と思う。同じ初期位置からやり直せば、最後の桁まで同じになる。' },
    { en: 'The outline is bent while the crowd moves. The run begins anew: say so.', ja: '動いている途中で輪郭を曲げる。計算は最初からやり直しになることを伝える。' },
    { en: 'Hunting for a gain of the pairs, pupils play too fast. Let them step.', ja: '対が増えるステップを探すのに、再生が速すぎる。一歩ずつ進めさせる。' },
  ],
  states: [
    { figure: 'crowd', what: { en: 'The crowd before it is let go', ja: '放す前の群れ' } },
    { figure: 'crowd', values: { step: '200' }, what: { en: 'The crowd at rest: arrows cancel', ja: '静止した群れ（矢印が打ち消し合う）' } },
    { figure: 'two-starts', values: { step: '0' }, what: { en: 'Two starts, before they run', ja: '二つの初期位置、動き出す前' } },
    { figure: 'energy', values: { step: '0' }, what: { en: 'A shaken crowd: hunt for a gain', ja: '揺さぶった群れ（増えるステップを探す）' } },
    { figure: 'energy', values: { damp: '2', step: '0' }, what: { en: 'The same with damping 2: no gain', ja: '減衰2の場合（増えない）' } },
    { figure: 'best', what: { en: 'Is this the best?', ja: 'これは最良か' } },
    { figure: 'quiet', what: { en: 'The exercise', ja: '練習' } },
  ],
};
