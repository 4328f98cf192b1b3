/** The dialog of all that can be saved: pictures, drawings, an animation, files for other programs, the recipe. */
import { make } from '../base/dom';
import { notice } from '../base/messages';
import type { Task } from '../base/task';
import { pageAddress } from '../state/link';
import type { Work } from '../state/work';
import { t } from '../words/take';
import { dialogOf } from './dialog';
import { fileOf, type Job } from './job';
import { signed, signedPng } from './origin';
import { openRecipe, recipeFile } from './recipe-file';
import { working } from './working';

export function save(work: Work, canvas: HTMLCanvasElement): void {
  const { engine, store } = work;
  const { preset, recipe } = store.state;
  const what = preset?.recipe === recipe ? preset.shown.name : engine.get('tile') === '1' ? 'tile' : engine.get('outline');
  const name = (ending: string): string => `bubblestone-${what}-${engine.get('seed')}${ending}`;
  /** What is made of the finished picture waits for it, or nobody has seen what it will show. */
  const made = (job: () => Job, finished = true) => (task: Task): Promise<Blob> => {
    if (finished && engine.stage() !== 'done') throw new Error(engine.problem() || t('wait'));
    const [link, order] = [engine.link(), job()];
    const bare = fileOf(link, order, task);
    return order.file === 'picture' || order.file === 'svg' ? bare.then((file) => signed(file, pageAddress(link))) : bare;
  };
  const normals = make(
    'select',
    { id: 'normals' },
    make('option', { value: 'normal-opengl' }, 'OpenGL (+Y)'),
    make('option', { value: 'normal-directx' }, 'DirectX (−Y)'),
  );
  normals.addEventListener('change', () => (chosenNormals = normals.value));
  normals.value = chosenNormals;
  const button = (id: string, word: string, ending: string, making: (task: Task) => Promise<Blob>): HTMLButtonElement => {
    const key = make('button', { type: 'button', class: 'key', id }, word);
    key.addEventListener('click', () => {
      dialog.close();
      void working(name(ending), making);
    });
    return key;
  };
  const shown = store.state.view === 'auto' ? 'picture' : store.state.view;
  const pixels = SCALES.filter((scale) => scale === 1 || canvas.width * scale <= MOST).map((scale) => {
    const n = canvas.width * scale;
    const key =
      scale === 1
        ? button('save-png', t('pixels', { n }), `-${shown}.png`, () => shownPng(canvas, engine.link()))
        : button(`save-png-${scale}`, t('pixels', { n }), `-${n}.png`, made(() => ({ file: 'picture', scale })));
    key.setAttribute('aria-label', t('pixels_label', { n }));
    return key;
  });
  const file = make('input', { type: 'file', accept: '.json,.png,.svg', hidden: '', 'aria-label': t('open_label') });
  const open = make('button', { type: 'button', class: 'key', id: 'open-recipe', 'aria-label': t('open_label') }, t('open'));
  open.addEventListener('click', () => file.click());
  file.addEventListener('change', () => {
    const [chosen] = file.files ?? [];
    dialog.close();
    if (chosen) void openRecipe(work, chosen).then((known) => known || notice('files', t('not_json', { name: chosen.name })));
  });
  const dialog = dialogOf(
    'save-dialog',
    t('save'),
    row(t('picture'), t('picture_note'), ...pixels),
    row(t('cells'), t('cells_note'), button('save-svg', 'SVG', '.svg', made(() => ({ file: 'svg' }), false))),
    row(t('forming'), t('forming_note'), button('save-gif', 'GIF', '.gif', made(() => ({ file: 'gif' }), false))),
    row(
      t('maps'),
      t('maps_note'),
      make('label', { class: 'said', for: 'normals' }, t('normals')),
      normals,
      button('save-maps', 'ZIP', '-maps.zip', made(() => ({ file: 'maps', normals: normals.value }))),
    ),
    row(
      t('mesh'),
      t('mesh_note'),
      button('save-glb', 'GLB', '.glb', made(() => ({ file: 'glb' }))),
      button('save-obj', 'OBJ', '.obj', made(() => ({ file: 'obj' }))),
    ),
    row(t('recipe'), t('recipe_note'), button('save-recipe', 'JSON', '.json', () => Promise.resolve(recipeFile(engine))), open, file),
  );
}

/** Times the picture's side. */
const SCALES = [1, 2, 3, 4];

/** The most pixels that a side may have. */
const MOST = 4096;

/** Which normals were asked for last. */
let chosenNormals = 'normal-opengl';

function row(what: string, note: string, ...ways: HTMLElement[]): HTMLElement {
  return make(
    'section',
    { class: 'take-save', role: 'group', 'aria-label': what },
    make('div', {}, make('h3', {}, what), make('p', { class: 'take-note' }, note)),
    make('div', { class: 'take-ways' }, ...ways),
  );
}

async function shownPng(canvas: HTMLCanvasElement, link: string): Promise<Blob> {
  const picture = await signedPng(canvas, pageAddress(link));
  if (!picture) throw new Error(t('no_png'));
  return picture;
}
