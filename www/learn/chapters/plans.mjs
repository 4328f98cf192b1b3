// The teacher's guide, as far as it holds for all chapters.

export const general = [
  {
    heading: { en: 'How a chapter goes', ja: '授業の進め方' },
    lead: {
      en: 'Plans, questions with the thoughts behind each answer, and links with every state prepared.',
      ja: '授業案、それぞれの答えの背後にある考え、準備済みの状態へのリンク。',
    },
    lines: [
      {
        en: 'Let pupils play first, without a task. Whoever has moved a bubble asks better questions.',
        ja: 'まず課題を出さずに、自由に触らせます。自分で動かした生徒は、よい問いをもちます。',
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
        ja: '「授業用の表示」では図が一つずつ画面を満たします。左右の矢印キーで前後に、答えの横の欄に挙手の数を入れます。Escで終わります。',
      },
      {
        en: 'After one visit with a connection the pages work offline. What pupils do is sent nowhere.',
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

/** The headings of each chapter’s part. */
export const headings = {
  aims: { en: 'Aims', ja: 'ねらい' },
  before: { en: 'What pupils should know before', ja: '前提となる知識' },
  plans: { en: 'Plans', ja: '授業案' },
  minutes: { en: 'minutes', ja: '分' },
  questions: { en: 'Questions, and the thoughts behind the answers', ja: '問題と、答えの背後にある考え' },
  wrong: { en: 'What goes wrong in class', ja: 'つまずきやすいところ' },
  states: { en: 'Prepared states', ja: '準備済みの状態' },
};
