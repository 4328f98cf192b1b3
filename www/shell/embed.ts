/** The picture alone, for other pages: a click pauses and plays, a link in the corner opens the whole page. It stores nothing. */
import { isEnd } from '../module/stages';
import { t } from '../words/words';
import { byId, byIdAs, make, wantsStill } from '../base/dom';
import { alertOf, clear } from '../base/messages';
import { Arrivals } from '../state/arrivals';
import { Engine } from '../state/engine';
import { fragment, pageAddress } from '../state/link';
import { Loop } from '../picture/loop';
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

  constructor() {
    const engine = (this.engine = new Engine(fragment(), (error, link) => {
      document.documentElement.dataset['stage'] = 'error';
      tellCrash(error, link);
    }));
    const loop = (this.loop = new Loop(engine, (stage) => this.shownAt(stage), (stage, changed) => this.drawn(stage, changed)));
    this.scripts = scriptFace(engine, () => loop.rests);
    byId('sheet').append(make('h1', { class: 'said' }, 'Bubblestone'), this.button, this.home);
    if (this.still) loop.stepsPerFrame = Number.MAX_SAFE_INTEGER;
    this.button.addEventListener('click', () => this.toggle());
    const arrivals = new Arrivals();
    addEventListener('hashchange', () => {
      const link = fragment();
      arrivals.reach(link, () => {
        engine.open(link);
        if (engine.alive) clear('trouble');
        this.opened();
      });
    });
    this.opened();
  }

  /** Who asks for less motion sees finished pictures only. */
  private shownAt(stage: string): string | undefined {
    return !this.still || isEnd(stage) ? 'auto' : undefined;
  }

  private drawn(stage: string, changed: boolean): void {
    const { canvas, context, engine, scripts } = this;
    document.documentElement.dataset['stage'] = stage;
    const view = this.shownAt(stage);
    if (context && changed && view) {
      if (canvas.width !== engine.side()) canvas.width = canvas.height = engine.side();
      engine.draw(context, view);
    }
    if (stage === 'done') scripts.done();
    if (stage === 'error') {
      alertOf('trouble', engine.problem());
      scripts.failed(engine.problem());
    }
    this.name(stage);
  }

  private toggle(): void {
    const { engine, loop } = this;
    if (isEnd(engine.stage())) {
      engine.restart();
      loop.paused = false;
      loop.changed();
    } else loop.paused = !loop.paused;
    this.name(engine.stage());
  }

  /** The button says what it does now. */
  private name(stage: string): void {
    const word = t(this.loop.paused || isEnd(stage) ? 'play' : 'pause');
    if (this.button.title === word) return;
    this.button.title = word;
    this.button.setAttribute('aria-label', word);
  }

  private opened(): void {
    this.home.href = pageAddress(this.engine.link());
    this.loop.changed();
  }
}
