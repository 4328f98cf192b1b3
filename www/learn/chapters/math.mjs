// Formulas as MathML, for the chapters. A row is written as words between spaces: a symbol by its name, a number, else an
// operator. Each symbol carries its name, so that the page can mark what it is in a figure.

/** The symbols by name. */
const symbols = {
  w: '<mi data-symbol="w">w</mi>',
  f: '<mi data-symbol="f">f</mi>',
  psi: '<mi data-symbol="psi">Ψ</mi>',
  l: '<mi>l</mi>',
  l0: '<msub data-symbol="l0"><mi>l</mi><mn>0</mn></msub>',
  k0: '<msub data-symbol="k0"><mi>k</mi><mn>0</mn></msub>',
  m: '<mi data-symbol="m">m</mi>',
  c: '<mi data-symbol="c">c</mi>',
  x: '<mi data-symbol="x" class="vector">x</mi>',
  'x.': '<mi data-symbol="x" class="vector">ẋ</mi>',
  'x..': '<mi data-symbol="x" class="vector">ẍ</mi>',
  F: '<mi data-symbol="f" class="vector">f</mi>',
};

/** How the words of a row are spoken, beside numbers and letters. */
const spoken = {
  en: { psi: 'psi', l0: 'l zero', k0: 'k zero', '=': 'equals', '/': 'over', '<': 'is less than', '>': 'is greater than' },
  ja: { psi: 'プサイ', l0: 'エル・ゼロ', k0: 'ケー・ゼロ', '=': 'イコール', '/': '割る', '<': '小なり', '>': '大なり' },
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

/** Something with fractions, in parentheses as tall. @param {string} inner */
export const fenced = (inner) => `<mrow><mo class="tall" stretchy="false" form="prefix">(</mo>${inner}<mo class="tall" stretchy="false" form="postfix">)</mo></mrow>`;

/** A value by cases, each with its condition. @param {[string, string][]} all */
export const cases = (all) => {
  const rows = all.map(([value, when]) => `<mtr><mtd>${value}</mtd><mtd>${when}</mtd></mtr>`);
  return `<mrow><mo class="brace" stretchy="false" form="prefix">{</mo><mtable class="cases">${rows.join('')}</mtable></mrow>`;
};

/** A formula in a line of text, spoken from its words. @param {string} words @param {'en' | 'ja'} language */
export function inLine(words, language) {
  const says = /** @type {Record<string, string>} */ (spoken[language]);
  const speech = words.split(' ').map((word) => says[word] ?? word);
  return `<math aria-label="${speech.join(' ')}">${row(words)}</math>`;
}
