import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

/** The styles of parts that change in every frame: the studio, and the figures of chapters. */
const FOLDERS = ['www/styles/', 'www/learn/figure/'];

// A browser that changes an element below one which a style asks with `:has` works out anew all elements that any such
// style may reach: the whole panel, in each frame.
test('no style of what changes in every frame asks what an element has inside', () => {
  for (const folder of FOLDERS) {
    const base = new URL(`../../${folder}`, import.meta.url);
    const names = readdirSync(base, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.css'));
    assert.ok(names.length > 3, folder);
    for (const name of names) {
      const lines = readFileSync(new URL(name.replaceAll('\\', '/'), base), 'utf8').split('\n');
      assert.deepEqual(lines.filter((line) => line.includes(':has(')), [], folder + name);
    }
  }
});
