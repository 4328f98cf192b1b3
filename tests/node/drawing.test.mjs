// Drawings become outlines: the areas, the rings, and why a drawing is refused. How the page takes an outline is in
// browser/import.test.mjs. `npm test -- 'page in Node'`.
import assert from 'node:assert/strict';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import { runnerImport } from 'vite';

/** @type {(text: string, side: number, progress: (done: number) => void) => { rings: [number, number][][], left: object, coarse?: number }[]} */
let outlines;

before(async () => {
  ({ outlines } = (await runnerImport(fileURLToPath(new URL('../../www/editor/import/read.ts', import.meta.url)))).module);
});

/** The picture's side. */
const SIDE = 192;

/** A drawing of side 100. @param {string} inner */
const svg = (inner) => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${inner}</svg>`;

/** The first outline of a text. @param {string} text */
const read = (text) => outlines(text, SIDE, () => {})[0] ?? assert.fail('no outline');

/** The area inside some rings, in the units of a drawing of side 100. @param {[number, number][][]} rings */
function area(rings) {
  const of = (/** @type {[number, number][]} */ ring) => ring.reduce((sum, [x, y], k) => sum + (x * (ring[(k + 1) % ring.length]?.[1] ?? 0) - y * (ring[(k + 1) % ring.length]?.[0] ?? 0)) / 2, 0);
  return (100 / SIDE) ** 2 * rings.reduce((sum, ring) => sum + of(ring), 0);
}

/** Squares side by side. @param {number} count @param {number} width */
function squares(count, width) {
  const columns = Math.ceil(Math.sqrt(count));
  const step = 100 / columns;
  return svg(Array.from({ length: count }, (_, k) => `<rect x="${(k % columns) * step}" y="${Math.floor(k / columns) * step}" width="${width * step}" height="${width * step}"/>`).join(''));
}

const line = 'fill="none" stroke="currentColor" stroke-width="8"';
const bend = 'M20 80V20H80';

/** The name of each drawing, the drawing, its area, and the number of its rings. @type {[what: string, inner: string, expected: number, count: number][]} */
const DRAWINGS = [
  ['a stroke with butt ends', `<line x1="20" y1="50" x2="80" y2="50" stroke="#000" stroke-width="8"/>`, 480, 1],
  ['square ends', `<path d="M20 50H80" ${line} stroke-linecap="square"/>`, 544, 1],
  ['round ends', `<path d="M20 50H80" ${line} stroke-linecap="round"/>`, 480 + Math.PI * 16, 1],
  ['a mitre', `<path d="${bend}" ${line}/>`, 960, 1],
  ['a bevel', `<path d="${bend}" ${line} stroke-linejoin="bevel"/>`, 960 - 8, 1],
  ['a round join', `<path d="${bend}" ${line} stroke-linejoin="round"/>`, 960 - 16 + Math.PI * 4, 1],
  ['a circle', `<circle cx="50" cy="50" r="30" ${line}/>`, Math.PI * 2 * 30 * 8, 2],
  ['a width that is inherited, with a unit, and scaled', `<g stroke-width="3pt" stroke="red" transform="translate(10) scale(2)"><path d="M5 25H35" fill="none"/></g>`, 60 * 8, 1],
  ['dashes', `<path d="M10 50H90" ${line} stroke-dasharray="10 5"/>`, 8 * (5 * 10 + 5), 6],
  ['a filling with a stroke', `<rect x="20" y="20" width="60" height="60" stroke="#123" stroke-width="8"/>`, 68 * 68, 1],
  ['strokes that cross', `<path d="M20 50H80M50 20V80" ${line}/>`, 960 - 64, 1],
  ['shapes that overlap, one of them run the other way', '<path d="M10 10H60V60H10Z"/><path d="M40 40V90H90V40Z"/>', 2500 + 2500 - 400, 1],
  ['fill-rule: nonzero', '<path d="M10 10H90V90H10ZM30 30H70V70H30Z"/>', 6400, 1],
  ['fill-rule: evenodd', '<path fill-rule="evenodd" d="M10 10H90V90H10ZM30 30H70V70H30Z"/>', 4800, 2],
  ['white over black', '<path d="M10 10H90V90H10Z"/><circle cx="50" cy="50" r="20" fill="#fff"/>', 6400 - Math.PI * 400, 2],
  ['white alone', '<path d="M10 10H90V90H10Z" fill="white"/>', 6400, 1],
  ['a page of white paper', '<rect width="100%" height="100%" fill="#fefefe"/><path d="M10 10H90V50H10Z"/>', 3200, 1],
  ['a clip path in a clip path', '<clipPath id="a"><path d="M0 0H50V100H0Z"/></clipPath><clipPath id="b" clip-path="url(#a)"><path d="M0 0H100V50H0Z"/></clipPath><g clip-path="url(#b)"><path d="M10 10H90V90H10Z"/></g>', 1600, 1],
  ['a clip path in parts of the shape', '<clipPath id="a" clipPathUnits="objectBoundingBox"><path d="M0 0H.5V.5H0Z"/></clipPath><path clip-path="url(#a)" d="M10 10H90V90H10Z"/>', 1600, 1],
  ['a rule that hides', '<style>.a, #b { display: none } g > .c { visibility: hidden } .d { fill: none } .e { opacity: 0 }</style><g fill="red"><path class="a" d="M0 0H9V9Z"/><path id="b" d="M0 0H9V9Z"/><path class="c" d="M0 0H9V9Z"/></g><path class="d" d="M0 0H9V9Z"/><g class="e"><path d="M0 0H9V9Z"/></g><path d="M10 10H90V90H10Z"/>', 6400, 1],
  ['a rule that wins by its weight, and one that is important', '<style>#b { fill: red } .c { fill: none } path { fill: none !important }</style><rect id="b" class="c" x="10" y="10" width="80" height="80"/><path d="M0 0H9V9Z" style="fill: red"/>', 6400, 1],
  ['a rule for print', '<style>@media print { rect { display: none } } @media screen { path { display: none } }</style><path d="M0 0H9V9Z"/><rect x="10" y="10" width="80" height="80"/>', 6400, 1],
  ['what reaches over the rim', '<path d="M-50 10H150V50H-50Z"/>', 4000, 1],
];

test('a drawing becomes what is seen of it', () => {
  for (const [what, inner, expected, count] of DRAWINGS) {
    const { rings, left, coarse } = read(svg(inner));
    assert.deepEqual([left, coarse], [{}, undefined], what);
    const found = area(rings);
    assert.ok(Math.abs(found - expected) <= 0.005 * expected, `${what}: ${found} instead of ${expected}`);
    assert.equal(rings.length, count, what);
  }
});

test('the icons of a well-known set come as they are drawn', () => {
  const icon = (/** @type {string} */ inner) => `<svg xmlns="http://www.w3.org/2000/svg" width="24" height="24" viewBox="0 0 24 24" fill="none" stroke="currentColor" stroke-width="2" stroke-linecap="round" stroke-linejoin="round">${inner}</svg>`;
  const unit = (100 / 24) ** 2;
  const glass = area(read(icon('<circle cx="11" cy="11" r="8"/><line x1="21" y1="21" x2="16.65" y2="16.65"/>')).rings);
  // The round end of the handle overlaps the ring of the glass by some hundredths only.
  const expected = unit * (2 * Math.PI * 8 * 2 + Math.hypot(4.35, 4.35) * 2 + Math.PI / 2);
  assert.ok(Math.abs(glass / expected - 1) < 0.02, `${glass} instead of ${expected}`);
  const tick = area(read(icon('<polyline points="20 6 9 17 4 12"/>')).rings);
  const check = unit * (2 * (Math.hypot(11, 11) + Math.hypot(5, 5)) + Math.PI - (1 - Math.PI / 4));
  assert.ok(Math.abs(tick / check - 1) < 0.01, `${tick} instead of ${check}`);
});

/** The word of a refusal with its values. @param {string} text */
function refusal(text) {
  try {
    read(text);
  } catch (why) {
    return /** @type {{ told: object }} */ (why).told;
  }
  return assert.fail('it is taken');
}

test('a drawing that is too much, or makes no sense, is refused with a reason', () => {
  const laughs = Array.from({ length: 9 }, (_, k) => `<g id="a${k + 1}">${`<use href="#a${k}"/>`.repeat(10)}</g>`).join('');
  for (const [text, word, values] of /** @type {[string, string, object][]} */ ([
    [squares(1600, 0.8), 'too_many_rings', { n: 6400, rings: 1600, most: 4096 }],
    [svg(`<defs><g id="a0"><rect width="9" height="9"/></g>${laughs}</defs><use href="#a9"/>`), 'too_many_shapes', { most: 50_000 }],
    [svg(`${'<g>'.repeat(9000)}<rect width="9" height="9"/>${'</g>'.repeat(9000)}`), 'too_deep', { most: 200 }],
    [svg(`<path d="M0 0${'l1 1 1-1'.repeat(400_000)}"/>`), 'too_many_points', { most: 200_000 }],
    [svg('<rect x="NaN" width="1e999" height="9"/><circle r="-5"/><path d="M0 0L1e400 9"/><rect width="0" height="50"/>'), 'no_shapes', {}],
  ])) assert.deepEqual(refusal(text), { word, values });
  // An element that uses itself is drawn without that use. Numbers that are too small or too large do not hide a square.
  const odd = read(svg('<g id="a"><rect x="20" y="20" width="50" height="50"/><use href="#a" x="5"/></g><rect x="1e-400" width="1e-300" height="9"/><path transform="scale(0)" d="M0 0H9V9"/>'));
  assert.ok(Math.abs(area(odd.rings) - 55 * 50) < 3);
});
