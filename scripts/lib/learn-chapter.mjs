// A chapter's page.
import { contents } from '../../www/learn/chapters/contents.mjs';
import { differences } from '../../www/learn/chapters/papers.mjs';
import { words } from '../../www/learn/chapters/words.mjs';
import { escaped, folderOf, pageFile, prose, way } from './learn-frame.mjs';

/** @typedef {import('./learn-frame.mjs').Site} Site */
/** @typedef {import('./learn-frame.mjs').Language} Language */
/** @typedef {import('./learn-frame.mjs').Words} Words */
/** @typedef {{ value: string, text: Words, reply?: Words, right?: boolean }} Answer */
/** @typedef {{ equation: string, math: string, speech: Words }} Equation */
/**
 * A part of a chapter.
 * @typedef {object} Block
 * @property {string} kind
 * @property {Words} [heading]
 * @property {Words} [text]
 * @property {Words} [ask] the question, where the text is no question
 * @property {Words} [caption]
 * @property {string} [figure]
 * @property {string} [key] of its question
 * @property {Answer[]} [answers]
 * @property {boolean} [tells] whether its figure shows the answer to the question before, so that it is not on the sheet
 * @property {Words[]} [blanks] of the sheet, where there are no answers to choose
 * @property {(Words | Equation)[]} [parts]
 * @property {Words[]} [lines]
 */
/** @typedef {{ name: string, number: number, title: Words, idea: Words, description: Words, blocks: Block[], sources: Words, guide: any }} Chapter */

/** Writes the blocks of one chapter in one language. */
class Writer {
  /** @param {Site} site @param {Language} language @param {Chapter} chapter */
  constructor(site, language, chapter) {
    this.site = site;
    this.language = language;
    this.chapter = chapter;
    this.t = words[language];
    this.folder = folderOf(language, chapter.name);
    this.glossary = way(this.folder, folderOf(language, 'glossary'));
    this.figures = 0;
  }

  /** @param {Words} [text] */
  prose(text) {
    return text ? prose(text[this.language], this.language, this.glossary) : '';
  }

  /** @param {Words} [text] */
  paragraph(text, kind = '') {
    return text ? `<p${kind && ` class="${kind}"`}>${this.prose(text)}</p>` : '';
  }

  /** @param {Block} block */
  heading({ heading, kind, figure }) {
    return heading ? `<h2 id="${kind === 'figure' ? figure : kind}">${this.prose(heading)}</h2>` : '';
  }

  /** @param {Block} block */
  figure({ figure = '', caption }) {
    this.figures += 1;
    const number = `<b>${this.t.figure} ${this.figures}.</b> `;
    const still = this.site.draw.figure(figure, this.language);
    return `<figure class="figure" id="fig-${figure}" data-figure="${figure}"><div class="figure-stage">${still}</div><figcaption>${number}${this.prose(caption)}</figcaption></figure>`;
  }

  /** The answers to a question, and the place of the sentence on what happened. @param {Block} block */
  ask({ key = '', figure = '', answers = [], text, ask = text }) {
    const rows = answers.map(({ value, text: words }) => `<label><input type="radio" name="${key}" value="${value}"><span class="letter" aria-hidden="true">${value}</span><span>${this.prose(words)}</span></label>`);
    const legend = `<legend>${this.prose(ask)}</legend>`;
    const replies = answers.flatMap(({ value, reply, right }) => (reply ? [`<li data-reply="${value}"${right ? ' data-right' : ''}><span class="letter" aria-hidden="true">${value}</span><span>${this.prose(reply)}</span></li>`] : []));
    const why = replies.length ? `<details class="answers"><summary>${this.t.answer}</summary><ul>${replies.join('')}</ul></details>` : '';
    return `<fieldset class="ask" data-ask="${key}" data-of="${figure}">${legend}<div class="choices">${rows.join('')}</div></fieldset>${this.seen(key, figure, replies.length > 0)}${why}`;
  }

  /**
   * The place of the sentence on what happened. Invisible copies of all texts that may come keep its room. A question
   * that the figure does not answer must have its replies in the text.
   */
  seen(key = '', figure = '', isReplied = false) {
    const answers = this.site.draw.answers(figure, key, this.language);
    if (!answers.length) {
      if (isReplied) return '';
      throw new Error(`${this.chapter.name}: the figure ${figure} has no question ${key}.`);
    }
    const room = (/** @type {string} */ text, kind = '') => (text ? `<span${kind} data-room="${escaped(text)}"></span>` : '');
    const rooms = answers.map(([prediction, sentence]) => `<p class="seen-room" aria-hidden="true">${room(prediction, ' class="expected"')}${room(sentence)}</p>`);
    return `<div class="seen-place" data-wait="${this.t.wait}"><p class="ask-seen" data-seen="${key}" hidden></p>${rooms.join('')}</div>`;
  }

  /** @param {Equation} equation */
  equation({ equation, math, speech }) {
    return `<div class="equation" id="eq-${equation}" role="group" aria-label="${this.t.equation} ${equation}" tabindex="0"><math display="block" aria-label="${escaped(speech[this.language])}">${math}</math><span class="number">(${equation})</span></div>`;
  }

  /** @param {Block[]} blocks */
  scene(blocks) {
    return `<section class="scene" data-kind="${blocks[0]?.kind}">${blocks.map((block) => this.block(block)).join('\n')}</section>`;
  }

  /** @param {Block} block @returns {string} */
  block(block) {
    const head = this.heading(block);
    switch (block.kind) {
      case 'question':
        return `<div class="beside"><div>${head}${this.ask(block)}</div>${this.figure(block)}</div>`;
      case 'figure':
        return `${head}${this.paragraph(block.text)}${this.figure(block)}`;
      case 'prediction':
        return `${head}${this.ask(block)}${this.figure(block)}`;
      case 'mark':
        return `${this.paragraph(block.text, 'marking')}${this.seen(block.key, block.figure)}`;
      case 'why':
        return `${head}${(block.parts ?? []).map((part) => ('math' in part ? this.equation(part) : this.paragraph(part))).join('\n')}`;
      case 'not-so':
        return `${head}${this.paragraph(block.text)}${this.ask(block)}${this.figure(block)}`;
      case 'exercise':
        return `${head}${this.paragraph(block.text)}${this.seen(block.key, block.figure)}${this.figure(block)}`;
      default:
        return `${head}${(block.lines ?? []).map((line) => this.paragraph(line)).join('')}${this.papers()}${this.studio()}`;
    }
  }

  /** The link to what the papers print, and how the program reads it. */
  papers() {
    const first = differences.find(({ chapter }) => chapter === this.chapter.name);
    const href = way(this.folder, folderOf(this.language, 'papers'));
    return first ? `<p><a href="${href}#${first.key}">${this.t.more}</a></p>` : '';
  }

  /** The link into the studio with the exercise's state. It ends the chapter, as it leads away from the text. */
  studio() {
    const { figure = '' } = this.chapter.blocks.find(({ kind }) => kind === 'exercise') ?? {};
    const href = `${way(this.folder, '')}#${escaped(this.site.draw.link(figure))}`;
    return `<p><a class="into-studio" data-figure="${figure}" href="${href}">${this.t.studio}</a></p>`;
  }

  /** Each figure with its questions is a scene, which fills the screen in a class. */
  scenes() {
    /** @type {Block[][]} */
    const scenes = [];
    for (const block of this.chapter.blocks) {
      if (block.kind === 'mark') scenes.at(-1)?.push(block);
      else scenes.push([block]);
    }
    return scenes.map((blocks) => this.scene(blocks)).join('\n');
  }
}

/** @param {Site} site @param {Language} language @param {Chapter} chapter */
export function chapterPage(site, language, chapter) {
  const writer = new Writer(site, language, chapter);
  const { t } = writer;
  const to = (/** @type {string} */ place) => way(writer.folder, folderOf(language, place));
  const neighbours = [neighbour(t.previous, contents[chapter.number - 2], language, to), neighbour(t.next, contents[chapter.number], language, to)];
  const body = `<article class="chapter">
<header><p class="over">${t.chapter(chapter.number)}</p><h1>${chapter.title[language]}</h1><p class="idea">${writer.prose(chapter.idea)}</p></header>
${writer.scenes()}
<footer><p class="sources">${t.sources}: ${escaped(chapter.sources[language])}</p>
<p class="onward"><a href="${to(`${chapter.name}/sheet`)}">${t.sheet}</a><a href="${to('guide')}#${chapter.name}">${t.guide}</a>${neighbours.join('')}</p></footer>
</article>`;
  return pageFile(site, language, { place: chapter.name, title: chapter.title[language], description: chapter.description[language], body, kind: 'of-chapter' });
}

/**
 * The link to the previous or the next chapter.
 * @param {string} word
 * @param {import('../../www/learn/chapters/contents.mjs').Row | undefined} row
 * @param {Language} language
 * @param {(place: string) => string} to
 */
function neighbour(word, row, language, to) {
  if (!row) return '';
  const { name, title } = row;
  return name ? `<a href="${to(name)}">${word}: ${title[language]}</a>` : `<span>${word}: ${title[language]} (${words[language].coming})</span>`;
}
