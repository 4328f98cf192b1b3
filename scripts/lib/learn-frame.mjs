// The frame of every page of the chapters: head, policy, links between the languages, foot. And the markup of the
// texts.
import { words } from '../../www/learn/chapters/words.mjs';
import { inLine } from '../../www/learn/chapters/math.mjs';

/** @typedef {'en' | 'ja'} Language */
/** @typedef {{ en: string, ja: string }} Words */
/**
 * Parts of the site that pages refer to.
 * @typedef {object} Site
 * @property {string} module the module's address in the site
 * @property {{ code: string, digest: string }} start
 * @property {string} script
 * @property {string[]} styles
 * @property {{ figure: (name: string, language: Language) => string, link: (name: string) => string, state: (name: string, values: Record<string, string>) => string, answers: (figure: string, key: string, language: Language) => [prediction: string, sentence: string][], term: (key: string) => string }} draw
 */

/** @param {string} text */
export const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

/** The folder of a page in a language: '' is the contents. @param {Language} language @param {string} place such as 'two-bubbles' */
export const folderOf = (language, place) => `learn/${language === 'ja' ? 'ja/' : ''}${place ? `${place}/` : ''}`;

/** The relative address from a page's folder to another place of the site. @param {string} from @param {string} to */
export const way = (from, to) => {
  const up = '../'.repeat(from.split('/').length - 1);
  return `${up}${to}`;
};

/**
 * A text's HTML: `[[term|words]]` becomes a link to the glossary, `$w = 1$` a formula, which no end of a line parts from its brackets and stops.
 * @param {string} text
 * @param {Language} language
 * @param {string} glossary the way to the glossary
 */
export function prose(text, language, glossary) {
  return escaped(text)
    .replace(/\[\[([\w-]+)(?:\|([^\]]+))?\]\]/g, (_, /** @type {string} */ term, /** @type {string} */ shown = term) => `<a class="term" href="${glossary}#${term}">${shown}</a>`)
    .replace(/([(（]?)\$([^$]+)\$([)）]?[,.:;、。]?)/g, (_, /** @type {string} */ bracket, /** @type {string} */ formula, /** @type {string} */ mark) => `<span class="formula">${bracket}${inLine(formula.replaceAll('&lt;', '<'), language)}${mark}</span>`);
}

const policy = (/** @type {string} */ digest) =>
  `default-src 'none'; script-src 'self' 'wasm-unsafe-eval' 'sha256-${digest}'; style-src 'self'; img-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'`;

const mark = '<svg class="mark" viewBox="0 0 24 24" aria-hidden="true"><path d="M3.2 4.9 10.6 3l1 8-8.9.9zM13.4 3l7.4 1.5.6 7.3-8.3-.7zM2.8 13.5l8.7-.8.7 8.3-8.6-.6zM13.2 12.7l8.2.8-1.2 7.2-6.6.4z"/></svg>';
const moon = '<svg viewBox="0 0 20 20" aria-hidden="true"><path fill-rule="evenodd" d="M10 2a8 8 0 1 1 0 16 8 8 0 0 1 0-16zm0 1.7v12.6a6.3 6.3 0 0 0 0-12.6z"/></svg>';

/**
 * A page of the chapters as a file of the site.
 * @param {Site} site
 * @param {Language} language
 * @param {object} page
 * @param {string} page.place its folder below that of the language
 * @param {string} page.title
 * @param {string} page.description
 * @param {string} page.body
 * @param {string} [page.kind] a class of the page
 */
export function pageFile(site, language, { place, title, description, body, kind = '' }) {
  const own = folderOf(language, place);
  const other = language === 'en' ? 'ja' : 'en';
  const t = words[language];
  const to = (/** @type {string} */ path) => way(own, path);
  const link = (/** @type {string} */ to, /** @type {string} */ text, now = false) => `<a href="${to}"${now ? ' aria-current="page"' : ''}>${text}</a>`;
  const places = [['', t.contents], ['glossary', t.glossary], ['guide', t.guide]].map(([name = '', text = '']) => link(to(folderOf(language, name)), text, name === place));
  const full = place ? `${title} · ${t.learn} · Bubblestone` : `${title} · Bubblestone`;
  const source = `<!doctype html>
<html lang="${language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${policy(site.start.digest)}">
<meta name="referrer" content="no-referrer">
<meta name="color-scheme" content="light dark">
<meta name="theme-color" content="#eae5dc" media="(prefers-color-scheme: light)" data-theme="light">
<meta name="theme-color" content="#191715" media="(prefers-color-scheme: dark)" data-theme="dark">
<script data-first="${to(site.module)}">${site.start.code}</script>
<title>${escaped(full)}</title>
<meta name="description" content="${escaped(description)}">
<meta property="og:type" content="article">
<meta property="og:title" content="${escaped(full)}">
<meta property="og:description" content="${escaped(description)}">
<link rel="icon" href="${to('favicon.svg')}" type="image/svg+xml">
<link rel="alternate" hreflang="${other}" href="${to(folderOf(other, place))}">
${site.styles.map((style) => `<link rel="stylesheet" href="${to(style)}">`).join('\n')}
<script type="module" src="${to(site.script)}"></script>
</head>
<body class="${kind}">
<a class="skip" href="#text">${t.skip}</a>
<header class="head">
<a class="home" href="${to('')}" aria-label="${t.home}">${mark}<span>Bubblestone</span></a>
<nav class="places" aria-label="${t.learn}">${places.join('')}</nav>
<div class="tools">
${kind === 'of-chapter' ? `<button type="button" class="quiet" id="class" aria-pressed="false" title="${t.toClassTitle}" hidden>${t.toClass}</button>` : ''}
<button type="button" class="quiet" id="print" hidden>${t.print}</button>
<a class="quiet" id="language" lang="${other}" hreflang="${other}" href="${to(folderOf(other, place))}">${t.language}</a>
<button type="button" class="quiet sign" id="theme" aria-pressed="false" aria-label="${t.theme}" hidden>${moon}</button>
</div>
</header>
<main id="text" tabindex="-1">
${body}
</main>
<footer class="foot"><p>${t.licence}</p><noscript><p>${t.bare}</p></noscript></footer>
</body>
</html>
`;
  return { fileName: `${own}index.html`, source };
}
