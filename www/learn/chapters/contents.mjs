// The contents: the chapters that are there, and those to come.
import { howMany } from './how-many.mjs';
import { howManyGuide } from './how-many-guide.mjs';
import { manyBubbles } from './many-bubbles.mjs';
import { manyBubblesGuide } from './many-bubbles-guide.mjs';
import { mesh } from './mesh.mjs';
import { meshGuide } from './mesh-guide.mjs';
import { squares } from './squares.mjs';
import { squaresGuide } from './squares-guide.mjs';
import { twoBubbles } from './two-bubbles.mjs';
import { twoBubblesGuide } from './two-bubbles-guide.mjs';
import { whichWay } from './which-way.mjs';
import { whichWayGuide } from './which-way-guide.mjs';

/** @typedef {import('./types.mjs').Words} Words */

/** The chapters that are there, with their parts of the teacher's guide. */
export const chapters = [
  { ...twoBubbles, guide: twoBubblesGuide },
  { ...manyBubbles, guide: manyBubblesGuide },
  { ...mesh, guide: meshGuide },
  { ...squares, guide: squaresGuide },
  { ...whichWay, guide: whichWayGuide },
  { ...howMany, guide: howManyGuide },
];

/** The titles of the chapters to come, by number. @type {Record<number, Words>} */
const coming = {
  7: { en: 'Stretch', ja: '引き伸ばす' },
  8: { en: 'Cells', ja: 'セル' },
  9: { en: 'A stone', ja: '石をつくる' },
  10: { en: 'Light', ja: '光' },
  11: { en: 'Surfaces', ja: '曲面' },
  12: { en: 'Piles', ja: '山積み' },
  13: { en: 'Walls', ja: '壁' },
  14: { en: 'The whole', ja: '全体' },
};

/** A row of the contents. One without a name is still to come. @typedef {{ name?: string, title: Words, idea?: Words }} Row */

/** All chapters in their order. @type {Row[]} */
export const contents = Array.from({ length: 14 }, (_, at) => {
  const [chapter, title] = [chapters.find(({ number }) => number === at + 1), coming[at + 1]];
  if (chapter) return chapter;
  if (!title) throw new Error(`The contents have no chapter ${at + 1}.`);
  return { title };
});
