/** The module's sentences in Japanese: what a link, a value or an outline has wrong. */

/** Replacements of whole sentences; `named` gives a parameter's name, `said` what a part of a sentence says. */
type Pattern = [pattern: RegExp, sentence: (...parts: string[]) => string];

/** Parameters as sentences name them: “Cell size (cs)”, and their choices: “S-curve (road_s)”, “Star”. `names` are by key, `choices` by key and word. */
export function japanese(names: (key: string) => string | undefined, choices: (key: string, word: string) => string | undefined): (text: string) => string {
  const named = (text: string): string => text.replace(/^.+ \((\w+)\)$/, (whole, key: string) => (names(key) ? `${names(key) ?? ''} (${key})` : whole));
  const chosen = (key: string, text: string): string => {
    const word = /\((\w+)\)$/.exec(text)?.[1] ?? text.toLowerCase();
    const label = choices(key, word);
    return label === undefined ? text : `${label} (${word})`;
  };
  /** What is allowed, or kept, of the parameter that a sentence names. */
  const value = (what: string, text: string): string => {
    const outline = /^the outline (.+)$/.exec(text)?.[1];
    if (outline) return `${names('outline') ?? ''}「${chosen('outline', outline)}」`;
    if (/^a (whole )?number |^[-\d.]+$/.test(text)) return said(text);
    const key = /\((\w+)\)$/.exec(what)?.[1] ?? '';
    const all = text.split(/, | or /).map((each) => chosen(key, each));
    return all.length > 1 ? `${all.join('、')}のどれか` : (all[0] ?? text);
  };
  const patterns: Pattern[] = [
    [/^(.+) must be (.+); (".*"|[-\d.]+) was given, kept (.+)\.$/, (what, allowed, given, kept) => `${named(what)}は${value(what, allowed)}でなければなりません。${given}が与えられたので、${value(what, kept)}にしました。`],
    [/^(.+) has no value; kept (.+)\.$/, (what, kept) => `${named(what)}に値がありません。${value(what, kept)}のままです。`],
    [/^(".*") is not a parameter; it was dropped\.$/, (what) => `${what}というパラメーターはありません。無視しました。`],
    [/^(.+) is given more than once; the last value counts\.$/, (what) => `${named(what)}が何度も与えられています。最後の値を使います。`],
    [/^(.+) cannot be read: (.+); kept what was there\.$/, (what, why) => `${named(what)}を読めません（${said(why)}）。元のままです。`],
    [/^(.+) cannot be read: (.+); kept (.+)\.$/, (what, why, kept) => `${named(what)}を読めません（${said(why)}）。${value(what, kept)}のままです。`],
    [/^The lines cannot be taken: (.+)\.$/, (why) => `拘束線を使えません（${said(why)}）。`],
    [/^Only the first (\d+) values of the link were read\.$/, (n) => `リンクの初めの${n}個の値だけを読みました。`],
    [/^The link has (\d+) more things to complain of\.$/, (n) => `リンクにはほかにも${n}か所、直したところがあります。`],
    [/^(Outline \(outline\)) is (.+), but (.+) are missing; kept (.+)\.$/, (what, is, points, kept) => `${named(what)}は${value(what, is)}ですが、${named(points)}がありません。${value(what, kept)}のままです。`],
    [/^(.+) need (the outline .+), but (.+) is (.+); they were dropped\.$/, (points, needed, what, is) => `${named(points)}には${value(what, needed)}が必要ですが、${named(what)}は${value(what, is)}です。点は使いません。`],
    [/^The link was made by a newer version \((\d+); this one knows (\d+)\); it was read as well as possible\.$/, (newer, known) => `リンクは新しい版（${newer}。ここは${known}）で作られたものです。読めるだけ読みました。`],
    [/^The version \(v\) must be a whole number from 1 to (\d+); (.+) was given, the link was read as version \d+\.$/, (most, given) => `版 (v) は1から${most}までの整数でなければなりません。${given}が与えられたので、版${most}として読みました。`],
    [/^The outline has (\d+) points; at most (\d+) are allowed\.$/, (n, most) => `輪郭に${n}個の点があります。${most}個までです。`],
    [/^The lines have (\d+) points; at most (\d+) are allowed\.$/, (n, most) => `拘束線に${n}個の点があります。${most}個までです。`],
    [/^(.+) needs at least 2 different points\.$/, (ring) => `${said(ring)}には異なる点が2個以上必要です。`],
    [/^Point (\d+) of (.+) is not a pair of finite numbers\.$/, (n, ring) => `${said(ring)}の点${n}は有限な数の組ではありません。`],
    [/^(.+) has a point far outside the picture, at (.+); at most half of the picture's side is allowed\.$/, (ring, place) => `${said(ring)}の点${place}は画像から離れすぎています。画像の一辺の半分までです。`],
    [/^(.+) needs at least 3 different points; it has (\d+)\.$/, (ring, n) => `${said(ring)}には異なる点が3個以上必要です。今は${n}個です。`],
    [/^All points of (.+) lie on one line through (.+)\.$/, (ring, place) => `${said(ring)}のすべての点が、${place}を通る一直線上にあります。`],
    [/^(.+) turns back on itself at (.+)\.$/, (ring, place) => `${said(ring)}が${place}で折り返しています。`],
    [/^(.+) crosses or touches itself at (.+)\.$/, (ring, place) => `${said(ring)}が${place}で自分自身と交わるか触れています。`],
    [/^(.+) and (.+) cross or touch at (.+)\.$/, (a, b, place) => `${said(a)}と${said(b)}が${place}で交わるか触れています。`],
    [/^(.+) at (.+) is too small: its area is (.+) square pixels, at least (.+) is needed\.$/, (ring, place, area, least) => `${place}の${said(ring)}は小さすぎます。面積は${area}平方画素で、${least}以上が必要です。`],
    [/^(.+) repeats a point at (.+); dropped\.$/, (ring, place) => `${said(ring)}の${place}の点が重複していたので、取り除きました。`],
    [/^(.+) repeats (\d+) points, the first at (.+); dropped\.$/, (ring, n, place) => `${said(ring)}で${n}個の点（最初は${place}）が重複していたので、取り除きました。`],
    [/^(\d+) more things like these were mended\.$/, (n) => `ほかにも${n}か所、同様に直しました。`],
    [/^Kept (.+)\.$/, (kept) => `${value('', kept)}のままです。`],
    [/^Not one cell fits into the outline\. Choose a smaller cell size or a larger outline\.$/, () => '輪郭にセルが一つも入りません。セルを小さくするか、輪郭を大きくしてください。'],
    [/^A stage is missing what it works on\. Begin again \(R\)\.$/, () => '前の段階の結果がありません。最初からやり直してください（R）。'],
    [/^There is not enough memory for a picture of (\d+) pixels: choose a smaller one\.$/, (side) => `一辺${side}画素の画像を作るにはメモリーが足りません。小さいものを選んでください。`],
  ];
  const whole = (text: string): string | undefined => {
    for (const [pattern, sentence] of patterns) {
      const parts = pattern.exec(text);
      if (parts) return sentence(...parts.slice(1));
    }
    return PARTS.find(([part]) => part === text)?.[1];
  };
  // Several sentences in one text come one by one, where they are not known as one.
  return (text) => whole(text) ?? text.split(/(?<=\.) (?=[A-Z])/).map((each) => whole(each) ?? each).join('');
}

/** Parts of sentences, and words that stand alone. */
const PARTS: readonly [string, string][] = [
  ['packing', '充填'],
  ['texture', 'テクスチャ'],
  ['tessellation', '分割'],
  ['skin', '皮膚'],
];

function said(text: string): string {
  const rules: [RegExp, string][] = [
    [/^a whole number from (\S+) to (\S+?)( px|°)?( in a picture of (\d+) px)?$/, '$1から$2$3までの整数'],
    [/^a number from (\S+) to (\S+?)( px|°)? in a picture of (\d+) px$/, '$1から$2$3までの数（画像の一辺$4 px）'],
    [/^a number from (\S+) to (\S+?)( px|°)?$/, '$1から$2$3までの数'],
    [/^[Tt]he outer ring$/, '外周'],
    [/^[Oo]uter ring (\d+)$/, '外周$1'],
    [/^[Rr]ing (\d+)$/, '輪$1'],
    [/^[Hh]ole (\d+)$/, '穴$1'],
    [/^[Ll]ine (\d+)$/, '線$1'],
    [/^row (\d+) has a point more than half a side outside the picture$/, '$1番の点が画像から一辺の半分より離れています'],
    [/^row (\d+) needs at least 2 different points$/, '$1番には異なる点が2個以上必要です'],
    [/^row (\d+) must have a radius from (\S+) to (\S+) sides$/, '$1番の半径は一辺の$2倍から$3倍まで'],
    [/^row (\d+) must have a value from (\S+) to (\S+)$/, '$1番の値は$2から$3まで'],
    [/^row (\d+) must be x, y, radius and value$/, '$1番は x, y, 半径, 値 でなければなりません'],
    [/^row (\d+) must have a kind from (\S+) to (\S+)$/, '$1番の種類は$2から$3まで'],
    [/^row (\d+) must be x, y and the kind's number$/, '$1番は x, y, 種類の番号 でなければなりません'],
    [/^(?:it has|they have) more than (\d+) (?:points|rows)$/, '$1個を超えています'],
    [/^a point has lost its y$/, 'yのない点があります'],
    [/^it has the character (.+)$/, '文字 $1 があります'],
    [/^a number is too large$/, '大きすぎる数があります'],
    [/^its end is missing$/, '終わりがありません'],
    [/^a number in it is none$/, '数でないものがあります'],
  ];
  const rule = rules.find(([pattern]) => pattern.test(text));
  return rule ? text.replace(...rule) : text;
}
