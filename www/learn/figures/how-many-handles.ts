/** The handles of the population: how many cells there are at first, when one goes, and when one comes. */
import type { ChoiceHandle, NumberHandle, Words } from './figure';

const RATIO: Words = { en: 'stable distances', ja: '安定距離' };

export const AT_START: NumberHandle = {
  kind: 'number', key: 'count', symbol: 'n', name: { en: 'Cells at first', ja: '初めの個数' }, unit: { en: 'cells', ja: '個' },
  from: 4, to: 80, stride: 1, fine: 1, coarse: 10, digits: 0,
};

/** A cell goes if its nearest neighbour is nearer than this. */
export const CROWDED: NumberHandle = {
  kind: 'number', key: 'crowd', symbol: 'a', name: { en: 'Goes below', ja: '去る境目' }, unit: RATIO,
  from: 0.5, to: 1, stride: 0.01, fine: 0.01, coarse: 0.1, digits: 2,
};

/** Our rule: a cell comes to an empty place if all others are at least this far from it. */
export const ROOM: NumberHandle = {
  kind: 'number', key: 'room', symbol: 'b', name: { en: 'Comes from', ja: '増える境目' }, unit: RATIO,
  from: 0.4, to: 1.2, stride: 0.01, fine: 0.01, coarse: 0.1, digits: 2,
};

/** The papers' rule: a cell comes beside one whose nearest neighbour is at least this far. */
export const LONELY: NumberHandle = {
  ...ROOM, from: 0.5, to: 1.2,
};

export const CELL_SIZE: NumberHandle = {
  kind: 'number', key: 'cs', symbol: 'd', name: { en: 'Cell size', ja: 'セルの大きさ' }, unit: { en: 'pixels', ja: 'ピクセル' },
  from: 22, to: 40, stride: 1, fine: 1, coarse: 4, digits: 0,
};

/** The papers' rule, of the first packing. */
export const RULE: ChoiceHandle = {
  kind: 'choice', key: 'pop', name: { en: 'Papers: comes', ja: '論文：増える所' },
  choices: [{ word: 'opposite', name: { en: 'opposite the nearest', ja: '最も近い隣の反対側' } }, { word: 'smallest', name: { en: 'only if there is room', ja: '空きがあるときだけ' } }],
};
