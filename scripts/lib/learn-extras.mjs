// The pages beside the chapters: contents, glossary, teacher's guide, and the sheet to print of each chapter.
import { contents } from '../../www/learn/chapters/contents.mjs';
import { words } from '../../www/learn/chapters/words.mjs';
import { general, headings as heads, plans as across } from '../../www/learn/chapters/plans.mjs';
import { escaped, folderOf, pageFile, prose, way } from './learn-frame.mjs';
import { row, speechOf } from '../../www/learn/chapters/math.mjs';

/** @typedef {import('./learn-frame.mjs').Site} Site */
/** @typedef {import('./learn-frame.mjs').Language} Language */
/** @typedef {import('./learn-frame.mjs').Words} Words */
/** @typedef {import('./learn-chapter.mjs').Chapter} Chapter */
/** @typedef {import('../../www/learn/chapters/types.mjs').Term} Term */

/** @param {Site} site @param {Language} language */
export function contentsPage(site, language) {
  const t = words[language];
  const rows = contents.map(({ name, title, idea }, at) => {
    const head = name ? `<a href="${name}/">${title[language]}</a>` : `<span>${title[language]}</span> <small>${t.coming}</small>`;
    return `<li${name ? '' : ' class="coming"'}><span class="number">${at + 1}</span><div><p class="title">${head}</p>${idea ? `<p>${idea[language]}</p>` : ''}</div></li>`;
  });
  const body = `<article><header><h1>${t.learn}</h1><p class="idea">${t.lead}</p></header>
<p>${t.about}</p>
<h2>${t.chapters}</h2><ol class="contents">${rows.join('')}</ol>
<p class="onward"><a href="papers/">${t.papers}</a><span>${t.papersLead}</span></p></article>`;
  return pageFile(site, language, { place: '', title: t.learn, description: t.lead, body });
}

/** @param {Site} site @param {Language} language @param {Term[]} terms */
export function glossaryPage(site, language, terms) {
  const t = words[language];
  const other = language === 'en' ? 'ja' : 'en';
  const rows = terms.map(({ key, symbol, chapter, name, text }) => {
    const at = contents.findIndex((one) => one.name === chapter);
    const sign = symbol ? `<math aria-label="${t.symbol}: ${speechOf(symbol, language)}">${row(symbol)}</math>` : '';
    return `<div class="entry" id="${key}"><dt><span>${name[language]}</span> <span class="other" lang="${other}">${name[other]}</span> ${sign}</dt>
<dd class="picture">${site.draw.term(key)}</dd>
<dd>${escaped(text[language])} <a class="back" href="../${chapter}/">${t.chapter(at + 1)}</a></dd></div>`;
  });
  const body = `<article><header><h1>${t.glossary}</h1><p class="idea">${t.glossaryLead}</p></header><dl class="glossary">${rows.join('')}</dl></article>`;
  return pageFile(site, language, { place: 'glossary', title: t.glossary, description: t.glossaryLead, body });
}

/** @param {string[]} items */
const list = (items) => `<ul>${items.map((item) => `<li>${item}</li>`).join('')}</ul>`;

/** @param {Site} site @param {Language} language @param {Chapter[]} chapters */
export function guidePage(site, language, chapters) {
  const t = words[language];
  const glossary = way(folderOf(language, 'guide'), folderOf(language, 'glossary'));
  const text = (/** @type {Words} */ words) => prose(words[language], language, glossary);
  const parts = general.map(({ heading, lines }) => `<section><h2>${text(heading)}</h2>${list(lines.map(text))}</section>`);
  const plans = across.map((plan) => planTable(plan, language, text));
  const own = chapters.map((chapter) => guideOf(site, language, chapter, text));
  const lead = general[0]?.lead?.[language] ?? '';
  const body = `<article class="guide"><header><h1>${t.guide}</h1><p class="idea">${lead}</p></header>${parts.join('')}<section id="plans"><h2>${text(heads.across)}</h2>${plans.join('')}</section>${own.join('')}</article>`;
  return pageFile(site, language, { place: 'guide', title: t.guide, description: lead, body });
}

/**
 * A plan as a table; a step that names a chapter has a link to it.
 * @param {{ minutes: number, steps: [string, Words, string?][] }} plan
 * @param {Language} language
 * @param {(words: Words) => string} text
 */
function planTable({ minutes, steps }, language, text) {
  const rows = steps.map(([from, what, name]) => {
    const link = name ? ` <a class="back" href="../${name}/">${words[language].chapter(contents.findIndex((one) => one.name === name) + 1)}</a>` : '';
    return `<tr><th scope="row">${from}</th><td>${text(what)}${link}</td></tr>`;
  });
  return `<table class="plan"><caption>${minutes} ${text(heads.minutes)}</caption><tbody>${rows.join('')}</tbody></table>`;
}

/**
 * A chapter's part of the guide.
 * @param {Site} site
 * @param {Language} language
 * @param {Chapter} chapter
 * @param {(words: Words) => string} text
 */
function guideOf(site, language, { name, number, title, guide }, text) {
  const t = words[language];
  const plans = guide.plans.map((/** @type {any} */ plan) => planTable(plan, language, text));
  const asked = guide.questions.map((/** @type {any} */ { question, right, thoughts }) => {
    const wrong = thoughts.map((/** @type {any} */ [answer, thought]) => `<li><b>${text(answer)}</b> ${text(thought)}</li>`);
    return `<li><p class="question">${text(question)}</p><p>${text(right)}</p><ul>${wrong.join('')}</ul></li>`;
  });
  const states = guide.states.map((/** @type {any} */ { link, figure, values = {}, what }) => `<li><a href="../${name}/#${escaped(link ?? site.draw.state(figure, values))}">${text(what)}</a></li>`);
  return `<section id="${name}"><h2>${t.chapter(number)}: ${title[language]}</h2>
<p class="onward"><a href="../${name}/">${title[language]}</a><a href="../${name}/sheet/">${t.sheet}</a></p>
<h3>${text(heads.aims)}</h3>${list(guide.aims.map(text))}
<h3>${text(heads.before)}</h3>${list(guide.before.map(text))}
<h3>${text(heads.plans)}</h3>${plans.join('')}
<h3>${text(heads.questions)}</h3><ol class="questions">${asked.join('')}</ol>
<h3>${text(heads.wrong)}</h3>${list(guide.wrong.map(text))}
<h3>${text(heads.states)}</h3><ul>${states.join('')}</ul></section>`;
}

/** @param {Site} site @param {Language} language @param {Chapter} chapter */
export function sheetPage(site, language, chapter) {
  const t = words[language];
  const place = `${chapter.name}/sheet`;
  const glossary = way(folderOf(language, place), folderOf(language, 'glossary'));
  const text = (/** @type {Words} */ words) => prose(words[language].replace(/\[\[[\w-]+\|([^\]]+)\]\]/g, '$1').replace(/\[\[([\w-]+)\]\]/g, '$1'), language, glossary);
  const lines = (/** @type {number} */ count) => '<span class="line"></span>'.repeat(count);
  const asked = chapter.blocks.filter(({ key, kind }) => key && kind !== 'exercise');
  /** Figures whose picture is on the sheet. @type {Set<string>} */
  const pictured = new Set();
  const parts = asked.map(({ key = '', heading, text: words, ask, answers = [], blanks = [], figure = '', tells = false }, at) => {
    const boxes = answers.map(({ value, text: answer }) => `<li><span class="box" aria-hidden="true"></span>${value}. ${text(answer)}</li>`);
    const guess = boxes.length ? `<ul class="boxes">${boxes.join('')}</ul>` : `<p class="fill">${blanks.map((words) => `${text(words)} <span class="blank"></span>`).join(' ')}</p>`;
    // The heading and the text of a wrong idea tell its answer; its question is a sentence of its own.
    const [title, more] = ask ? [undefined, ask] : [heading, words];
    // A picture of something else is left out, and one that tells the answer to the question before.
    const hasPicture = !tells && !pictured.has(figure) && site.draw.answers(figure, key, language).length > 0;
    if (hasPicture) pictured.add(figure);
    const picture = hasPicture ? `<div class="picture">${site.draw.figure(figure, language)}</div>` : '';
    return `<section class="asked"><h2><span>${t.order[0]} ${at + 1}</span> ${title ? text(title) : ''}</h2>${more ? `<p>${text(more)}</p>` : ''}
<div class="guess">${picture}<div><h3>${t.order[1]}</h3>${guess}</div></div><div class="reasons"><div><h3>${t.order[2]}</h3>${lines(3)}</div><div><h3>${t.order[3]}</h3>${lines(3)}</div></div></section>`;
  });
  const body = `<article class="sheet"><header><p class="over">${t.chapter(chapter.number)}</p><h1>${chapter.title[language]}</h1><p class="fill">${t.name} <span class="blank"></span> ${t.date} <span class="blank"></span></p></header>${parts.join('')}</article>`;
  return pageFile(site, language, { place, title: `${t.sheet}: ${chapter.title[language]}`, description: chapter.description[language], body, kind: 'of-sheet' });
}
