/** The words of surfaces in space in Japanese: those that are other ones than a pavement's, by generator and key. */
import type { Foreign } from './foreign';

/** Numbers of shapes, by shape. */
const SHAPES: Record<string, Record<string, string>> = {
  terrain: { hills: '丘の数', height: '丘の幅に対する高さ', lane: '小道の深さ', wind: '小道の曲がり', hill: 'どの丘か' },
  slope: { rise: '坂の角度', landing: '両端の平らな所', width: '長さに対する幅', round: '曲がり目の丸み' },
  stairs: { steps: '段数', pitch: '踏面に対する蹴上げ', width: '長さに対する幅', landing: '上の踊り場（踏面を1とする）' },
  cylinder: { height: '直径に対する高さ', top: '下に対する上の幅', belly: 'ふくらみ（負ならくびれ）', caps: '端をふさぐ' },
  sphere: { height: '幅に対する高さ', depth: '幅に対する奥行き', square: '四角さ' },
  torus: { tube: '輪の半径に対する管の半径', height: '管の幅に対する高さ', waves: '波の数', swell: '波の深さ（できる深さを1とする）' },
  knot: { turns: '中心を回る回数', lobes: '耳の数', tube: '太さ（余地を1とする）', swing: '耳の内と外への振れ', height: '振れの奥行きに対する高さ' },
  horn: { turns: '巻き数', rise: '平面からの巻き上がり', taper: '根元に対する先の幅', girth: '太さ（余地を1とする）' },
  leg: { toes: '指の数', spread: '指の間の角度', bend: '膝の曲がり', girth: '太さ', reach: '指の長さ' },
  tail: { curl: '巻き', taper: '根元に対する先の幅', girth: '長さに対する根元の幅', lift: '平面からの巻き上がり' },
  fish: { height: '長さに対する体高', width: '体高に対する体幅', tail: '尾びれの大きさ', fins: 'ひれの大きさ', swim: '横への曲がり' },
  turtle: { width: '長さに対する幅', height: '長さに対する高さ', rim: '縁', keel: '背に沿う稜' },
  egg: { height: '幅に対する高さ', point: '上のとがり', base: '底の平らさ' },
  vase: { height: '幅に対する高さ', shoulder: '最も広い所の高さ', neck: '最も広い所に対する首の幅', lip: '首に対する口の幅', hollow: '高さに対する内側の深さ' },
  letter: { letter: '文字（Aは1）', weight: '高さに対する線の太さ', depth: '高さに対する奥行き', round: '縁の丸み', lean: '傾き' },
};

const shapes = Object.entries(SHAPES).flatMap(([shape, rows]) =>
  Object.entries(rows).map(([word, name]) => [`${shape}_${word}`, { name, help: '曲面の形を決める数の一つ。' }] as const),
);

export const parameters: Foreign['parameters'] = {
  form: {
    name: '曲面',
    help: '覆う曲面。規則による形、またはファイルの形。',
    choices: {
      terrain: '地形', slope: '坂', stairs: '階段', cylinder: '円柱', sphere: '球', torus: 'トーラス', knot: '結び目', horn: '角', leg: '足', tail: '尾', fish: '魚',
      turtle: '亀の甲羅', egg: '卵', vase: '壺', letter: '文字', file: 'ファイルから',
    },
  },
  ...Object.fromEntries(shapes),
  model: { name: 'モデル', help: 'ファイルの要約値と名前。リンクにファイルそのものは入りません。' },
  up: { name: '上の軸', help: 'ファイルの中でどちらが上か。', choices: { y: 'y軸', z: 'z軸' } },
  'surface.on': { name: '充填する面', help: 'セルをそのままの曲面に充填するか、簡単にした曲面に充填して戻すか。', choices: { fit: '足りる細かさの面', whole: 'そのままの曲面', simple: '簡単にした曲面' } },
  crease: { name: '折り目', help: '鋭い縁でセルを折り曲げるか、曲面をそこで切るか。', choices: { fold: '折り曲げる', cut: '切る' } },
  fold: { name: '折り目の角度', help: 'これより大きく曲がる縁を折り目とします。' },
  open: { name: '開いた所', help: '曲面の終わる所。内側のある殻か、そこで切った立体か。', choices: { shell: '殻', capped: '立体' } },
  yaw: { name: '回転', help: '同じ光の下で、モデルを縦の軸のまわりに回します。' },
  bent: { name: 'アスペクト比の決め方', help: 'どこでも同じアスペクト比にするか、どの向きにも同じだけ曲がる所では丸くするか。', choices: { even: '一様', curvature: '曲がりに応じて' } },
  'surface.stretch': { name: 'アスペクト比のスポット', help: '曲面の上の、アスペクト比の異なる柔らかなスポット。' },
  cn: { name: 'セルの数', help: 'およそこの数のセルが曲面を覆います。' },
  taper: { name: '大きさの変化', help: '始めに対する、終わりでのセルの大きさ。' },
  along: { name: '変化の向き', help: 'セルが大きく、または小さくなる向き。頭から尾へ、または一つの方向へ。', choices: { bones: '頭から尾へ', up: '上へ', right: '右へ', front: '手前へ' } },
  cc: { name: 'セルの張る角度', help: '曲がりの強い所ほどセルを小さくします。そこで一つのセルが張る角度。0では一様です。' },
  cl: { name: '最小のセル', help: '最も小さいセル（平均の大きさを1とする）。' },
  ch: { name: '最大のセル', help: '最も大きいセル（平均の大きさを1とする）。' },
  'surface.spots': { name: '大きさのスポット', help: '曲面の上の、セルが大きく、または小さくなる柔らかなスポット。' },
  'surface.dir': {
    name: '方向',
    help: 'セルの列が従うもの。頭から尾への体の向き、一つの方向、曲がり、縁、または列どうしだけ。',
    choices: { bones: '頭から尾へ', axis: '一つの方向', curvature: '曲がりに沿う', border: '縁と折り目', free: 'できるだけ滑らかに' },
  },
  axis: { name: '向かう先', help: '列が従う、空間の中の方向。', choices: { up: '上へ', right: '右へ', front: '手前へ' } },
  'surface.angle': { name: '角度', help: 'すべての方向を、外から見て反時計回りに回します。' },
  'surface.strokes': { name: 'ストローク', help: '曲面に描いた線。列と、それに沿う流れが従います。' },
  'surface.reach': { name: 'ストロークの届く距離', help: 'ストロークが効く距離（モデルを囲む箱の一辺を1とする）。' },
  'surface.lines': { name: '拘束線', help: '曲面の上の線。それに沿ってセルが並びます。' },
  flow: { name: '流れ', help: '鱗の傾く向き。頭から尾へ、一つの方向へ、ストロークに沿って、または隣に合わせて。', choices: { bones: '頭から尾へ', axis: '一つの方向', strokes: 'ストロークに沿う', free: '隣に合わせる' } },
  flip: { name: '流れの正逆', help: '流れをどちらへ向けるか。', choices: { 0: 'そのまま', 1: '逆向き' } },
  'surface.seed': { name: 'シード', help: '乱数の種。シードが違えば、石も違います。' },
  'surface.hs': { name: '高さ', help: '石の高さ（セルの大きさを1とする）。' },
  'surface.sa': { name: '流れの角度', help: '上面が傾き上がる向き。流れから、外から見て反時計回り。' },
  'surface.pn': { name: '模様の間隔', help: '印から次の印まで、または印の届く距離（モデルを囲む箱の一辺を1とする）。' },
  'surface.pa': { name: '模様の角度', help: '縞を横切る向き、または印の付いたセルの向き。正面から見て、x軸から時計回り。' },
  'surface.belly': { name: '腹', help: '体の片側に、配色の腹の色がどれだけ出るか。' },
  'surface.ba': { name: '腹の向き', help: '腹のある側。正面から見て、x軸から時計回り。' },
  'surface.moss': { name: '苔', help: '苔を生やします。目地、くぼみ、上を向いた所に。' },
};

export const presets: Foreign['presets'] = {
  'cobbled-hill': { title: '石畳の丘', note: '丘の間の小道。どこも石畳です。' },
  'saurian-leg': { title: '恐竜の足', note: '腿から指まで、爪へ向かって小さくなる鱗。' },
};
