// The page splits, parses and writes the words of the view in a link. `npm test -- 'page in Node'`.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import typescript from 'typescript';
import { moduleIn } from '../../scripts/lib/headless.mjs';
import { wholeModule } from '../../scripts/lib/wasm.mjs';

/** @type {any} */
let viewing;

before(async () => {
  const [parting, asking] = await Promise.all(['viewing', 'asked-view'].map((name) => moduleOf(`../../www/state/${name}.ts`)));
  viewing = { ...parting, ...asking };
});

/** Loads a file of the page that imports nothing. @param {string} path beside this file */
function moduleOf(path) {
  const source = readFileSync(new URL(path, import.meta.url), 'utf8');
  const { outputText } = typescript.transpileModule(source, { compilerOptions: { module: typescript.ModuleKind.ESNext, target: typescript.ScriptTarget.ES2022, verbatimModuleSyntax: true } });
  return import(`data:text/javascript,${encodeURIComponent(outputText)}`);
}

const SIGHTS = { bases: ['auto', 'picture', 'mesh', 'cells'], overlays: ['size', 'cells', 'mesh', 'forces'], offers: ['forming', 'turn'], home: '330,40,2.95,28', lowest: 5 };

/** @param {string} words */
const read = (words) => viewing.read(words, SIGHTS);

/** @param {any} asked */
const written = (asked, sights = SIGHTS) => viewing.written(asked, sights);

test('a fragment is parted into its recipe and its view, and joined again', () => {
  for (const [fragment, recipe, words] of [
    ['', '', ''],
    ['v=1&cs=18', 'v=1&cs=18', ''],
    ['v=1&cs=18&view=mesh+forces&step=12', 'v=1&cs=18', 'view=mesh+forces&step=12'],
    ['zoom=2&cs=18&&PACE=1&seed=7', 'cs=18&seed=7', 'zoom=2&PACE=1'],
    ['view=mesh', 'v=1', 'view=mesh'],
    ['%76iew=mesh&v=1', 'v=1', '%76iew=mesh'],
    ['%&views=1&step', '%&views=1', 'step'],
    ['v=1&camera=330,38&cs=18', 'v=1&cs=18', 'camera=330,38'],
  ]) {
    assert.deepEqual(viewing.parted(fragment), { recipe, words }, fragment);
  }
  assert.equal(viewing.joined('v=1&cs=18', 'step=3'), 'v=1&cs=18&step=3');
  assert.equal(viewing.joined('', 'step=3'), 'v=1&step=3');
  assert.equal(viewing.joined('', ''), 'v=1');
});

test('what is written is read as it was, and what all see is not written', () => {
  assert.equal(written({}), '');
  assert.equal(written({ view: 'auto', overlays: [], zoom: { scale: 1, x: 0.5, y: 0.5 } }), '');
  for (const words of [
    'view=mesh',
    'view=auto+forces',
    'view=mesh+forces&pace=0.25&step=12&zoom=2.5,0.31,0.62',
    'view=cells+size+cells+mesh&pace=100000',
    'step=0',
    'zoom=16,0.0313,0.9688',
    'camera=330',
    'camera=12.5,80',
    'view=mesh&zoom=2,0.5,0.5&camera=330,38,1.6,35,0.25,0,-0.125',
  ]) {
    const { viewing: asked, faults } = read(words);
    assert.deepEqual(faults, [], words);
    assert.equal(written(asked), words);
  }
});

test('layers alone stand over the picture, in any order and however they are joined', () => {
  for (const given of ['forces+size', 'size%2Bforces', 'auto size forces', 'AUTO%20forces,size', 'auto+size+forces+size']) {
    assert.deepEqual(read(`view=${given}`), { viewing: { view: 'auto', overlays: ['size', 'forces'] }, faults: [] }, given);
  }
});

test('what is wrong is told, with what is taken instead', () => {
  for (const [words, asked, faults] of [
    ['view=moon', '', [['view', 'moon', 'auto']]],
    ['view=', '', [['view', '', 'auto']]],
    ['view=mesh+sun+forces', 'view=mesh+forces', [['layer', 'sun', undefined]]],
    ['view=mesh+picture', 'view=mesh', [['layer', 'picture', undefined]]],
    ['view=moon+forces', 'view=auto+forces', [['view', 'moon', 'auto']]],
    ['pace=0', 'pace=0.01', [['pace', '0', '0.01']]],
    ['pace=1e9', 'pace=100000', [['pace', '1e9', '100000']]],
    ['pace=fast', '', [['pace', 'fast', undefined]]],
    ['pace', '', [['pace', '', undefined]]],
    ['step=-3', 'step=0', [['step', '-3', '0']]],
    ['step=1.5', 'step=2', [['step', '1.5', '2']]],
    ['step=NaN', '', [['step', 'nan', undefined]]],
    ['step=Infinity', '', [['step', 'infinity', undefined]]],
    ['step=%E0%A4%A', '', [['step', '%e0%a4%a', undefined]]],
    ['zoom=99', 'zoom=16,0.5,0.5', [['zoom', '99', '16']]],
    ['zoom=0.5', '', [['zoom', '0.5', '1']]],
    ['zoom=2,0.5', '', [['zoom', '2,0.5', undefined]]],
    ['zoom=2,a,b', '', [['zoom', '2,a,b', undefined]]],
    ['zoom=2,1,1,1', '', [['zoom', '2,1,1,1', undefined]]],
    ['zoom=2,-1,0.5', 'zoom=2,0.25,0.5', [['zoom', '2,-1,0.5', '2,0.25,0.5']]],
    ['camera=400,2', 'camera=360,5', [['camera', '400,2', '360,5']]],
    ['camera=0,90,99,1,3,-3', 'camera=0,90,20,5,2,-2', [['camera', '0,90,99,1,3,-3', '0,90,20,5,2,-2']]],
    ['camera=here', '', [['camera', 'here', undefined]]],
    ['camera=1,2,', '', [['camera', '1,2,', undefined]]],
    ['camera=1,45,3,4,0,0,0,0', '', [['camera', '1,45,3,4,0,0,0,0', undefined]]],
  ]) {
    const found = read(/** @type {string} */ (words));
    const told = found.faults.map((/** @type {any} */ { what, given, kept }) => [what, given, kept]);
    assert.deepEqual([written(found.viewing), told], [asked, faults], String(words));
  }
});

test('a zoom shows nothing beside the picture, and of two words of one key the last one counts', () => {
  assert.equal(written(read('zoom=2,0,1').viewing), 'zoom=2,0.25,0.75');
  assert.equal(written(read('zoom=3').viewing), 'zoom=3,0.5,0.5');
  assert.equal(written(read('step=3&step=4&view=mesh&view=cells').viewing), 'view=cells&step=4');
});

test('a step in the making of a body is shown where there are bodies', () => {
  for (const [offers, body] of [[['turn'], '12:3'], [['frames'], '12:3'], [[], undefined]]) assert.equal(viewing.read('body=12:3', { ...SIGHTS, offers }).viewing.body, body);
  assert.deepEqual(viewing.read('body=0:3', SIGHTS).faults, [{ what: 'body', given: '0:3' }]);
});

test('a camera stands where it is said, else as usual', () => {
  assert.deepEqual(read('camera').viewing.camera, [330, 40, 2.95, 28, 0, 0, 0]);
  assert.deepEqual(read('camera=90,10,0.5').viewing.camera, [90, 10, 0.5, 28, 0, 0, 0]);
  assert.equal(written({ camera: [330.04, 38.26, 2.95049, 28, 0.000049, 0, 0] }), 'camera=330,38.3');
});

test('a plane cuts the bodies of a generator that offers it', () => {
  const pile = { ...SIGHTS, offers: ['frames', 'cut'] };
  const { cut } = viewing.read('cut=0,1,0,0.25', pile).viewing;
  assert.deepEqual(cut, [0, 1, 0, 0.25]);
  assert.equal(written({ cut }, pile), 'cut=0,1,0,0.25');
  assert.equal(viewing.wholeBodies([0.12345, -0.6, 0.5, 0]), 'whole=0.123,-0.6,0.5,0');
  assert.equal(viewing.wholeBodies(undefined), '');
  for (const given of ['1,0,0', '0,0,0,1', '1,0,0,x', '1,0,0,0,0']) assert.deepEqual(viewing.read(`cut=${given}`, pile).faults, [{ what: 'cut', given }]);
  assert.deepEqual(read('cut=0,1,0,0').faults, [{ what: 'cut', given: '0,1,0,0' }]);
});

test('each generator has its first camera, and its lowest one', () => {
  const space = { ...SIGHTS, offers: ['frames'], home: '10,20,2.5', lowest: -85 };
  assert.deepEqual(viewing.read('camera', space).viewing.camera, [10, 20, 2.5, 28, 0, 0, 0]);
  assert.equal(written({ camera: [40, 20, 2.5, 28, 0, 0, 0] }, space), 'camera=40');
  assert.equal(written({ camera: [10, 40, 2.95, 28, 0, 0, 0] }, space), 'camera=10,40,2.95');
  const { viewing: asked, faults } = viewing.read('camera=0,-99', space);
  assert.deepEqual([asked.camera.slice(0, 2), faults], [[0, -85], [{ what: 'camera', given: '0,-99', kept: '0,-85' }]]);
});

test('what has no bodies is not seen from a slant', () => {
  const { viewing: asked, faults } = viewing.read('camera=330&view=mesh', { ...SIGHTS, offers: [] });
  assert.deepEqual([written(asked), faults], ['view=mesh', [{ what: 'camera', given: '330' }]]);
});

test('what is not packed in steps is not held at one', () => {
  const { viewing: asked, faults } = viewing.read('step=3&view=mesh', { ...SIGHTS, offers: [] });
  assert.deepEqual([written(asked), faults], ['view=mesh', [{ what: 'step', given: '3' }]]);
});

test('the view of each preset is read without a fault, and written as it is', async () => {
  const { generators, presets } = await moduleIn(wholeModule);
  let viewed = 0;
  for (const generator of generators()) {
    for (const { name, view } of presets(generator.word)) {
      const { viewing: asked, faults } = viewing.read(view, generator);
      assert.deepEqual(faults, [], name);
      assert.equal(written(asked, generator), view, name);
      viewed += view === '' ? 0 : 1;
    }
  }
  assert.ok(viewed > 4);
});

test('saved files are named by one rule, in letters that every system takes', async () => {
  const { fileName } = await moduleOf('../../www/take/file-name.ts');
  assert.equal(fileName('Granite ring', '1', { ending: 'svg' }), 'bubblestone-granite-ring-1.svg');
  assert.equal(fileName('Lizard’s leg', '7', { size: 4096, ending: 'png' }), 'bubblestone-lizards-leg-7-4096.png');
  assert.equal(fileName('17 (d)', '2', { size: 512, variant: ['maps', false, 'unreal'], ending: 'zip' }), 'bubblestone-17-d-2-512-maps-unreal.zip');
  assert.equal(fileName('/Café…', '3', { variant: ['low', 'one-mesh'], ending: 'glb' }), 'bubblestone-cafe-3-low-one-mesh.glb');
});

test('a number that rounds to zero has no sign', async () => {
  const { fixed } = await moduleOf('../../www/base/fixed.ts');
  assert.deepEqual([-0.0004, -0, 0.0004, -0.0006, -2].map((value) => fixed(value, 3)), ['0.000', '0.000', '0.000', '-0.001', '-2.000']);
});
