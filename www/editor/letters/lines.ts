/**
 * Breaks a text into lines so that its letters become as large as possible.
 *
 * Intl.Segmenter finds words in scripts without spaces. Lines follow the rules of Japanese typesetting (kinsoku): no line
 * begins with a closing mark or small kana, and none ends with an opening mark. Particles and endings in hiragana stay
 * with the word before them, and words stay whole, unless breaking them makes the letters a lot larger.
 */

/** A part of a line that is not broken; `spaced` if a space precedes it within a line. */
interface TextPiece {
  text: string;
  spaced: boolean;
}

/** The ways to break a line of the given text, the coarsest first. */
type Ways = TextPiece[][];

/** Characters that may not begin a line, and those that may not end one. */
const NO_BEGIN = /^[\p{Pe}\p{Pf}\p{M}、。，．・：；？！,.:;?!%％‰°℃ー々〻ゝゞヽヾぁぃぅぇぉっゃゅょゎゕゖァィゥェォッャュョヮヵヶㇰ-ㇿ…‥～〜'"’”-]/u;
const NO_END = /[\p{Ps}\p{Pi}\p{Sc}#＃'"‘“]$/u;

/** Scripts whose words have no spaces between them. */
const UNSPACED = '\\p{Script=Han}\\p{Script=Hiragana}\\p{Script=Katakana}\\p{Script=Thai}\\p{Script=Lao}\\p{Script=Khmer}\\p{Script=Myanmar}\\u3000-\\u303f\\u30fb-\\u30ff\\uff00-\\uffef';
const FREE_BEGIN = new RegExp(`^[${UNSPACED}\\p{Extended_Pictographic}]`, 'u');
const FREE_END = new RegExp(`([${UNSPACED}\\p{Extended_Pictographic}\\u{fe0f}]|[-–—/])$`, 'u');

/** Hiragana alone: an ending, a particle, or a short word. */
const KANA = /^[\p{Script=Hiragana}ー]+$/u;

/** Most letters of a word together with the hiragana that stay with it. */
const LONGEST = 6;

/** The letters of a text as people count them (grapheme clusters). */
export function lettersIn(text: string): string[] {
  return segments(text, 'grapheme');
}

function segments(text: string, granularity: 'grapheme' | 'word'): string[] {
  // Browsers of recent years may lack it.
  if (!('Segmenter' in Intl)) return Array.from(text);
  return Array.from(new Intl.Segmenter('ja', { granularity }).segment(text), ({ segment }) => segment);
}

/** The ways to break a line: into phrases, words, or letters. */
export function waysOf(line: string): Ways {
  const words = line.split(/\s+/u).filter((word) => word !== '');
  const by = (split: (word: string) => string[], phrases: boolean): TextPiece[] => words.flatMap((word) => kept(split(word), phrases).map((text, k) => ({ text, spaced: k === 0 })));
  const byWord = (word: string): string[] => segments(word, 'word');
  return [by(byWord, true), by(byWord, false), by(lettersIn, false)];
}

/** The parts of a word without spaces, joined where no line may break. */
function kept(parts: string[], phrases: boolean): string[] {
  const whole: string[] = [];
  for (const part of parts) {
    const before = whole.at(-1);
    if (before !== undefined && !mayBreak(before, part, phrases)) whole[whole.length - 1] = before + part;
    else whole.push(part);
  }
  return whole;
}

function mayBreak(before: string, after: string, phrases: boolean): boolean {
  if (NO_BEGIN.test(after) || NO_END.test(before)) return false;
  if (!FREE_BEGIN.test(after) && !FREE_END.test(before)) return false;
  return !(phrases && KANA.test(after) && before.length + after.length <= LONGEST);
}

/** Phrases, and then words, are broken only if letters become larger by this factor. */
const LARGER = 1.12;

/** Largest number of lines. */
const MOST = 40;

/** A text in lines, and its size relative to one that fills a square. */
interface Broken {
  lines: string[];
  scale: number;
}

/** The lines whose letters become largest in a square. `scaleOf` returns their size, `widthOf` the width of a text. */
export function broken(text: string, widthOf: (text: string) => number, scaleOf: (lines: string[]) => number): string[] {
  const given = text.split('\n').map(waysOf).filter(([pieces]) => pieces?.length);
  const tries = [0, 1, 2].map((way) => best(given.map((ways) => ways[way] ?? []), widthOf, scaleOf));
  return tries.reduce((chosen, one) => (one.scale > chosen.scale * LARGER ? one : chosen)).lines;
}

function best(given: TextPiece[][], widthOf: (text: string) => number, scaleOf: (lines: string[]) => number): Broken {
  const measured = given.map((pieces) => new Measured(pieces, widthOf));
  let found: Broken = { lines: [], scale: 0 };
  const most = Math.min(MOST, given.reduce((sum, pieces) => sum + pieces.length, 0));
  for (let count = given.length, before = 0; count <= Math.max(most, given.length); count += 1) {
    const width = leastWidth(measured, count);
    const lines = measured.flatMap((line) => line.within(width));
    if (lines.length === before) continue;
    before = lines.length;
    const scale = scaleOf(lines);
    if (scale > found.scale) found = { lines, scale };
  }
  return found;
}

/** The least width that needs no more than `count` lines. */
function leastWidth(measured: Measured[], count: number): number {
  let [low, high] = [Math.max(0, ...measured.map(({ widest }) => widest)), Math.max(0, ...measured.map(({ whole }) => whole))];
  const fits = (width: number): boolean => measured.reduce((sum, line) => sum + line.linesIn(width), 0) <= count;
  if (fits(low)) return low;
  for (let k = 0; k < 24; k += 1) {
    const middle = (low + high) / 2;
    if (fits(middle)) high = middle;
    else low = middle;
  }
  return high;
}

/** A given line, with the widths of its pieces. */
class Measured {
  readonly widest: number;
  readonly whole: number;
  private readonly pieces: TextPiece[];
  /** The distance to the end of each piece, and the space before each. */
  private readonly ends: number[] = [];
  private readonly spaces: number[];
  private readonly widths: number[];

  constructor(pieces: TextPiece[], widthOf: (text: string) => number) {
    const space = widthOf('n n') - widthOf('nn');
    this.pieces = pieces;
    this.widths = pieces.map(({ text }) => widthOf(text));
    this.spaces = pieces.map(({ spaced }, k) => (spaced && k > 0 ? space : 0));
    let end = 0;
    this.widths.forEach((width, k) => this.ends.push((end += width + (this.spaces[k] ?? 0))));
    this.widest = Math.max(0, ...this.widths);
    this.whole = end;
  }

  /** The least number of lines that are no wider than this. */
  linesIn(width: number): number {
    let [lines, left] = [1, 0];
    this.widths.forEach((own, k) => {
      const more = own + (k > 0 && left > 0 ? (this.spaces[k] ?? 0) : 0);
      if (left > 0 && left + more > width + 1e-6) [lines, left] = [lines + 1, own];
      else left += more;
    });
    return lines;
  }

  /** The fewest lines no wider than this, as even as possible: the sum of the squares of their widths is least. */
  within(width: number): string[] {
    const { pieces } = this;
    const count = this.linesIn(width);
    let sums: number[] = [0, ...pieces.map(() => Infinity)];
    const from: number[][] = [];
    for (let line = 0; line < count; line += 1) {
      const next = sums.map(() => Infinity);
      const chosen = sums.map(() => 0);
      for (let begin = 0; begin < pieces.length; begin += 1) {
        for (let end = begin + 1; end <= pieces.length; end += 1) {
          const wide = this.width(begin, end);
          if (wide > width + 1e-6 && end > begin + 1) break;
          const sum = (sums[begin] ?? Infinity) + wide * wide;
          if (sum < (next[end] ?? Infinity)) [next[end], chosen[end]] = [sum, begin];
        }
      }
      sums = next;
      from.push(chosen);
    }
    const lines: string[] = [];
    for (let line = count - 1, end = pieces.length; line >= 0; line -= 1) {
      const begin = from[line]?.[end] ?? 0;
      lines.unshift(textOf(pieces.slice(begin, end)));
      end = begin;
    }
    return lines;
  }

  private width(begin: number, end: number): number {
    return (this.ends[end - 1] ?? 0) - (this.ends[begin] ?? 0) + (this.widths[begin] ?? 0);
  }
}

function textOf(pieces: TextPiece[]): string {
  return pieces.map(({ text, spaced }, k) => (spaced && k > 0 ? ` ${text}` : text)).join('');
}
