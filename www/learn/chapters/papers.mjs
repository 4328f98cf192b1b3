// Papers and differences: equations and rules of sections 4 and 5 as they are printed, and as the program reads them.
import { at, PAVEMENTS, SKINS } from './cite.mjs';
import { cases, fenced, over, raised, row } from './math.mjs';
import { directionDifferences } from './papers-direction.mjs';
import { meshDifferences } from './papers-mesh.mjs';
import { packingDifferences } from './papers-packing.mjs';

const BRACKET = fenced(`${over('5', '4')}${raised('w', 3)}<mo>−</mo>${over('19', '8')}${raised('w', 2)}<mo>+</mo>${over('9', '8')}`);
const QUARTIC = fenced(`${over('5', '16')}${raised('w', 4)}<mo>−</mo>${over('19', '24')}${raised('w', 3)}<mo>+</mo>${over('9', '8')}${row('w')}<mo>−</mo>${over('153', '256')}`);
const RANGE = { en: 'for w up to 1.5, and 0 beyond', ja: 'ダブリューが1.5まで、その先は0' };

/** @param {string} factor */
const potential = (factor) => `${row('psi ( w ) =')}${cases([[`<mo>−</mo>${factor}${QUARTIC}<mo>,</mo>`, row('0 ≤ w ≤ 1.5')], ['<mn>0</mn><mo>,</mo>', row('w ≥ 1.5')]])}`;
const QUARTIC_SPEECH = {
  en: 'times the bracket: five sixteenths w to the fourth, minus nineteen twenty-fourths w cubed, plus nine eighths w, minus 153 over 256',
  ja: 'かける、かっこ、16分の5ダブリューの4乗、引く24分の19ダブリューの3乗、足す8分の9ダブリュー、引く256分の153、かっことじ',
};

const PAIR = 'outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&fend=0&mend=0&most=1000';
/** @param {number} w */
const pair = (w) => `fig=pair&${PAIR}&given=0.25,0.5,1;${0.25 + w / 4},0.5,0&damp=0.5&move=rk4&dt=0.1&step=0`;

/** In the order of the equations. @type {import('./types.mjs').Difference[]} */
export const differences = [
  ...directionDifferences,
  {
    key: 'force', chapter: 'two-bubbles', isMisprint: true,
    heading: { en: 'Equation (2): the force, and its slope', ja: '式(2)：力とその傾き' },
    from: { en: `${PAVEMENTS.en}4.2, eq. (2); ${SKINS.en}5.1`, ja: `${PAVEMENTS.ja}4.2節 式(2)。${SKINS.ja}5.1節` },
    printed: {
      math: `${row('f ( 1 ) = f ( 1.5 ) = 0 ,')}<mspace width="0.6em"/><msup><mi data-symbol="f">f</mi><mo>′</mo></msup>${row('( 1 ) = − k0')}`,
      speech: { en: 'f of 1 equals f of 1.5 equals 0, and f prime of 1 equals minus k zero.', ja: 'エフ・オブ・1はエフ・オブ・1.5に等しく0。エフ・プライム・オブ・1はマイナス、ケー・ゼロ。' },
    },
    ours: {
      math: `${row('f ( w ) =')}${over('k0', 'l0')}${BRACKET}<mo>,</mo><mspace width="0.6em"/><msup><mi data-symbol="f">f</mi><mo>′</mo></msup>${row('( 1 ) = −')}${over('k0', 'l0')}`,
      speech: { en: `f of w equals k zero over l zero, times the bracket: five quarters w cubed, minus nineteen eighths w squared, plus nine eighths; f prime of 1 equals minus k zero over l zero.`, ja: 'エフ・オブ・ダブリューは、エル・ゼロ分のケー・ゼロかける、かっこ、4分の5ダブリューの3乗、引く8分の19ダブリューの2乗、足す8分の9、かっことじ。エフ・プライム・オブ・1はマイナス、エル・ゼロ分のケー・ゼロ。' },
    },
    note: {
      en: 'The printed factor $k0 / l0$ gives the slope $− k0 / l0$, and not $− k0$, as the paper of 2003 demands: both agree where $l0 = 1$. The papers have one $k0$ for all pairs. Ours takes $k0 = l0²$, so that a force is a length, and large cells push harder.',
      ja: '印刷された係数$k0 / l0$では、傾きは$− k0 / l0$となり、2003年の論文が求める$− k0$にはなりません。両者が一致するのは$l0 = 1$のときです。論文では$k0$は全体で一つですが、本プログラムでは$k0 = l0²$とし、力を長さで表します。大きいセルほど強く押します。',
    },
    task: {
      question: { en: 'Differentiate the bracket at $w = 1$.', ja: 'かっこの中を$w = 1$で微分しましょう。' },
      answer: { en: '15/4 − 19/4 = −1: in the figure the force falls through 0 at $w = 1$ with slope −1, in units of $k0 / l0$.', ja: '15/4 − 19/4 = −1。図の力は、$k0 / l0$を単位として、$w = 1$で傾き−1で0を横切ります。' },
    },
    see: { link: pair(0.95), words: { en: 'The pair at w = 0.95: the force is about 0.05', ja: 'w = 0.95の対。力はおよそ0.05' } },
  },
  {
    key: 'sign', chapter: 'two-bubbles', isMisprint: true,
    heading: { en: 'Which sign has a push?', ja: '斥力の符号はどちらか' },
    from: at(SKINS, '5.1', '5.1節'),
    printed: { text: { en: 'Nearer than the stable distance “the force is negative (the cells are repelled from each other), otherwise the force is positive”.', ja: '安定距離より近ければ「力は負（セルは反発する）、そうでなければ力は正」（原文は英語）。' } },
    ours: {
      math: row('f ( 0 ) = 9/8 > 0'),
      speech: { en: 'f of 0 equals nine eighths, greater than 0.', ja: 'エフ・オブ・0は8分の9で、0より大きい。' },
    },
    note: {
      en: 'The equation on the same page is positive for near cells, 9/8 at $w = 0$, and negative between 1 and 1.5. We keep the equation: a push is positive.',
      ja: '同じページの式は、近いセルに対して正（$w = 0$で9/8）、1と1.5の間で負です。本プログラムは式に従い、斥力を正とします。',
    },
    task: {
      question: { en: 'Move the bubbles to $w = 0.7$ and to $w = 1.2$. Which sign does the curve have, and which way do the arrows point?', ja: 'バブルを$w = 0.7$と$w = 1.2$に置きましょう。曲線の符号と、矢印の向きはどうなりますか。' },
      answer: { en: 'At 0.7 the curve is above 0 and the arrows point apart; at 1.2 it is below 0 and they point at each other.', ja: '0.7では曲線が0より上で、矢印は外向き。1.2では0より下で、矢印は向かい合います。' },
    },
    see: { link: pair(0.7), words: { en: 'The pair at w = 0.7', ja: 'w = 0.7の対' } },
  },
  {
    key: 'potential', chapter: 'two-bubbles', isMisprint: true,
    heading: { en: 'Equation (3): work is force times a length', ja: '式(3)：仕事は力×長さ' },
    from: at(PAVEMENTS, '4.2, eq. (3)', '4.2節 式(3)'),
    printed: {
      math: potential(over('k0', 'l0')),
      speech: { en: `psi of w equals minus k zero over l zero, ${QUARTIC_SPEECH.en}, ${RANGE.en}.`, ja: `プサイ・オブ・ダブリューは、マイナス、エル・ゼロ分のケー・ゼロ、${QUARTIC_SPEECH.ja}、${RANGE.ja}。` },
    },
    ours: {
      math: potential(row('k0')),
      speech: { en: `psi of w equals minus k zero, ${QUARTIC_SPEECH.en}, ${RANGE.en}.`, ja: `プサイ・オブ・ダブリューは、マイナス、ケー・ゼロ、${QUARTIC_SPEECH.ja}、${RANGE.ja}。` },
    },
    note: {
      en: 'Integrating (2) means to sum force times a length, and a step in w is a length of $l0$: the $l0$ below $k0$ is cancelled. With the printed factor the slope of the valley over the distance would be the force divided by $l0$.',
      ja: '(2)を積分するとは、力×長さを足すことです。wの一刻みは長さ$l0$なので、$k0$の下の$l0$は約分されます。印刷された係数のままでは、距離に対する谷の傾きが力を$l0$で割ったものになります。',
    },
    task: {
      question: { en: 'In the figure read Ψ at $w = 0.5$ and at $w = 0.6$. By how much does it fall, and what is the mean force times 0.1?', ja: '図で$w = 0.5$と0.6のΨを読みましょう。どれだけ下がりますか。その間の力×0.1と比べましょう。' },
      answer: { en: 'From 0.115 to 0.053: it falls by 0.062 $k0$. Midway the force is 0.615 in $k0 / l0$, and the way is 0.1 $l0$: 0.062 $k0$. No $l0$ is left.', ja: '0.115から0.053へ、0.062 $k0$だけ下がります。中間の力は0.615（単位$k0 / l0$）、進む長さは0.1 $l0$で、積は0.062 $k0$。$l0$は残りません。' },
    },
    see: { link: pair(0.5), words: { en: 'The pair at w = 0.5', ja: 'w = 0.5の対' } },
  },
  ...packingDifferences,
  ...meshDifferences,
];
