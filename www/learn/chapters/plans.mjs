// The part of the teacher's guide that holds for all chapters.

export const general = [
  {
    heading: { en: 'How a chapter goes', ja: '授業の進め方' },
    lead: {
      en: 'Plans, questions with the thoughts behind each answer, and links with every state prepared.',
      ja: '授業案、それぞれの答えの背後にある考え、準備済みの状態へのリンク。',
    },
    lines: [
      {
        en: 'Let pupils play first, without a task: three minutes of twenty, eight of sixty. Whoever has moved a bubble asks better questions.',
        ja: 'まず課題を出さずに、自由に触らせます。20分の授業なら3分、60分なら8分です。自分で動かした生徒は、よい問いをもちます。',
      },
      {
        en: 'Read the question aloud and have hands raised for each answer. The row beside each answer counts them. Do not comment yet.',
        ja: '問題を読み上げ、答えごとに手を挙げさせます。答えの横で数を記録できます。まだ論評はしません。',
      },
      {
        en: 'Ask for reasons, first of the smaller groups. Whoever wants to change sides may.',
        ja: '理由を聞きます。少数派から始めます。途中で予想を変えてもかまいません。',
      },
      {
        en: 'Only then try it. The figure says beside the prediction what happened. Let pupils say why before you read it out.',
        ja: 'それから実験します。結果は予想の横に示されます。読み上げる前に、理由を生徒に言わせます。',
      },
      {
        en: 'Equations come last. Each symbol marks what it is in the figure: point at one, and the other is marked.',
        ja: '式は最後です。記号と図の対応する部分は、どちらかを指すともう一方に印が付きます。',
      },
    ],
  },
  {
    heading: { en: 'In the room', ja: '教室で' },
    lines: [
      {
        en: '“For a class” fills the screen with one figure. Right and left arrow go on and back, a box beside each answer takes the number of hands, Esc ends.',
        ja: '「授業用」では図が一つずつ画面を満たします。左右の矢印キーで前後に、答えの横の欄に挙手の数を入れます。Escで終わります。',
      },
      {
        en: 'After one visit with a connection the pages work offline. Nothing that pupils do is sent anywhere.',
        ja: '一度接続して開いておけば、オフラインでも使えます。生徒の操作はどこにも送りません。',
      },
      {
        en: 'A link keeps a figure as it is seen. Copy the address to hand out a state.',
        ja: 'アドレスは図の今の状態を保ちます。コピーすれば、その状態を配れます。',
      },
      {
        en: 'Print each chapter with all its figures, and a sheet for pupils: question, answers with boxes, lines for reasons, what happened.',
        ja: '章は図ごと印刷できます。配布用プリントは、問題、予想、討論、実験の順です。',
      },
    ],
  },
];

/**
 * Plans that go over several chapters. A step has its minutes, the work, and its chapter.
 * @type {{ minutes: number, steps: [string, { en: string, ja: string }, string?][] }[]}
 */
export const plans = [
  {
    minutes: 20,
    steps: [
      ['0–3', { en: 'Free play: a finished pavement, taken apart layer by layer.', ja: '自由に遊ぶ。できあがった石畳を、一枚ずつ分解する。' }, 'two-bubbles'],
      ['3–10', { en: 'Two bubbles at w = 1.6 are let go: predict, argue, run.', ja: 'w = 1.6で放した二つのバブル。予想、討論、実験。' }, 'two-bubbles'],
      ['10–13', { en: 'A crowd: bend the outline, and watch it come to rest.', ja: '群れ。輪郭を曲げ、静止するまで見る。' }, 'many-bubbles'],
      ['13–17', { en: 'Bubbles, mesh, cells: do the lines cross?', ja: 'バブル、メッシュ、セル。線は交わるか。' }, 'mesh'],
      ['17–20', { en: 'Nine squares with and without corners. Then the pavement once more: who can name its layers?', ja: '隅のある正方形とない正方形、九個ずつ。最後にもう一度石畳を見て、一枚一枚が何かを言わせる。' }, 'squares'],
    ],
  },
  {
    minutes: 60,
    steps: [
      ['0–8', { en: 'Free play: the pavement’s layers, then the pair.', ja: '自由に遊ぶ。石畳の図、次にバブルの対。' }, 'two-bubbles'],
      ['8–18', { en: 'What will it do? Predict, argue, run.', ja: 'どうなるか。予想、討論、実験。' }, 'two-bubbles'],
      ['18–29', { en: 'Different first places: will both end alike? Predict, argue, run.', ja: '初期位置だけを変える。同じところに落ち着くか。予想、討論、実験。' }, 'many-bubbles'],
      ['29–41', { en: 'Three ways to place points: mark the two middles that will move, argue, run.', ja: '点の三通りの置き方。中央値に印を付け、討論、実験。' }, 'mesh'],
      ['41–52', { en: 'From which weight on are there four wells? Predict, argue, drop the square.', ja: 'どれだけの重みから井戸は四つか。予想、討論、正方形を落とす。' }, 'squares'],
      ['52–60', { en: 'One cell is missing: does the rule see the hole? Show it.', ja: 'セルが一つ足りない。規則は穴に気づくか。教師が見せる。' }, 'how-many'],
    ],
  },
  {
    minutes: 180,
    steps: [
      ['0–25', { en: 'Free play in pairs, with the first figure of each chapter. Each pair writes down one question of its own.', ja: '二人一組で、各章の最初の図で自由に遊ぶ。組ごとに問いを一つ書く。' }],
      ['25–55', { en: 'Both predictions on the pair, with the sheet; then equations (2) and (3) on the curves.', ja: '対についての二つの予想をプリントで。次に、曲線の上で式(2)と(3)。' }, 'two-bubbles'],
      ['55–80', { en: 'Will both end alike, and is it downhill all the way?', ja: '同じところに落ち着くか。ずっと下り坂か。' }, 'many-bubbles'],
      ['80–105', { en: 'Three ways to place points, and two points pushed together. Then a break, if there is one.', ja: '点の三通りの置き方と、二つの点を近づける実験。休憩を入れるならこのあと。' }, 'mesh'],
      ['105–130', { en: 'From which weight on, and whether corners bump into each other.', ja: 'どれだけの重みからか。角と角はぶつかるのか。' }, 'squares'],
      ['130–150', { en: 'The middle of the road, and halfway between 10° and 80°.', ja: '道の真ん中と、10°と80°の中間。' }, 'which-way'],
      ['150–165', { en: 'Does the rule see the hole? Then break it.', ja: '規則は穴に気づくか。次に壊してみる。' }, 'how-many'],
      ['165–180', { en: 'Into the studio: each pair makes a pavement, shows where each chapter can be seen in it, and answers its own question.', ja: 'スタジオで組ごとに石畳を作り、各章がどこに見えるかを示して、初めの問いに答える。' }],
    ],
  },
];

/** The headings of each chapter’s part. */
export const headings = {
  aims: { en: 'Aims', ja: 'ねらい' },
  before: { en: 'Needed before', ja: '前提となる知識' },
  plans: { en: 'Plans', ja: '授業案' },
  across: { en: 'Plans over several chapters', ja: '複数の章にわたる授業案' },
  minutes: { en: 'minutes', ja: '分' },
  questions: { en: 'Questions, and the thoughts behind the answers', ja: '問題と、答えの背後にある考え' },
  wrong: { en: 'Where pupils stumble', ja: 'つまずきやすいところ' },
  states: { en: 'Prepared states', ja: '準備済みの状態' },
};
