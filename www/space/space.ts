/** The parts of the page for generators that are seen by frames only: model files, and tools for painting. */
import { t } from '../words/space';
import { said } from '../words/words';
import { make } from '../base/dom';
import { MODELS } from '../base/files';
import { notice } from '../base/messages';
import type { Later } from '../base/later';
import { filesOf } from '../state/rules';
import type { Work } from '../state/work';
import type { PageTurntable } from '../turn/page';
import { FileRequest } from './file-request';
import { ModelBar } from './bar';
import { openModel, type Given } from './models';
import { Painter } from './paint/painter';
import '../styles/late/space.css';

/** Keys that choose in a closed list. */
const STEPS = /^(Arrow|Page|Home|End|.$)/;

/** The acts that other parts of the page do. */
interface SpaceActs {
  /** Starts the engine when the recipe has not changed. */
  again(): void;
  /** Opens a file, which gets the role if it is a model. */
  take(file: File, role?: string): void;
}

/** The index of the stage that repairs a file. */
const MADE = 0;

export class Space {
  private readonly work: Work;
  private readonly turn: Later<PageTurntable>;
  private readonly acts: SpaceActs;
  private painter: Painter | undefined;
  /** The name of the file that was opened last, until its repairs have been shown. */
  private opened = '';
  /** The role of the file that is being chosen; undefined for the one that the recipe waits for, or its first one. */
  private role: string | undefined;
  private readonly asked = new FileRequest(() => this.choose());
  private readonly bar: ModelBar;
  /** The last recipe with a file. */
  private last: string | undefined;
  /** The last key, until something is pressed by a pointer. */
  private key = '';
  private readonly file = make('input', { type: 'file', id: 'model-file', accept: MODELS, hidden: '', 'aria-label': t('choose') });

  constructor(work: Work, turn: Later<PageTurntable>, acts: SpaceActs) {
    this.work = work;
    this.turn = turn;
    this.acts = acts;
    this.bar = new ModelBar(work, (role) => this.choose(role));
    document.body.append(this.file);
    document.addEventListener('keydown', ({ key }) => (this.key = key), { capture: true });
    document.addEventListener('pointerdown', () => (this.key = ''), { capture: true });
    this.file.addEventListener('change', () => {
      const [chosen] = this.file.files ?? [];
      if (chosen) acts.take(chosen, this.role);
      // Resetting the value lets the visitor choose the same file again.
      this.file.value = '';
    });
    work.store.on(['recipe', 'stage'], () => this.follow());
  }

  /** Opens the browser's dialog for files; the chosen one gets this role. */
  choose(role?: string): void {
    this.role = role;
    this.file.click();
  }

  /**
   * Opens the dialog after a choice in a list that needs a file. In a closed list, a key only passes over the choice:
   * then a sentence tells how to open a file.
   */
  wanted(role: string): void {
    if (STEPS.test(this.key)) notice('files', t('by_key'));
    else this.choose(role);
  }

  /** Returns to the last recipe with a file, or opens the dialog if there is none. */
  yours(): void {
    const { engine, store } = this.work;
    if (this.last === undefined || filesOf(engine).length) this.choose();
    else this.work.open(this.last, { own: true, then: () => store.update({ paused: false }) });
  }

  /** Takes the file of a model or of a building. */
  async take(given: Given): Promise<void> {
    if (!(await openModel(this.work, given, () => this.acts.again()))) return;
    this.opened = given.file.name;
    this.follow();
  }

  /** Updates these parts after a change of the state. */
  follow(): void {
    const { engine, store } = this.work;
    const { stage, recipe } = store.state;
    this.bar.follow();
    if (filesOf(engine).length && engine.files().length) this.last = recipe;
    this.asked.show(stage === 'error' ? engine.missing()[0]?.name : undefined);
    this.tell();
    if (engine.offers('paint')) this.turn.ask((page) => void this.painted(page));
  }

  /** Shows what was repaired in an opened file, once that is known. */
  private tell(): void {
    const { engine } = this.work;
    const { stages } = engine.generator;
    const stage = engine.stage();
    if (stage === 'error' && !engine.missing().length) this.opened = '';
    if (this.opened === '' || filesOf(engine).length === 0 || (stage !== 'done' && stages.indexOf(stage) <= MADE)) return;
    const mended = engine.remarks().filter(({ code }) => code.startsWith('mended'));
    const sentences = mended.map(said);
    if (sentences.length > 1) notice('opened', t('mended', { name: this.opened }), ...sentences);
    else if (sentences.length) notice('opened', [t('opened', { name: this.opened }), ...sentences].join(' '));
    this.opened = '';
  }

  private painted(page: PageTurntable): Painter {
    return (this.painter ??= this.begin(page));
  }

  private begin(page: PageTurntable): Painter {
    const painter = new Painter(this.work, page.surface);
    page.framed = () => painter.draw();
    return painter;
  }
}
