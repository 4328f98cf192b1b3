// Chapter 3 in the teacher's guide. A state is a figure with other values than those that it opens with.

export const meshGuide = {
  aims: [
    { en: 'Say by the empty circle which of two diagonals belongs to Delaunay’s triangulation.', ja: '二本の対角線のうち、ドロネー三角形分割に属するのはどちらかを、空円で言える。' },
    { en: 'Explain from the shortest side and the circle’s radius why packed points make good triangles, and random ones do not.', ja: '最も短い辺と外接円の半径から、充填した点の三角形が良く、ランダムな点では悪くなるわけを説明できる。' },
    { en: 'Draw the dual of a mesh, and say how many sides a cell has.', ja: 'メッシュの双対を描き、セルの辺の数を言える。' },
  ],
  before: [
    { en: 'Chapters 1 and 2: push and pull end at w = 1.5; a crowd comes to rest.', ja: '第1章と第2章（力はw = 1.5で終わる、群れの静止）。' },
    { en: 'The circle through three points. For equation (b): the sine, and angles that see the same chord.', ja: '三点を通る円。式(b)には、正弦と円周角。' },
  ],
  plans: [
    {
      minutes: 20,
      steps: [
        ['0–4', { en: 'Free play: bubbles, mesh, cells, step by step.', ja: '自由に遊ぶ。バブル、メッシュ、セルを順に見る。' }],
        ['4–7', { en: 'Do the lines cross?', ja: '線は交わるか。' }],
        ['7–15', { en: 'Three ways to place points: mark the middles, argue, run.', ja: '点の三通りの置き方。中央値に印を付け、討論、実験。' }],
        ['15–20', { en: 'Push two points together: does Delaunay make good triangles?', ja: '二つの点を近づける。ドロネーは良い三角形を作るか。' }],
      ],
    },
    {
      minutes: 60,
      steps: [
        ['0–8', { en: 'Free play with the mesh and its cells. Count sides.', ja: 'メッシュとセルの図で遊び、辺を数える。' }],
        ['8–13', { en: 'Do the lines cross?', ja: '線は交わるか。' }],
        ['13–27', { en: 'Three ways to place points: mark, argue, run.', ja: '点の三通りの置き方。印、討論、実験。' }],
        ['27–40', { en: 'When does an edge flip? Predict, argue, drag slowly.', ja: '辺はいつ入れ替わるか。予想、討論、ゆっくり動かす。' }],
        ['40–50', { en: 'Both equations, at the board, with one triangle and its circle.', ja: '二つの式を、一つの三角形とその外接円で、板書で。' }],
        ['50–60', { en: 'Push two points together. The exercise is homework.', ja: '二つの点を近づける。練習は宿題。' }],
      ],
    },
    {
      minutes: 180,
      steps: [
        ['0–30', { en: 'Dots on paper: join them to triangles by eye, and measure the smallest angle. Then free play.', ja: '紙に点を打ち、目で三角形に結び、最小角を測る。それから自由に遊ぶ。' }],
        ['30–60', { en: 'Do the lines cross, and three ways to place points, with the sheet.', ja: '線は交わるか、点の三通りの置き方を、プリントで。' }],
        ['60–95', { en: 'When does an edge flip? Then compasses: test each triangle of one’s own paper.', ja: '辺はいつ入れ替わるか。次にコンパスで、自分の紙の三角形を調べる。' }],
        ['95–125', { en: 'Derive equation (b) by the angle at the centre; find 30° from s = R.', ja: '中心角から式(b)を導き、s = Rのとき30°になることを確かめる。' }],
        ['125–150', { en: 'Push two points together; the exercise.', ja: '二つの点を近づける。練習。' }],
        ['150–180', { en: 'The dual on paper. Count nodes, edges, triangles, and find why the mean is about six (Euler).', ja: '紙の上で双対を描く。点、辺、三角形を数え、平均がほぼ六になるわけを考える（オイラー）。' }],
      ],
    },
  ],
  questions: [
    {
      question: { en: 'All pairs nearer than w = 1.5 are joined: do lines cross?', ja: 'w = 1.5より近いものをすべて結ぶと、線は交わるか' },
      right: { en: 'b. Yes, where four stand nearly in a square: both diagonals are about 1.41.', ja: 'b。四つがほぼ正方形に並ぶところで交わる。対角線は二本とも約1.41。' },
      thoughts: [
        [{ en: 'a, never:', ja: 'a（決して）：' }, { en: 'has the perfect honeycomb in mind.', ja: '完全な蜂の巣を思い浮かべている。' }],
        [{ en: 'c, nearly everywhere:', ja: 'c（至るところ）：' }, { en: 'thinks that a bubble feels those behind its neighbours.', ja: '隣の向こうまで力が届くと考えている。' }],
      ],
    },
    {
      question: { en: 'Random points stay. Where are the two other middles after 20 rounds, and at rest?', ja: 'ランダムな点は動かない。ロイド法20回の後と静止の後、ほかの二つの中央値はどこか' },
      right: { en: 'Lloyd about 48°, packed about 56°. Random stays at about 32°.', ja: 'ロイド法は約48°、充填は約56°。ランダムは約32°のまま。' },
      thoughts: [
        [{ en: 'Both near 32°:', ja: 'どちらも32°付近：' }, { en: 'thinks that the rule of joining makes the triangles.', ja: '結び方の規則が三角形を決めると考えている。' }],
        [{ en: 'Packed at 60°:', ja: '充填が60°：' }, { en: 'has the honeycomb in mind; walls and places between grains spoil some triangles.', ja: '蜂の巣を思い浮かべている。壁や、並びの境目では三角形がくずれる。' }],
        [{ en: 'Lloyd above the bubbles:', ja: 'ロイド法がバブルより上：' }, { en: 'takes the order that is seen at first, 46° and 44°, for the one at the end.', ja: '初めに見える順序（46°と44°）が、最後まで続くと考えている。' }],
      ],
    },
    {
      question: { en: 'When does an edge flip?', ja: '辺はいつ入れ替わるか' },
      right: { en: 'b. When all four corners lie on one circle. In the figure the new edge can be the longer one.', ja: 'b。四つの頂点が一つの円周上に並んだとき。図では、新しい辺のほうが長いこともある。' },
      thoughts: [
        [{ en: 'a, when the other is shorter:', ja: 'a（短くなったとき）：' }, { en: 'takes near points for neighbours, and compares the two diagonals alone.', ja: '近い点どうしを結ぶのが良いと考え、二本の長さだけを比べている。' }],
        [{ en: 'c, when a point runs into an edge:', ja: 'c（ぶつかったとき）：' }, { en: 'thinks that the mesh changes only when it must.', ja: 'やむを得ないときだけ変わると考えている。' }],
      ],
    },
    {
      question: { en: 'Two points nearly touch: what does the smallest angle do?', ja: '二つの点が触れそうになると、最小角はどうなるか' },
      right: { en: 'b. It goes towards 0°: no way to join these points avoids a thin triangle.', ja: 'b。0°に近づく。どう結んでも細い三角形ができる。' },
      thoughts: [
        [{ en: 'a, it stays above 30°:', ja: 'a（30°より大きい）：' }, { en: 'thinks that a good rule can mend bad points.', ja: '規則が良ければ、悪い点でも何とかなると考えている。' }],
      ],
    },
  ],
  wrong: [
    { en: 'A point is dragged across the rim, and edges change without a flip: at the rim they come and go when three points lie in a line. Stay inside.', ja: '点を縁の外へ動かすと、入れ替わりでなく辺が増減する。縁では三点が一直線に並ぶときに変わる。内側で動かす。' },
    { en: 'Points are dragged too fast, and the moment is missed. Use the keys, with Shift for small strides.', ja: '速く動かしすぎて、その瞬間を見逃す。キーを使い、Shiftで細かく動かす。' },
    { en: 'The packing is judged by its worst triangle. With a fixed number a hole or a close pair may stay; chapter 6 mends that.', ja: '充填を最も悪い三角形で判断する。数を固定すると、穴や近すぎる対が残ることがある。第6章で直す。' },
    { en: 'Lloyd is thought to be wrong. It makes good triangles, too, in many small rounds; but no rows along a road.', ja: 'ロイド法が誤りだと思う。回数を重ねれば良い三角形になる。ただし、道に沿う列はできない。' },
  ],
  states: [
    { figure: 'dual', values: { step: '1' }, what: { en: 'The mesh, before any cell', ja: 'メッシュだけ（セルはまだない）' } },
    { figure: 'dual', what: { en: 'Mesh and cells', ja: 'メッシュとセル' } },
    { figure: 'three', values: { rounds: '0', step: '0' }, what: { en: 'Three times at random', ja: '三つともランダム' } },
    { figure: 'three', values: { rounds: '20', step: '200' }, what: { en: 'After 20 rounds, and at rest', ja: 'ロイド法20回と静止' } },
    { figure: 'flip', what: { en: 'Twelve points, before a flip', ja: '十二個の点（入れ替わる前）' } },
    { figure: 'close', what: { en: 'Twelve good points', ja: '良い配置の十二個の点' } },
    { figure: 'place', what: { en: 'The exercise', ja: '練習' } },
  ],
};
