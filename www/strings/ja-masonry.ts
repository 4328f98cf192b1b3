/** The Japanese for masonry, by generator and key. It comes with the second module. */
import type { Foreign } from './foreign';

const COLOURS = { red: '赤れんが', yellow: '黄色いれんが', dark: '黒れんが', honey: '蜂蜜色の石', grey: '灰色の石', pale: '淡い石' };

/** The heads of openings, by their numbers. */
const HEADS = { 0: '直線', 1: '弧', 2: '半円' };

/** The numbers of buildings, by building: the name, the help, and the labels of choices. */
const BUILDINGS: Record<string, Record<string, [name: string, help: string, choices?: Record<string, string>]>> = {
  block: {
    length: ['長さ（半枚の数）', '左右の大きさ。半枚は、目地を含むれんが半分の長さです。'],
    width: ['幅（半枚の数）', '前後の大きさ。目地を含むれんが半分の長さで数えます。'],
    height: ['高さ（段の数）', '地面から上端までの、れんがの列の数。一段は、目地を含む一列です。'],
  },
  lhouse: {
    length: ['長さ（半枚の数）', '棟に沿う、母屋の左右の大きさ。'],
    width: ['幅（半枚の数）', '翼を含む、前後の大きさ。'],
    wing: ['翼の幅（半枚の数）', '翼の左右の大きさ。母屋は、これより半枚6個分以上長く保たれます。'],
    depth: ['翼の長さ（半枚の数）', '翼が母屋の後ろへ延びる長さ。母屋の幅は、半枚6個分以上に保たれます。'],
    height: ['軒の高さ（段の数）', '地面から屋根までの、れんがの段の数。窓の高さは変わりません。'],
    windows: ['壁ごとの窓の数', 'それぞれの壁に、入るだけの窓。その一つが扉になり、窓がなくても扉は残ります。'],
    head: ['開口のまぐさ', '窓と扉の上の形。弧は円の一部、半円は円の半分です。', HEADS],
    pitch: ['屋根の勾配', '水平からの屋根の角度。幅の広い翼では、棟が低くなるように緩くなります。'],
  },
  gabled: {
    length: ['長さ（半枚の数）', '棟に沿う大きさ。屋根は両方の妻壁より20 cm外へ出ます。'],
    width: ['幅（半枚の数）', '棟を横切る大きさ。広いほど屋根が高くなります。'],
    height: ['軒の高さ（段の数）', '長い壁の、地面から屋根の下面までの、れんがの段の数。'],
    pitch: ['屋根の勾配', '水平からの屋根の角度。急なら、どちらの妻にも窓が入ります。'],
    windows: ['壁ごとの窓の数', 'それぞれの壁に入るだけの窓。妻の下では三つまで。正面には扉も付きます。'],
    head: ['開口のまぐさ', '扉と窓の上の形。妻の小さな窓は、いつも半円です。', HEADS],
  },
  wall: {
    length: ['長さ（半枚の数）', '端から端までの大きさ。短い壁では開口が狭くなります。'],
    height: ['高さ（段の数）', '地面から上端までの、れんがの段の数。低い壁では開口も低くなります。'],
    thickness: ['厚み（半枚の数）', '前後の大きさ。2でれんが1個の長さです。'],
    width: ['開口の幅（半枚の数）', '左と中央の開口の幅。右の開口は、これより半枚2個分広くなります。'],
    head: ['中央のまぐさ', '中央の開口の上の形。左右の開口は、いつも直線です。', HEADS],
  },
  gate: {
    span: ['開口の幅（半枚の数）', '通り道の幅。その上のアーチの高さは、幅の半分です。'],
    pier: ['柱の幅（半枚の数）', '通り道の左右にある壁の、それぞれの幅。'],
    springing: ['アーチの起点の高さ（段の数）', '地面からアーチの始まりまでの、れんがの段の数。'],
    over: ['頂の上の段の数', 'アーチの頂から壁の上端までの、れんがの段の数。'],
    thickness: ['厚み（半枚の数）', '通り道の前後の長さ。2でれんが1個の長さです。'],
  },
  steps: {
    steps: ['段数', '地面から上までの段の数。多いほど高く、奥へ上ります。'],
    width: ['幅（半枚の数）', '両側の柱の間にある、階段の左右の大きさ。'],
    tread: ['踏面（半枚の数）', '一段の奥行き。2でれんが1個の長さです。'],
    riser: ['蹴上げ（段の数）', '一つの踏面から次の踏面までの、れんがの段の数。多いほど急です。'],
    column: ['柱の幅（半枚の数）', '両側の柱の幅と奥行き。笠は四方へ半枚1個分ずつ張り出します。'],
    height: ['柱の高さ（段の数）', '地面から柱の上端までの、れんがの段の数。そのうち二段は笠です。'],
  },
  tower: {
    around: ['周の長さ（半枚の数）', '外側を一周する段の長さ。80では、塔の幅が半枚およそ25個分です。'],
    height: ['高さ（段の数）', '地面から、屋根のない上端までの、れんがの段の数。'],
    thickness: ['厚み（半枚の数）', '壁の外側から内側までの大きさ。2でれんが1個の長さです。'],
    windows: ['窓の数', '塔を巡る、入るだけの窓。一つおきに高い所に付きます。'],
    width: ['窓の幅（半枚の数）', '壁に沿う、それぞれの窓の幅。広いほど、入る窓が減ります。'],
  },
  ring: {
    walls: ['壁の数', '正多角形に並ぶ壁の数。3では三角形で、12ではほとんど円です。'],
    side: ['壁の長さ（半枚の数）', '外側の、角から角までの長さ。長いほど輪が広がります。'],
    height: ['高さ（段の数）', '地面からすべての壁の上端までの、れんがの段の数。'],
    thickness: ['厚み（半枚の数）', 'それぞれの壁の厚み。1でれんが半分、2でれんが1個の長さです。'],
  },
  sheet: {
    length: ['長さ（半枚の数）', '開口のない一枚の面の、端から端までの大きさ。'],
    height: ['高さ（段の数）', '地面から面の上端までの、れんがの段の数。'],
    thickness: ['厚み（半枚の数）', 'れんがが面の後ろへ入る深さ。1でれんが半分、2でれんが1個の長さです。'],
  },
  plan: {
    height: ['高さ（段の数）', 'すべての壁の、れんがの段の数。開口は、上端より四段以上低く終わります。'],
    thickness: ['厚み（半枚の数）', '壁の厚み。壁は、描いた線の左側に立ちます。'],
    pitch: ['屋根の勾配（0なら屋根なし）', 'へこんだ角のない閉じた平面図に、屋根を掛けます。0では上が開いたままです。'],
  },
};

const numbers = Object.entries(BUILDINGS).flatMap(([building, rows]) => Object.entries(rows).map(([word, [name, help, choices]]) => [`masonry.${building}_${word}`, choices ? { name, help, choices } : { name, help }] as const));

export const parameters: Foreign['parameters'] = {
  building: {
    name: '建物',
    help: '建てる物。規則による物、またはファイルの物。',
    choices: {
      block: '直方体', lhouse: 'L字形の家', gabled: '切妻の家', wall: '開口のある壁', gate: '門', steps: '柱のある階段', tower: '円塔', ring: '壁の輪', sheet: '一枚の壁', plan: '平面図の壁', file: 'ファイル',
    },
  },
  ...Object.fromEntries(numbers),
  plan: { name: '平面図の角', help: '壁が沿う線の角のxとy（半枚の数、yは手前へ）。壁は線の左に立ちます。最後の角が最初の角と同じなら、線は閉じます。' },
  openings: { name: '開口', help: '壁の開口。壁の番号（1から）、壁に沿った距離、窓台の高さ（0なら門）、幅、高さ、頭の形（0は直線、1は弧、2は半円）。高さは段の数、ほかは半枚の数です。' },
  'masonry.model': { name: 'モデル', help: '建物のファイルの要約値と名前。リンクにファイルそのものは入りません。' },
  'masonry.unit': { name: 'ファイルの単位', help: 'OBJファイルの長さの単位。JSONの建物には単位が書かれています。', choices: { m: 'メートル', cm: 'センチメートル', mm: 'ミリメートル', ft: 'フィート', in: 'インチ' } },
  'masonry.up': { name: '上の軸', help: 'OBJファイルの中でどちらが上か。JSONではyです。', choices: { y: 'y軸', z: 'z軸' } },
  'masonry.yaw': { name: '回転', help: '同じ光の下で、建物を縦の軸のまわりに回します。' },
  'masonry.pattern': {
    name: '積み方',
    help: '建物の部分が通る、模様の木。',
    choices: {
      quoins: '隅石のあるれんが', bricks: 'れんが', coped: '笠石のあるれんが', ashlar: '乱積みの切石', rgb: 'RGBブロック', diagonal: '斜めれんがの階段', cement: 'セメント石の階段',
    },
  },
  hand: { name: '角', help: '角と稜線のれんがの向き。建物全体で解くか、論文のとおり、建物に書かれた印によるか。', choices: { solved: '解く', stored: '手で' } },
  flips: { name: '手で変えた向き', help: 'れんがの向きを手で変えた角（0）と稜線（1）と、その番号。' },
  'masonry.seed': { name: 'シード', help: '乱数の種。' },
  module: {
    name: '寸法',
    help: '目地を含む、れんがや石の大きさ。',
    choices: { nf: 'ドイツの標準形', us: 'アメリカの標準形', uk: 'イギリスの標準形', ashlar: '125 mmの石', cube: '250 mmの立方体', own: '自由な寸法' },
  },
  'masonry.w': { name: '半枚の幅', help: '目地を含む、半枚のれんがの幅。' },
  'masonry.h': { name: '段の高さ', help: '目地を含む、一段の高さ。' },
  'masonry.joint': { name: '目地', help: '目地の厚み。' },
  recess: { name: '目地の深さ', help: '目地材が壁の表面からどれだけ奥にあるか。' },
  chamfer: { name: '面取り', help: 'ブロックの面取りの幅。' },
  rough: { name: '粗さ', help: '石がどれだけ丸く粗いか。0では平らです。' },
  crooked: { name: 'ゆがみ', help: 'ブロックがどれだけ曲がって置かれるか。' },
  walls: { name: '壁', help: '壁の色。', choices: { ...COLOURS, white: '白塗りのれんが', parts: '部分ごと' } },
  dressing: { name: '縁どり', help: '窓台、まぐさ、アーチ、隅石の色。', choices: { same: '壁と同じ', ...COLOURS } },
  'masonry.mortar': { name: '目地材', help: '目地材の色。', choices: { light: '明るい', grey: '灰色', sand: '砂色', dark: '暗い' } },
  roof: { name: '屋根', help: '屋根の瓦の色。', choices: { slate: 'スレート', tiles: '赤い瓦', brown: '茶色の瓦', stone: '石の瓦' } },
  'masonry.ground': { name: '地面', help: '建物が立つ所。', choices: { grass: '草', gravel: '砂利', paving: '敷石', none: 'スタジオの床' } },
  'masonry.moss': { name: '苔', help: '低い所、上を向く所、北側に苔を生やします。' },
  'masonry.damp': { name: '湿り', help: '地面から湿りを上げ、窓台から水を垂らします。' },
  'masonry.vary': { name: '色のばらつき', help: 'ブロックごとの色調の違い。' },
  'masonry.gloss': { name: '光沢', help: 'ブロックの光り方。', choices: { own: 'そのまま', matt: 'つや消し', glossy: 'つやあり', wet: '濡れ' } },
};

export const groups: Foreign['groups'] = { Building: '建物', Pattern: '積み方', Module: '寸法', Blocks: 'ブロック', Buildings: '建物' };

export const presets: Foreign['presets'] = {
  cottage: { title: '小さな家', note: '淡い窓台と隅石のある赤れんがの家が、夕方の光の中、スレートの下に立つ。' },
  farmhouse: { title: '農家', note: '粗い灰色の石がL字形の家のどの角も回り、瓦には苔が生える。' },
  'stone-house': { title: '石の家', note: '蜂蜜色の切石の窓を、長短の淡い石が縁どる。' },
  'garden-wall': { title: '庭の壁', note: '三つの開口に半円と直線のまぐさがあり、笠石が雨をよける。' },
  'brick-tower': { title: '円塔', note: '湿った塔をれんが積みが一回りし、上に笠石が載る。' },
  'brick-gate': { title: '門', note: '立てたれんがの二重の輪が、半円アーチの上の壁を支える。' },
  'brick-steps': { title: '階段', note: 'れんがが段とともに登り、両わきの柱には笠石が載る。' },
  pentagon: { title: '五角形', note: '五つの壁のれんがは、一列を加えるまで、すべての角で互い違いにはならない。' },
  'walled-garden': { title: '壁の庭', note: '門と六つの窓が、直角の半分で四度曲がる壁に囲まれた庭に面する。' },
  'bay-wall': { title: '張り出しのある壁', note: '二か所で前に出る壁の、八つの斜めの角をれんが積みが回る。' },
  'stone-yard': { title: '石の中庭', note: '粗い石が中庭を囲み、門の前に玄関が張り出す。' },
  'steps-diagonal': { title: '階段・斜めのれんが', note: '段の上の角では、二つのれんがが斜めに出会い、柱には矢筈積みがはまる。' },
  'steps-cement': { title: '階段・セメント石', note: '粗いセメントの石が踏面と笠に沿って並び、間をれんがが埋める。' },
  seams: { title: '継ぎ目', note: '平らなテクスチャはブロックの稜線で途切れ、隣ではセルが角を回る。' },
  'cube-laid': { title: '立方体、稜線まで', note: '立方体の角と稜線にはブロックがあり、面はまだ空いている。' },
  'steps-corners': { title: '階段・角', note: '角のれんが。段の上の角にはそれぞれ三つある。' },
  'steps-edges': { title: '階段・稜線', note: '角のれんがの間に、稜線のれんがが並ぶ。' },
  'steps-panels': { title: '階段・飾り', note: '柱の面では、飾りがほかのれんがより先にはまる。' },
  'steps-faces': { title: '階段・面', note: '残りの場所を、面のれんがが埋める。' },
  'masonry7-a': { title: '直方体・RGB', note: '角は赤、稜線は緑、面は青。方法の三つの段階が見える。' },
  'masonry7-b': { title: '直方体・れんが', note: '長手と小口が稜線で互い違いになり、れんが積みが合う。' },
  'masonry7-c': { title: '直方体・切石', note: '稜線の互い違いの石の間を、大小の石が埋める。' },
  'masonry7-d': { title: '家・RGB', note: '家の開口には、それぞれの角と稜線がある。' },
  'masonry7-g': { title: '門・RGB', note: 'アーチの稜線のブロックが曲線に沿う。' },
  'masonry7-i': { title: '門・切石', note: '迫石と薄い石の縁がアーチを回る。' },
};
