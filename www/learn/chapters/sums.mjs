// The sums over the outline's segments that give a direction: two as the papers print them, and ours.
import { over, row, under } from './math.mjs';

const MEAN = `${row('v =')}<mfrac><mn>1</mn><mi>n</mi></mfrac>${under('∑', 'i')}`;

/** The length of segment i. */
const LENGTH = `<mrow><mo stretchy="false">|</mo>${row('si')}<mo stretchy="false">|</mo></mrow>`;

const FOUR_THETA = '<mn>4</mn><msub data-symbol="theta"><mi>θ</mi><mi>i</mi></msub>';
const TURNED = `<mrow><mo stretchy="false">(</mo><mi>cos</mi>${FOUR_THETA}<mo>,</mo><mi>sin</mi>${FOUR_THETA}<mo stretchy="false">)</mo></mrow>`;
const ALONG = `<munder data-symbol="weight"><mo>∫</mo>${row('si')}</munder><mfrac data-symbol="weight"><mrow><mi>d</mi><mi>s</mi></mrow><msup><mi>r</mi><mn>4</mn></msup></mfrac>`;

/** Equation (1) of the paper of 2000: the mean of the segments as arrows, over their squared distances. */
export const arrowSum = {
  math: `${MEAN}${over('si', 'di²')}`,
  speech: {
    en: 'v equals one over n times the sum over i of the vector s i over d i squared.',
    ja: 'ブイは、エヌ分の1かける、アイについての、ディー・アイの2乗分のベクトル、エス・アイの和。',
  },
};

/** Equation (1) of the paper of 2001: the mean of the segments' lengths, over their squared distances. */
export const lengthSum = {
  math: `${MEAN}<mfrac>${LENGTH}${row('di²')}</mfrac>`,
  speech: {
    en: 'v equals one over n times the sum over i of the length of s i over d i squared.',
    ja: 'ブイは、エヌ分の1かける、アイについての、ディー・アイの2乗分のエス・アイの長さの和。',
  },
};

/** The sum of four-fold arrows, each weighted along its whole segment. */
export const fourFoldSum = {
  math: `${row('v4 =')}${under('∑', 'i')}${TURNED}${ALONG}`,
  speech: {
    en: 'v four equals the sum over the segments i of the vector cosine four theta i, sine four theta i, times the integral along segment i of one over r to the fourth.',
    ja: 'ブイ・フォーは、各線分アイについて、ベクトル、コサイン4シータ・アイ、サイン4シータ・アイに、線分に沿うアールの4乗分の1の積分をかけたものの和。',
  },
};
