// Chapter 4 in the teacher's guide. A state is a figure with other values than those that it opens with.

export const squaresGuide = {
  aims: [
    { en: 'Read a landscape of contours: wells, a pass, the way a square will slide.', ja: '等値曲線の地形を読み、井戸、峠、滑る向きを言える。' },
    { en: 'Explain how five potentials, laid over each other, make four wells of a ring.', ja: '五つのポテンシャルを重ねると、輪が四つの井戸になることを説明できる。' },
    { en: 'Tell apart what the radius does (where) and what the weight does (how deep).', ja: '半径の役目（場所）と重みの役目（深さ）を区別できる。' },
  ],
  before: [
    { en: 'Chapter 1: the potential of a pair, and its ring of rest at w = 1.', ja: '第1章（対のポテンシャル、w = 1の静止）。' },
    { en: 'Contour lines of a map. For the equation: the diagonal of a square.', ja: '地図の等高線。式には、正方形の対角線の長さ。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–4', { en: 'Nine squares, twice: what is different? Where may a neighbour rest?', ja: '九つの正方形。二つの違いは。隣はどこで静止できるか。' }],
        ['4–9', { en: 'Free play: drop the square, watch it slide.', ja: '自由に遊ぶ。正方形を置いて、滑らせる。' }],
        ['9–16', { en: 'From which weight on? Predict, argue, try 0 and 0.05.', ja: 'どれだけの重みから。予想、討論、0と0.05で実験。' }],
        ['16–20', { en: 'Sixty squares: who wrote the rows?', ja: '六十個の正方形。列を作ったのはだれか。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–6', { en: 'Nine squares, twice. Where may a neighbour rest?', ja: '九つの正方形。隣はどこで静止できるか。' }],
        ['6–16', { en: 'Free play with the landscape. Draw its contours from memory.', ja: '地形の図で自由に遊び、等値曲線を思い出して描く。' }],
        ['16–30', { en: 'From which weight on? Predict, argue, try.', ja: 'どれだけの重みから。予想、討論、実験。' }],
        ['30–42', { en: 'Equation (4), and $root2 r0$ with ruler and set square.', ja: '式(4)。$root2 r0$を定規で測って確かめる。' }],
        ['42–54', { en: 'Corners do not bump: change the weight, then the radius.', ja: '角はぶつからない。重み、次に半径を変える。' }],
        ['54–60', { en: 'Sixty squares. The exercise is homework.', ja: '六十個の正方形。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–30', { en: 'Tiles and coins on a table: which ones form rows, and why? Then free play.', ja: '机の上のタイルと硬貨。列になるのはどちらで、なぜか。それから自由に遊ぶ。' }],
        ['30–65', { en: 'Where may a neighbour rest, and from which weight on, with the sheet.', ja: '隣の静止できる場所と、重みの問題を、プリントで。' }],
        ['65–100', { en: 'Add five curves on paper along a line through an edge, then along a diagonal.', ja: '辺を通る直線と対角線に沿って、五つの曲線を紙の上で足す。' }],
        ['100–130', { en: 'Corners do not bump. Draw where the well lies against the radius.', ja: '角はぶつからない。半径に対する井戸の場所をグラフにする。' }],
        ['130–155', { en: 'Sixty squares with several starts: count pairs edge to edge.', ja: '六十個の正方形を何通りか試し、辺を共有する組を数える。' }],
        ['155–180', { en: 'Design a potential for triangles: where must the small bubbles sit? Discuss.', ja: '三角形のポテンシャルを考える。小さなバブルはどこに置くか。討論する。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'Where around a held bubble may another come to rest?', ja: '留めたバブルのまわりで、もう一つが静止できるのはどこか' },
      right: { en: 'b. Anywhere on a ring: the force depends on the distance alone.', ja: 'b。輪の上のどこでも。力は距離だけで決まる。' },
      thoughts: [
        [{ en: 'a, in four places:', ja: 'a（四か所）：' }, { en: 'has the pavement in mind, and takes its rows for a law of nature.', ja: '石畳を思い浮かべ、列になるのが当然だと考えている。' }],
        [{ en: 'c, in six places:', ja: 'c（六か所）：' }, { en: 'thinks of the honeycomb, which is made by all together.', ja: '蜂の巣を思い浮かべている。六は全部がそろってはじめて決まる。' }],
      ],
    },
    {
      question: { en: 'From which corner weight on are there four wells?', ja: '隅の重みがいくつから、井戸は四つになるか' },
      right: { en: 'c. From any weight above 0: with 0.05 the barrier is 0.009 $k0$.', ja: 'c。0より大きければいくつでも。0.05で障壁は0.009 $k0$。' },
      thoughts: [
        [{ en: 'a, from 0.41 on:', ja: 'a（0.41から）：' }, { en: 'takes the number of the paper for a threshold: such a number must mean a change.', ja: '論文の値を境目と考えている。特別な数には特別な変化があるはずだとみている。' }],
        [{ en: 'b, from 0.2 on:', ja: 'b（0.2から）：' }, { en: 'thinks that a little is lost, as with friction: something must be overcome first.', ja: '摩擦のように、少しだけでは効かないと考えている。' }],
      ],
    },
    {
      question: { en: 'Weight 1 instead of 0.41: where is the place of rest at an edge?', ja: '重みを0.41から1にすると、辺の先の静止する場所はどこか' },
      right: { en: 'c. At w = 1, as before. The well is deeper, and has not moved.', ja: 'c。前と同じw = 1。井戸は深くなるが、動かない。' },
      thoughts: [
        [{ en: 'a, farther away:', ja: 'a（遠く）：' }, { en: 'thinks that corners bump into each other, and harder now.', ja: '角どうしがぶつかり、重みが増せば強く押すと考えている。' }],
        [{ en: 'b, nearer:', ja: 'b（近く）：' }, { en: 'takes the deeper well for a stronger pull.', ja: '井戸が深いほど強く引くと考えている。' }],
      ],
    },
  ],
  wrong: [
    { en: 'The landscape is taken for ground in space. Its height is energy, and the square slides on a plane.', ja: '地形を実際の坂と思う。高さはエネルギーで、正方形は平面を滑る。' },
    { en: 'Dropped exactly at 45° the square stays, at any weight: it stands on the pass. Move it by a hair.', ja: 'ちょうど45°に置くと、重みがあっても峠の上で止まる。ほんの少しずらす。' },
    { en: 'The weight is on 0, and pupils wait for a slide to an edge. Check the number first.', ja: '重みが0のまま、辺へ滑るのを待つ。先に値を確かめる。' },
    { en: 'Squares are expected to turn. Their direction is given by the field; only centres move.', ja: '正方形が回ると思う。向きはベクトル場で決まり、動くのは中心だけである。' },
  ],
  states: [
    { figure: 'nine', values: { step: '0' }, what: { en: 'Nine squares at the start', ja: '九つの正方形、開始' } },
    { figure: 'nine', what: { en: 'Nine squares at rest', ja: '九つの正方形、静止' } },
    { figure: 'wells', values: { cw: '0', given: '0.5,0.5,1;0.68,0.32,0', step: '0' }, what: { en: 'Dropped at 45°, weight 0', ja: '45°に置く、重み0' } },
    { figure: 'wells', values: { cw: '0.05', given: '0.5,0.5,1;0.68,0.33,0', step: '0' }, what: { en: 'Dropped near 45°, weight 0.05', ja: '45°の近くに置く、重み0.05' } },
    { figure: 'sixty', what: { en: 'Sixty squares at rest', ja: '六十個の正方形、静止' } },
    { figure: 'bump', values: { cw: '1', step: '0' }, what: { en: 'Weight 1', ja: '重み1' } },
    { figure: 'bump', values: { cr: '0.8', step: '0' }, what: { en: 'Radius 0.8: the wells lie too far out', ja: '半径0.8（井戸が遠すぎる）' } },
    { figure: 'slide', what: { en: 'The exercise', ja: '練習' } },
  ],
};
