/** Handles for the sun, or the lamp, on the picture: to drag, or to move by arrow keys. Only the light is computed again. */
import { t } from '../words/look';
import { byId, make } from '../base/dom';
import { fixed } from '../base/fixed';
import { ARROWS } from '../late/arrows';
import { shape } from '../late/svg';
import type { Engine } from '../state/engine';
import { homeOf } from '../state/asked-view';
import { onStep } from '../state/scale';
import type { Store } from '../state/store';
import type { Work } from '../state/work';
import type { SheetPlace } from './zoom';
import '../styles/late/look.css';

/** Distance of the sun from the middle of the sheet when it is at the horizon, in sides. */
const HORIZON = 0.46;

/**
 * Distance of the lamp's bulb from its foot, in sides: a minimum, and an amount per side of the lamp's height. The bulb
 * is above the foot, but below it if the foot is nearer than UPPER to the upper edge.
 */
const POST = [0.07, 0.12] as const;
const UPPER = 0.16;

/** The step of an arrow key, in degrees and in sides of the picture. */
const TURN = 3;
const NUDGE = 0.02;

export class LightOnCanvas {
  private readonly work: Work;
  private readonly engine: Engine;
  private readonly store: Store;
  private readonly sheet = byId('sheet');
  private readonly layer = make('div', { class: 'light-layer' });
  /** Each line twice: the wider dark one below is its shadow. A filter would cost seconds if the processor draws the page. */
  private readonly lines = twice('line');
  private readonly horizons = twice('circle');
  private readonly sun = handle('sun', 'sun_place');
  private readonly foot = handle('lamp', 'lamp_place');
  private readonly bulb = handle('bulb', 'lamp_height');
  private readonly choice: HTMLElement;
  private readonly kinds: [string, HTMLInputElement][];
  /** The values to set in the next frame. */
  private waiting: Record<string, number> = {};
  private frame = 0;

  constructor(work: Work) {
    this.work = work;
    this.engine = work.engine;
    this.store = work.store;
    for (const horizon of this.horizons) place(horizon, { cx: 0.5, cy: 0.5, r: HORIZON });
    const svg = shape('svg', { viewBox: '0 0 1 1', 'aria-hidden': 'true' }, ...this.horizons, ...this.lines);
    this.kinds = [
      ['parallel', make('input', { type: 'radio', name: 'light-kind' })],
      ['point', make('input', { type: 'radio', name: 'light-kind' })],
    ];
    const [sun, lamp] = this.kinds.map(([kind, radio]) => {
      radio.addEventListener('change', () => work.set('light', kind));
      return radio;
    });
    this.choice = make(
      'fieldset',
      { class: 'segments light-kinds' },
      make('legend', { class: 'said' }, t('light_which')),
      ...[[sun, t('sun')] as const, [lamp, t('lamp')] as const].map(([radio, word]) => make('label', {}, ...(radio ? [radio] : []), make('span', {}, word))),
    );
    this.layer.append(svg, this.sun, this.foot, this.bulb);
    this.layer.hidden = true;
    this.sheet.append(this.choice);
    this.dragged(this.sun, (at) => this.aim(at));
    this.dragged(this.foot, ({ x, y }) => this.put({ lx: x, ly: y }));
    this.dragged(this.bulb, ({ y }) => this.put({ lz: ((y - this.footAt().y) * this.upwards() - POST[0]) / POST[1] }));
    this.keys(this.sun, (dx, dy) => ({ az: (this.number('az') + dx * TURN + 360) % 360, el: this.number('el') - dy * TURN }));
    this.keys(this.foot, (dx, dy) => ({ lx: this.number('lx') + dx * NUDGE, ly: this.number('ly') + dy * NUDGE }));
    this.keys(this.bulb, (dx, dy) => ({ lz: this.number('lz') + (dx - dy) * NUDGE }));
    this.store.on(['recipe', 'turn', 'camera'], () => this.place());
    for (const place of [this.layer, this.choice]) {
      place.addEventListener('keydown', ({ key }) => {
        if (key !== 'Escape') return;
        byId('light-button').focus();
        this.store.update({ light: false });
      });
    }
  }

  show(on: boolean): void {
    this.layer.hidden = this.choice.hidden = !on;
    this.place();
  }

  private number(key: string): number {
    return this.waiting[key] ?? Number(this.engine.get(key));
  }

  private footAt(): SheetPlace {
    const inside = (v: number): number => Math.min(Math.max(v, 0.02), 0.98);
    return { x: inside(this.number('lx')), y: inside(this.number('ly')) };
  }

  /** The rotation of the picture on the screen, in degrees. */
  private round(): number {
    const { turn, camera } = this.store.state;
    return turn ? (camera ?? homeOf(this.engine.generator))[0] : 0;
  }

  private upwards(): 1 | -1 {
    return this.footAt().y < UPPER ? 1 : -1;
  }

  /** Sets the light's direction and height from the pointer's place relative to the middle of the sheet. */
  private aim({ x, y }: SheetPlace): void {
    const far = Math.min(Math.hypot(x - 0.5, y - 0.5) / HORIZON, 1);
    const azimuth = (Math.atan2(y - 0.5, x - 0.5) * 180) / Math.PI + this.round();
    this.put({ az: (Math.round(azimuth) + 360) % 360, el: 90 - far * 90 });
  }

  /** Sets the latest values in the next frame, as a drag that has not ended. */
  private put(values: Record<string, number>): void {
    Object.assign(this.waiting, values);
    this.frame ||= requestAnimationFrame(() => this.hand(true));
  }

  private hand(held: boolean): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const values = Object.entries(this.waiting);
    this.waiting = {};
    for (const [key, value] of values) {
      const row = this.engine.schema.find((parameter) => parameter.key === key);
      if (row) this.work.write(key, String(onStep(row, value)), true);
    }
    if (!held) this.store.update({ held: false });
  }

  private dragged(element: HTMLElement, to: (at: SheetPlace) => void): void {
    let off: SheetPlace = { x: 0, y: 0 };
    const at = (event: PointerEvent): SheetPlace => {
      const box = this.layer.getBoundingClientRect();
      return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
    };
    element.addEventListener('pointerdown', (event) => {
      if (event.button) return;
      element.setPointerCapture(event.pointerId);
      const [box, layer] = [element.getBoundingClientRect(), this.layer.getBoundingClientRect()];
      const now = at(event);
      off = { x: (box.left + box.width / 2 - layer.left) / layer.width - now.x, y: (box.top + box.height / 2 - layer.top) / layer.height - now.y };
    });
    element.addEventListener('pointermove', (event) => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      const { x, y } = at(event);
      to({ x: x + off.x, y: y + off.y });
    });
    element.addEventListener('lostpointercapture', () => this.hand(false));
  }

  /** Arrow keys; with Shift, five times as far. The step ends when the key rises. */
  private keys(element: HTMLElement, to: (dx: number, dy: number) => Record<string, number>): void {
    element.addEventListener('keydown', (event) => {
      const way = ARROWS[event.key];
      if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const by = event.shiftKey ? 5 : 1;
      Object.assign(this.waiting, to(way[0] * by, way[1] * by));
      this.hand(true);
    });
    for (const end of ['keyup', 'blur']) element.addEventListener(end, () => this.store.state.held && this.hand(false));
  }

  /** Places handles and labels by the recipe's light. */
  private place(): void {
    if (this.layer.hidden) return;
    const kind = this.engine.get('light');
    for (const [word, radio] of this.kinds) radio.checked = word === kind;
    const lamp = kind === 'point';
    // The lamp has a place in the picture; the sun stands around the sheet.
    const over = lamp && !this.store.state.turn ? byId('pane') : this.sheet;
    if (this.layer.parentElement !== over) over.append(this.layer);
    this.sun.hidden = lamp;
    this.foot.hidden = this.bulb.hidden = !lamp;
    for (const horizon of this.horizons) horizon.toggleAttribute('hidden', lamp);
    if (lamp) this.placeLamp();
    else this.placeSun();
  }

  private placeSun(): void {
    const [az, el] = [this.number('az'), this.number('el')];
    const far = HORIZON * (1 - el / 90);
    const way = ((az - this.round()) * Math.PI) / 180;
    const at = { x: 0.5 + far * Math.cos(way), y: 0.5 + far * Math.sin(way) };
    stand(this.sun, at, az, [0, 360], t('sun_said', { az, el }));
    this.draw(at, { x: 0.5, y: 0.5 });
  }

  private placeLamp(): void {
    const [lx, ly, lz] = [this.number('lx'), this.number('ly'), this.number('lz')];
    const at = this.footAt();
    const top = { x: at.x, y: Math.max(at.y + this.upwards() * (POST[0] + POST[1] * lz), 0.02) };
    stand(this.foot, at, lx, [-1, 2], t('lamp_said', { x: fixed(lx, 2), y: fixed(ly, 2) }));
    stand(this.bulb, top, lz, [0.05, 2], t('lamp_height_said', { z: fixed(lz, 2) }));
    this.draw(top, at);
  }

  private draw(from: SheetPlace, to: SheetPlace): void {
    for (const line of this.lines) place(line, { x1: from.x, y1: from.y, x2: to.x, y2: to.y });
  }
}

function twice(name: 'line' | 'circle'): SVGElement[] {
  return [shape(name, { class: 'shade' }), shape(name)];
}

function place(element: SVGElement, values: Record<string, number>): void {
  for (const [name, value] of Object.entries(values)) element.setAttribute(name, String(value));
}

function handle(name: string, word: 'sun_place' | 'lamp_place' | 'lamp_height'): HTMLElement {
  return make('div', { class: `light-handle ${name}`, id: `light-${name}`, role: 'slider', tabindex: '0', 'aria-label': t(word) });
}

function stand(element: HTMLElement, { x, y }: SheetPlace, now: number, [from, to]: [number, number], said: string): void {
  element.style.left = `${100 * x}%`;
  element.style.top = `${100 * y}%`;
  element.setAttribute('aria-valuemin', String(from));
  element.setAttribute('aria-valuemax', String(to));
  element.setAttribute('aria-valuenow', String(now));
  element.setAttribute('aria-valuetext', said);
}
