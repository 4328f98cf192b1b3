/** The Japanese for piles, by generator and key, if it differs from that for other generators. It comes with the second module. */
import type { Foreign } from './foreign';

const COMPONENTS = {
  rice: '米粒', pebble: '小石', smooth: '滑らかな小石', chestnut: '栗', nut: 'ナット', bolt: 'ボルト', gear: '歯車', ball: '玉', torus: '輪', box: '角材',
  bean: '豆', cashew: 'カシュー', almond: 'アーモンド', walnut: 'くるみ', leaf: '葉', orange: 'オレンジ', apple: 'りんご', file: 'ファイル',
};

const FINISHES = {
  own: 'もとのまま', rice: '米粒', river: '川原の石', basalt: '玄武岩', quartz: '石英', chestnut: '栗', brass: '真鍮', steel: '鋼', copper: '銅', wood: '木',
  walnut: '濃い木', bean: '小豆', blackbean: '黒豆', cashew: 'カシュー', almond: 'アーモンド', leaf: '落ち葉', greenleaf: '緑の葉', orange: 'オレンジ',
  apple: '赤りんご', greenapple: '青りんご', red: '赤', blue: '青', yellow: '黄', white: '白', toys: 'いろいろな色', ivory: '象牙', clay: '粘土', nutshell: 'くるみの殻', glass: 'ガラス',
};

const UPRIGHT = { y: 'y軸', z: 'z軸' };

const ORDERS = { random: '無作為', scan: '一列ずつ' };

/** The rows of a type, by its number and the words that precede its name. */
function ofType(number: number, whose: string): Foreign['parameters'] {
  const row = (key: string, name: string, help: string, choices?: Record<string, string>): Foreign['parameters'] => ({ [`${key}${number}`]: choices ? { name, help, choices } : { name, help } });
  return {
    ...row('c', number === 1 ? '積む物' : `${whose}物`, number === 1 ? '積み重ねる物。' : `山に加える${whose}物。`, number === 1 ? COMPONENTS : { none: 'なし', ...COMPONENTS }),
    ...row('file', 'モデル', `${whose}物のファイルの要約値と名前。リンクにファイルそのものは入りません。`),
    ...row('up', '上の軸', `${whose}物のファイルの中でどちらが上か。`, UPRIGHT),
    ...row('f', '仕上げ', `${whose}物の色とつや。`, FINISHES),
    ...row('k', '大きさ', `${whose}物の大きさの倍率。`),
    ...row('sigma', '間隔', `${whose}物の点どうしの最小の距離（最大の内接球の半径を1とする）。1より小さいと密、大きいと疎。0では物に合わせて決まります。`),
    ...row('tu', 'uまわりの回転', `${whose}物が、水平な軸uのまわりにどれだけ回るか。`),
    ...row('tv', 'vまわりの回転', `${whose}物が、面の法線vのまわりにどれだけ回るか。`),
    ...row('tw', 'wまわりの回転', `${whose}物が、軸wのまわりにどれだけ回るか。`),
    ...row('l', '移動範囲', `${whose}物が面の法線に沿ってどこまで滑れるか（対角線を1とする）。0では点の場所のままです。`),
  };
}

/** The numbers of shapes, by shape: the name and the help. */
const SHAPES: Record<string, Record<string, [name: string, help: string]>> = {
  heap: {
    height: ['幅に対する高さ', '頂の高さ。0.1では平らに広がり、0.5では急になります。'],
    round: ['頂の丸み', '頂とすそを丸めます。0.3ではほとんど円錐で、1ではどこも滑らかです。'],
    depth: ['幅に対する奥行き', '盛り山を前後に縮めて楕円にします。1では円いすそのままです。'],
  },
  dome: {
    height: ['幅に対する高さ', '丸屋根の高さ。0.5で奥行きが1なら、球の半分です。'],
    depth: ['幅に対する奥行き', '丸屋根を前後に縮めて楕円にします。1では円いすそのままです。'],
  },
  riceball: {
    thick: ['幅に対する厚み', '前後の厚み。0.3では薄いおむすび、0.65では厚いおむすびです。'],
    round: ['角の丸み', '三つの角を丸めます。0でははっきりした三角形で、1ではほとんど円です。'],
  },
  block: {
    height: ['幅に対する高さ', '地面から上の面までの高さ。1では幅と同じ高さです。'],
    depth: ['幅に対する奥行き', '前後の大きさ。1では幅と同じ奥行きです。'],
    round: ['縁の丸み', '最も短い辺の半分に対する、縁の半径。1では狭い面が半円になります。'],
  },
  bowl: {
    depth: ['幅に対する内側の深さ', '縁から内側の底までの深さ。0.2では浅い皿で、0.5では深い鉢です。'],
    full: ['盛り具合', '中身の高さ。0では縁より深さの五分の一だけ低く、1では縁の上に盛り上がります。'],
  },
  openbox: {
    depth: ['幅に対する奥行き', '前後の大きさ。1では上から見て正方形の箱です。'],
    height: ['幅に対する側面の高さ', '箱を囲む板の高さ。中身も一緒に高くなります。'],
    full: ['盛り具合', '平らな中身の高さ。0では内側の五分の二まで、1では縁まで入ります。'],
  },
};

const shapes = Object.entries(SHAPES).flatMap(([shape, rows]) => Object.entries(rows).map(([word, [name, help]]) => [`${shape}_${word}`, { name, help }] as const));

export const parameters: Foreign['parameters'] = {
  ...ofType(1, ''),
  ...ofType(2, '第二の'),
  ...ofType(3, '第三の'),
  ...ofType(4, '第四の'),
  ...Object.fromEntries(shapes),
  variants: { name: '変種の数', help: '曲げたり、細らせたり、膨らませたりした物の種類。同じものが二つとないようにできます。' },
  jitter: { name: '大きさのばらつき', help: '物の大きさがどれだけ違うか。' },
  'pile.form': {
    name: '形',
    help: '物を積む、または入れる形。規則による形、またはファイルの形。',
    choices: {
      riceball: 'おむすび', heap: '盛り山', dome: '丸屋根', block: '直方体', bowl: '鉢', openbox: '開いた箱', terrain: '地形', slope: '坂', stairs: '階段', cylinder: '円柱',
      sphere: '球', torus: 'トーラス', knot: '結び目', horn: '角', leg: '足', tail: '尾', fish: '魚', turtle: '亀の甲羅', egg: '卵', vase: '壺', letter: '文字', file: 'ファイル',
    },
  },
  'pile.model': { name: '形のモデル', help: '形のファイルの要約値と名前。リンクにファイルそのものは入りません。' },
  'pile.ps': { name: '形の大きさ', help: '形の最も長い辺の半分（物の長さの半分を1とする）。' },
  core: { name: '形の表面', help: '物の間から形そのものを見せるか。', choices: { own: '形に合わせて', seen: '見せる', hidden: '隠す' } },
  layers: { name: '層', help: '物の層の数。外側の層と、その下の内側の層。' },
  'pile.yaw': { name: '回転', help: '同じ光の下で、山を縦の軸のまわりに回します。' },
  darts: { name: '点', help: '点を置く順。一列ずつでは列が見えます。', choices: ORDERS },
  merge: { name: '種類', help: '大きな種類の点の近くにある、小さな種類の点を除くか。', choices: { merged: '合わせる', alone: '別々に' } },
  frame: { name: '軸', help: '物の回転のもとになる軸。それぞれの場所の面の軸か、空間の軸か。', choices: { local: '面の軸', global: '空間の軸' } },
  'pile.seed': { name: 'シード', help: '乱数の種。シードが違えば、山も違います。' },
  refine: { name: '探索', help: '物の位置の求め方。正確に求めるか、論文の黄金分割法によるか。', choices: { exact: '正確', golden: '黄金分割法' } },
  reading: { name: 'コスト', help: '黄金分割法のコストで調べる、置き終えた物。', choices: { nearest: '最も近い物', all: 'すべての物' } },
  iterations: { name: '反復回数', help: '黄金分割法の反復の回数。' },
  'pile.reach': { name: '移動範囲', help: '移動範囲を与えたままにするか、法線に沿って三個から五個の物に当たる長さにするか。', choices: { given: '与えたまま', natural: '自動' } },
  offset: { name: 'オフセット', help: 'どこまで重なっても接触とみなすか（小さい方の最大の内接球の半径を1とする）。' },
  removal: { name: '除去', help: 'さらにどれだけ深く重なると、後の物を除くか。' },
  alpha: { name: '内側の割合', help: '移動範囲のうち形の内側にある割合。0では論文のとおり外へ積み、1では輪郭を保ちます。' },
  order: { name: '順序', help: '物が落ち着く順。一列ずつでは列が見えます。', choices: ORDERS },
  first: { name: '大きな種類', help: '大きな種類から先に置くか。', choices: { large: '先に', mixed: '小さな種類と一緒に' } },
  retries: { name: 'やり直し', help: '物を除く前に、別の向きを試す回数。' },
  'pile.vary': { name: '色のばらつき', help: '物ごとの色調の違い。' },
  'pile.gloss': { name: '光沢', help: '物の光り方。', choices: { own: 'そのまま', matt: 'つや消し', glossy: 'つやあり', wet: '濡れ' } },
  'pile.wet': { name: '濡れ', help: '山を下から、高さのこの割合まで濡らします。' },
};

export const groups: Foreign['groups'] = {
  Component: '積む物', 'Second type': '第二の種類', 'Third type': '第三の種類', 'Fourth type': '第四の種類', Placing: '配置', Refinement: '詰め', Look: '見た目',
};

export const presets: Foreign['presets'] = {
  'rice-ball': { title: 'おむすび', note: 'しっとりした長短の米粒が、手で握ったようにすき間なく詰まる。' },
  'chestnut-box': { title: '栗の箱', note: 'つやのある栗が木箱を満たし、板を突き抜けるものは一つもない。' },
  'fruit-basket': { title: '果物かご', note: 'りんごとオレンジが胡桃の中に沈み、その下にもう一層ある。' },
  'oranges': { title: '鉢のオレンジ', note: 'どの実にも毛穴のような粒があり、ところどころにへたがのぞく。' },
  'wet-pebbles': { title: '濡れた小石', note: '川の小石が水際から下では黒く光り、上では白く乾いている。' },
  'chestnut-rice': { title: '栗ごはん', note: '移動範囲の短い栗が先に落ち着き、ご飯の中に深く収まる。' },
  'nuts-bolts': { title: 'ナットとボルト', note: '真鍮のナットと鋼のボルトが混じり、どちらも空を映す。' },
  'toys': { title: 'おもちゃ', note: '輪と球と積み木が、形ごとの色で一つの山になる。' },
  'cashews': { title: 'カシューの鉢', note: '先の濃いクリーム色の実が、鉢の中で互いに抱き合う。' },
  'autumn-leaves': { title: '落ち葉', note: '低い横からの光が、掃き集めた葉を透かす。' },
  'bean-letter': { title: '豆の文字', note: '豆が内側にだけ動くので、文字の縁がくっきり残る。' },
  'stones-hill': { title: '丘の石', note: '大きな黒い石が地面に半ば埋まり、その間に白い小石が集まる。' },
  'nut-bowl': { title: '木の実の鉢', note: '胡桃とアーモンドとカシューナッツが白い鉢で等しく混じる。' },
  'leaf-dome': { title: '生け垣', note: '緑の葉が、刈り込んだ生け垣のように半球を覆う。' },
  'toy-box': { title: '積み木の箱', note: '青と白の積み木が木箱に投げ込まれている。' },
  'quartz-egg': { title: '石英の卵', note: 'なめらかな白い小石が卵を覆い、同じ石は二つとない。' },
  'sea-glass': { title: 'シーグラス', note: '浜で集めたような五色の丸いガラスが白い鉢を満たす。' },
  'leaf-fish': { title: '木の葉の魚', note: '緑の葉と紅葉が、うろこのように魚の上に寝ている。' },
  'ivory-knot': { title: '象牙の結び目', note: '象牙色の豆が三つ葉の結び目をたどる。' },
  'nut-letter': { title: 'ナットの文字', note: '大きな真鍮のナットがSを作り、小さな鋼のナットがすき間を埋める。' },
  'copper-globe': { title: '銅の球', note: '銅のナットが球に寄りかかり、どの側でも輪が空を映す。' },
  'gear-ring': { title: '歯車の輪', note: '鋼の歯車と小さな真鍮の歯車が輪に沿って寝ている。' },
  'ammonite': { title: 'アンモナイト', note: '白い小石が、広い口から先まで巻き貝の形をたどる。' },
  'basalt-stairs': { title: '玄武岩の階段', note: '黒い小石が三つの段に手で敷いたように平らに並ぶ。' },
  'pile9-a': { title: '', note: '米粒が法線のまわりにだけ回り、面に寝ている。論文の本文では物と形が失われており、どちらも推測である。' },
  'pile9-c': { title: '', note: '小石が法線のまわりにだけ回り、山に平らに載る。論文の本文では物と形が失われており、どちらも推測である。' },
  'pile9-e': { title: '', note: '豆が法線のまわりにだけ回り、鉢の中で平らに寝る。論文の本文では物と形が失われており、どちらも推測である。' },
  'pile10-a': { title: '', note: '輪・球・積み木の間隔は4・2・1、範囲は1・2・3である。論文の本文では形と角度と順序が失われており、これらは推測である。' },
  'pile10-b': { title: '', note: '範囲0.1の栗が、範囲1.5の米の中に深く留まる。大きい物とその大きさ、形、角度は推測で、論文の個数は7,400とも97,400とも読める。' },
  'pile11-a': { title: '', note: 'オフセットTが0なので、胡桃どうしが重ならない。論文の本文では物と形と角度が失われており、これらは推測である。' },
  'pile11-b': { title: '', note: 'オフセットTが0.2なので胡桃が少し重なり、すき間がふさがる。物と形と角度は推測で、論文の数字を秒と個数に分けたところも推測である。' },
  'pile13-a': { title: '', note: '回転が面の軸から始まるので、積み木が面に沿う。論文の本文では物と形と角度が失われており、これらは推測である。' },
  'pile13-b': { title: '', note: '回転が空間の軸から始まるので、積み木が水平な層をなす。論文の本文では物と形と角度が失われており、これらは推測である。' },
  'pile14-a': { title: '', note: 'オレンジの層が球の内部まで満たす。論文の本文では物と形と角度が失われており、これらは推測である。' },
  'pile14-b': { title: '', note: '図14 (a) と同じ数値で、オレンジの層が卵を満たす。ここでも物と形と角度は推測である。' },
  'pile15-a': { title: '', note: 'まばらな輪が面に寝て、花瓶が光を通す。論文の本文では物と形が失われており、どちらも推測である。' },
  'pile15-b': { title: '', note: '間隔7のナットと間隔2のボルトが、同じ範囲3で積もる。論文の本文では形と角度と順序が失われており、これらは推測である。' },
  'pile15-c': { title: '', note: '歯車が鎧の板のように球に寝ている。論文の本文では物と形が失われており、どちらも推測である。' },
  'pile15-d': { title: '', note: '少ないナットが多くのボルトに混じり、範囲はどちらも10である。論文の本文では形と角度と順序が失われており、これらは推測である。' },
  'pile6-alone': { title: '', note: '二つの種類を合わせないと、米が栗の場所を占める。論文では丸屋根ではなくおむすびで、数値は推測である。' },
  'pile6-merged': { title: '', note: '栗の半径の内に米粒が置かれないので、栗の場所が空く。論文では丸屋根ではなくおむすびで、数値は推測である。' },
  'pile8-strict': { title: '', note: '範囲の短いオレンジが小石の中に沈んだままになる。物と形と数値は推測である。' },
  'pile8-loose': { title: '', note: '範囲の長いオレンジが小石から突き出る。物と形と数値は推測である。' },
  'pile12-normal': { title: '', note: 'アーモンドが傾かず、花瓶に平らに寝る。物と形と数値は推測である。' },
  'pile12-random': { title: '', note: 'アーモンドがあらゆる向きに回り、同じ花瓶が粗くなる。物と形と数値は推測である。' },
};
