// Formulas as MathML, for the chapters. A row is written as words between spaces: a symbol by its name, a number, else
// an operator. Each symbol carries its name, so that the page can mark the same symbol in a figure.

/**
 * A letter with a subscript. @param {string} name the symbol's in the page @param {string} letter @param {string} below
 * MathML @param {string} [kind]
 */
const low = (name, letter, below, kind = '') => `<msub data-symbol="${name}"><mi${kind}>${letter}</mi>${below}</msub>`;

const vector = ' class="vector"';
const [zero, i, j] = ['<mn>0</mn>', '<mi>i</mi>', '<mi>j</mi>'];
const ij = `<mrow>${i}${j}</mrow>`;

/** The root of two, less one. @param {string} name */
const rootLessOne = (name) => `<mrow data-symbol="${name}"><mo stretchy="false">(</mo><msqrt><mn>2</mn></msqrt><mo>−</mo><mn>1</mn><mo stretchy="false">)</mo></mrow>`;

/** The symbols by name. */
const symbols = {
  w: '<mi data-symbol="w">w</mi>',
  wij: low('w', 'w', ij),
  wp: low('w', 'w', '<mrow><mi>p</mi><mi>j</mi></mrow>'),
  f: '<mi data-symbol="f">f</mi>',
  psi: '<mi data-symbol="psi">Ψ</mi>',
  psi0: low('psi0', 'Ψ', '<msub><mi>P</mi><mn>0</mn></msub>'),
  psi1: low('corner', 'Ψ', '<msub><mi>P</mi><mn>1</mn></msub>'),
  psi2: low('corner', 'Ψ', '<msub><mi>P</mi><mn>2</mn></msub>'),
  psi3: low('corner', 'Ψ', '<msub><mi>P</mi><mn>3</mn></msub>'),
  psi4: low('corner', 'Ψ', '<msub><mi>P</mi><mn>4</mn></msub>'),
  l: '<mi>l</mi>',
  l0: low('l0', 'l', zero),
  'l0²': '<msubsup data-symbol="l0"><mi>l</mi><mn>0</mn><mn>2</mn></msubsup>',
  k0: low('k0', 'k', zero),
  r0: low('r0', 'r', zero),
  cw: rootLessOne('cw'),
  cr: rootLessOne('cr'),
  root2: '<msqrt><mn>2</mn></msqrt>',
  alpha: '<mi data-symbol="alpha">α</mi>',
  beta: '<mi data-symbol="beta">β</mi>',
  gamma: '<mi data-symbol="gamma">γ</mi>',
  sin: '<mi>sin</mi>',
  s: '<mi data-symbol="shortest">s</mi>',
  R: '<mi data-symbol="R">R</mi>',
  r: '<mi>r</mi>',
  v4: low('v4', 'v', '<mn>4</mn>', vector),
  q: '<mi data-symbol="turns">q</mi>',
  k: '<mi data-symbol="corners">k</mi>',
  m: '<mi data-symbol="m">m</mi>',
  c: '<mi data-symbol="c">c</mi>',
  E: '<mi data-symbol="E">E</mi>',
  t: '<mi>t</mi>',
  n: '<mi data-symbol="n">n</mi>',
  i: '<mi>i</mi>',
  j: '<mi>j</mi>',
  p: '<mi>p</mi>',
  A: '<mi data-symbol="area">A</mi>',
  d: '<mi>d</mi>',
  'd²': '<msup><mi>d</mi><mn>2</mn></msup>',
  di: low('distance', 'd', i),
  'di²': '<msubsup data-symbol="distance"><mi>d</mi><mi>i</mi><mn>2</mn></msubsup>',
  a: '<mi data-symbol="crowd">a</mi>',
  b: '<mi data-symbol="room">b</mi>',
  v: `<mi data-symbol="v"${vector}>v</mi>`,
  si: low('segment', 's', i, vector),
  nij: `<msub><mi${vector}>n</mi>${ij}</msub>`,
  x: '<mi data-symbol="x" class="vector">x</mi>',
  'x.': '<mi data-symbol="x" class="vector">ẋ</mi>',
  'x..': '<mi data-symbol="x" class="vector">ẍ</mi>',
  'x.i': low('x', 'ẋ', i, vector),
  'x..i': low('x', 'ẍ', i, vector),
  F: '<mi data-symbol="f" class="vector">f</mi>',
  Fi: low('f', 'f', i, vector),
};

/** How the words of a row are spoken; numbers and letters are spoken as they are. */
const spoken = {
  en: {
    v4: 'v four', si: 's i', di: 'd i', F: 'f', psi: 'psi', psi0: 'psi P zero', psi1: 'psi P one', l0: 'l zero', k0: 'k zero', r0: 'r zero', wij: 'w i j', nij: 'n i j', Fi: 'f i', cw: 'root 2 minus 1', cr: 'root 2 minus 1', root2: 'root 2', 'd²': 'd squared', 'l0²': 'l zero squared',
    '=': 'equals', '/': 'over', '<': 'is less than', '>': 'is greater than', '≈': 'is about', '≤': 'is at most', '+': 'plus', '−': 'minus', '′': 'prime',
  },
  ja: {
    alpha: 'アルファ', beta: 'ベータ', gamma: 'ガンマ', sin: 'サイン', v: 'ブイ', v4: 'ブイ・フォー', si: 'エス・アイ', di: 'ディー・アイ', q: 'キュー', k: 'ケー', s: 'エス', R: 'アール', r: 'アール',
    psi: 'プサイ', psi0: 'プサイ・ピー・ゼロ', psi1: 'プサイ・ピー・いち', l0: 'エル・ゼロ', k0: 'ケー・ゼロ', r0: 'アール・ゼロ', wij: 'ダブリュー・アイ・ジェー', nij: 'エヌ・アイ・ジェー', Fi: 'エフ・アイ', cw: 'ルート2引く1', cr: 'ルート2引く1', root2: 'ルート2', 'd²': 'ディーの2乗', 'l0²': 'エル・ゼロの2乗',
    '=': 'イコール', '/': '割る', '<': '小なり', '>': '大なり', '≈': 'およそ', '≤': '小なりイコール', '+': '足す', '−': '引く', '′': 'プライム',
  },
};

/** @param {string} word */
function part(word) {
  if (word in symbols) return symbols[/** @type {keyof symbols} */ (word)];
  const text = word.replace('<', '&lt;').replace('>', '&gt;');
  return /^\d[\d./]*$/.test(word) ? `<mn>${text}</mn>` : `<mo>${text}</mo>`;
}

/** @param {string} words */
export const row = (words) => `<mrow>${words.split(' ').map(part).join('')}</mrow>`;

/** @param {string} above @param {string} below both rows */
export const over = (above, below) => `<mfrac>${row(above)}${row(below)}</mfrac>`;

/** @param {string} base @param {number} power */
export const raised = (base, power) => `<msup>${part(base)}<mn>${power}</mn></msup>`;

/** A sign over a range, such as a sum. @param {string} sign @param {string} below a row */
export const under = (sign, below) => `<munder><mo movablelimits="false">${sign}</mo>${row(below)}</munder>`;

/** A formula with fractions, in parentheses of the same height. @param {string} inner */
export const fenced = (inner) => `<mrow><mo class="tall" stretchy="false" form="prefix">(</mo>${inner}<mo class="tall" stretchy="false" form="postfix">)</mo></mrow>`;

/** A value by cases, each with its condition. @param {[string, string][]} all */
export const cases = (all) => {
  const rows = all.map(([value, when]) => `<mtr><mtd>${value}</mtd><mtd>${when}</mtd></mtr>`);
  return `<mrow><mo class="brace" stretchy="false" form="prefix">{</mo><mtable class="cases">${rows.join('')}</mtable></mrow>`;
};

/** How a row is spoken. @param {string} words @param {'en' | 'ja'} language */
export function speechOf(words, language) {
  const says = /** @type {Record<string, string>} */ (spoken[language]);
  return words.split(' ').map((word) => says[word] ?? word).join(' ');
}

/** A formula in a line of text, spoken from its words. @param {string} words @param {'en' | 'ja'} language */
export const inLine = (words, language) => `<math aria-label="${speechOf(words, language)}">${row(words)}</math>`;
