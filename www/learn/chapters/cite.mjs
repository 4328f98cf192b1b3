// The papers as they are cited.

/** @typedef {import('./types.mjs').Words} Words */

const OLD = 'K. Miyata, T. Itoh, K. Shimada (2000)';
export const PAVEMENTS = { en: `${OLD}, `, ja: `${OLD}、` };
export const JAPANESE = { en: 'K. Miyata, T. Itoh, K. Shimada (2001), in Japanese, ', ja: '宮田、伊藤、嶋田（2001）、' };
export const SKINS = { en: 'T. Itoh, K. Miyata, K. Shimada (2003), ', ja: 'T. Itoh, K. Miyata, K. Shimada (2003)、' };

/** A place in a paper. @param {Words} paper @param {string} en @param {string} ja @returns {Words} */
export const at = (paper, en, ja) => ({ en: paper.en + en, ja: paper.ja + ja });
