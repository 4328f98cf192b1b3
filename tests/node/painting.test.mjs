// The numbers of lines painted on a surface. `npm test -- 'page in Node'`.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import typescript from 'typescript';

/** @type {any} */
let places;

before(async () => {
  const source = readFileSync(new URL('../../www/space/paint/places.ts', import.meta.url), 'utf8');
  const { outputText } = typescript.transpileModule(source, { compilerOptions: { module: typescript.ModuleKind.ESNext, target: typescript.ScriptTarget.ES2022, verbatimModuleSyntax: true } });
  places = await import(`data:text/javascript,${encodeURIComponent(outputText)}`);
});

/** An arc of radius 1000, slightly unsteady like a hand. */
const arc = Array.from({ length: 200 }, (_, k) => {
  const angle = (Math.PI * k) / 199;
  return [1000 * Math.cos(angle), 1000 * Math.sin(angle), 300 + 3 * Math.sin(7 * k)].map(Math.round);
});

test('a line keeps its ends and its way in few points', () => {
  const few = places.simplified(arc, 20);
  assert.ok(few.length > 4 && few.length <= 20, `${few.length} points`);
  assert.deepEqual([few[0], few.at(-1)], [arc[0], arc.at(-1)]);
  for (const place of arc) assert.ok(places.fromLine(place, few) < 25, String(place));
  assert.ok(places.simplified(arc, 4).length <= 4);
});

test('a line of one place, or of places that are one, stays a line', () => {
  assert.deepEqual(places.simplified([[1, 2, 3]], 20), [[1, 2, 3]]);
  assert.deepEqual(places.simplified([[1, 2, 3], [1, 2, 3], [1, 2, 3]], 20), [[1, 2, 3], [1, 2, 3]]);
});

test('rows are parts of the box and come back as steps', () => {
  const row = places.rowOf(arc.slice(0, 3));
  assert.deepEqual(places.placesOf(row), arc.slice(0, 3));
  assert.equal(places.textOf([[0.5, 0.25, 1], [0, 1, 0]]), '0.5,0.25,1;0,1,0');
});

test('how far a place is from a line is told from its nearest piece', () => {
  const line = [[0, 0, 0], [100, 0, 0], [100, 100, 0]];
  assert.equal(places.fromLine([50, 30, 0], line), 30);
  assert.equal(places.fromLine([100, 150, 0], line), 50);
  assert.equal(places.fromLine([0, 0, 7], [[0, 0, 0]]), 7);
  assert.equal(places.fromLine([0, 0, 7], []), Infinity);
});
