/** The harmless answers of an engine that has failed or has no result yet. */
import type { Answer, Generator, Status } from '../module/types';

export const NO_ANSWER: Answer = { refused: true, notices: [] };

export const NO_GENERATOR: Generator = {
  word: '',
  title: '',
  stages: [],
  begins: [],
  stepping: '',
  placing: '',
  settled: '',
  seen: [],
  bases: [],
  overlays: [],
  offers: [],
  names: [],
  samples: [],
  chance: '',
  home: '',
  lowest: 0,
};

export const NO_STATUS: Status = {
  cells: 0,
  steps: 0,
  largestMove: 0,
  energy: 0,
  added: 0,
  removed: 0,
  converged: false,
  stones: 0,
  ms: {},
};
