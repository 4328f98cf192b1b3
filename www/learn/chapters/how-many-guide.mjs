// Chapter 6 in the teacher's guide. A state is a figure with other values than those that it opens with.

export const howManyGuide = {
  aims: [
    { en: 'Say from the smallest w of a cell whether it is crowded, lonely, or neither.', ja: 'セルのwの最小値から、過密か、孤立しているか、どちらでもないかを言える。' },
    { en: 'Explain why a rule that looks at cells misses a hole, and one that looks at places finds it.', ja: 'セルを見る規則が穴を見落とし、場所を見る規則が見つける理由を説明できる。' },
    { en: 'Tell why two thresholds need a distance from each other, as with a heater’s switch.', ja: '二つのしきい値の間に余裕が要ることを、暖房のスイッチのように説明できる。' },
  ],
  before: [
    { en: 'Chapter 1: the ratio w, and where the force ends. Chapter 2: a crowd comes to rest.', ja: '第1章（距離の比w、力の届く範囲）。第2章（群れは静止する）。' },
    { en: 'To read “the smallest of”. For the wrong idea: area of a square and of a circle.', ja: '「最小の値」という言い方。「面積÷大きさの2乗」には、正方形や円の面積。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–3', { en: 'One is taken out: what do its neighbours do?', ja: '一つ抜き取ると、隣はどうするか。' }],
        ['3–7', { en: 'Free play with too few and too many.', ja: '少なすぎる・多すぎる出発で自由に遊ぶ。' }],
        ['7–15', { en: 'The hole: predict, argue, try.', ja: '穴。予想、討論、実験。' }],
        ['15–20', { en: 'Break it: let the thresholds cross.', ja: '壊してみる。しきい値を逆転させる。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–8', { en: 'One is taken out. Then free play with too few and too many.', ja: '一つ抜き取る。それから自由に遊ぶ。' }],
        ['8–22', { en: 'The hole: predict, argue, try. Lower the papers’ value until something comes.', ja: '穴。予想、討論、実験。何か増えるまで、論文の値を下げてみる。' }],
        ['22–35', { en: 'Break it: thresholds that cross.', ja: '壊してみる。しきい値の逆転。' }],
        ['35–45', { en: 'Both rules as formulas.', ja: '二つの規則を式で。' }],
        ['45–60', { en: 'Area over size squared: predict, try other outlines. The exercise is homework.', ja: '面積÷大きさの2乗。予想し、ほかの輪郭も試す。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–30', { en: 'Coins in a frame: how many fit? Fill it, take one out, see what moves.', ja: '枠に硬貨はいくつ入るか。並べて、一つ抜き、何が動くかを見る。' }],
        ['30–70', { en: 'One is taken out, and the hole, with the sheet.', ja: '一つ抜き取る問題と穴の問題を、プリントで。' }],
        ['70–105', { en: 'Break it. Find pairs of thresholds that rest, and draw them in a plane.', ja: '壊してみる。落ち着くしきい値の組を探し、平面に描く。' }],
        ['105–145', { en: 'Area over size squared. Work out 0.87 for the honeycomb; try U, L and star.', ja: '面積÷大きさの2乗。蜂の巣の0.87を計算し、U字、L字、星で試す。' }],
        ['145–165', { en: 'The exercise: who is nearest with one guess?', ja: '練習。一度の見当で最も近いのはだれか。' }],
        ['165–180', { en: 'Write a rule of your own for coming and going, and say how it could fail.', ja: '増減の規則を自分で作り、どんなとき失敗するかを書く。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'One is taken out of a honeycomb: what do its neighbours do?', ja: '蜂の巣の並びから一つ抜くと、隣はどうするか' },
      right: { en: 'b. Nothing: at w = 1 there was no force between them.', ja: 'b。何もしない。w = 1では、もともと力がない。' },
      thoughts: [
        [{ en: 'a, they close the hole:', ja: 'a（穴をふさぐ）：' }, { en: 'thinks of water, or that nature leaves no room empty.', ja: '水のように、空いたところは埋まると考えている。' }],
        [{ en: 'c, they fly apart:', ja: 'c（飛び散る）：' }, { en: 'thinks of a keystone: all held each other by pressing.', ja: '要石のように、押し合って支えていると考えている。' }],
      ],
    },
    {
      question: { en: 'Does “far from its nearest neighbour” bring one into the hole?', ja: '「最も近い隣まで遠い」という規則で、穴に一つ増えるか' },
      right: { en: 'b. No: each cell at the hole still has near neighbours on its other sides.', ja: 'b。いいえ。穴の縁のセルにも、ほかの側には近い隣がいる。' },
      thoughts: [
        [{ en: 'a, yes:', ja: 'a（はい）：' }, { en: 'sees the hole, as a person does, and reads “some neighbour is far” for “the nearest is far”.', ja: '人の目で穴を見て、「遠い隣がある」を「最も近い隣が遠い」と取り違えている。' }],
      ],
    },
    {
      question: { en: 'Thresholds that cross: what happens?', ja: 'しきい値が逆転すると、どうなるか' },
      right: { en: 'c. Cells come and go at every look, as long as the program looks.', ja: 'c。調査が続くかぎり、増えたり減ったりする。' },
      thoughts: [
        [{ en: 'a, it rests after one look:', ja: 'a（一度で落ち着く）：' }, { en: 'thinks that what has been corrected is correct.', ja: '一度直せば、正しくなると考えている。' }],
        [{ en: 'b, it rests with more:', ja: 'b（増えて落ち着く）：' }, { en: 'looks at who comes, and forgets that the others are then too near.', ja: '増えるほうだけを見て、そのため混むことを忘れている。' }],
      ],
    },
    {
      question: { en: 'A U and a square of one area, size 28 instead of 34: how many does the U hold?', ja: '面積の等しいU字形と正方形。大きさを34から28にすると、U字形にはいくつ入るか' },
      right: { en: 'b. More than the square: 30 and 29. At 34 it was 13 and 19; area over size squared is 25.5 for both.', ja: 'b。正方形より多い（30と29）。34では13と19だった。面積÷大きさの2乗は、どちらも25.5。' },
      thoughts: [
        [{ en: 'a, just as many:', ja: 'a（同じ数）：' }, { en: 'counts by area, which is the same.', ja: '面積が同じなので、個数も同じと考えている。' }],
        [{ en: 'c, fewer:', ja: 'c（少ない）：' }, { en: 'takes the ratio of the first picture for a law: a third fewer, as before.', ja: '初めの比がいつも成り立つと考え、同じ割合で少ないとみている。' }],
      ],
    },
  ],
  wrong: [
    { en: 'Pupils say “the hole is far from its neighbours”. Ask whom the rule asks: cells, or places.', ja: '「穴は隣から遠い」と言う。規則が調べるのはセルか、場所かを問う。' },
    { en: 'Crowded is read as “many around”. It means one that is too near.', ja: '「過密」を「まわりに多い」と読む。近すぎる相手が一つあることである。' },
    { en: 'A run that is stopped too early looks at rest. Looks end at step 100: go on to there.', ja: '早く止めると静止して見える。調査は100ステップまで続くので、そこまで進める。' },
    { en: 'Several handles are moved at once. Let each group change one only.', ja: '一度にいくつもの値を変える。班ごとに一つだけ変えさせる。' },
  ],
  states: [
    { figure: 'crowded', values: { step: '0' }, what: { en: 'Too few and too many, at the start', ja: '少なすぎる・多すぎる出発' } },
    { figure: 'crowded', values: { step: '100' }, what: { en: 'Both at the end', ja: 'どちらも終わったところ' } },
    { figure: 'hole', values: { step: '0' }, what: { en: 'The hole, before any look', ja: '穴、調べる前' } },
    { figure: 'hole', values: { room: '0.97', step: '100' }, what: { en: 'The papers’ rule with 0.97: cells come everywhere', ja: '論文の規則で0.97（あちこちで増える）' } },
    { figure: 'never', what: { en: 'Thresholds with room between them: rest', ja: '間に余裕のあるしきい値（静止）' } },
    { figure: 'never', values: { crowd: '0.95', room: '0.85', step: '100' }, what: { en: 'Thresholds that cross', ja: '逆転したしきい値' } },
    { figure: 'count', values: { cs: '28', step: '120' }, what: { en: 'U and square with size 28', ja: '大きさ28のU字形と正方形' } },
    { figure: 'right-number', what: { en: 'The exercise', ja: '練習' } },
  ],
};
