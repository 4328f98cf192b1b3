/**
 * The editor as the page uses it: it connects the figures over the canvas with the recipe.
 *
 * sorts.ts lists the sorts of figures. edited.ts holds the figures and changes them. figure-editor.ts has the keys and
 * the bar, gestures.ts and pen.ts the pointers, sheet.ts the drawing.
 *
 * Opening the editor changes nothing. A link holds only the many points of an outline; the editor finds a few handles
 * in them each time it opens (geometry/handles.ts). The stretch between two handles stays the same to the last bit until
 * one of them is moved (geometry/curve.ts). Outlines of roads and letters are contours of a distance on a grid, by
 * marching squares, with few points and sharp corners (geometry/contour.ts). The editor remembers the middle lines of a
 * road beside the outline that they gave, so undo brings them back. A drag is one step of the history.
 */
import type { Point, Ring } from '../module/types';
import { t } from '../words/editor';
import { byId } from '../base/dom';
import { reasonOf } from '../base/errors';
import { alertOf, clear, notice } from '../base/messages';
import type { Engine, SetResult } from '../state/engine';
import { toolApplies } from '../state/rules';
import type { Work } from '../state/work';
import { nameOf } from '../take/name';
import { exportDialog, importDialog } from './dialogs';
import { FigureEditor } from './figure-editor';
import { ringOf, scaled } from './geometry/curve';
import type { Figure, Sort } from './geometry/figures';
import { arranged, turned } from './geometry/rings';
import { roadRings } from './geometry/road';
import { simplify } from './geometry/simplify';
import type { Try } from './import/read';
import { read, remarks } from './import/reading';
import { textDialog } from './letters/dialog';
import { Sorts } from './sorts';
import '../styles/late/editor.css';

/** The endings of files that may hold an outline; files without an ending may, too. */
const KNOWN = /(^[^.]*|\.(svg|json|txt))$/i;

/** Largest file, in bytes. A drawing with ten thousand points has about 200 000. */
const LARGEST = 4_000_000;

/** Number of outlines whose roads, or handles, are remembered. */
const REMEMBERED = 400;

/** Largest number of points that the engine takes. */
const POINTS = 4096;

/** Matches text that may be an outline. Only such text is worth a message if it is refused. */
const OUTLINE = /^\s*(<(\?xml|!--|!doctype svg|svg|path)|[[{]|m\s*[-+.\d])/i;

/** The recipe that gets an outline where the page shows none. */
const PAVEMENT = 'v=1';

/** An outline from elsewhere with more rings or points is shown without handles, which would hide it. */
const SHOWN = { rings: 50, points: 1500 };

export class Editor {
  private readonly sorts: Sorts;
  private readonly work: Work;
  private readonly engine: Engine;
  private readonly figureEditor: FigureEditor;
  private last = 'outline';
  /** The recipe's text of the edited list when the handles last agreed with it. */
  private known = '';
  /** The editor itself changes the recipe, so the handles need not follow. */
  private writing = false;
  /** Points are being dragged. */
  private held = false;
  /**
   * Figures by the outline that was made from them, with lengths in sides of the picture. When undo brings an outline
   * back, its figures come back, too.
   */
  private readonly given = new Map<string, Figure[]>();
  private giving: Figure[] = [];
  private rim: Ring[] = [];
  /** The width of the last road. */
  private width: number | undefined;
  private readonly open: (file: File) => void;

  /** `open` opens any file. */
  constructor(work: Work, open: (file: File) => void) {
    this.work = work;
    this.open = open;
    const { engine } = work;
    this.engine = engine;
    this.sorts = new Sorts(engine);
    this.figureEditor = new FigureEditor(byId('editor'), byId('editor-bar'), {
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
        if (!on) this.remember();
        work.store.update({ held: on });
      },
      disarmed: () => work.store.update({ editing: this.word }),
      closed: () => work.store.update({ editing: undefined }),
    });
  }

  /** The word of the sort that is edited now. */
  private get word(): string | undefined {
    return this.figureEditor.open ? this.figureEditor.figures.sort?.word : undefined;
  }

  private first(sort: Sort): number {
    return (sort.broad ? this.width : undefined) ?? sort.value?.first ?? 0;
  }

  /**
   * Starts to edit the sort `asked`, or stops if it is edited already. Without `asked`, takes the sort that was edited
   * last. `fresh`: if the sort `asked` has no figure, adds a first one.
   */
  toggle(asked?: string, fresh = true): void {
    const word = asked ?? this.last;
    if (this.word === word && !this.figureEditor.figures.armed) return this.figureEditor.close();
    this.begin(word);
    if (fresh) this.figureEditor.start(asked !== undefined);
  }

  /** Chooses a tool of the box. By keyboard, a new figure is added without drawing. */
  use(tool: string, byKey: boolean): void {
    if (tool === 'hole') return this.hole(byKey);
    if (tool === 'text') return textDialog({ engine: this.engine, take: (rings, values) => this.takeLetters(rings, values) });
    const dialog = { import: importDialog, export: exportDialog }[tool];
    if (!dialog) return this.toggle(tool, byKey);
    dialog({
      side: () => this.engine.side(),
      outline: () => this.engine.outline(),
      fileName: (ending) => nameOf(this.engine, this.work.store, { variant: ['outline'], ending }),
      takeFile: this.open,
      takeText: (text, name) => this.takeText(text, name),
    });
  }

  private hole(byKey: boolean): void {
    if (this.figureEditor.figures.armed) return this.figureEditor.figures.disarm();
    if (this.word !== 'outline') this.begin('outline');
    if (byKey) return this.figureEditor.figures.addFigure();
    this.begin('outline', true);
  }

  /** Turns the present outline into a polygon that can be edited. */
  free(): void {
    if (this.takeRings(this.engine.outline())) this.begin('outline');
  }

  /** Shows handles on the figures of this sort. The recipe does not change. */
  begin(word: string, armed = false): void {
    const now = this.sorts.now();
    const sort = now.find((other) => other.word === word) ?? now[0];
    if (!sort) return;
    this.last = sort.word;
    this.known = this.text(sort.word);
    const figures = this.remembered(sort.word) ?? (sort.word === 'road' ? [] : this.sorts.read(sort));
    this.rim = sort.word === 'road' && figures.length ? arranged(roadRings(figures, this.engine.side())) : [];
    this.figureEditor.show(sort, figures, armed);
    this.work.store.update({ editing: armed ? 'hole' : sort.word });
  }

  /** The recipe changed. If something else changed it, editing goes on with the new figures of the same sort. */
  follow(): void {
    const word = this.word;
    if (word === undefined || this.writing || this.text(word) === this.known) return;
    clear('outline');
    // A drag of the old figures ends here: they must not go into this recipe, nor be remembered for its outline.
    this.giving = [];
    this.figureEditor.abandon();
    const there = toolApplies(this.engine, word) && (isOutline(word) || this.engine.get(word) !== '');
    if (there) this.begin(word);
    else this.figureEditor.close();
  }

  /** The recipe's text for this sort, with the unit of its points. */
  private text(word: string): string {
    const keys = isOutline(word) ? ['tile', 'outline', 'poly', 'ow', 'on', 'oa'] : [word];
    return ['size', ...keys].map((key) => this.engine.get(key)).join();
  }

  close(): void {
    this.figureEditor.close();
  }

  /** Takes an outline from a file. */
  async takeFile(file: File): Promise<boolean> {
    const refused = /^image\/(?!svg)/.test(file.type) ? 'only_picture' : !KNOWN.test(file.name) ? 'unknown_kind' : file.size > LARGEST ? 'too_large' : undefined;
    if (!refused) return this.takeText(await file.text(), file.name);
    return this.refuse(t(refused, { name: file.name }));
  }

  /** Takes an outline from the clipboard's text, if it is one. */
  paste(text: string): void {
    if (OUTLINE.test(text)) void this.takeText(text, t('pasted'));
  }

  /** Tells that a link, or a picture of another page, was dropped. */
  refuseLink(): void {
    this.refuse(t('dropped_link'));
  }

  /** Takes an outline from a text. */
  async takeText(text: string, name: string): Promise<boolean> {
    if (this.tiled()) return false;
    const side = this.engine.side();
    try {
      const tries = await read(text, name, side);
      if (!tries) return false;
      const scaled = (by: number): Try[] => tries.map((one) => ({ ...one, rings: multiplied(one.rings, by) }));
      return this.isDrawn ? this.takeNew(scaled(this.engine.side() / side)) : this.openNew(scaled(1 / side));
    } catch (error) {
      return this.refuse(reasonOf(error));
    }
  }

  /** Whether the picture has an outline. */
  private get isDrawn(): boolean {
    return this.engine.offers('outline');
  }

  /** Shows the reason why a file or a text was not taken. */
  private refuse(sentence: string): false {
    alertOf('outline', t(this.isDrawn ? 'kept' : 'unchanged', { sentence }));
    return false;
  }

  /** Opens the default pavement with the first of these outlines that it accepts. Their unit is the side of the picture. */
  private openNew(tries: Try[]): boolean {
    let first = '';
    for (const one of tries) {
      const { link, refused, sentences } = this.engine.drawn(PAVEMENT, one.rings);
      if (!refused) {
        this.work.open(link, { own: true, then: () => this.opened([...sentences, ...remarks(one)]) });
        return true;
      }
      first ||= sentences.join(' ');
    }
    return this.refuse(first);
  }

  private opened(sentences: string[]): void {
    this.work.store.update({ paused: false });
    notice('outline', ...sentences);
    this.tookNew();
  }

  /** Whether the picture is a tile, which has no outline to edit. Shows a message if it is. */
  private tiled(): boolean {
    const tiled = this.engine.get('tile') === '1';
    if (tiled) alertOf('outline', t('tile_has_none'));
    return tiled;
  }

  /** Takes the first of these outlines that the engine accepts. */
  private takeNew(tries: Try[]): boolean {
    if (this.tiled()) return false;
    const taken = this.change('outline', () => {
      let first = '';
      for (const one of tries) {
        const { refused, sentences } = this.work.outline(one.rings, this.held);
        if (!refused) return { refused, sentences: [...sentences, ...remarks(one)] };
        first ||= sentences.join(' ');
      }
      return { refused: true, sentences: [t('last_good', { sentence: first })] };
    });
    if (taken) this.tookNew();
    return taken;
  }

  /**
   * Takes letters, with lengths in sides, and values for other parameters, as one step. Returns the reason of a
   * refusal, or ''.
   */
  private takeLetters(rings: Ring[], values: [key: string, text: string][]): string {
    const side = this.engine.side();
    const { refused, sentences } = this.engine.setOutline(multiplied(rings, side));
    if (refused) return sentences.join(' ');
    this.change('outline', () => {
      this.work.setAll(values);
      return { refused, sentences };
    });
    this.tookNew();
    return '';
  }

  /** After a new outline: the recipe no longer belongs to its preset. Shows handles unless there would be too many. */
  private tookNew(): void {
    this.work.store.update({ preset: undefined });
    const rings = this.engine.outline();
    if (rings.length > SHOWN.rings || rings.flat().length > SHOWN.points) this.figureEditor.close();
    // In one task, the outline and its handles would block the page for too long.
    else setTimeout(() => this.begin('outline'));
  }

  /** Gives an outline to the engine. Returns false if it was refused. */
  private takeRings(rings: Ring[]): boolean {
    return this.change('outline', () => {
      const { refused, sentences } = this.work.outline(rings, this.held);
      return { refused, sentences: refused ? [t('last_good', { sentence: sentences.join(' ') })] : sentences };
    });
  }

  private take(sort: Sort, figures: Figure[]): boolean {
    if (sort.word === 'road') return this.takeRoads(figures);
    if (sort.form === 'ring') return this.takeOutline(figures);
    return this.change(sort.word, () => this.work.write(sort.word, this.sorts.text(sort, figures), this.held));
  }

  private takeRoads(figures: Figure[]): boolean {
    const side = this.engine.side();
    this.width = figures.at(-1)?.value ?? this.width;
    this.rim = arranged(roadRings(figures, side));
    // The last road was removed: the outline stays as it is.
    if (!this.rim.length) return true;
    return this.takeRings(this.rim) && this.gave(figures);
  }

  private takeOutline(figures: Figure[]): boolean {
    const side = this.engine.side();
    const rings = turned(figures.map((figure) => ringOf(figure, side)));
    return this.takeRings(simplify(rings, side, POINTS)) && this.gave(figures);
  }

  /** Remembers that these figures gave the outline. */
  private gave(figures: Figure[]): true {
    const side = this.engine.side();
    this.giving = figures.map((figure) => scaled(figure, 1 / side));
    if (!this.held) this.remember();
    return true;
  }

  private remember(): void {
    const word = this.word;
    if (!this.giving.length || word === undefined) return;
    const oldest = this.given.keys().next().value;
    if (this.given.size >= REMEMBERED && oldest !== undefined) this.given.delete(oldest);
    this.given.set(this.shape(word), this.giving);
    this.giving = [];
  }

  /** The figures that gave the present outline, if they are known. */
  private remembered(word: string): Figure[] | undefined {
    const side = this.engine.side();
    return isOutline(word) ? this.given.get(this.shape(word))?.map((figure) => scaled(figure, side)) : undefined;
  }

  /** A key for the present outline, the same at any size of the picture. */
  private shape(word: string): string {
    return [word, this.engine.get('outline'), this.engine.get('poly')].join();
  }

  /** Makes a change that comes from the handles, so they need not follow it. */
  private change(word: string, act: () => SetResult): boolean {
    this.writing = true;
    const { refused, sentences } = act();
    this.writing = false;
    this.known = this.text(word);
    if (refused) alertOf('outline', sentences.join(' '));
    else notice('outline', ...sentences);
    return !refused;
  }
}

function multiplied(rings: Ring[], by: number): Ring[] {
  return rings.map((ring) => ring.map(([x, y]): Point => [x * by, y * by]));
}

function isOutline(word: string): boolean {
  return word === 'outline' || word === 'road';
}
