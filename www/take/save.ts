/** The dialog for saving: pictures, drawings, an animation, files for other programs, and the recipe. */
import { t } from '../words/take';
import { make, say } from '../base/dom';
import { MODELS } from '../base/files';
import type { ToldTask } from '../late/task';
import { pageAddress } from '../state/link';
import type { Engine } from '../state/engine';
import type { Work } from '../state/work';
import { row, select, shown, takeDialog } from './dialog';
import type { Kind } from './file-name';
import { FILES, makeFilm } from './film';
import { codecsFor, type Codec, type FormingShape } from './files/codecs';
import type { Job } from './files/job.worker';
import { slabSize, type Slab } from './files/slab';
import { finished, still } from './finished';
import { fileOf } from './job';
import { megabytes, meshes } from './meshes';
import { nameOf } from './name';
import { signed, signedPng } from './origin';
import { recipeFile } from './recipe-file';
import { seenNow } from './seen';
import { turned } from './turned';
import { working } from './working';

/** Factors of the picture's side, for pictures and for maps. */
const SCALES = [1, 2, 3, 4, 8];
const MAP_SCALES = [1, 2, 4, 8];

/** The most pixels along a side. */
const MOST = 8192;

/** The stages that a larger picture repeats for each of its pixels. */
const OF_PIXELS = ['planes', 'weather', 'shading'];

/** A shorter time, in milliseconds, is not shown. */
const LONG = 3000;

/** The last choices: the program or kind of normals and the factor of the side for maps, the shape for films. */
const chosen: { program: string; scale: number; shape: FormingShape } = { program: 'normal-opengl', scale: 1, shape: 'square' };

/** Programs that maps are for. With the first two, maps keep their own names. */
const PROGRAMS = { 'normal-opengl': 'OpenGL (+Y)', 'normal-directx': 'DirectX (−Y)', blender: 'Blender', godot: 'Godot', unity: 'Unity', unreal: 'Unreal' };

/** The sizes of slabs, in millimetres, and the squares along a side of the grid. */
const measures: Slab = { side: 100, base: 3, relief: 4, squares: 256 };
const LIMITS = { side: [1, 10_000], base: [0.1, 1000], relief: [0.1, 1000] } as const;
const GRIDS = [128, 256, 512, 1024];

/** Files that carry their link. */
const SIGNED: readonly Job['file'][] = ['picture', 'turn', 'svg'];

type Making = (task: ToldTask) => Promise<Blob>;

export class SaveDialog {
  private readonly work: Work;
  private readonly canvas: HTMLCanvasElement;
  private readonly take: (file: File) => void;
  private readonly dialog: HTMLDialogElement;

  /** `take` opens a file. */
  constructor(work: Work, canvas: HTMLCanvasElement, take: (file: File) => void) {
    this.work = work;
    this.canvas = canvas;
    this.take = take;
    this.dialog = takeDialog(
      'save-dialog',
      t('save'),
      ...this.offered('maps', () => row(t('picture'), t('picture_note'), ...this.pictures())),
      ...(this.work.store.state.turn ? [turned(work, (id, word, kind, job) => this.button(id, word, kind, this.made(job, false)), () => this.dialog.close())] : []),
      ...this.offered('svg', () => row(t('cells'), t('cells_note'), this.button('save-svg', 'SVG', { ending: 'svg' }, this.made(() => ({ file: 'svg' }), false)))),
      ...this.offered('forming', () => row(t('forming'), t('forming_note'), ...this.films())),
      ...this.offered('maps', () => row(t('maps'), t('maps_note'), ...this.maps())),
      ...this.offered('mesh', () => meshes(work.engine, (id, word, kind, job) => this.button(id, word, kind, this.made(job)))),
      ...this.offered('slab', () => row(t('slab'), t('slab_note'), ...this.slab())),
      row(t('recipe'), t('recipe_note'), ...this.recipe()),
    );
  }

  /** A row, if the generator at work offers that part. */
  private offered(part: string, row: () => HTMLElement): HTMLElement[] {
    return this.work.engine.offers(part) ? [row()] : [];
  }

  private button(id: string, word: string, kind: Kind | (() => Kind), making: Making): HTMLButtonElement {
    const key = make('button', { type: 'button', class: 'key', id }, word);
    key.addEventListener('click', () => {
      this.dialog.close();
      void working(nameOf(this.work.engine, this.work.store, typeof kind === 'function' ? kind() : kind), making);
    });
    return key;
  }

  /** Has the worker make a file. One of the finished picture `waits` for it. */
  private made(job: () => Job, waits = true): Making {
    const { engine, store } = this.work;
    return async (task) => {
      const order = job();
      if (waits) await finished(engine, store, task);
      const link = engine.link();
      const file = await fileOf(link, order, task);
      return SIGNED.includes(order.file) ? signed(file, pageAddress(link)) : file;
    };
  }

  private pictures(): HTMLElement[] {
    const { canvas } = this;
    const { engine, store } = this.work;
    const { view } = store.state;
    const asShown: Making = async (task) => {
      await still(engine, store, task);
      return shownPng(canvas, engine.link());
    };
    return SCALES.filter((scale) => scale === 1 || canvas.width * scale <= MOST).map((scale) => {
      const n = canvas.width * scale;
      const ms = scale === 1 ? 0 : timeOf(engine, scale);
      const word = timed(t('pixels', { n }), ms);
      const key =
        scale === 1
          ? this.button('save-png', word, { size: n, variant: [view !== 'auto' && view], ending: 'png' }, asShown)
          : this.button(`save-png-${scale}`, word, { size: n, ending: 'png' }, this.made(() => ({ file: 'picture', scale })));
      key.setAttribute('aria-label', timed(t('pixels_label', { n }), ms));
      return key;
    });
  }

  /** Films in the shapes that the browser can encode, and the animation, which all browsers can make. */
  private films(): HTMLElement[] {
    const { engine, store } = this.work;
    const shape = select('shape', t('shape'), { square: t('square'), upright: t('upright') }, chosen.shape);
    const film = make('button', { type: 'button', class: 'key', id: 'save-film', disabled: '' }, FILES.mp4);
    const can = new Map<string, Codec[]>();
    const tell = (): void => {
      chosen.shape = shape.value as FormingShape;
      const [codec] = can.get(shape.value) ?? [];
      film.disabled = !codec;
      film.textContent = FILES[codec?.file ?? 'mp4'];
    };
    shape.addEventListener('change', tell);
    film.addEventListener('click', () => {
      this.dialog.close();
      void makeFilm(engine, store, chosen.shape, can.get(chosen.shape) ?? []);
    });
    void Promise.all((['square', 'upright'] as const).map(async (word) => [word, await codecsFor(word)] as const)).then((found) => {
      for (const [word, codecs] of found) if (codecs.length) can.set(word, codecs);
      tell();
      if (can.size) return;
      for (const way of [shape, film]) way.hidden = true;
      const note = film.closest('section')?.querySelector('.take-note');
      if (note) say(note, t('no_film'));
    });
    return [shape, film, this.button('save-gif', 'GIF', { variant: ['forming'], ending: 'gif' }, this.made(() => ({ file: 'gif', ...seenNow(engine, store) }), false))];
  }

  private maps(): HTMLElement[] {
    const { width } = this.canvas;
    const program = select('normals', t('normals'), PROGRAMS, chosen.program);
    program.addEventListener('change', () => (chosen.program = program.value));
    const scales = MAP_SCALES.filter((scale) => width * scale <= MOST);
    const sizes = Object.fromEntries(scales.map((scale) => [scale, `${scale}× · ${t('pixels', { n: width * scale })}`]));
    const size = select('maps-size', t('maps_size'), sizes, String(scales.includes(chosen.scale) ? chosen.scale : 1));
    size.addEventListener('change', () => (chosen.scale = Number(size.value)));
    const kind = (): Kind => ({ size: width * Number(size.value), variant: ['maps', program.value.replace('normal-', '')], ending: 'zip' });
    const zip = this.button('save-maps', 'ZIP', kind, this.made(() => ({ file: 'maps', program: program.value, scale: Number(size.value) })));
    return [program, size, zip];
  }

  /** A slab for 3D printing. All its sizes are kept while the page is open. */
  private slab(): HTMLElement[] {
    const size = make('output', { class: 'take-note', id: 'slab-size' });
    const tell = (): void => {
      const { triangles, bytes } = slabSize(measures.squares);
      size.value = t('slab_size', { n: shown(triangles), size: megabytes(bytes) });
    };
    const measure = (word: 'side' | 'base' | 'relief'): HTMLElement => {
      const [least, most] = LIMITS[word];
      const box = make('input', { id: `slab-${word}`, type: 'number', inputmode: 'decimal', min: String(least), max: String(most), step: 'any', value: String(measures[word]) });
      box.addEventListener('change', () => {
        // An invalid number leaves the size as it was.
        measures[word] = Math.min(most, Math.max(least, box.valueAsNumber || measures[word]));
        box.value = String(measures[word]);
      });
      return make('label', { class: 'take-sized' }, t(word), box);
    };
    const grid = select('slab-grid', t('grid'), Object.fromEntries(GRIDS.map((n) => [n, t('squares', { n })])), String(measures.squares));
    grid.addEventListener('change', () => {
      measures.squares = Number(grid.value);
      tell();
    });
    tell();
    const stl = this.button('save-stl', 'STL', { ending: 'stl' }, this.made(() => ({ file: 'stl', slab: { ...measures } })));
    return [measure('side'), measure('base'), measure('relief'), grid, stl, size];
  }

  /** Saves the recipe, or opens one. */
  private recipe(): HTMLElement[] {
    const { work } = this;
    const file = make('input', { type: 'file', accept: `.png,.svg,${MODELS}`, hidden: '', 'aria-label': t('open_label') });
    const open = make('button', { type: 'button', class: 'key', id: 'open-recipe', 'aria-label': t('open_label') }, t('open'));
    open.addEventListener('click', () => file.click());
    file.addEventListener('change', () => {
      const [chosen] = file.files ?? [];
      this.dialog.close();
      if (chosen) this.take(chosen);
    });
    return [this.button('save-recipe', 'JSON', { ending: 'json' }, (task) => recipeFile(work.engine, task)), open, file];
  }
}

/**
 * The approximate milliseconds that the picture takes at this multiple of its side, by the times of its stages: a worker
 * runs all of them, then the last ones for each pixel.
 */
function timeOf(engine: Engine, scale: number): number {
  const { ms } = engine.status();
  const sum = (times: (number | undefined)[]): number => times.reduce<number>((sum, time = 0) => sum + time, 0);
  return sum(Object.values(ms)) + scale ** 2 * sum(OF_PIXELS.map((stage) => ms[stage]));
}

/** Adds a time to words, unless it is short. */
function timed(words: string, ms: number): string {
  if (ms < LONG) return words;
  const seconds = ms / 1000;
  return seconds < 90 ? t('seconds', { words, n: Number(seconds.toPrecision(1)) }) : t('minutes', { words, n: Math.round(seconds / 60) });
}

async function shownPng(canvas: HTMLCanvasElement, link: string): Promise<Blob> {
  const picture = await signedPng(canvas, pageAddress(link));
  if (!picture) throw new Error(t('no_png'));
  return picture;
}
