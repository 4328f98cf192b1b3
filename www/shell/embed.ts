/**
 * The picture alone, for other pages, in the view of its link. A click pauses and plays; a link in the corner opens
 * the whole page. It stores nothing.
 */
import { isEnd } from '../module/stages';
import { t } from '../words/words';
import { byId, byIdAs, make } from '../base/dom';
import { Later } from '../base/later';
import { alertOf, clear } from '../base/messages';
import { Arrivals } from '../state/arrivals';
import { fragment, pageAddress } from '../state/link';
import { read, written } from '../state/asked-view';
import { wantsFine } from '../state/fine';
import { joined, parted, WHOLE, type Camera, type Cut } from '../state/viewing';
import type { Fine } from '../look/fine';
import type { Turntables } from '../turn/turntables';
import { layInFrame } from '../picture/frame';
import { PictureHost } from '../picture/host';
import { Until } from '../picture/until';
import { scriptFace, type ScriptFace } from './scripts';
import { tellCrash } from './trouble';
import '../styles/late/embed.css';

export class Embed {
  readonly scripts: ScriptFace;
  private readonly canvas = byIdAs('canvas', HTMLCanvasElement);
  private readonly button = make('button', { type: 'button', class: 'embed-play' });
  private readonly home = make('a', { class: 'embed-home', target: '_blank', rel: 'noopener' }, 'Bubblestone');
  private readonly host: PictureHost;
  private readonly turning: Later<Turntables>;
  /** The view and its overlays, in the module's words. */
  private view = 'auto';
  private zoom = WHOLE;
  /** Smooths the finished picture. It is loaded later; without it the plain picture stays. */
  private fine: Fine | undefined;
  private refining = !wantsFine();
  /** The camera of the turntable; undefined while the picture is shown. */
  private camera: Camera | undefined;
  private cut: Cut | undefined;

  constructor() {
    const { recipe, words } = parted(fragment());
    const { canvas } = this;
    this.host = new PictureHost(recipe, {
      canvas,
      view: () => this.view,
      worked: (stage, _changed, drawn) => this.worked(stage, drawn),
      crashed: (error, link) => this.crashed(error, link),
    });
    const { engine, loop } = this.host;
    this.turning = new Later(() => this.bringTurntables());
    this.scripts = scriptFace(engine, () => loop.rests, () => this.camera);
    byId('sheet').append(make('h1', { class: 'said' }, 'Bubblestone'), this.button, this.home);
    this.button.addEventListener('click', () => this.toggle());
    const arrivals = new Arrivals();
    addEventListener('hashchange', () => {
      const { recipe, words } = parted(fragment());
      arrivals.reach(recipe, () => {
        this.host.open(recipe);
        if (engine.alive) clear('trouble');
        this.opened(words);
        // The step that a link asks for is reached from the start of the forming.
        if (loop.until) engine.restart();
      });
    });
    this.opened(words);
  }

  /** Shows a crash. It may happen while the engine is being made. */
  private crashed(error: unknown, link: string): void {
    document.documentElement.dataset['stage'] = 'error';
    (this.scripts as ScriptFace | undefined)?.failed();
    tellCrash(error, link);
  }

  private worked(stage: string, drawn: boolean): void {
    const { scripts } = this;
    document.documentElement.dataset['stage'] = stage;
    if (stage === 'done') {
      scripts.done();
      this.refine();
    }
    if (drawn) this.fine?.redrawn();
    else this.fine?.follow();
    if (stage === 'error') {
      const problem = this.host.engine.problem();
      alertOf('trouble', problem);
      scripts.failed(problem);
    }
    this.name(stage);
  }

  private refine(): void {
    if (this.refining) return;
    this.refining = true;
    const { canvas, host: { engine, loop } } = this;
    import('../look/fine').then(
      ({ Fine, standing }) =>
        (this.fine = new Fine(canvas, engine, () => {
          if (this.camera || engine.offers('frames')) return undefined;
          const still = standing(engine, this.view, { stage: engine.stage(), isPaused: loop.paused });
          return still && { link: engine.link(), side: engine.side(), zoom: this.zoom.scale, ...still };
        })),
      () => undefined,
    );
  }

  private toggle(): void {
    const { host, host: { engine, loop } } = this;
    if (isEnd(engine.stage())) {
      loop.until = undefined;
      loop.paused = false;
      host.restart();
    } else loop.paused = !loop.paused;
    this.name(engine.stage());
  }

  /** Updates the button's name to its present action. */
  private name(stage: string): void {
    const does = this.host.loop.paused || isEnd(stage) ? 'play' : 'pause';
    const word = t(does);
    this.button.dataset['does'] = does;
    if (this.button.title === word) return;
    this.button.title = word;
    this.button.setAttribute('aria-label', word);
  }

  /**
   * Shows the turntable, or the picture again. Generators that are seen by frames only always show the turntable. Its
   * code is loaded later; without it the picture stays.
   */
  private turn(camera: Camera | undefined): void {
    const { engine } = this.host;
    this.camera = camera;
    document.documentElement.dataset['offers'] = engine.generator.offers.join(' ');
    const isOn = (): boolean => engine.offers('frames') || this.camera !== undefined;
    if (!isOn() && !this.turning.here) return;
    this.turning.ask((both) => {
      // The turntable of a picture hides the play button; frames of the engine itself keep it, as a small one.
      this.button.hidden = isOn() && !engine.offers('frames');
      both.show(isOn()).follow();
    });
  }

  private async bringTurntables(): Promise<Turntables> {
    const { Turntables } = await import('../turn/turntables');
    const { engine } = this.host;
    return new Turntables(this.host, {
      generator: () => engine.generator,
      link: () => engine.link(),
      held: () => false,
      get: (key) => engine.get(key),
      schema: () => engine.schema,
      camera: () => this.camera,
      cut: () => this.cut,
      take: (now) => (this.camera = now),
      ended: () => this.turn(undefined),
      alone: true,
    });
  }

  private opened(words: string): void {
    const { host, host: { engine, loop } } = this;
    const { viewing } = read(words, engine.generator);
    const { view = 'auto', overlays = [], pace = 1, step, zoom = WHOLE, camera, cut } = viewing;
    this.cut = cut;
    this.view = [view, ...overlays].join('+');
    this.home.href = pageAddress(joined(engine.link(), written(viewing, engine.generator)));
    layInFrame(byId('sheet'), (this.zoom = engine.offers('frames') ? WHOLE : zoom));
    this.turn(camera);
    this.fine?.follow();
    loop.stepsPerFrame = host.still ? Number.MAX_SAFE_INTEGER : pace;
    if (step !== undefined) {
      loop.paused = false;
      loop.until = new Until(step, () => this.name(engine.stage()));
    }
    host.changed();
  }
}
