/** The tool that cuts away all bodies beyond a plane, so that those behind it are seen. */
import { t } from '../words/turn';
import { make } from '../base/dom';
import { fixed } from '../base/fixed';
import { onSlide } from '../base/slide';
import type { Camera, Cut } from '../state/viewing';
import { towards } from './camera';

/** The least and greatest place of the plane from the middle of the bodies, in sides of the picture, and a step. */
const PLACES = { min: -0.7, max: 0.7, step: 0.01 };

/** The directions of the side that is cut away; the first one is that of the camera. */
const WAYS = ['here', 'x', 'y', 'z'] as const;
type Way = (typeof WAYS)[number];
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

interface Needs {
  camera(): Camera;
  /** Takes another plane, or `undefined`. `moving` while the slider is dragged. */
  take(cut: Cut | undefined, moving: boolean): void;
}

export class CutTool {
  readonly element: HTMLElement;
  private readonly needs: Needs;
  private readonly button = make('button', { type: 'button', class: 'key', id: 'turn-cut', title: t('cut_title') }, t('cut'));
  private readonly slider = make('input', { type: 'range', id: 'turn-cut-at', min: String(PLACES.min), max: String(PLACES.max), step: String(PLACES.step), 'aria-label': t('cut_at'), title: t('cut_at') });
  private readonly radios = WAYS.map((way) => make('input', { type: 'radio', name: 'turn-cut-way', value: way }));
  private readonly more: HTMLElement;
  private cut: Cut | undefined;

  constructor(needs: Needs) {
    this.needs = needs;
    const ways = this.radios.map((radio, k) => make('label', {}, radio, make('span', {}, t(`cut_${WAYS[k] ?? 'here'}`))));
    this.more = make('div', { class: 'turn-cut-more' }, this.slider, make('div', { class: 'segments', role: 'radiogroup', 'aria-label': t('cut_way') }, ...ways));
    this.element = make('div', { class: 'turn-cut' }, this.button, this.more);
    this.button.addEventListener('click', () => needs.take(this.cut ? undefined : this.plane('here'), false));
    // A click on the chosen direction takes that of the camera again.
    this.radios.forEach((radio, k) => radio.addEventListener('click', () => needs.take(this.plane(WAYS[k] ?? 'here'), false)));
    onSlide(this.slider, (last) => this.move(!last));
    // Events here are neither for the frame nor for the picture below.
    for (const sign of ['click', 'dblclick', 'pointerdown', 'pointermove', 'touchstart', 'keydown']) this.element.addEventListener(sign, (event) => event.stopPropagation());
    // The plane's usual place is in the middle.
    for (const at of ['--default', '--origin']) this.slider.style.setProperty(at, '0.5');
    this.show(undefined, true);
  }

  /** Shows the present plane, or that there is none. */
  show(cut: Cut | undefined, hidden: boolean): void {
    this.cut = cut;
    this.element.hidden = hidden;
    this.more.hidden = cut === undefined;
    this.button.setAttribute('aria-pressed', String(cut !== undefined));
    if (!cut) return;
    const now = wayOf(cut);
    for (const radio of this.radios) radio.checked = radio.value === now;
    if (Number(this.slider.value) !== cut[3]) this.slider.value = String(cut[3]);
    const { min, max } = PLACES;
    this.slider.style.setProperty('--place', String((Number(this.slider.value) - min) / (max - min)));
    this.slider.setAttribute('aria-valuetext', fixed(cut[3], 2));
  }

  private move(moving: boolean): void {
    const { cut } = this;
    if (cut) this.needs.take([cut[0], cut[1], cut[2], Number(this.slider.value)], moving);
  }

  /** The plane in the middle, or where it is now, with another direction. */
  private plane(way: Way): Cut {
    const [x, y, z] = way === 'here' ? towards(this.needs.camera()) : AXES[way];
    return [x, y, z, this.cut?.[3] ?? 0];
  }
}

function wayOf([x, y, z]: Cut): Way {
  const found = Object.entries(AXES).find(([, axis]) => axis[0] === x && axis[1] === y && axis[2] === z);
  return (found?.[0] as Way | undefined) ?? 'here';
}
