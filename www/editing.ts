/** Who edits what over the canvas, and what becomes of it. */
import { byId } from './dom';
import { Editor } from './editor';
import type { Engine } from './engine';
import { alertOf, notice } from './messages';
import { Sorts } from './sorts';
import type { Figure, Ring, Sort } from './types';

export class Editing {
  readonly sorts: Sorts;
  private readonly engine: Engine;
  private readonly changed: () => void;
  private readonly editor: Editor;
  private last = 'outline';
  /** Called when editing begins, changes what it edits, or ends. */
  shown: () => void = () => undefined;

  constructor(engine: Engine, changed: () => void) {
    this.engine = engine;
    this.changed = changed;
    this.sorts = new Sorts(engine);
    this.editor = new Editor(byId('editor'), byId('editor-bar'), {
      side: () => engine.side(),
      sorts: () => this.sorts.now(),
      choose: (word) => this.begin(word),
      fresh: (sort, figures, at) => this.sorts.fresh(sort, figures, at),
      change: (sort, figures) => this.take(sort, figures),
      live: (on) => {
        engine.live(on);
        if (!on) this.changed();
      },
      closed: () => this.shown(),
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
    this.editor.open(sort, figures);
    this.shown();
  }

  /** Another recipe came by other ways: what is edited goes on with what it has of the same sort. */
  follow(): void {
    const word = this.word;
    if (word === undefined) return;
    if (word === 'outline' ? this.engine.get('outline') === 'polygon' : this.engine.get(word) !== '') this.begin(word);
    else this.editor.close();
  }

  end(): void {
    this.editor.close();
  }

  /** Gives an outline to the engine; false where it was refused. */
  takeRings(rings: Ring[]): boolean {
    const { refused, sentence } = this.engine.setOutline(rings);
    return this.told(refused, sentence, 'The last good outline stays.');
  }

  private take(sort: Sort, figures: Figure[]): boolean {
    if (sort.form === 'ring') return this.takeRings(figures.map(({ points }) => points));
    const sentence = this.sorts.write(sort, figures);
    return this.told(sentence !== '', sentence, '');
  }

  private told(refused: boolean, sentence: string, kept: string): boolean {
    if (refused) alertOf('outline', `${sentence} ${kept}`.trim());
    else notice('outline', ...(sentence ? [sentence] : []));
    this.changed();
    return !refused;
  }
}
