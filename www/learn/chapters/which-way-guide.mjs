// Chapter 5 in the teacher's guide. A state is a figure with other values than those that it opens with.

export const whichWayGuide = {
  aims: [
    { en: 'Explain why the direction of a square is an angle up to quarter turns, and no arrow.', ja: '正方形の向きは90°ごとに同じになる角度で、矢印ではないことを説明できる。' },
    { en: 'Say where the printed sum fails in a road, and how the four-fold angle mends it.', ja: '論文の式による和が道のどこで働かなくなるか、四倍角がそれをどう直すかを言える。' },
    { en: 'Count quarter turns on a walk, and say beforehand how many an outline has.', ja: '一周で90°回転を数え、輪郭ごとの数を前もって言える。' },
  ],
  before: [
    { en: 'Chapter 4: the four wells of a square.', ja: '第4章（正方形の四つの井戸）。' },
    { en: 'To add arrows. For the equations: angles beyond 360°, cosine and sine; the integral only as a sum of small pieces.', ja: '矢印の足し方。式には、360°を超える角、余弦と正弦。積分は細かく分けた和としてだけ使う。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–4', { en: 'Free play: turn the square, watch both arrows. Where are the wells now?', ja: '自由に遊ぶ。正方形を回し、二つの矢印を見る。井戸はどこか。' }],
        ['4–12', { en: 'In the middle of the road: predict, argue, move the point.', ja: '道の真ん中。予想、討論、点を動かす。' }],
        ['12–20', { en: 'Halfway between 10° and 80°: predict, argue, turn the stroke.', ja: '10°と80°の中間。予想、討論、線を回す。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–8', { en: 'Free play with the square and the road.', ja: '正方形と道の図で自由に遊ぶ。' }],
        ['8–12', { en: 'Where are the wells now?', ja: '井戸はどこか。' }],
        ['12–24', { en: 'In the middle of the road: predict, argue, try.', ja: '道の真ん中。予想、討論、実験。' }],
        ['24–32', { en: 'Ten pieces.', ja: '辺を十等分する。' }],
        ['32–44', { en: 'Equation (1), and the four-fold sum, term by term for a road.', ja: '式(1)と四倍角の和を、道の辺ごとに。' }],
        ['44–54', { en: 'Halfway between 10° and 80°.', ja: '10°と80°の中間。' }],
        ['54–60', { en: 'Once around, as a show. The exercise is homework.', ja: '「ぐるりと一周」を見せる。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–25', { en: 'Paper squares and paper arrows on pins: turn them, and note which turns can be seen. Then free play.', ja: '紙の正方形と矢印をピンで留めて回し、見分けられる回転を書き出す。それから自由に遊ぶ。' }],
        ['25–60', { en: 'Where are the wells, the middle of the road, ten pieces, with the sheet.', ja: '井戸の場所、道の真ん中、十等分、をプリントで。' }],
        ['60–95', { en: 'Equation (1) by hand: a road of 5 by 1, its middle, then with one side cut into ten.', ja: '式(1)を手で計算する。5×1の道の真ん中、次に一辺を十等分した場合。' }],
        ['95–130', { en: 'Once around: walk round the classroom along its walls with a paper cross. Count. Then equation (b) and the figure: an oval pulls four singular points apart, and the count stays.', ja: '紙の十字を持って教室の壁沿いに一周し、数える。次に式(b)と図。楕円にすると特異点は四つに分かれるが、数は変わらない。' }],
        ['130–155', { en: 'Halfway between 10° and 80°; which pairs have no halfway?', ja: '10°と80°の中間。中間の決まらない組はどれか。' }],
        ['155–180', { en: 'The exercise. Hexagons look alike after 60°: how does the chapter go for them?', ja: '練習。六角形は60°で元に戻る。この章はどう変わるか。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'A square is turned by 90°: where are its wells?', ja: '正方形を90°回すと、井戸はどこにあるか' },
      right: { en: 'b. Where they were: each is at the place of the next one.', ja: 'b。元の場所。それぞれが次の井戸の場所に来る。' },
      thoughts: [
        [{ en: 'a, at four new places:', ja: 'a（新しい四つの場所）：' }, { en: 'follows one well, and not all four.', ja: '四つ全体でなく、一つの井戸を追っている。' }],
        [{ en: 'c, beyond the corners:', ja: 'c（角の先）：' }, { en: 'takes half a step of symmetry for a whole one: that is 45°.', ja: '対称の一区切りを半分に取り違えている（45°の場合）。' }],
      ],
    },
    {
      question: { en: 'In the middle of a straight road the printed sum points …', ja: 'まっすぐな道の真ん中で、論文の式による和はどちらを向くか' },
      right: { en: 'c. Nowhere: both long sides cancel, and less than 2 % of the arrows’ lengths are left on the middle half of the road.', ja: 'c。どこも向かない。長い辺どうしが打ち消し合い、道の中ほど半分では、矢印の長さの合計の2%も残らない。' },
      thoughts: [
        [{ en: 'a, along:', ja: 'a（沿う）：' }, { en: 'sees two long sides that lie along the road, and forgets that arrows have a sense.', ja: '二本の辺が道に沿うことを見て、矢印の前後を忘れている。' }],
        [{ en: 'b, across:', ja: 'b（横切る）：' }, { en: 'is right about the small rest away from the centre: the ends leave it. Ask how long it is.', ja: '中心を外れたときのわずかな残りについては正しい。どれくらいの長さかを問う。' }],
      ],
    },
    {
      question: { en: 'One side is cut into ten: which sum changes in the middle?', ja: '一つの辺を十等分すると、真ん中で変わるのはどちらの和か' },
      right: { en: 'b. The printed one: the cut side counts less than before, so it no longer cancels the other.', ja: 'b。論文の式による和。切った辺の重みが減り、もう一方と打ち消し合わなくなる。' },
      thoughts: [
        [{ en: 'a, neither:', ja: 'a（どちらも変わらない）：' }, { en: 'trusts that the same shape gives the same sum; so it should be.', ja: '形が同じなら和も同じだと考えている。本来そうあるべきである。' }],
        [{ en: 'c, both:', ja: 'c（両方）：' }, { en: 'thinks that more pieces are more terms, and more terms another sum.', ja: '項が増えれば和も変わると考えている。' }],
      ],
    },
    {
      question: { en: 'Once around a round place: how many quarter turns?', ja: '円い広場を一周すると、90°回転は何回分か' },
      right: { en: 'c. Four: along the wall the cross turns once.', ja: 'c。4回。壁に沿えば、十字はちょうど一回転する。' },
      thoughts: [
        [{ en: 'a, none:', ja: 'a（0回）：' }, { en: 'sees the cross come back as it was, and forgets the way.', ja: '十字が元に戻ったことだけを見て、途中を数えていない。' }],
        [{ en: 'b, one:', ja: 'b（1回）：' }, { en: 'thinks of the smallest turn that a square cannot see. It takes four of them to go round.', ja: '正方形が見分けられない最小の回転を考えている。一周にはそれが四つ要る。' }],
      ],
    },
    {
      question: { en: 'Strokes at 10° and 80°: which way do squares stand halfway?', ja: '10°と80°の線の中間で、正方形はどちらを向くか' },
      right: { en: 'b. At 0°, as 80° is −10° to a square.', ja: 'b。0°。正方形にとって80°は−10°と同じ。' },
      thoughts: [
        [{ en: 'a, at 45°:', ja: 'a（45°）：' }, { en: 'takes the mean of the numbers. At 45° a square would stand 35° off both.', ja: '数を平均している。45°では、どちらの線とも35°ずれる。' }],
        [{ en: 'c, they cannot agree:', ja: 'c（決まらない）：' }, { en: 'is right about strokes that are 45° apart, such as 10° and 55°.', ja: '45°離れた場合（10°と55°など）については正しい。' }],
      ],
    },
  ],
  wrong: [
    { en: 'Four-fold arrows are read as directions of squares. They are four times the angle: divide first.', ja: '四倍角の矢印を正方形の向きと読む。角度を4で割ってから読む。' },
    { en: 'On the middle line, but off the centre, a small arrow is left, and pupils cry “across”. Read its length beside the lengths of the terms.', ja: '中央線の上でも中心を外れると小さな矢印が残り、「横切る」と思う。長さを、各項の長さと比べて読ませる。' },
    { en: 'The walk runs over a singular point, and its count is not whole or jumps. Choose another radius.', ja: '道筋が特異点の上を通り、数が整数にならなかったり跳んだりする。半径を変える。' },
    { en: 'In the ring a walk around the hole counts four, and pupils look for singular points in the ring. They belong to the hole: inside of the ring there are none.', ja: '環で穴を囲んで一周すると4回になり、環の中に特異点を探してしまう。この4回は穴のもので、環の中に特異点はない。' },
    { en: 'Angles are counted clockwise on screen, here as in the studio; pupils may expect the other sense. Only differences matter.', ja: '角度は、図でもスタジオでも画面上の時計回り。反対回りと思う生徒がいる。大切なのは角度の差だけである。' },
  ],
  states: [
    { figure: 'quarter', values: { angle: '0' }, what: { en: 'The square before it is turned', ja: '回す前の正方形' } },
    { figure: 'road', values: { at: '0.5,0.5' }, what: { en: 'The middle of the road', ja: '道の真ん中' } },
    { figure: 'road', values: { at: '0.7,0.5' }, what: { en: 'On the middle line, off the centre', ja: '中央線の上、中心から外れた点' } },
    { figure: 'pieces', values: { pieces: '10' }, what: { en: 'One side in ten pieces', ja: '一つの辺を十等分' } },
    { figure: 'walk', what: { en: 'A walk that counts 0', ja: '0回の道筋' } },
    { figure: 'walk', values: { at: '0.5,0.5,0.3' }, what: { en: 'A walk around the middle', ja: '中心を囲む道筋' } },
    { figure: 'halfway', what: { en: 'Strokes at 10° and 30°', ja: '10°と30°の線' } },
    { figure: 'fork', what: { en: 'The exercise', ja: '練習' } },
  ],
};
