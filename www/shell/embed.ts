/**
 * The picture alone, for other pages, in the view of its link. A click pauses and plays; a link in the corner opens
 * the whole page. It stores nothing.
 */
import { isEnd } from '../module/stages';
import { t } from '../words/words';
import { byId, byIdAs, make, wantsStill } from '../base/dom';
import { alertOf, clear } from '../base/messages';
import { Arrivals } from '../state/arrivals';
import { Engine } from '../state/engine';
import { fragment, pageAddress } from '../state/link';
import { read, written } from '../state/asked-view';
import { isPicture, wantsFine } from '../state/fine';
import { joined, parted, WHOLE, type Camera } from '../state/viewing';
import type { Fine } from '../look/fine';
import type { LocalFrames } from '../turn/local';
import type { Place, Turntable } from '../turn/turntable';
import { layInFrame } from '../picture/frame';
import { Loop } from '../picture/loop';
import { Until } from '../picture/until';
import { scriptFace, type ScriptFace } from './scripts';
import { tellCrash } from './trouble';
import '../styles/late/embed.css';

export class Embed {
  readonly scripts: ScriptFace;
  private readonly canvas = byIdAs('canvas', HTMLCanvasElement);
  private readonly context = this.canvas.getContext('2d');
  private readonly button = make('button', { type: 'button', class: 'embed-play' });
  private readonly home = make('a', { class: 'embed-home', target: '_blank', rel: 'noopener' }, 'Bubblestone');
  private readonly engine: Engine;
  private readonly loop: Loop;
  private readonly still = wantsStill();
  /** The view and its overlays, in the module's words. */
  private view = 'auto';
  private zoom = WHOLE;
  /** Smooths the finished picture. It is loaded later; without it the plain picture stays. */
  private fine: Fine | undefined;
  private refining = !wantsFine();
  /** The camera of the turntable; undefined while the picture is shown. */
  private camera: Camera | undefined;
  /** The turntable of a picture's bodies, and that of generators seen by frames only. */
  private slant: Turntable | undefined;
  private own: Turntable | undefined;
  private frames: LocalFrames | undefined;

  constructor() {
    const { recipe, words } = parted(fragment());
    const engine = (this.engine = new Engine(recipe, (error, link) => {
      document.documentElement.dataset['stage'] = 'error';
      tellCrash(error, link);
    }));
    const loop = (this.loop = new Loop(engine, (stage) => this.shownAt(stage), (stage, changed) => this.drawn(stage, changed)));
    this.scripts = scriptFace(engine, () => loop.rests, () => this.camera);
    byId('sheet').append(make('h1', { class: 'said' }, 'Bubblestone'), this.button, this.home);
    this.button.addEventListener('click', () => this.toggle());
    const arrivals = new Arrivals();
    addEventListener('hashchange', () => {
      const { recipe, words } = parted(fragment());
      arrivals.reach(recipe, () => {
        engine.open(recipe);
        if (engine.alive) clear('trouble');
        this.opened(words);
        // A held step is reached from the start.
        if (loop.until) engine.restart();
      });
    });
    this.opened(words);
  }

  /** The view of a stage. Visitors who prefer reduced motion see only finished or paused pictures. */
  private shownAt(stage: string): string | undefined {
    return !this.still || isEnd(stage) || this.loop.paused ? this.view : undefined;
  }

  private drawn(stage: string, changed: boolean): void {
    const { canvas, context, engine, scripts } = this;
    document.documentElement.dataset['stage'] = stage;
    const view = this.shownAt(stage);
    if (context && changed && view && !engine.offers('frames')) {
      if (canvas.width !== engine.side()) canvas.width = canvas.height = engine.side();
      engine.draw(context, view);
    }
    if (stage === 'done') scripts.done();
    if (stage === 'done') this.refine();
    this.fine?.follow();
    if (stage === 'error') {
      alertOf('trouble', engine.problem());
      scripts.failed(engine.problem());
    }
    this.name(stage);
  }

  private refine(): void {
    if (this.refining) return;
    this.refining = true;
    const { canvas, engine } = this;
    import('../look/fine').then(
      ({ Fine }) =>
        (this.fine = new Fine(canvas, () => {
          const isPlain = isPicture(this.view) && engine.stage() === 'done' && !this.camera && !engine.offers('frames');
          return isPlain ? { link: engine.link(), side: engine.side(), zoom: this.zoom.scale } : undefined;
        })),
      () => undefined,
    );
  }

  private toggle(): void {
    const { engine, loop } = this;
    if (isEnd(engine.stage())) {
      loop.until = undefined;
      engine.restart();
      loop.paused = false;
      loop.changed();
    } else loop.paused = !loop.paused;
    this.name(engine.stage());
  }

  /** Updates the button's name to its present action. */
  private name(stage: string): void {
    const does = this.loop.paused || isEnd(stage) ? 'play' : 'pause';
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
    const { engine, loop } = this;
    const isFramed = engine.offers('frames');
    this.camera = camera;
    document.documentElement.dataset['offers'] = engine.generator.offers.join(' ');
    const show = (): void => {
      const on = isFramed || this.camera !== undefined;
      const turntable = isFramed ? this.own : this.slant;
      // Beside frames of the engine itself, a small button is shown.
      this.button.hidden = on && !isFramed;
      for (const other of [this.own, this.slant]) if (other !== turntable) other?.toggle(false);
      loop.painter = isFramed ? this.frames : undefined;
      turntable?.toggle(on);
      turntable?.follow();
    };
    if (isFramed ? this.own : (this.slant ?? !camera)) return show();
    const place: Place = {
      generator: () => engine.generator,
      link: () => engine.link(),
      held: () => false,
      get: (key) => engine.get(key),
      camera: () => this.camera,
      take: (now) => (this.camera = now),
      ended: () => this.turn(undefined),
      alone: true,
    };
    const both = Promise.all([import('../turn/turntable'), isFramed ? import('../turn/local') : undefined]);
    both.then(
      ([{ Turntable }, local]) => {
        if (local) this.own ??= new Turntable({ ...place, frames: (heard) => (this.frames = new local.LocalFrames({ engine, loop, view: () => this.view }, heard)) });
        else this.slant ??= new Turntable(place);
        show();
      },
      () => undefined,
    );
  }

  private opened(words: string): void {
    const { engine, loop } = this;
    const { viewing } = read(words, engine.generator);
    const { view = 'auto', overlays = [], pace = 1, step, zoom = WHOLE, camera } = viewing;
    this.view = [view, ...overlays].join('+');
    this.home.href = pageAddress(joined(engine.link(), written(viewing, engine.generator)));
    layInFrame(byId('sheet'), (this.zoom = engine.offers('frames') ? WHOLE : zoom));
    this.turn(camera);
    this.fine?.follow();
    loop.stepsPerFrame = this.still ? Number.MAX_SAFE_INTEGER : pace;
    if (step !== undefined) {
      loop.paused = false;
      loop.until = new Until(step, () => this.name(engine.stage()));
    }
    loop.changed();
  }
}
