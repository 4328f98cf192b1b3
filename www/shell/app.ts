/** The wiring of the page: which changes cause which work, and which parts show the result. */
import { countedBy, isEnd, isUpToSteps } from '../module/stages';
import type { Preset } from '../module/types';
import { t } from '../words/words';
import { byId, byIdAs, frame, say } from '../base/dom';
import { isMarked, mark } from '../base/marks';
import { alertOf, clear, notice } from '../base/messages';
import { isFirstVisit } from '../base/storage';
import type { Engine } from '../state/engine';
import { askedFor, firstState, openedFirst } from '../state/first';
import { History } from '../state/history';
import { isReload } from '../state/link';
import { lastWork, remember } from '../state/memory';
import { Store, type State } from '../state/store';
import { WHOLE } from '../state/viewing';
import { Work } from '../state/work';
import { Ahead } from '../picture/ahead';
import { Forming } from '../picture/forming';
import { PictureHost } from '../picture/host';
import { keepInSight } from '../picture/sight';
import { StatusLine } from '../picture/status';
import { Transport } from '../picture/transport';
import { View } from '../picture/view';
import { Seed } from '../panel/seed';
import { Address } from './address';
import { bindButtons } from './buttons';
import { described } from './described';
import { furnish } from './furnish';
import { makeLookTools } from './look-tools';
import { offerMakes } from './makes';
import { OFFERED, partsOf, type PageParts } from './parts';
import { refine } from './refine';
import { scriptFace, type ScriptFace } from './scripts';
import { remedies, tellCrash } from './trouble';

/**
 * Milliseconds without a change before the end of the work is announced, so that the steps of a slider are not
 * announced one by one.
 */
const SETTLED = 400;
/** Frames to wait for the first cells, or the first frame of bodies, before the panel is built anyway. */
const PATIENCE = 40;
/** The panel waits for the first picture, but at most this many milliseconds after the first cells. */
const QUICK = 1200;

export class App {
  readonly host: PictureHost;
  readonly work: Work;
  readonly history: History;
  readonly forming: Forming;
  readonly view: View;
  readonly parts: PageParts;
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly address: Address;
  private readonly transport: Transport;
  private readonly status = new StatusLine();
  private readonly face: ScriptFace;
  /** Whether cells have been shown. */
  private begun = false;
  /** Resolves when the first picture is done. */
  readonly finished: Promise<void>;
  private finish = (): void => undefined;
  /** The timer of the announcement that the work has ended. */
  private telling = 0;

  constructor() {
    const last = lastWork();
    const { recipe: asked, words } = askedFor(last);
    this.finished = new Promise((resolve) => (this.finish = resolve));
    const crashed = (error: unknown, link: string): void => this.crashed(error, link);
    this.host = new PictureHost(openedFirst(asked, last), {
      canvas: byIdAs('canvas', HTMLCanvasElement),
      view: () => this.view.words,
      worked: (stage, changed, drawn) => this.worked(stage, changed, drawn),
      crashed,
    });
    const { engine, loop } = this.host;
    this.engine = engine;
    /**
     * For a new visitor the page's first picture forms slowly. Scripts get their results from a second engine that
     * runs ahead.
     */
    const newcomer = isFirstVisit() && asked === '' && !this.host.still;
    this.face = scriptFace(engine, () => loop.rests, () => this.store.state.camera, () => this.forming.ahead);
    this.store = new Store(firstState(engine, asked, last));
    this.work = new Work(engine, this.store);
    this.history = new History(this.store, (link, act) => this.work.reach(link, act));
    this.view = new View(engine, this.store);
    this.forming = new Forming(
      engine,
      loop,
      (tell) => new Ahead(this.store.state.recipe, crashed, tell),
      () => this.told(),
    );
    this.parts = partsOf(this.work, this.view, this.host, () => this.leaveForming());
    this.address = new Address(this.work, loop, this.parts.linked, () => this.history.undo());
    this.offer();
    this.transport = this.makeTransport();
    new Seed(this.work, () => this.push());
    this.follow();
    bindButtons(this);
    offerMakes(this.work, () => this.push());
    makeLookTools(this.store, this.parts, () => this.leaveEditor());
    notice('link', ...engine.notices());
    if (last && asked !== '' && last.own && last.recipe !== this.store.state.recipe && !isReload()) this.address.tellReplaced();
    remember(this.store);
    keepInSight(this.store);
    if (newcomer) this.forming.begin(true);
    this.address.show(words, () => loop.begin());
    refine(this.work, this.view, this.finished);
  }

  /**
   * Builds the panel and the rail. They take long to build, so the first cells are shown before, and a quick picture is
   * finished. The timeline comes after the first picture, or at a pause.
   */
  async furnish(): Promise<void> {
    for (let waited = 0; waited < PATIENCE && !this.hasBegun(); waited += 1) await frame();
    const late = performance.now() + (this.engine.offers('frames') ? 0 : QUICK);
    while (performance.now() < late && !this.hasMade()) await frame();
    await furnish(this);
    const bring = (): void => void this.parts.timeline.load();
    this.store.on(['paused'], bring);
    // A link to one step may have come to its pause before.
    if (this.store.state.paused) bring();
    void this.finished.then(bring);
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
    if (offers.includes('models')) this.parts.space.ask((space) => space.follow());
    this.store.update({ layers: false, compare: false, plots: false, turn: isFramed, camera: undefined, cut: undefined, repeat: 1, ...(isFramed ? { zoom: WHOLE } : {}) });
  }

  /** Whether cells or bodies have been shown, or never will be. */
  private hasBegun(): boolean {
    return this.begun || isMarked('frame') || this.store.state.stage === 'error' || !this.engine.alive;
  }

  /** Whether the first picture is computed, or its work stands for another reason. */
  private hasMade(): boolean {
    return isMarked('made') || this.host.loop.stands || !this.engine.alive;
  }

  /** The functions for scripts. */
  scripts(): ScriptFace['face'] {
    return this.face.face;
  }

  /** Connects the parts of the state with their followers: recipe -> studio -> view. */
  private follow(): void {
    const { store, host } = this;
    const showTransport = ({ paused, pace }: State): void => {
      host.drive({ paused, pace });
      this.transport.show(this.isOver() ? 'again' : paused ? 'play' : 'pause', pace);
    };
    store.on(['recipe', 'editing'], () => this.forming.leave());
    store.on(['recipe'], () => {
      this.forming.endAhead();
      clear('remarks');
      this.parts.editor.here?.follow();
      host.changed();
    });
    store.on(['make'], () => {
      this.offer();
      host.changed();
    });
    store.on(['paused', 'pace', 'stage', 'other'], showTransport);
    store.on(['held'], () => host.changed());
    store.on(['view', 'overlays'], () => host.loop.redraw());
    showTransport(store.state);
  }

  private makeTransport(): Transport {
    const { store } = this;
    const transport = new Transport({
      toggle: () => (this.isOver() ? this.again() : store.update({ paused: !store.state.paused })),
      step: () => this.step(),
      speed: (pace) => {
        this.host.still = false;
        store.update({ pace });
        if (pace === this.transport.fastest()) this.forming.leave();
      },
    });
    if (this.host.still) store.update({ pace: transport.fastest() });
    return transport;
  }

  /** Shows a crash. It may happen at any time, even while the engine is being made. */
  private crashed(error: unknown, link: string): void {
    (this.store as Store | undefined)?.update({ stage: 'error' });
    document.documentElement.dataset['stage'] = 'error';
    (this.face as ScriptFace | undefined)?.failed();
    tellCrash(error, link);
  }


  /** Restarts the forming, at a pace to watch it, or paused at its start. */
  again(paused = false): void {
    this.host.still = false;
    this.store.update({ paused });
    this.goOn();
    const { compare, beside } = this.store.state;
    // Two compared pictures advance together by steps, not by the clock.
    if (!compare || !beside) this.forming.begin();
    this.work.restart();
    // The buttons are updated now, not with the next frame.
    this.report(this.engine.stage());
    this.host.changed();
  }

  private leaveEditor(): void {
    this.parts.editor.here?.close();
  }

  /** Lets the work run past the step at which a link paused it. */
  private goOn(): void {
    this.host.loop.until = undefined;
    this.address.leave();
  }

  /** Lets the work run past that step, at the work's own pace. */
  private leaveForming(): void {
    this.forming.leave();
    this.goOn();
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
    if (this.engine.status().steps === before && this.engine.alive && isEnd(this.store.state.other)) notice('done', t('settled'));
    this.host.loop.redraw();
  }

  /** Called after each frame in which something was done. */
  private worked(stage: string, changed: boolean, drawn: boolean): void {
    const { preset, recipe } = this.store.state;
    const { loop } = this.host;
    if (drawn) this.view.redrawn();
    const status = this.engine.status();
    this.begun ||= changed && status.cells > 0;
    if (!this.engine.offers('frames')) {
      if (this.begun) mark('cells');
      if (changed && stage === 'done') mark('picture');
    }
    this.forming.follow(stage, this.begun);
    this.parts.timeline.here?.follow(stage, status);
    if (this.status.show(stage, status, { watched: loop.watch !== undefined, goesOn: !loop.stands })) {
      const remarks = this.view.remarks(stage);
      this.status.name(this.oldNote(stage) || this.view.note || (preset ? '' : described(this.engine)), [this.view.absences().values(), remarks], preset?.shown, preset?.recipe !== recipe, stage, status);
    }
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

  /** A note that the frame on the screen belongs to an earlier recipe; '' if it does not, or if there is no frame. */
  private oldNote(stage: string): string {
    return stage === 'error' && this.engine.offers('frames') && document.querySelector('.turn[data-shown]') ? t('last_picture') : '';
  }

  /** Shows why this recipe gives no picture, with buttons that mend it. */
  private stuck(): void {
    const sentence = this.engine.problem();
    // A missing file is shown by a part of its own on the sheet.
    if (!this.engine.missing().length) {
      // A message that a file is open would seem to contradict this.
      clear('opened');
      alertOf('trouble', sentence, ...remedies(this.work));
    }
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
    this.telling = window.setTimeout(() => say(byId('live'), t(`done_${countedBy(this.engine.generator)}`, { cells, steps })), SETTLED);
  }

  /** Makes the next change an entry of its own in the browser's history. */
  push(): void {
    this.address.push();
  }

  /** Opens a preset by one of its links, in its view. */
  openPreset(preset: Preset, link: string): void {
    this.address.openPreset(preset, link);
  }
}
