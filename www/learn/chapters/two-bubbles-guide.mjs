// Chapter 1 in the teacher's guide. Links to states are made as figures make theirs.

const PAIR = 'outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&fend=0&mend=0&most=1000';

/** The state of a figure: a pair at a distance. @param {string} figure @param {number} w @param {string} values */
const state = (figure, w, values) => `fig=${figure}&${PAIR}&given=0.25,0.5,1;${0.25 + w / 4},0.5,0&${values}`;

export const twoBubblesGuide = {
  aims: [
    { en: 'Say from the curve whether a pair pushes, pulls or does nothing.', ja: '曲線から、二つが押し合うか、引き合うか、何もしないかを言える。' },
    { en: 'Tell force and potential apart, and read one from the other.', ja: '力とポテンシャルを区別し、一方から他方を読み取れる。' },
    { en: 'Explain why damping brings rest, and why a long step can destroy it.', ja: '減衰が静止をもたらすこと、長すぎる時間刻みがそれを壊すことを説明できる。' },
  ],
  before: [
    { en: 'Distance, speed, and that a force changes a speed.', ja: '距離、速さ、力が速さを変えること。' },
    { en: 'To read a curve. For the equations: powers; for the potential: that work is force times a way.', ja: 'グラフの読み方。式にはべき乗、ポテンシャルには「仕事＝力×距離」。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–3', { en: 'The top picture: what was placed first? Then take it apart.', ja: '冒頭の絵。何を置いたのか。予想してから、ほどく。' }],
        ['3–7', { en: 'Free play with the pair.', ja: '対の図で自由に遊ぶ。' }],
        ['7–14', { en: 'w = 1.6: predict, argue, try. Read the curve beyond 1.5.', ja: 'w = 1.6。予想、討論、実験。1.5から先の曲線を読む。' }],
        ['14–18', { en: 'Not a spring: find the strongest pull.', ja: 'ばねではない。最も強い引力を探す。' }],
        ['18–20', { en: 'Each pupil draws the curve from memory.', ja: '各自、曲線を思い出して描く。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–5', { en: 'The top picture.', ja: '冒頭の絵。' }],
        ['5–15', { en: 'Free play with the pair. Collect what was noticed.', ja: '対の図で自由に遊び、気づきを集める。' }],
        ['15–27', { en: 'w = 1.6: predict, argue, try.', ja: 'w = 1.6。予想、討論、実験。' }],
        ['27–40', { en: 'Without damping: marks on the curve, then starts until two are less than 0.02 apart.', ja: '減衰なし。曲線に印を付け、差が0.02より小さい二つの出発点が見つかるまで試す。' }],
        ['40–50', { en: 'Equations (2) and (3), symbol by symbol.', ja: '式(2)と(3)を、記号ごとに。' }],
        ['50–60', { en: 'Break it: steps of 0.2, 0.55 and 1.0. The exercise is homework.', ja: '壊してみる。刻み0.2、0.55、1.0。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–25', { en: 'The top picture; free play; each group writes down three laws of bubbles.', ja: '冒頭の絵。自由に遊び、班ごとに「バブルの法則」を三つ書く。' }],
        ['25–60', { en: 'Both predictions with the sheet.', ja: '二つの予想を、プリントで。' }],
        ['60–100', { en: 'Equations. Check f(0), f(1), f(1.5) by hand; find 19/15 by calculus or from the figure.', ja: '式。f(0)、f(1)、f(1.5)を手計算し、19/15を微分または図から求める。' }],
        ['100–140', { en: 'Write one step of Euler on paper for the pair at w = 0.9, then compare with the figure.', ja: 'w = 0.9の対について、オイラー法の一ステップを紙で計算し、図と比べる。' }],
        ['140–165', { en: 'Break it; the exercise; then a third bubble in the studio.', ja: '壊してみる。練習。スタジオで三つ目のバブル。' }],
        ['165–180', { en: 'Back to the three laws: which ones hold?', ja: '三つの法則に戻る。どれが正しかったか。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'What is the picture made of?', ja: '絵は何からできているか' },
      right: { en: 'b. Bubbles that push and pull. The stones come last.', ja: 'b。押し合い、引き合うバブル。石は最後にできる。' },
      thoughts: [
        [{ en: 'a, stones cut one by one:', ja: 'a（石を一つずつ）：' }, { en: 'thinks of the mason, for whom the order of work is the order of places.', ja: '職人を思い浮かべ、作業の順序と場所の決まる順序を同じとみている。' }],
        [{ en: 'c, a photograph:', ja: 'c（写真）：' }, { en: 'takes what looks real for recorded.', ja: '本物らしいものは写したものだと考えている。' }],
      ],
    },
    {
      question: { en: 'Pulled to w = 1.6 and let go?', ja: 'w = 1.6まで引いて放すと' },
      right: { en: 'b. It stays: from 1.5 on the force is 0.', ja: 'b。とどまる。1.5から先では力が0。' },
      thoughts: [
        [{ en: 'a, it drifts off:', ja: 'a（離れていく）：' }, { en: 'thinks that what is not held must move, or that push goes on for ever.', ja: '支えのないものは動く、または押す力がどこまでも続くと考えている。' }],
        [{ en: 'c, it comes back:', ja: 'c（戻ってくる）：' }, { en: 'thinks of a spring or a rubber band: whatever is drawn wants back.', ja: 'ばねやゴムのように、引けば必ず戻ると考えている。' }],
      ],
    },
    {
      question: { en: 'Without damping, how near may they start?', ja: '減衰なしで、どこまで近くから始められるか' },
      right: { en: '0.718, where Ψ is 0: as high as the plain beyond 1.5.', ja: '0.718。Ψが0、つまり1.5から先の平地と同じ高さになるところ。' },
      thoughts: [
        [{ en: 'A mark at 0.5:', ja: '0.5に印：' }, { en: 'mirrors 1.5 at 1. The curve is not symmetric: the push is far stronger.', ja: '1を中心に1.5を折り返している。斥力のほうがずっと強く、曲線は対称ではない。' }],
        [{ en: 'A mark near 1:', ja: '1の近くに印：' }, { en: 'thinks that any push leads away, and forgets the pull on the way.', ja: '押されれば離れると考え、途中で働く引力を忘れている。' }],
        [{ en: 'A mark close to 0:', ja: '0の近くに印：' }, { en: 'thinks that the pull always wins in the end.', ja: '最後には必ず引力が勝つと考えている。' }],
      ],
    },
    {
      question: { en: 'Explicit Euler with a step of 1.0?', ja: '刻み1.0の陽的オイラー法は' },
      right: { en: 'c. It flies apart: each step overshoots by more than damping takes away.', ja: 'c。飛び離れる。一歩ごとの行き過ぎが、減衰の奪う分より大きい。' },
      thoughts: [
        [{ en: 'a, it rests:', ja: 'a（静止する）：' }, { en: 'thinks that damping always wins, and that a longer step only saves time.', ja: '減衰が必ず勝ち、刻みを大きくしても時間が節約されるだけだと考えている。' }],
        [{ en: 'b, it swings for ever:', ja: 'b（揺れつづける）：' }, { en: 'sees the overshoot, but takes it for a balance, as at 0.55.', ja: '行き過ぎには気づいているが、0.55のときのように釣り合うとみている。' }],
      ],
    },
  ],
  wrong: [
    { en: 'Pupils take the circle for a wall. It is only the room that a bubble wants: circles may overlap.', ja: '円を壁だと思う。円は求める広さにすぎず、重なってもよい。' },
    { en: 'A minus sign of the force is read as “weaker”. Say push and pull first, signs later.', ja: '力の負号を「弱い」と読む。先に「押す」「引く」と言い、符号は後で。' },
    { en: 'The potential is taken for a track in space. Its axis is the distance, not a place.', ja: 'ポテンシャルの谷を実際の坂道と思う。横軸は場所ではなく距離である。' },
    { en: 'With damping left on, every start comes back from farther inside. Check that it reads 0.', ja: '減衰を残したまま試すと、もっと近くから始めても戻ってくる。0になっているか確かめる。' },
  ],
  states: [
    { link: state('pair', 0.7, 'damp=0.5&move=rk4&dt=0.1'), what: { en: 'The pair at w = 0.7', ja: 'w = 0.7の対' } },
    { link: state('let-go', 1.6, 'damp=0.6&move=rk4&dt=0.1&step=0'), what: { en: 'Pulled to 1.6, before it is let go', ja: '1.6まで引き、放す前' } },
    { link: state('let-go', 0.9, 'damp=0&move=rk4&dt=0.1&step=0'), what: { en: 'Without damping, from 0.9', ja: '減衰なし、0.9から' } },
    { link: state('let-go', 0.6, 'damp=0&move=rk4&dt=0.1&step=0'), what: { en: 'Without damping, from 0.6: it parts', ja: '減衰なし、0.6から（離れる）' } },
    { link: state('not-so', 0.9, 'damp=0.5&move=euler&dt=0.2&step=100'), what: { en: 'Euler, step 0.2: rest', ja: 'オイラー法、刻み0.2：静止' } },
    { link: state('not-so', 0.9, 'damp=0.5&move=euler&dt=0.55&step=60'), what: { en: 'Euler, step 0.55: it swings on', ja: 'オイラー法、刻み0.55：揺れつづける' } },
    { link: state('not-so', 0.9, 'damp=0.5&move=euler&dt=1&step=60'), what: { en: 'Euler, step 1.0: it flies apart', ja: 'オイラー法、刻み1.0：飛び離れる' } },
  ],
};
