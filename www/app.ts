/** The wiring: what happens when something on the page is changed, and what is shown of it. */
import { Controls } from './controls';
import { byId, say } from './dom';
import { Editing } from './editing';
import { Engine } from './engine';
import { Files } from './files';
import { bindKeys } from './keys';
import { address, Link } from './link';
import { Loop } from './loop';
import { alertOf, clear, notice, passing } from './messages';
import { OutlineTools } from './outline-tools';
import { Presets } from './presets';
import { scriptFace, type ScriptFace } from './scripts';
import { StatusLine } from './status';
import { Thumbs } from './thumbs';
import { Transport } from './transport';
import { tellCrash } from './trouble';
import type { Preset } from './types';
import { View, VIEWS } from './view';

export class App {
  private readonly engine: Engine;
  private readonly loop: Loop;
  private readonly link: Link;
  private readonly view: View;
  private readonly controls: Controls;
  private readonly presets: Presets;
  private readonly thumbs: Thumbs;
  private readonly transport: Transport;
  private readonly status = new StatusLine();
  private readonly editing: Editing;
  private readonly face: ScriptFace;
  /** The preset that was opened last, and the link that it gave. */
  private preset: { shown: Preset; link: string } | undefined;
  /** Visitors who asked for less motion see no cells move until they choose a speed. */
  private still = matchMedia('(prefers-reduced-motion: reduce)').matches;
  private stage = '';

  constructor(link: string) {
    this.engine = new Engine(link, (error, last) => this.crashed(error, last));
    this.face = scriptFace(this.engine);
    this.loop = new Loop(this.engine, (stage, changed) => this.drawn(stage, changed));
    this.view = new View(this.engine, () => this.loop.redraw());
    this.link = new Link((fragment) => this.open(fragment, false));
    this.editing = new Editing(this.engine, () => this.changed());
    this.controls = new Controls(this.engine.schema, {
      get: (key) => this.engine.get(key),
      defaultOf: (parameter) => this.engine.defaultOf(parameter),
      change: (key, text) => this.change(key, text),
      edit: (key) => this.editing.toggle(key),
      kinds: () => this.editing.sorts.kinds(),
    });
    const outline = new OutlineTools(this.engine, this.controls, this.editing);
    this.editing.shown = () => outline.show();
    this.presets = new Presets(this.engine.presets, {
      chosen: (preset) => this.choose(preset),
      moved: () => (this.thumbs as Thumbs | undefined)?.wake(),
    });
    this.thumbs = new Thumbs(this.presets.thumbs, () => this.stage === 'done' || this.loop.paused);
    this.transport = this.makeTransport();
    new Files(this.engine);
    this.bind();
    notice('link', ...this.engine.notices());
    this.recognise();
    this.changed();
  }

  /** What scripts may use. */
  scripts(): ScriptFace['face'] {
    return this.face.face;
  }

  private makeTransport(): Transport {
    const transport = new Transport({
      toggle: () => this.pause(!this.loop.paused),
      step: () => this.step(),
      restart: () => {
        this.engine.restart();
        this.loop.changed();
      },
      speed: (stepsPerFrame) => {
        this.still = false;
        this.loop.stepsPerFrame = stepsPerFrame;
      },
      seed: (text) => this.change('seed', text),
      dice: () => {
        this.engine.set('seed', String(this.engine.randomSeed()));
        this.changed(true);
      },
      copy: () => void this.copy(),
      save: () => void this.save(),
    });
    if (this.still) this.loop.stepsPerFrame = transport.fastest();
    return transport;
  }

  private bind(): void {
    const press = (id: string) => () => byId(id).click();
    bindKeys({
      ' ': press('play'),
      s: press('step'),
      '.': press('step'),
      r: press('restart'),
      d: press('dice'),
      c: press('copy'),
      e: () => this.editing.toggle(),
      '?': press('about-button'),
      ...Object.fromEntries(VIEWS.map(({ word }, index) => [String(index), () => (this.view.word = word)])),
    });
    byId('about-button').addEventListener('click', () => {
      byId('about').scrollIntoView({ behavior: this.still ? 'auto' : 'smooth' });
      byId('about').focus({ preventScroll: true });
    });
  }

  /** May come at any time, even while the engine is being made. */
  private crashed(error: unknown, link: string): void {
    this.stage = 'error';
    document.documentElement.dataset['stage'] = 'error';
    (this.face as ScriptFace | undefined)?.failed();
    tellCrash(error, link);
  }

  /** A control was moved. */
  private change(key: string, text: string): void {
    if (key === 'outline' && text === 'polygon') return this.editing.begin('outline');
    const sentence = this.engine.set(key, text);
    notice('value', ...(sentence ? [sentence] : []));
    if (key === 'outline' || key === 'tile' || key === this.editing.word) this.editing.follow();
    this.changed();
  }

  private choose(preset: Preset): void {
    this.editing.end();
    this.open(preset.link, true);
    this.preset = { shown: preset, link: this.engine.link() };
    this.pause(false);
    this.changed();
  }

  private open(fragment: string, push: boolean): void {
    notice('link', ...this.engine.open(fragment));
    clear('value');
    clear('outline');
    this.recognise();
    this.editing.follow();
    this.changed(push);
  }

  /** Finds the preset that the recipe in use is. */
  private recognise(): void {
    const link = this.engine.link();
    const shown = this.engine.presets.find((preset) => preset.link.replace(/^#/, '') === link);
    if (shown) this.preset = { shown, link };
  }

  /** Shows what the engine holds after any change, and lets it work on. */
  private changed(push = false): void {
    const link = this.engine.link();
    if (push) this.link.push(link);
    else this.link.replace(link);
    this.controls.refresh();
    this.editing.shown();
    this.presets.mark(this.preset?.link === link ? this.preset.shown.name : undefined);
    this.showTransport();
    this.loop.changed();
  }

  private pause(paused: boolean): void {
    this.loop.paused = paused;
    this.showTransport();
  }

  private showTransport(): void {
    this.transport.show(this.loop.paused, this.engine.get('seed'));
  }

  private step(): void {
    this.pause(true);
    const before = this.engine.status().steps;
    this.engine.step();
    if (this.engine.status().steps === before && this.engine.alive) {
      passing('done', 'The packing has settled: restart it (R) to step through it again.');
    }
    this.loop.redraw();
  }

  /** After each frame in which something was done. */
  private drawn(stage: string, changed: boolean): void {
    if (!this.engine.alive) return;
    if (changed && (!this.still || stage === 'done' || this.loop.paused)) this.view.draw();
    const status = this.engine.status();
    this.status.show(stage, status);
    this.status.name(this.view.note, this.preset?.shown, this.preset?.link !== this.engine.link(), stage, status);
    this.report(stage);
    if (stage === 'error') this.stuck();
    if (stage !== 'done') return;
    this.face.done();
    this.thumbs.wake();
  }

  /** This recipe gives no pavement; another one may. */
  private stuck(): void {
    const sentence = this.engine.problem();
    alertOf('trouble', sentence);
    this.face.failed(sentence);
  }

  /** Names the stage at work to scripts, and the end of the work to listeners. */
  private report(stage: string): void {
    if (stage === this.stage) return;
    if (this.stage === 'error') clear('trouble');
    this.stage = stage;
    document.documentElement.dataset['stage'] = stage;
    const { cells, steps } = this.engine.status();
    say(byId('live'), stage === 'done' ? `The picture is done: ${cells} cells after ${steps} steps.` : '');
  }

  private async copy(): Promise<void> {
    const link = this.engine.link();
    this.link.replace(link);
    try {
      await navigator.clipboard.writeText(address(link));
      passing('done', 'The link is copied.');
    } catch {
      notice('done', `The browser does not let a page copy. This is the link: ${address(link)}`);
    }
  }

  private async save(): Promise<void> {
    const name = ['bubblestone', this.view.word === 'auto' ? 'picture' : this.view.word, this.engine.get('outline'), this.engine.get('seed')];
    const saved = await this.view.save(name.join('-'));
    if (!saved) notice('done', 'The browser could not make a PNG file of the picture.');
  }
}
