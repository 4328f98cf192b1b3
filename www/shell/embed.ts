/** The picture alone, for other pages: a click pauses and plays, a link in the corner opens the whole page. It stores nothing. */
import { isEnd } from '../module/stages';
import { t } from '../words/words';
import { byId, byIdAs, make, wantsStill } from '../base/dom';
import { alertOf } from '../base/messages';
import { Engine } from '../state/engine';
import { fragment, pageAddress } from '../state/link';
import { Loop } from '../picture/loop';
import { scriptFace, type Bubblestone } from './scripts';
import { tellCrash } from './trouble';
import '../styles/late/embed.css';

export function embed(): Bubblestone {
  const canvas = byIdAs('canvas', HTMLCanvasElement);
  const context = canvas.getContext('2d');
  const still = wantsStill();
  const engine = new Engine(fragment(), (error, link) => {
    document.documentElement.dataset['stage'] = 'error';
    tellCrash(error, link);
  });
  const scripts = scriptFace(engine, () => loop.rests);
  const button = make('button', { type: 'button', class: 'embed-play' });
  const home = make('a', { class: 'embed-home', target: '_blank', rel: 'noopener' }, 'Bubblestone');
  byId('sheet').append(make('h1', { class: 'said' }, 'Bubblestone'), button, home);

  const shownAt = (stage: string): string | undefined => (!still || isEnd(stage) ? 'auto' : undefined);
  const loop = new Loop(engine, shownAt, (stage, changed) => {
    document.documentElement.dataset['stage'] = stage;
    const view = shownAt(stage);
    if (context && changed && view) {
      if (canvas.width !== engine.side()) canvas.width = canvas.height = engine.side();
      engine.draw(context, view);
    }
    if (stage === 'done') scripts.done();
    if (stage === 'error') {
      alertOf('trouble', engine.problem());
      scripts.failed(engine.problem());
    }
    say(stage);
  });
  const say = (stage: string): void => {
    const word = t(loop.paused || isEnd(stage) ? 'play' : 'pause');
    if (button.title === word) return;
    button.title = word;
    button.setAttribute('aria-label', word);
  };
  if (still) loop.stepsPerFrame = Number.MAX_SAFE_INTEGER;
  button.addEventListener('click', () => {
    if (isEnd(engine.stage())) {
      engine.restart();
      loop.paused = false;
      loop.changed();
    } else loop.paused = !loop.paused;
    say(engine.stage());
  });
  const opened = (): void => {
    home.href = pageAddress(engine.link());
    loop.changed();
  };
  engine.arrived = (sentences, failed) => {
    if (failed) alertOf('trouble', sentences.join(' '));
    opened();
  };
  addEventListener('hashchange', () => {
    engine.open(fragment());
    opened();
  });
  opened();
  return scripts.face;
}
