/** Who edits what over the canvas, and what becomes of it. */
import { byId } from './dom';
import { Editor } from './editor';
import type { Engine } from './engine';
import { alertOf, notice } from './messages';
import { Sorts } from './sorts';
import type { Figure, Ring, Sort } from './types';
import type { Work } from './work';

export class Editing {
  readonly sorts: Sorts;
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

  constructor(work: Work) {
    this.work = work;
    const { engine } = work;
    this.engine = engine;
    this.sorts = new Sorts(engine);
    const layer = byId('editor');
    this.editor = new Editor(layer, byId('editor-bar'), {
      side: () => engine.side(),
      sorts: () => this.sorts.now(),
      choose: (word) => this.begin(word),
      fresh: (sort, figures, at) => this.sorts.fresh(sort, figures, at),
      change: (sort, figures) => this.take(sort, figures),
      live: (on) => {
        engine.live(on);
        this.held = on;
        work.store.update({ held: on });
      },
      closed: () => work.store.update({ editing: undefined }),
    });
  }

  /** The word of what is edited now. */
  get word(): string | undefined {
    return this.editor.word;
  }

  /** Ends the editing of this sort, or begins it, with a first figure where there is none. */
  toggle(word = this.last): void {
    if (this.word === word) return this.editor.close();
    this.begin(word);
    this.editor.start();
  }

  /** Shows handles on figures of this sort; of a built-in outline a free one of few points is made. */
  begin(word: string): void {
    const now = this.sorts.now();
    const sort = now.find((other) => other.word === word) ?? now[0];
    if (!sort) return;
    this.last = sort.word;
    const figures = this.sorts.read(sort);
    if (sort.form === 'ring' && this.engine.get('outline') !== 'polygon') this.takeRings(figures.map(({ points }) => points));
    this.known = this.text(sort.word);
    this.editor.open(sort, figures);
    this.work.store.update({ editing: sort.word });
  }

  /** The recipe changed: where that came by other ways, what is edited goes on with what it has of the same sort. */
  follow(): void {
    const word = this.word;
    if (word === undefined || this.writing || this.text(word) === this.known) return;
    if (word === 'outline' ? this.engine.get('outline') === 'polygon' : this.engine.get(word) !== '') this.begin(word);
    else this.editor.close();
  }

  /** What the recipe says of what is edited. */
  private text(word: string): string {
    return word === 'outline' ? this.engine.get('outline') + this.engine.get('poly') : this.engine.get(word);
  }

  end(): void {
    this.editor.close();
  }

  /** Gives an outline to the engine; false where it was refused. */
  takeRings(rings: Ring[]): boolean {
    return this.change('outline', () => {
      const { refused, sentence } = this.work.outline(rings, this.held);
      return { refused, sentence, kept: 'The last good outline stays.' };
    });
  }

  private take(sort: Sort, figures: Figure[]): boolean {
    if (sort.form === 'ring') return this.takeRings(figures.map(({ points }) => points));
    return this.change(sort.word, () => {
      const sentence = this.work.write(sort.word, this.sorts.text(sort, figures), this.held);
      return { refused: sentence !== '', sentence, kept: '' };
    });
  }

  /** A change from here, which the handles need not follow. */
  private change(word: string, act: () => { refused: boolean; sentence: string; kept: string }): boolean {
    this.writing = true;
    const { refused, sentence, kept } = act();
    this.writing = false;
    this.known = this.text(word);
    if (refused) alertOf('outline', `${sentence} ${kept}`.trim());
    else notice('outline', ...(sentence ? [sentence] : []));
    return !refused;
  }
}
