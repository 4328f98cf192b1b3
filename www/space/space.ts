/** What surfaces in space have on the page beside what all pictures have: files of models, and what is to be said of them. */
import { said } from '../words/words';
import { t } from '../words/space';
import { make } from '../base/dom';
import { clear, notice } from '../base/messages';
import type { Work } from '../state/work';
import { Asked } from './asked';
import { MODEL, openModel } from './models';
import '../styles/late/space.css';

export class Space {
  private readonly work: Work;
  private readonly again: () => void;
  private readonly asked = new Asked(() => this.choose());
  private readonly file = make('input', { type: 'file', id: 'model-file', accept: '.obj,.glb,.ply,.stl', hidden: '', 'aria-label': t('choose') });
  /** What was said of the last surface. */
  private told = '';

  /** `again` is to be called where the engine has something to do that is no change of the recipe. */
  constructor(work: Work, again: () => void) {
    this.work = work;
    this.again = again;
    document.body.append(this.file);
    this.file.addEventListener('change', () => {
      const [chosen] = this.file.files ?? [];
      if (chosen) void this.take(chosen);
      // The same file may be chosen again.
      this.file.value = '';
    });
    work.store.on(['recipe', 'stage'], () => this.follow());
  }

  /** Has the visitor choose a file. */
  choose(): void {
    this.file.click();
  }

  /** A file that was chosen or dropped. */
  take(file: File): Promise<void> {
    return openModel(this.work, file, this.again);
  }

  /** What is drawn or named by a control of the panel. */
  edit(key: string): void {
    if (key === MODEL) this.choose();
  }

  /** Shows what the state of the work asks for. */
  follow(): void {
    const { engine, store } = this.work;
    const { stage } = store.state;
    this.asked.show(stage === 'error' ? engine.missing()?.name : undefined);
    if (stage === 'done' || stage === 'error') this.tell();
  }

  /** What was mended, or does not fit well; once, as long as it is the same. */
  private tell(): void {
    const sentences = this.work.engine.inSpace((studio) => studio.remarks(), []).map(said);
    const all = sentences.join(' ');
    if (all === this.told) return;
    this.told = all;
    if (all === '') clear('surface');
    else notice('surface', ...sentences);
  }
}
