/** The wiring of the page: which changes cause which work, and which parts show the result. */
import { isEnd, isUpToSteps } from '../module/stages';
import { language, t } from '../words/words';
import { byId, byIdAs, frame, say, wantsStill } from '../base/dom';
import { bindKeys, listenToKeys } from '../base/keys';
import { speak } from '../base/language';
import { mark } from '../base/marks';
import { alertOf, clear, notice, passing } from '../base/messages';
import { isFirstVisit } from '../base/storage';
import { Engine } from '../state/engine';
import { askedFor, firstState, openedFirst } from '../state/first';
import { History } from '../state/history';
import { isReload, withValues } from '../state/link';
import { isLocked } from '../state/locks';
import { lastWork, remember } from '../state/memory';
import { Store, type State } from '../state/store';
import { WHOLE } from '../state/viewing';
import { Work } from '../state/work';
import { Ahead } from '../picture/ahead';
import { Forming } from '../picture/forming';
import { Loop } from '../picture/loop';
import { keepInSight } from '../picture/sight';
import { StatusLine } from '../picture/status';
import { Transport } from '../picture/transport';
import { View } from '../picture/view';
import { Dice } from '../panel/dice';
import { Panel } from '../panel/panel';
import { Presets } from '../panel/presets';
import { Scaling, SIDE } from '../panel/scaling';
import { Seed, SEED } from '../panel/seed';
import { Address } from './address';
import { copyLink } from './copy';
import { described } from './described';
import { EditTools } from './edit-tools';
import { makeLookTools } from './look-tools';
import { offerMakes } from './makes';
import { OFFERED, partsOf, type Parts } from './parts';
import { refine } from './refine';
import { scriptFace, type ScriptFace } from './scripts';
import { tellCrash } from './trouble';

/**
 * Milliseconds without a change before the end of the work is announced, so that the steps of a slider are not
 * announced one by one.
 */
const SETTLED = 400;
/** Frames to wait for the first cells before the panel is built anyway. */
const PATIENCE = 12;

export class App {
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly work: Work;
  private readonly history: History;
  private readonly loop: Loop;
  private readonly forming: Forming;
  private readonly address: Address;
  private readonly view: View;
  private readonly transport: Transport;
  private readonly status = new StatusLine();
  private readonly parts: Parts;
  private readonly scaling: Scaling;
  private readonly face: ScriptFace;
  /** Whether cells have been shown. */
  private begun = false;
  /** Resolves when the first picture is done. */
  readonly finished: Promise<void>;
  private finish = (): void => undefined;
  /** The timer of the announcement that the work has ended. */
  private telling = 0;
  /** Visitors who prefer less motion see no forming until they choose a speed. */
  private still = wantsStill();

  constructor() {
    const last = lastWork();
    const { recipe: asked, words } = askedFor(last);
    /**
     * For a new visitor the page's first picture forms slowly. Scripts get their results from a second engine that
     * runs ahead.
     */
    const newcomer = isFirstVisit() && asked === '' && !this.still;
    this.finished = new Promise((resolve) => (this.finish = resolve));
    this.engine = new Engine(openedFirst(asked, last), (error, link) => this.crashed(error, link));
    this.face = scriptFace(this.engine, () => this.loop.rests, () => this.store.state.camera, () => this.forming.ahead);
    this.store = new Store(firstState(this.engine, asked, last));
    this.work = new Work(this.engine, this.store);
    this.scaling = new Scaling(this.work);
    this.history = new History(this.store, (link, act) => this.work.reach(link, act));
    this.view = new View(this.engine, this.store);
    this.loop = new Loop(this.engine, (stage) => this.shownAt(stage), (stage, changed) => this.drawn(stage, changed));
    this.forming = new Forming(
      this.engine,
      this.loop,
      (tell) => new Ahead(this.store.state.recipe, (error, link) => this.crashed(error, link), tell),
      () => this.told(),
    );
    this.parts = partsOf(this.work, this.view, this.loop);
    this.address = new Address(this.work, this.loop, this.parts.linked, () => this.history.undo());
    this.offer();
    this.transport = this.makeTransport();
    new Seed(this.work, () => this.push());
    this.follow();
    this.bind();
    offerMakes(this.work, () => this.push());
    makeLookTools(this.store, this.parts, () => this.leaveEditor());
    notice('link', ...this.engine.notices());
    if (last && asked !== '' && last.own && last.recipe !== this.store.state.recipe && !isReload()) this.address.tellReplaced();
    remember(this.store);
    keepInSight(this.store);
    if (newcomer) this.forming.begin(true);
    this.address.show(words, () => this.loop.begin());
    void this.finished.then(() => refine(this.work, this.view));
  }

  /** Builds the panel and the rail. They take long to build, so the first cells are shown before. */
  async furnish(): Promise<void> {
    const { store } = this;
    for (let waited = 0; waited < PATIENCE && !this.hasBegun(); waited += 1) await frame();
    const panel = new Panel(
      this.engine,
      (key, text, done) => {
        this.change(key, text, done);
        // The visitor has not chosen a file yet, so the control shows the old value again.
        if (this.wantsFile(key, text)) panel.refresh();
      },
      ({ key, item }) => (item === 'file' ? this.parts.space.ask((space) => space.choose()) : this.parts.editor.ask((editor) => editor.toggle(key))),
    );
    const tools = new EditTools(this.work, this.parts.editor, (file) => this.parts.space.ask((space) => void space.take(file)));
    const dice = new Dice(this.work, () => this.push());
    const presets = new Presets((preset) => {
      this.leaveEditor();
      this.push();
      if (isLocked(store, SEED)) this.work.open(withValues(preset.link, [[SEED, this.engine.get(SEED)]]), { preset });
      else this.work.open(preset.link);
      store.update({ paused: false });
    });
    const mark = ({ recipe, preset }: State): void => presets.mark(preset?.recipe === recipe ? preset.shown.name : undefined);
    /** The generator that the panel was built for. */
    let made = '';
    /** Builds the parts that depend on the generator. */
    const build = async (): Promise<void> => {
      const { make: word } = store.state;
      if (word === made) return;
      made = '';
      await panel.build();
      tools.build(panel);
      dice.build(panel);
      this.scaling.build(panel);
      panel.refresh();
      panel.attach();
      this.loop.spare();
      await frame();
      presets.build(this.engine.presets);
      mark(store.state);
      made = word;
    };
    let building = Promise.resolve();
    // Builds run one after the other, because they share the panel.
    const follow = (): Promise<void> => (building = building.catch(() => undefined).then(build));
    store.on(['make'], () => void follow());
    store.on(['recipe'], (state) => {
      if (state.make !== made) return;
      panel.refresh();
      mark(state);
    });
    await follow();
  }

  /**
   * Prepares the page for the present generator before anything of it is shown: stages, views, and the parts that it
   * needs.
   */
  private offer(): void {
    const { generator } = this.engine;
    const { offers } = generator;
    const isFramed = offers.includes('frames');
    this.status.follow(generator);
    this.view.follow();
    document.documentElement.dataset['offers'] = offers.join(' ');
    for (const [part, id] of OFFERED) byId(id).hidden = !offers.includes(part);
    this.leaveEditor();
    if (offers.includes('paint')) this.parts.space.ask((space) => space.follow());
    this.store.update({ layers: false, compare: false, plots: false, turn: isFramed, camera: undefined, repeat: 1, ...(isFramed ? { zoom: WHOLE } : {}) });
  }

  /** Whether cells have been shown, or never will be. */
  private hasBegun(): boolean {
    return this.begun || this.store.state.stage === 'error' || !this.engine.alive;
  }

  /** The functions for scripts. */
  scripts(): ScriptFace['face'] {
    return this.face.face;
  }

  /** Connects the parts of the state with their followers: recipe -> studio -> view. */
  private follow(): void {
    const { store } = this;
    const showHistory = ({ past, future, stored, own }: State): void => {
      byIdAs('undo', HTMLButtonElement).disabled = past.length === 0;
      byIdAs('redo', HTMLButtonElement).disabled = future.length === 0;
      const note = byId('stored');
      const text = stored && own ? t('stored') : '';
      // Screen readers announce it only the first time.
      if (!text && note.textContent) note.ariaLive = 'off';
      say(note, text);
    };
    const showTransport = ({ paused, pace }: State): void => {
      if (this.loop.paused !== paused) this.loop.paused = paused;
      this.loop.stepsPerFrame = pace;
      this.transport.show(this.isOver() ? 'again' : paused ? 'play' : 'pause', pace);
    };
    store.on(['recipe', 'editing'], () => this.forming.leave());
    store.on(['recipe'], () => {
      this.forming.endAhead();
      clear('remarks');
      this.parts.editor.here?.follow();
      this.loop.changed();
    });
    store.on(['make'], () => {
      this.offer();
      this.loop.changed();
    });
    store.on(['past', 'future', 'stored', 'own'], showHistory);
    store.on(['paused', 'pace', 'stage', 'other'], showTransport);
    store.on(['held'], () => this.loop.changed());
    store.on(['view', 'overlays'], () => this.loop.redraw());
    showTransport(store.state);
    showHistory(store.state);
  }

  private makeTransport(): Transport {
    const { store } = this;
    const transport = new Transport({
      toggle: () => (this.isOver() ? this.again() : store.update({ paused: !store.state.paused })),
      step: () => this.step(),
      speed: (pace) => {
        this.still = false;
        store.update({ pace });
        if (pace === this.transport.fastest()) this.forming.leave();
      },
    });
    if (this.still) store.update({ pace: transport.fastest() });
    return transport;
  }

  private bind(): void {
    const { parts } = this;
    const press = (id: string) => () => byId(id).click();
    bindKeys(
      { keys: [' '], shown: ['Space'], word: 'key_play', act: press('play') },
      { keys: ['s', '.'], word: 'key_step', act: press('step'), repeats: true },
      { keys: ['r'], word: 'key_restart', act: () => this.again() },
      { keys: ['d'], word: 'key_dice', act: press('dice') },
      { keys: ['x'], word: 'key_throw', act: press('throw') },
      { keys: ['ctrl+z'], shown: ['Ctrl+Z'], word: 'key_undo', act: press('undo'), repeats: true },
      { keys: ['ctrl+shift+z', 'ctrl+y'], shown: ['Ctrl+Shift+Z', 'Ctrl+Y'], word: 'key_redo', act: press('redo'), repeats: true },
      { keys: ['c'], word: 'key_copy', act: () => void copyLink(this.engine.link()) },
      { keys: '0123456789'.split(''), shown: ['0', '–', '9'], word: 'key_view', act: (key) => this.store.update({ view: this.view.bases[Number(key)] ?? 'auto' }) },
      { keys: ['e'], word: 'key_edit', part: 'outline', act: () => parts.editor.ask((editor) => editor.toggle()) },
    );
    listenToKeys();
    for (const id of ['share', 'save']) byId(id).addEventListener('click', () => this.forming.leave());
    byId('share').addEventListener('click', () => parts.share.ask(({ share }) => share(this.engine, this.store, this.view.canvas)));
    byId('save').addEventListener('click', () => parts.save.ask(({ SaveDialog }) => new SaveDialog(this.work, this.view.canvas)));
    byId('undo').addEventListener('click', () => this.history.undo());
    byId('redo').addEventListener('click', () => this.history.redo());
    byId('about-button').addEventListener('click', () => {
      byId('about').scrollIntoView({ behavior: this.still ? 'auto' : 'smooth' });
      byId('about').focus({ preventScroll: true });
    });
    const select = byIdAs('language', HTMLSelectElement);
    select.value = language();
    select.addEventListener('change', () => speak(select.value));
  }

  /** Shows a crash. It may happen at any time, even while the engine is being made. */
  private crashed(error: unknown, link: string): void {
    (this.store as Store | undefined)?.update({ stage: 'error' });
    document.documentElement.dataset['stage'] = 'error';
    (this.face as ScriptFace | undefined)?.failed();
    tellCrash(error, link);
  }

  /** A control was moved. */
  private change(key: string, text: string, done: boolean): void {
    if (key === 'outline' && text === 'polygon') return this.parts.editor.ask((editor) => editor.free());
    if (this.wantsFile(key, text)) return this.parts.space.ask((space) => space.choose());
    if (key === SIDE) return this.scaling.set(text, !done);
    this.work.set(key, text, !done);
  }

  /** Whether a value needs a file that the recipe does not name yet. */
  private wantsFile(key: string, text: string): boolean {
    const files = this.engine.schema.filter(({ item }) => item === 'file');
    return files.some(({ key: file, shownFor }) => shownFor?.key === key && shownFor.words.includes(text) && this.engine.get(file) === '');
  }

  /** Restarts the forming, at a pace to watch it, or paused at its start. */
  private again(paused = false): void {
    this.still = false;
    this.store.update({ paused });
    this.goOn();
    const { compare, beside } = this.store.state;
    // Two compared pictures advance together by steps, not by the clock.
    if (!compare || !beside) this.forming.begin();
    this.work.restart();
    // The buttons are updated now, not with the next frame.
    this.report(this.engine.stage());
    this.loop.changed();
  }

  private leaveEditor(): void {
    this.parts.editor.here?.close();
  }

  /** Lets the work run past the step where a link held it. */
  private goOn(): void {
    this.loop.until = undefined;
    this.address.leave();
  }

  /** Whether no work is left, neither here nor in the compared picture. */
  private isOver(): boolean {
    return isEnd(this.engine.stage()) && isEnd(this.store.state.other);
  }

  private step(): void {
    const stage = this.engine.stage();
    if (this.isOver()) return this.again(true);
    this.store.update({ paused: true });
    this.goOn();
    // The work up to the first step of the packing runs even while paused.
    const { generator } = this.engine;
    if (!isEnd(stage) && stage !== generator.stepping && isUpToSteps(generator, stage)) return;
    const before = this.engine.status().steps;
    this.work.step();
    if (this.engine.status().steps === before && this.engine.alive && isEnd(this.store.state.other)) passing('done', t('settled'));
    this.loop.redraw();
  }

  /** The view that is drawn at a stage. Visitors who prefer less motion see finished pictures only. */
  private shownAt(stage: string): string | undefined {
    return !this.still || stage === 'done' || this.store.state.paused ? this.view.words : undefined;
  }

  /** Called after each frame in which something was done. */
  private drawn(stage: string, changed: boolean): void {
    if (!this.engine.alive) return;
    const { preset, recipe } = this.store.state;
    if (changed && !this.engine.offers('frames') && this.shownAt(stage) !== undefined) this.view.draw();
    const status = this.engine.status();
    this.begun ||= changed && status.cells > 0;
    if (!this.engine.offers('frames')) {
      if (this.begun) mark('cells');
      if (changed && stage === 'done') mark('picture');
    }
    this.forming.follow(stage, this.begun);
    this.status.show(stage, status, this.loop.watch !== undefined);
    const remarks = this.view.remarks(stage);
    this.status.name(this.view.note || (preset ? '' : described(this.engine)), [this.view.absences().values(), remarks], preset?.shown, preset?.recipe !== recipe, stage, status);
    this.report(stage);
    if (stage === 'error') this.stuck();
    if (stage === 'done') this.finish();
  }

  /** Sets the stage of the recipe for scripts. The stage on the screen may be an earlier one. */
  private told(): void {
    const stage = this.forming.ahead?.stage ?? this.engine.stage();
    const { dataset } = document.documentElement;
    if (dataset['stage'] !== stage) dataset['stage'] = stage;
    if (stage !== 'done') return;
    mark('made');
    this.face.done();
  }

  /** This recipe gives no picture; another one may. */
  private stuck(): void {
    const sentence = this.engine.problem();
    // A missing file is shown by a part of its own on the sheet.
    if (!this.engine.missing().length) alertOf('trouble', sentence);
    this.face.failed(sentence);
  }

  /** Updates the stage in the state and for scripts, and announces the end of the work. */
  private report(stage: string): void {
    this.told();
    const before = this.store.state.stage;
    if (stage === before) return;
    if (before === 'error') clear('trouble');
    // A pause applies to one forming, not to the next.
    this.store.update(isEnd(stage) ? { stage, paused: false } : { stage });
    const { cells, steps } = this.engine.status();
    clearTimeout(this.telling);
    say(byId('live'), '');
    if (stage !== 'done') return;
    this.telling = window.setTimeout(() => say(byId('live'), t('done', { cells, steps })), SETTLED);
  }

  /** Makes the next change an entry of its own in the browser's history. */
  private push(): void {
    this.address.push();
  }
}
