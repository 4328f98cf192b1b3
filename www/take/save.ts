/** The dialog of all that can be saved: pictures, drawings, an animation, files for other programs, the recipe. */
import { t } from '../words/take';
import { make } from '../base/dom';
import { notice } from '../base/messages';
import type { Task } from '../late/task';
import { pageAddress } from '../state/link';
import type { Work } from '../state/work';
import { takeDialog } from './dialog';
import type { Job } from './files/job.worker';
import { fileOf } from './job';
import { signed, signedPng } from './origin';
import { openRecipe, recipeFile } from './recipe-file';
import { working } from './working';

/** Times the picture's side. */
const SCALES = [1, 2, 3, 4];

/** The most pixels that a side may have. */
const MOST = 4096;

/** Which normals were asked for last. */
let chosenNormals = 'normal-opengl';

type Making = (task: Task) => Promise<Blob>;

export class SaveDialog {
  private readonly work: Work;
  private readonly canvas: HTMLCanvasElement;
  private readonly dialog: HTMLDialogElement;

  constructor(work: Work, canvas: HTMLCanvasElement) {
    this.work = work;
    this.canvas = canvas;
    this.dialog = takeDialog(
      'save-dialog',
      t('save'),
      row(t('picture'), t('picture_note'), ...this.pictures()),
      ...this.offered('svg', t('cells'), t('cells_note'), this.button('save-svg', 'SVG', '.svg', this.made(() => ({ file: 'svg' }), false))),
      ...this.offered('forming', t('forming'), t('forming_note'), this.button('save-gif', 'GIF', '.gif', this.made(() => ({ file: 'gif' }), false))),
      row(t('maps'), t('maps_note'), ...this.maps()),
      ...this.offered(
        'mesh',
        t('mesh'),
        t('mesh_note'),
        this.button('save-glb', 'GLB', '.glb', this.made(() => ({ file: 'glb' }))),
        this.button('save-obj', 'OBJ', '.obj', this.made(() => ({ file: 'obj' }))),
      ),
      row(t('recipe'), t('recipe_note'), ...this.recipe()),
    );
  }

  /** A row of what the generator at work makes. */
  private offered(part: string, what: string, note: string, ...ways: HTMLElement[]): HTMLElement[] {
    return this.work.engine.generator.offers.includes(part) ? [row(what, note, ...ways)] : [];
  }

  private name(ending: string): string {
    const { engine, store } = this.work;
    const { preset, recipe, make: word } = store.state;
    const what = preset?.recipe === recipe ? preset.shown.name : engine.get('tile') === '1' ? 'tile' : engine.get('outline') || word;
    return `bubblestone-${what}-${engine.get('seed')}${ending}`;
  }

  private button(id: string, word: string, ending: string, making: Making): HTMLButtonElement {
    const key = make('button', { type: 'button', class: 'key', id }, word);
    key.addEventListener('click', () => {
      this.dialog.close();
      void working(this.name(ending), making);
    });
    return key;
  }

  /** By the worker; what is made of the `finished` picture waits for it, or nobody has seen what it will show. */
  private made(job: () => Job, finished = true): Making {
    const { engine } = this.work;
    return async (task) => {
      if (finished && engine.stage() !== 'done') throw new Error(engine.problem() || t('wait'));
      const [link, order] = [engine.link(), job()];
      const file = await fileOf(link, order, task);
      return order.file === 'picture' || order.file === 'svg' ? signed(file, pageAddress(link)) : file;
    };
  }

  private pictures(): HTMLElement[] {
    const { canvas } = this;
    const { view } = this.work.store.state;
    return SCALES.filter((scale) => scale === 1 || canvas.width * scale <= MOST).map((scale) => {
      const n = canvas.width * scale;
      const key =
        scale === 1
          ? this.button('save-png', t('pixels', { n }), `-${view === 'auto' ? 'picture' : view}.png`, () => shownPng(canvas, this.work.engine.link()))
          : this.button(`save-png-${scale}`, t('pixels', { n }), `-${n}.png`, this.made(() => ({ file: 'picture', scale })));
      key.setAttribute('aria-label', t('pixels_label', { n }));
      return key;
    });
  }

  private maps(): HTMLElement[] {
    const normals = make(
      'select',
      { id: 'normals' },
      make('option', { value: 'normal-opengl' }, 'OpenGL (+Y)'),
      make('option', { value: 'normal-directx' }, 'DirectX (−Y)'),
    );
    normals.addEventListener('change', () => (chosenNormals = normals.value));
    normals.value = chosenNormals;
    const zip = this.button('save-maps', 'ZIP', '-maps.zip', this.made(() => ({ file: 'maps', normals: normals.value })));
    return [make('label', { class: 'said', for: 'normals' }, t('normals')), normals, zip];
  }

  /** Saves the recipe, and opens one. */
  private recipe(): HTMLElement[] {
    const { work } = this;
    const file = make('input', { type: 'file', accept: '.json,.png,.svg', hidden: '', 'aria-label': t('open_label') });
    const open = make('button', { type: 'button', class: 'key', id: 'open-recipe', 'aria-label': t('open_label') }, t('open'));
    open.addEventListener('click', () => file.click());
    file.addEventListener('change', () => {
      const [chosen] = file.files ?? [];
      this.dialog.close();
      if (chosen) void openRecipe(work, chosen).then((known) => known || notice('files', t('not_json', { name: chosen.name })));
    });
    return [this.button('save-recipe', 'JSON', '.json', () => Promise.resolve(recipeFile(work.engine))), open, file];
  }
}

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
