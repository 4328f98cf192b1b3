/** The editor as the page uses it: who edits what over the canvas, and what becomes of it. */
import { byId } from '../dom';
import type { Engine } from '../engine';
import { alertOf, clear, notice } from '../messages';
import type { Point, Ring } from '../types';
import type { Work } from '../work';
import { exportDialog, importDialog, textDialog } from './dialogs';
import { Editor } from './editor';
import type { Figure, Sort } from './figures';
import { looksLikeOutline, ringsOf } from './import';
import { arranged, turned } from './rings';
import { roadRings } from './road';
import { Sorts } from './sorts';
import { tell } from './words';

/** Bytes of a file; the outline of a drawing of ten thousand points has some two hundred thousand. */
const LARGEST = 4_000_000;

/** Outlines whose roads are remembered. */
const ROADS = 200;

export class Desk {
  private readonly sorts: Sorts;
  private readonly work: Work;
  private readonly engine: Engine;
  private readonly editor: Editor;
  private last = 'outline';
  /** What the recipe said of it when the handles were last the same. */
  private known = '';
  /** The recipe is changed from here. */
  private writing = false;
  /** Points are in the hand. */
  private held = false;
  /** The roads that gave an outline, with places in sides of the picture: they can be changed while the outline is still theirs. */
  private readonly roads = new Map<string, Figure[]>();
  private paved: Figure[] = [];
  private rim: Ring[] = [];
  /** The width of the last road. */
  private width: number | undefined;

  constructor(work: Work) {
    this.work = work;
    const { engine } = work;
    this.engine = engine;
    this.sorts = new Sorts(engine);
    this.editor = new Editor(byId('editor'), byId('editor-bar'), {
      side: () => engine.side(),
      sorts: () => this.sorts.now(),
      choose: (word) => this.begin(word),
      fresh: (sort, figures, at) => {
        const fresh = this.sorts.fresh(sort, figures, at);
        return fresh && sort.broad ? { ...fresh, value: this.first(sort) } : fresh;
      },
      first: (sort) => this.first(sort),
      change: (sort, figures) => this.take(sort, figures),
      rim: () => this.rim,
      live: (on) => {
        engine.live(on);
        this.held = on;
        if (!on && this.word === 'road') this.remember();
        work.store.update({ held: on });
      },
      disarmed: () => work.store.update({ editing: this.word }),
      closed: () => work.store.update({ editing: undefined }),
    });
  }

  /** The word of what is edited now. */
  private get word(): string | undefined {
    return this.editor.open ? this.editor.sort?.word : undefined;
  }

  private first(sort: Sort): number {
    return (sort.broad ? this.width : undefined) ?? sort.value?.first ?? 0;
  }

  /** Ends the editing of this sort, or begins it, with a first figure where there is none and one is wanted. */
  toggle(word = this.last, fresh = true): void {
    if (this.word === word && !this.editor.armed) return this.editor.close();
    this.begin(word);
    if (fresh) this.editor.start();
  }

  /** A tool of the box; by the keyboard, a new figure comes without drawing. */
  use(tool: string, byKey: boolean): void {
    if (tool === 'hole') return this.hole(byKey);
    const dialog = { text: textDialog, import: importDialog, export: exportDialog }[tool];
    if (!dialog) return this.toggle(tool, byKey);
    dialog({
      side: () => this.engine.side(),
      outline: () => this.engine.outline(),
      take: (rings) => this.takeNew(rings),
      takeFile: (file) => this.takeFile(file),
      takeText: (text, name) => this.takeText(text, name),
    });
  }

  private hole(byKey: boolean): void {
    if (this.editor.armed) return this.editor.disarm();
    if (this.word !== 'outline') this.begin('outline');
    if (byKey) return this.editor.addFigure();
    this.begin('outline', true);
  }

  /** Shows handles on figures of this sort; of a built-in outline a free one of few points is made. */
  begin(word: string, armed = false): void {
    const now = this.sorts.now();
    const sort = now.find((other) => other.word === word) ?? now[0];
    if (!sort) return;
    this.last = sort.word;
    const figures = sort.word === 'road' ? this.roadsNow() : this.sorts.read(sort);
    if (sort.form === 'ring' && this.engine.get('outline') !== 'polygon') this.takeRings(figures.map(({ points }) => points));
    this.known = this.text(sort.word);
    this.rim = sort.word === 'road' && figures.length ? arranged(roadRings(figures, this.engine.side())) : [];
    this.editor.show(sort, figures, armed);
    this.work.store.update({ editing: armed ? 'hole' : sort.word });
  }

  /** The recipe changed: where that came by other ways, what is edited goes on with what it has of the same sort. */
  follow(): void {
    const word = this.word;
    if (word === undefined || this.writing || this.text(word) === this.known) return;
    clear('outline');
    const there = word === 'road' || (word === 'outline' ? this.engine.get('outline') === 'polygon' : this.engine.get(word) !== '');
    if (there) this.begin(word);
    else this.editor.close();
  }

  /** What the recipe says of what is edited. */
  private text(word: string): string {
    return word === 'outline' || word === 'road' ? this.engine.get('outline') + this.engine.get('poly') : this.engine.get(word);
  }

  close(): void {
    this.editor.close();
  }

  /** An outline's file, chosen or dropped. */
  async takeFile(file: File): Promise<boolean> {
    if (await (await import('../take/recipe-file')).openRecipe(this.work, file)) return true;
    const refused = /^image\/(?!svg)/.test(file.type) ? 'only_picture' : file.size > LARGEST ? 'too_large' : undefined;
    if (!refused) return this.takeText(await file.text(), file.name);
    alertOf('outline', tell('kept', { sentence: tell(refused, { name: file.name }) }));
    return false;
  }

  /** Text from the clipboard, where that is an outline. */
  paste(text: string): void {
    if (looksLikeOutline(text)) this.takeText(text, tell('pasted'));
  }

  /** Text that has an outline. */
  takeText(text: string, name: string): boolean {
    try {
      const { rings, loose } = ringsOf(text, name, this.engine.side());
      return this.takeNew(rings, loose);
    } catch (error) {
      alertOf('outline', tell('kept', { sentence: error instanceof Error ? error.message : String(error) }));
      return false;
    }
  }

  /** An outline from elsewhere; where its rings cannot be used as they are, `loose` gives what they enclose together. */
  private takeNew(rings: Ring[], loose?: () => Ring[]): boolean {
    if (this.engine.get('tile') === '1') {
      alertOf('outline', tell('tile_has_none'));
      return false;
    }
    if (!this.takeRings(arranged(rings), loose && (() => arranged(loose())))) return false;
    this.begin('outline');
    return true;
  }

  /** Gives an outline to the engine; false where it was refused. */
  private takeRings(rings: Ring[], loose?: () => Ring[]): boolean {
    return this.change('outline', () => {
      const first = this.work.outline(rings, this.held);
      const second = first.refused ? (loose?.() ?? []) : [];
      const { refused, sentence } = second.length ? this.work.outline(second, this.held) : first;
      return { refused, sentence: refused ? tell('last_good', { sentence }) : sentence };
    });
  }

  private take(sort: Sort, figures: Figure[]): boolean {
    if (sort.word === 'road') return this.takeRoads(figures);
    if (sort.form === 'ring') return this.takeRings(turned(figures.map(({ points }) => points)));
    return this.change(sort.word, () => {
      const sentence = this.work.write(sort.word, this.sorts.text(sort, figures), this.held);
      return { refused: sentence !== '', sentence };
    });
  }

  private takeRoads(figures: Figure[]): boolean {
    const side = this.engine.side();
    this.width = figures.at(-1)?.value ?? this.width;
    this.rim = arranged(roadRings(figures, side));
    // The last road was removed: the outline stays as it is.
    if (!this.rim.length) return true;
    if (!this.takeRings(this.rim)) return false;
    this.paved = scaled(figures, 1 / side);
    if (!this.held) this.remember();
    return true;
  }

  /** The outline at hand is that of these roads. */
  private remember(): void {
    const oldest = this.roads.keys().next().value;
    if (this.roads.size >= ROADS && oldest !== undefined) this.roads.delete(oldest);
    this.roads.set(this.known, this.paved);
  }

  private roadsNow(): Figure[] {
    return scaled(this.roads.get(this.text('road')) ?? [], this.engine.side());
  }

  /** A change from here, which the handles need not follow. */
  private change(word: string, act: () => { refused: boolean; sentence: string }): boolean {
    this.writing = true;
    const { refused, sentence } = act();
    this.writing = false;
    this.known = this.text(word);
    if (refused) alertOf('outline', sentence);
    else notice('outline', ...(sentence ? [sentence] : []));
    return !refused;
  }
}

function scaled(figures: Figure[], by: number): Figure[] {
  return figures.map(({ points, value }) => ({ points: points.map(([x, y]): Point => [x * by, y * by]), value }));
}
