// The pages of the chapters as they were built: both languages have the same parts, links lead somewhere, and the
// numbers in texts are the engine's.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { selectAll, selectOne } from 'css-select';
import { DomUtils, parseDocument } from 'htmlparser2';
import { moduleIn } from '../../scripts/lib/headless.mjs';
import { filesOf } from '../../scripts/lib/offline.mjs';
import { chapters as made, contents } from '../../www/learn/chapters/contents.mjs';
import { differences } from '../../www/learn/chapters/papers.mjs';
import { plans as across } from '../../www/learn/chapters/plans.mjs';
import { terms } from '../../www/learn/chapters/terms.mjs';
import { figuresCode } from '../common/figures.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const site = join(root, 'dist');
const files = filesOf(site);

const pages = files.filter((path) => path.startsWith('learn/') && path.endsWith('.html'));
const chapters = made.map(({ name }) => name);
const languages = ['en', 'ja'];

const source = (path) => readFileSync(join(site, path), 'utf8');
const parsed = new Map();
const read = (path) => parsed.get(path) ?? parsed.set(path, parseDocument(source(path))).get(path);
const chapter = (name, language) => read(`learn/${language === 'ja' ? 'ja/' : ''}${name}/index.html`);

/** The words of a page as people read them, without formulas, drawings, handles, and numbers that the run decides. */
function textOf(node) {
  if (node.type === 'text') return node.data;
  const { class: kind = '' } = node.attribs ?? {};
  if (['math', 'svg', 'script', 'style'].includes(node.name) || /figure-(tools|told)/.test(kind)) return ' ';
  return (node.children ?? []).map(textOf).join(node.name === 'span' || node.name === 'a' ? '' : ' ');
}

const words = (node) => textOf(node).match(/[\p{L}\d]+(?:[.’'-][\p{L}\d]+)*/gu) ?? [];
const keys = (page, selector, name) => selectAll(selector, page).map((element) => element.attribs[name]);

test('each page is there in both languages', () => {
  for (const place of ['', 'glossary/', 'guide/', 'papers/', ...chapters.flatMap((name) => [`${name}/`, `${name}/sheet/`])]) {
    for (const language of languages) {
      const path = `learn/${language === 'ja' ? 'ja/' : ''}${place}index.html`;
      assert.ok(pages.includes(path), path);
      assert.equal(selectOne('html', read(path)).attribs.lang, language);
    }
  }
  assert.equal(pages.length, 2 * (4 + 2 * chapters.length));
});

test('the contents have fourteen chapters, and links to those that are there', () => {
  for (const path of ['learn/index.html', 'learn/ja/index.html']) {
    const rows = selectAll('.contents > li', read(path));
    assert.equal(rows.length, 14);
    assert.deepEqual(rows.map((row) => selectOne('a', row)?.attribs.href ?? ''), contents.map(({ name }) => (name ? `${name}/` : '')));
  }
});

for (const name of chapters) {
  test(`${name}: at most 900 English words`, () => {
    const count = words(selectOne('article', chapter(name, 'en'))).length;
    assert.ok(count > 400 && count <= 900, `${count} words`);
  });

  test(`${name}: both languages have the same figures, questions, answers, terms and equations`, () => {
    const [en, ja] = languages.map((language) => chapter(name, language));
    const parts = [
      ['figure', 'data-figure'],
      ['.ask', 'data-ask'],
      ['.ask input', 'value'],
      ['.ask-seen', 'data-seen'],
      ['[data-reply]', 'data-reply'],
      ['.equation', 'id'],
      ['.into-studio', 'data-figure'],
      ['math [data-symbol]', 'data-symbol'],
    ];
    for (const [selector, attribute] of parts) {
      const own = keys(en, selector, attribute);
      assert.ok(own.length > 0, selector);
      // The two languages may have their symbols in different orders.
      assert.deepEqual(keys(ja, selector, attribute).sort(), own.sort(), selector);
    }
    const links = (page) => keys(page, 'a.term', 'href').map((href) => href.split('#')[1]).sort();
    assert.deepEqual(links(ja), links(en));
    assert.doesNotMatch(textOf(selectOne('article', ja)), /\$|\[\[|undefined/);
    assert.doesNotMatch(textOf(selectOne('article', en)), /\$|\[\[|undefined|[ぁ-ん]/);
  });

  // Chapters in which some symbols belong to the whole calculation are left out.
  if (['mesh', 'which-way', 'how-many'].includes(name))
    test(`${name}: each symbol of an equation is in a figure`, () => {
      const page = chapter(name, 'en');
      const shown = keys(page, '.figure-stage [data-symbol]', 'data-symbol');
      const symbols = keys(page, '.equation [data-symbol]', 'data-symbol');
      assert.ok(symbols.length > 2);
      assert.deepEqual(symbols.filter((symbol) => !shown.includes(symbol)), []);
    });

  test(`${name}: the exercise comes last, then ours and theirs in two lines, then the studio with the exercise's state`, () => {
    for (const language of languages) {
      const page = chapter(name, language);
      const [exercise, ours] = selectAll('.scene', page).slice(-2);
      assert.deepEqual([exercise.attribs['data-kind'], ours.attribs['data-kind']], ['exercise', 'ours']);
      const [studio, ...others] = selectAll('.into-studio', page);
      assert.equal(others.length, 0);
      assert.equal(studio.attribs['data-figure'], selectOne('figure', exercise).attribs['data-figure']);
      // Two lines, the link to the papers, the link into the studio.
      const lines = selectAll('p', ours);
      assert.equal(lines.length, 4);
      assert.equal(studio.parent, lines.at(-1));
    }
  });

  test(`${name}: no figure stands still before its lines are drawn`, () => {
    for (const language of languages) assert.equal(selectAll('.to-come', chapter(name, language)).length, 0);
  });

  test(`${name}: each question has the picture that shows its answer, and a place for what happened`, () => {
    const page = chapter(name, 'en');
    for (const ask of selectAll('.ask', page)) {
      assert.ok(selectOne(`#fig-${ask.attribs['data-of']}`, page), ask.attribs['data-ask']);
      // A question that the figure does not answer has its replies in the text.
      const isSeen = selectOne(`[data-seen=${ask.attribs['data-ask']}]`, page);
      assert.ok(isSeen || selectAll('[data-reply]', ask.parent).length === selectAll('label', ask).length, ask.attribs['data-ask']);
      const answers = selectAll('label', ask);
      assert.ok(answers.length >= 2 && answers.length <= 4);
    }
    for (const figure of selectAll('figure', page)) {
      assert.ok(selectOne('.figure-stage svg', figure), figure.attribs.id);
      assert.ok(words(selectOne('figcaption', figure)).length > 5, figure.attribs.id);
    }
    // The first figure stands beside the first question, and so before any equation.
    const [first] = selectAll('.scene', page);
    assert.ok(selectOne('.beside .ask', first) && selectOne('.beside figure', first));
    const html = DomUtils.getOuterHTML(page);
    assert.ok(html.indexOf('<figure') < html.indexOf('class="equation"'));
  });

  test(`${name}: every term of the glossary is linked from its first use`, () => {
    for (const language of languages) {
      const page = chapter(name, language);
      const own = terms.filter((term) => term.chapter === name);
      assert.deepEqual(keys(page, 'a.term', 'href').map((href) => href.split('#')[1]).sort(), own.map(({ key }) => key).sort());
      if (language === 'ja') continue;
      // Answers and headings have no links; texts and captions do.
      const prose = selectAll('section > p, section > * > p, legend, figcaption', page);
      for (const { key, name: names } of own) {
        const word = names.en.replace(/ \(.*/, '');
        const first = prose.find((part) => new RegExp(`\\b${word}s?\\b`, 'i').test(textOf(part)));
        if (first) assert.ok(selectOne(`a.term[href$="#${key}"]`, first), `${key} is used before its link`);
      }
    }
  });
}

test('the glossary has each term once, with a picture and its name in the other language', () => {
  for (const path of ['learn/glossary/index.html', 'learn/ja/glossary/index.html']) {
    const page = read(path);
    const entries = selectAll('.entry', page);
    assert.deepEqual(entries.map(({ attribs }) => attribs.id), terms.map(({ key }) => key));
    for (const entry of entries) {
      assert.ok(selectOne('svg path, svg circle', entry), entry.attribs.id);
      assert.notEqual(textOf(selectOne('.other', entry)).trim(), '');
      if (terms.find(({ key }) => key === entry.attribs.id).symbol) assert.ok(selectOne('math', entry), entry.attribs.id);
    }
  }
});

test('every formula has speech in the page’s language', () => {
  for (const path of pages) {
    const isJapanese = path.startsWith('learn/ja/');
    for (const formula of selectAll('math', read(path))) {
      const speech = formula.attribs['aria-label'] ?? '';
      assert.notEqual(speech.trim(), '', path);
      if (formula.attribs.display === 'block') assert.equal(/[ァ-ン]/.test(speech), isJapanese, speech);
      assert.doesNotMatch(speech, /undefined|[<>{}]/);
    }
  }
});

test('links stay in the site, and lead to something', () => {
  for (const path of [...pages, 'index.html']) {
    for (const [, name, address] of source(path).matchAll(/ (href|src|data-first)="([^"]*)"/g)) {
      assert.doesNotMatch(address, /^(\w+:|\/)/, `${path}: ${address}`);
      const [plain, fragment = ''] = address.split('#');
      const target = plain === '' ? path : posix.join(posix.dirname(path), plain);
      const file = plain === '' || !/(^|\/)$|\.\.$/.test(target) ? target : posix.join(target, 'index.html');
      const found = file === './index.html' ? 'index.html' : file;
      assert.ok(files.includes(found), `${path}: ${name} ${address} is no file`);
      // A fragment is a place in the page, or the words of a state.
      if (fragment && !fragment.includes('=')) assert.ok(selectOne(`[id="${fragment}"]`, read(found)), `${path}: ${address}`);
    }
  }
});

test('the policy allows the page’s own scripts alone', () => {
  for (const path of pages) {
    const page = read(path);
    const policy = selectOne('meta[http-equiv]', page).attribs.content;
    const inside = selectAll('script', page).filter(({ attribs }) => !attribs.src);
    assert.equal(inside.length, 1);
    const digest = createHash('sha256').update(DomUtils.textContent(inside[0])).digest('base64');
    assert.ok(policy.includes(`'sha256-${digest}'`), path);
    assert.doesNotMatch(source(path), / (style|on\w+)="/, path);
  }
});

test('the numbers in the texts are the engine’s', async () => {
  const { bubbleCurve } = await moduleIn(join(root, 'pkg'));
  const [force, potential] = [0, 1].map((column) => (w) => bubbleCurve(w)[column]);
  assert.equal(force(0), 9 / 8);
  assert.equal((-force(19 / 15)).toFixed(3), '0.145');
  // An eighth of the strongest push.
  assert.equal(Math.round(force(0) / -force(19 / 15)), 8);
  assert.equal((-potential(1)).toFixed(3), '0.048');
  assert.ok(potential(0.7175) > 0 && potential(0.7185) < 0);
  for (const language of languages) {
    const text = DomUtils.textContent(selectOne('article', chapter('two-bubbles', language)));
    for (const number of ['9/8', '0.145', '0.048', '0.718', '19/15']) assert.ok(text.includes(number), `${language}: ${number}`);
  }
});

test('the numbers of the landscape and of both outlines are the engine’s', async () => {
  const { Bubblestone } = await moduleIn(join(root, 'pkg'));
  const studio = new Bubblestone('outline=square&size=128&kind=square&cs=32&dir=constant&edge=open&pop=off&fend=0&mend=0');
  const energy = (x, y) => {
    studio.set('given', `0.5,0.5,1;${0.5 + x / 4},${0.5 + y / 4},0`);
    studio.hold(0);
    while (['domain', 'fields'].includes(studio.stage())) studio.tick(10, 0);
    while (!studio.reach(10));
    return studio.energyParts()[0];
  };
  const ways = Array.from({ length: 81 }, (_, k) => 0.9 + k / 200);
  const lowest = (at) => ways.map((w) => [at(w), w]).reduce((least, one) => (one[0] < least[0] ? one : least));
  for (const [weight, depth, barrier] of [['0', '0.048', '0.000'], ['0.05', '0.052', '0.009'], [String(Math.SQRT2 - 1), '0.076', '0.046']]) {
    studio.set('cw', weight);
    const [[well, w], [pass]] = [lowest((far) => energy(far, 0)), lowest((far) => energy(far * Math.SQRT1_2, far * Math.SQRT1_2))];
    assert.deepEqual([(-well).toFixed(3), w.toFixed(2), (pass - well).toFixed(3)], [depth, '1.00', barrier], weight);
  }
  studio.free();
  const counts = readFileSync(join(root, 'tests/learn.txt'), 'utf8').match(/^count rest \S+ [0-9a-f]{16} (\d+) .* [0-9a-f]{16} (\d+) /m);
  assert.deepEqual(counts?.slice(1), ['13', '19']);
  const round = (Math.sqrt(3) / 2).toFixed(2);
  for (const language of languages) {
    const [square, many] = ['squares', 'how-many'].map((name) => DomUtils.textContent(selectOne('article', chapter(name, language))));
    for (const number of ['0.048', '0.076', '0.009', '0.046']) assert.ok(square.includes(number), `${language}: ${number}`);
    for (const number of ['13', '19', round]) assert.ok(many.includes(number), `${language}: ${number}`);
  }
});

/** The engine at a recipe's first step, or at another one, with its cells joined. */
function joinedAt({ Bubblestone }, recipe, step = 0) {
  const studio = new Bubblestone(recipe);
  while (['domain', 'fields'].includes(studio.stage())) studio.tick(10, 0);
  studio.hold(step);
  while (!studio.reach(10));
  while (!studio.joinCells(10));
  return studio;
}

/** Delaunay's triangles: the smallest angle, the shortest side, the radius. */
function trianglesOf(studio) {
  const numbers = studio.joined('triangles');
  return Array.from({ length: numbers.length / 10 }, (_, k) => [Math.min(...numbers.slice(10 * k + 3, 10 * k + 6)), numbers[10 * k + 6], numbers[10 * k + 9]]);
}

const hasNumbers = (name, numbers) => {
  for (const language of languages) {
    const text = DomUtils.textContent(selectOne('article', chapter(name, language)));
    for (const number of numbers) assert.ok(text.includes(number), `${name}, ${language}: ${number}`);
  }
};

test('the numbers of meshes are the engine’s', async () => {
  const module = await moduleIn(join(root, 'pkg'));
  const { FIGURES } = await figuresCode();
  const recipeOf = (name) => FIGURES.find((figure) => figure.name === name).recipe;
  // Cells across the diagonal of a square act on each other; those behind the neighbours in a honeycomb do not.
  assert.ok(module.bubbleCurve(Math.SQRT2)[0] !== 0 && module.bubbleCurve(Math.sqrt(3))[0] === 0);
  const least = ['close', 'place'].map((name) => {
    const triangles = trianglesOf(joinedAt(module, recipeOf(name)));
    for (const [angle, shortest, radius] of triangles) assert.ok(Math.abs(Math.sin((angle * Math.PI) / 180) - shortest / (2 * radius)) < 1e-12);
    return Math.min(...triangles.map(([angle]) => angle));
  });
  assert.ok(least[0] >= 44 && least[0] < 45 && Math.round(least[1]) === 8, String(least));
  // The shortest side is the radius at 30°; in a honeycomb the angle is 60°.
  const [[even, side, radius]] = trianglesOf(joinedAt(module, 'outline=square&size=256&kind=circle&cs=64&edge=open&pop=off&given=0.3,0.4,0;0.7,0.4,0;0.5,0.7464,0'));
  assert.deepEqual([even.toFixed(1), (radius / side).toFixed(2)], ['60.0', '0.58']);
  const three = recipeOf('three').replace('rounds=4', 'rounds=20');
  const middles = [[three, 0], [`${three}&cells=lloyd`, 0], [three, 200]].map(([recipe, step]) => Math.round(joinedAt(module, recipe, step).joined('angles')[0]));
  assert.deepEqual(middles, [32, 48, 56]);
  hasNumbers('mesh', ['1.41', '1.73', '1.5', '180°', '30°', '60°', '0.58', '44°', '8°']);
  const { en, ja } = made.find(({ name }) => name === 'mesh').guide.questions[1].right;
  for (const middle of middles) assert.ok(en.includes(`${middle}°`) && ja.includes(`${middle}°`), `${middle}`);
});

/** The engine with the fields of a recipe, and places in shares of its side. */
function fieldsOf({ Bubblestone }, recipe) {
  const studio = new Bubblestone(recipe);
  while (['domain', 'fields'].includes(studio.stage())) studio.tick(10, 0);
  const side = studio.side();
  return {
    printed: (x, y) => studio.segmentTerms(x * side, y * side)[2],
    /** The direction of squares, from -45 to 45 degrees. */
    direction: (x, y) => {
      const [along, across] = studio.directionAt(x * side, y * side);
      const degrees = (Math.atan2(across, along) * 180) / Math.PI;
      return degrees - 90 * Math.round(degrees / 90);
    },
    /** Quarter turns on a walk round a place. */
    quarters: (x, y, radius) => {
      const places = Array.from({ length: 72 }, (_, k) => (k * Math.PI) / 36).flatMap((angle) => [side * (x + radius * Math.cos(angle)), side * (y + radius * Math.sin(angle))]);
      return Math.round(4 * (studio.directionsAlong(Float64Array.from(places)).at(-1) ?? NaN)) + 0;
    },
  };
}

test('the numbers of directions are the engine’s', async () => {
  const module = await moduleIn(join(root, 'pkg'));
  const { FIGURES } = await figuresCode();
  const of = (name) => fieldsOf(module, FIGURES.find((figure) => figure.name === name).recipe);
  const road = of('road');
  for (let x = 0.275; x <= 0.7251; x += 0.025) assert.ok(road.printed(x, 0.5) < 0.02, `${x}`);
  const [disc, square, ring, fork] = [of('walk'), fieldsOf(module, 'outline=square&size=256&kind=square'), fieldsOf(module, 'size=256&kind=square'), of('fork')];
  assert.deepEqual([disc.quarters(0.5, 0.5, 0.3), disc.quarters(0.7, 0.5, 0.1), square.quarters(0.5, 0.5, 0.2)], [4, 0, 0]);
  assert.deepEqual([ring.quarters(0.5, 0.5, 0.35), ring.quarters(0.5, 0.15, 0.05)], [4, 0]);
  assert.deepEqual([fork.quarters(0.5, 0.43, 0.1), fork.quarters(0.5, 0.72, 0.08)], [4 - 6, 0]);
  const { recipe, handles } = FIGURES.find(({ name }) => name === 'halfway');
  const halfway = (...angles) => {
    const [, text] = recipe.match(/strokes=([^&]*)/);
    const points = (words) => words.split(/[;,]/).map(Number).reduce((pairs, number, k) => (k % 2 ? [...pairs.slice(0, -1), [pairs.at(-1)[0], number]] : [...pairs, [number]]), []);
    const strokes = angles.reduce((words, angle, k) => handles[k].listed.write(angle, points(words)).strokes, text);
    return fieldsOf(module, recipe.replace(text, strokes)).direction(0.5, 0.5);
  };
  assert.equal(Math.round(halfway(10, 30)), 20);
  assert.equal(halfway(10, 80).toFixed(6).replace('-', ''), '0.000000');
  hasNumbers('which-way', ['10°', '80°', '45°', '0°', '20°', '30°', '90°']);
  const { questions } = made.find(({ name }) => name === 'which-way').guide;
  for (const language of languages) assert.ok(questions[1].right[language].includes('2') && questions[4].thoughts[0][1][language].includes(`${45 - 10}°`));
});

/** Checks that there are plans of three lengths, and that their steps leave no gap. */
function fillTheirTime(plans) {
  assert.deepEqual(plans.map(({ minutes }) => minutes), [20, 60, 180]);
  for (const { minutes, steps } of plans) {
    const times = steps.map(([time]) => time.split('–').map(Number));
    assert.equal(times[0][0], 0);
    assert.equal(times.at(-1)[1], minutes);
    times.slice(1).forEach(([from], k) => assert.equal(from, times[k][1]));
  }
}

test('the guide has plans over several chapters, which begin with free play and lead there', () => {
  fillTheirTime(across);
  for (const [path, play] of [['learn/guide/index.html', /^Free play/], ['learn/ja/guide/index.html', /自由に遊ぶ/]]) {
    const tables = selectAll('#plans .plan', read(path));
    assert.equal(tables.length, across.length);
    for (const table of tables) {
      assert.match(textOf(selectOne('td', table)).trim(), play);
      const names = keys(table, 'a', 'href').map((href) => href.split('/')[1]);
      assert.ok(new Set(names).size > 3 && names.every((name) => chapters.includes(name)), String(names));
    }
  }
});

for (const { name, guide } of made) {
  test(`${name}: the guide has plans that fill their time, and a thought behind each wrong answer`, () => {
    const { plans, questions, states } = guide;
    fillTheirTime(plans);
    const page = chapter(name, 'en');
    const asked = selectAll('.ask', page);
    assert.equal(questions.length, asked.length + selectAll('.marking', page).length, 'a mark on a curve is a question, too');
    const ofLetters = questions.filter(({ right }) => /^[a-d]\./.test(right.en));
    assert.deepEqual(ofLetters.map(({ thoughts }) => thoughts.length + 1), asked.map((ask) => selectAll('label', ask).length));
    // The letter that is right in the guide is right in the chapter, too.
    const rights = made.find((one) => one.name === name).blocks.flatMap(({ answers = [] }) => answers.filter(({ right }) => right).map(({ value }) => value));
    assert.deepEqual(ofLetters.map(({ right }) => right.en[0]), rights);
    assert.deepEqual(ofLetters.map(({ right }) => right.ja[0]), rights);
    const figures = keys(page, 'figure', 'data-figure');
    assert.ok(states.length > 3);
    const links = selectAll(`#${name} li a[href*="#fig="]`, read('learn/guide/index.html')).map(({ attribs }) => attribs.href);
    assert.equal(links.length, states.length);
    for (const link of links) assert.ok(link.startsWith(`../${name}/#`) && figures.includes(new URLSearchParams(link.split('#')[1]).get('fig')), link);
  });
}

test('printed equations stand beside ours, and each is seen in a figure that is there, or in the studio', () => {
  for (const [path, isJapanese] of [['learn/papers/index.html', false], ['learn/ja/papers/index.html', true]]) {
    const page = read(path);
    const rows = selectAll('.difference', page);
    const there = differences.filter(({ chapter: name }) => !name || chapters.includes(name));
    assert.deepEqual(rows.map(({ attribs }) => attribs.id), there.map(({ key }) => key));
    for (const [k, row] of rows.entries()) {
      assert.equal(selectAll('.side', row).length, 2);
      assert.equal(selectAll('.misprint', row).length, Number(Boolean(there[k].isMisprint)));
      // A misprint has an exercise with its answer.
      assert.equal(selectAll('.task', row).length, Number(Boolean(there[k].isMisprint)), there[k].key);
      const { href } = selectOne('.see a', row).attribs;
      const figure = new URLSearchParams(href.split('#')[1]).get('fig');
      if (figure) assert.ok(selectOne(`#fig-${figure}`, chapter(there[k].chapter, isJapanese ? 'ja' : 'en')), href);
      else assert.match(href, /^(\.\.\/)+#v=1&/);
    }
  }
  for (const { name } of made) assert.ok(differences.some(({ chapter: own }) => own === name), `${name} has no difference`);
});
