/** The module's words in Japanese. */
import type { Foreign } from './foreign';

export const foreign: Foreign = {
  parameters: {},
  units: {},
  groups: {},
  presets: {},
  figure: (text) => text,
  sentences: [],
};
