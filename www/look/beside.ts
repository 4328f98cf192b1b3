/**
 * Another picture beside the page's own. Both form in step, and a changed control changes both. Other values of the
 * second recipe stay as they are. Undo restores both.
 */
import { countedBy, isEnd } from '../module/stages';
import { t } from '../words/look';
import { byId, frame, make, say, wantsStill } from '../base/dom';
import type { Engine } from '../state/engine';
import { valuesIn } from '../state/link';
import type { Store } from '../state/store';
import type { Partner, Work } from '../state/work';
import type { PictureHost } from '../picture/host';
import { FRAMES, type Loop } from '../picture/loop';
import type { View } from '../picture/view';
import { Gestures, type Hands } from '../turn/gestures';
import { homeOf } from '../state/asked-view';
import { ALL_AROUND } from '../turn/camera';
import type { Way } from './way';
import { Together } from './together';
import { Zoom } from './zoom';
import '../styles/late/beside.css';

export class Beside implements Partner, Way {
  readonly sheet = make('div', { class: 'sheet', id: 'beside' });
  private readonly work: Work;
  private readonly store: Store;
  private readonly own: Loop;
  private readonly frame = byId('frame');
  private readonly canvas: HTMLCanvasElement;
  private readonly pane = make('div', { class: 'pane' });
  /** Lies over the frames, and receives the gestures that turn them. */
  private readonly grip = make('div', { class: 'beside-grip' });
  private readonly names = [make('p', { class: 'beside-name', id: 'beside-name' }), make('p', { class: 'beside-name own' })] as const;
  private host: PictureHost | undefined;
  /** The name of the other recipe, and the link that has this name. */
  private title = '';
  private link = '';
  /** For each recipe of the page, the other recipe that stood beside it, to restore it on Undo. */
  private readonly pairs = new Map<string, string>();
  /** The page's recipe after the last change. */
  private last = '';

  constructor(work: Work, view: View, own: Loop, canvas: HTMLCanvasElement) {
    this.work = work;
    this.store = work.store;
    this.own = own;
    this.canvas = canvas;
    this.sheet.append(this.pane);
    new Gestures(this.grip, this.hands(), false);
    new Zoom(this.store, () => undefined, this.sheet);
    // Two fingers zoom the pictures, not the page.
    this.sheet.addEventListener('touchstart', (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });
    this.store.on(['recipe'], () => this.goBack());
    this.store.on(['paused', 'pace'], (state) => this.host?.drive(state));
    view.drawn(() => this.tell());
  }

  show(on: boolean): void {
    this.frame.toggleAttribute('data-beside', on);
    if (on) {
      byId('sheet').before(this.sheet, this.names[0]);
      byId('sheet').after(this.names[1]);
      // On a phone, the new layout may leave the pictures small: scrolls to where they are large.
      void frame().then(() => byId('enlarge').hidden || byId('enlarge').click());
      return;
    }
    for (const element of [this.sheet, ...this.names]) element.remove();
    if (this.host) this.host.loop.pair = undefined;
    this.host = this.own.pair = this.work.partner = undefined;
    this.store.update({ other: 'done' });
  }

  /**
   * Shows this host beside the page's own picture. Both begin again; for visitors who prefer less motion, only this one
   * works.
   */
  take(host: PictureHost, title: string): void {
    const { canvas, grip, pane } = this;
    const { engine, loop } = (this.host = host);
    [this.title, this.link] = [title, engine.link()];
    canvas.removeAttribute('aria-hidden');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-labelledby', 'beside-name');
    if (engine.offers('frames')) pane.after(canvas, grip);
    else pane.append(canvas);
    grip.hidden = !engine.offers('frames');
    [loop.rhythm, loop.may] = [FRAMES, undefined];
    host.still = wantsStill();
    loop.pair = this.own.pair = new Together(this.work.engine, engine);
    this.work.partner = this;
    this.pairs.clear();
    this.remember();
    this.store.update({ other: engine.stage() });
    host.drive(this.store.state);
    // Visitors who prefer less motion see the present picture.
    if (wantsStill()) return;
    if (!isEnd(this.work.engine.stage())) return this.restart();
    this.work.restart();
    this.own.changed();
  }

  /** Gestures on either picture turn both. */
  private hands(): Hands {
    const { store } = this;
    const none = (): void => undefined;
    return {
      camera: () => store.state.camera ?? homeOf(this.host?.engine.generator ?? { home: '' }),
      heights: () => ALL_AROUND,
      take: (camera) => store.update({ camera }),
      home: () => store.update({ camera: undefined }),
      leave: none,
      tap: none,
      over: none,
      enter: none,
    };
  }

  /** A control has changed: copies the changed values to the other recipe, if it has these parameters. */
  follow(): void {
    const { host, last } = this;
    const own = this.work.engine;
    if (!host) return;
    const { engine } = host;
    const [before, now] = [new Set(valuesIn(last)), new Set(valuesIn(own.link()))];
    const keys = [...before, ...now].filter((pair) => before.has(pair) !== now.has(pair)).map((pair) => pair.replace(/=.*/s, ''));
    const known = new Set(engine.schema.map(({ key }) => key));
    for (const key of new Set(keys)) if (known.has(key)) engine.set(key, own.get(key));
    this.remember();
    host.changed();
  }

  step(): void {
    this.host?.step();
  }

  restart(): void {
    this.host?.restart();
  }

  /** The page has another recipe: restores the other recipe that stood beside it before. */
  private goBack(): void {
    const { host } = this;
    if (!host) return;
    const then = this.pairs.get(this.store.state.recipe);
    if (then === undefined || then === host.engine.link()) return this.tell();
    host.open(then);
    this.last = this.store.state.recipe;
  }

  private remember(): void {
    this.last = this.store.state.recipe;
    if (this.host) this.pairs.set(this.last, this.host.engine.link());
  }

  worked(stage: string): void {
    this.store.update({ other: stage });
    this.tell();
  }

  /** Writes the name and the counts below each picture. */
  private tell(): void {
    if (!this.host) return;
    const { engine } = this.host;
    const { preset, recipe } = this.store.state;
    const mine = preset ? named(preset.shown.figure || preset.shown.title, preset.recipe === recipe) : t('compare_mine');
    write(this.names[0], named(this.title, engine.link() === this.link), engine);
    write(this.names[1], mine, this.work.engine);
  }
}

function named(name: string, same: boolean): string {
  return same ? name : t('compare_after', { name });
}

function write(line: HTMLElement, name: string, engine: Engine): void {
  if (!line.firstChild) line.append(make('strong'), make('span'));
  const [title, counts] = line.children;
  if (title) say(title, name);
  if (counts) say(counts, engine.problem() || counted(engine));
}

/**
 * Counts and time. The time covers the stages up to the present one, because later stages still hold the times of the
 * previous picture.
 */
function counted(engine: Engine): string {
  const { cells, steps, ms } = engine.status();
  const { stages, offers } = engine.generator;
  const at = stages.indexOf(engine.stage());
  const spent = stages.slice(0, at < 0 ? stages.length : at + 1).reduce((sum, word) => sum + (ms[word] ?? 0), 0);
  const counts = { cells, steps, seconds: (spent / 1000).toFixed(2) };
  const counted = countedBy(engine.generator);
  return t(counted === 'cells' && offers.includes('forming') ? 'compare_counts' : `compare_${counted}`, counts);
}
