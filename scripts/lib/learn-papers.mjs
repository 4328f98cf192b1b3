// The page on what the papers print, and how the program reads it.
import { chapters } from '../../www/learn/chapters/contents.mjs';
import { differences } from '../../www/learn/chapters/papers.mjs';
import { words } from '../../www/learn/chapters/words.mjs';
import { escaped, folderOf, pageFile, prose, way } from './learn-frame.mjs';

/** @typedef {import('./learn-frame.mjs').Site} Site */
/** @typedef {import('./learn-frame.mjs').Language} Language */
/** @typedef {import('../../www/learn/chapters/types.mjs').Difference} Difference */
/** @typedef {import('../../www/learn/chapters/types.mjs').Side} Side */

/** One side of a row. @param {Language} language @param {string} title @param {Side} side */
function sideOf(language, title, { math, speech, text }) {
  const body = math ? `<math display="block" aria-label="${escaped(speech?.[language] ?? '')}">${math}</math>` : `<p>${escaped(text?.[language] ?? '')}</p>`;
  return `<div class="side" role="group" aria-label="${title}"${math ? ' tabindex="0"' : ''}><p class="over">${title}</p>${body}</div>`;
}

/**
 * The link to the state that shows a difference: of a figure of the chapter, or of the studio. @param {Language}
 * language @param {Difference} difference
 */
function seeing(language, { chapter = '', see }) {
  const own = folderOf(language, 'papers');
  const state = see.figure ? `fig=${see.figure}` : (see.link ?? '');
  const href = way(own, state.startsWith('fig=') ? folderOf(language, chapter) : '');
  return `<p class="see">${words[language].see}: <a href="${href}#${escaped(state)}">${escaped(see.words[language])}</a></p>`;
}

/** @param {Language} language @param {Difference} difference */
function rowOf(language, difference) {
  const t = words[language];
  const text = (/** @type {import('./learn-frame.mjs').Words} */ words) => prose(words[language], language, way(folderOf(language, 'papers'), folderOf(language, 'glossary')));
  const { key, isMisprint, heading, from, printed, ours, note, task } = difference;
  const mark = isMisprint ? ` <small class="misprint">${t.misprint}</small>` : '';
  const exercise = task ? `<div class="task"><p><b>${t.task}</b> ${text(task.question)}</p><details class="answers"><summary>${t.solution}</summary><p>${text(task.answer)}</p></details></div>` : '';
  return `<section class="difference" id="${key}"><h2>${escaped(heading[language])}${mark}</h2>
<p class="sources">${escaped(from[language])}</p>
<div class="sides">${sideOf(language, t.printed, printed)}${sideOf(language, t.ours, ours)}</div>
<p>${text(note)}</p>${exercise}${seeing(language, difference)}</section>`;
}

/** Rows on chapters that are still to come are left out. @param {Site} site @param {Language} language */
export function papersPage(site, language) {
  const t = words[language];
  const there = differences.filter(({ chapter }) => !chapter || chapters.some(({ name }) => name === chapter));
  const body = `<article class="papers"><header><h1>${t.papers}</h1><p class="idea">${t.papersLead}</p></header>${there.map((difference) => rowOf(language, difference)).join('\n')}</article>`;
  return pageFile(site, language, { place: 'papers', title: t.papers, description: t.papersLead, body });
}
