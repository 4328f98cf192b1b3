// The contents: the chapters that are there, and those to come.
import { howMany } from './how-many.mjs';
import { howManyGuide } from './how-many-guide.mjs';
import { manyBubbles } from './many-bubbles.mjs';
import { manyBubblesGuide } from './many-bubbles-guide.mjs';
import { squares } from './squares.mjs';
import { squaresGuide } from './squares-guide.mjs';
import { twoBubbles } from './two-bubbles.mjs';
import { twoBubblesGuide } from './two-bubbles-guide.mjs';

/** @typedef {{ en: string, ja: string }} Words */

/** The chapters that are there, with their parts of the teacher's guide. */
export const chapters = [
  { ...twoBubbles, guide: twoBubblesGuide },
  { ...manyBubbles, guide: manyBubblesGuide },
  { ...squares, guide: squaresGuide },
  { ...howMany, guide: howManyGuide },
];

/** Those to come, by number. @type {Record<number, { title: Words, idea?: Words }>} */
const coming = {
  3: { title: { en: 'From bubbles to a mesh', ja: 'バブルからメッシュへ' }, idea: { en: 'To join points is easy; to have good points is the work.', ja: '点を結ぶのは簡単です。良い点を置くのが仕事です。' } },
  5: { title: { en: 'Which way?', ja: 'どちら向き？' }, idea: { en: 'A square looks alike after a quarter turn, so directions cannot be averaged as arrows.', ja: '正方形は90度回しても同じなので、向きを矢印として平均することはできません。' } },
  7: { title: { en: 'Stretch', ja: '引き伸ばす' } },
  8: { title: { en: 'Cells', ja: 'セル' } },
  9: { title: { en: 'A stone', ja: '石をつくる' } },
  10: { title: { en: 'Light', ja: '光' } },
  11: { title: { en: 'Surfaces', ja: '曲面' } },
  12: { title: { en: 'Piles', ja: '山積み' } },
  13: { title: { en: 'Walls', ja: '壁' } },
  14: { title: { en: 'The whole', ja: '全体' } },
};

/** A row of the contents. One without a name is still to come. @typedef {{ name?: string, title: Words, idea?: Words }} Row */

/** All chapters in their order. @type {Row[]} */
export const contents = Array.from({ length: 14 }, (_, at) => {
  const chapter = chapters.find(({ number }) => number === at + 1);
  const row = chapter ?? coming[at + 1];
  if (!row) throw new Error(`The contents have no chapter ${at + 1}.`);
  return row;
});
