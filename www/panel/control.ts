/** One control of the panel: a label, the ways to change it, a reset, and its help. */
import type { Parameter } from '../module/types';
import { t } from '../words/words';
import { typedIn } from '../base/decimals';
import { make, say, symbol } from '../base/dom';
import { onSlide } from '../base/slide';
import { differs } from '../state/rules';
import { fromPlace, isLogarithmic, onStep, stepOf, toPlace } from '../state/scale';
import { shown } from './shown';
import { withPictures, type Pictures } from './pictured';

/**
 * A choice is a row of buttons if its labels, with SEGMENT_ROOM letters for the space around each, have at most this
 * many letters; else a list.
 */
const SEGMENT_LETTERS = 38;
const SEGMENT_ROOM = 4;

/** The key of the picture's side. */
export const SIDE = 'size';

/** Lists of these kinds are typed: commas between numbers, semicolons between rows. */
export const TYPED: readonly Parameter['item'][] = ['plan', 'opening', 'bubble'];

/** A slider runs from 0 to this. */
const PLACES = 1000;

export interface Control {
  readonly parameter: Parameter;
  readonly element: HTMLElement;
  /** Shows the value in the engine, and the present default. */
  show(value: string, standard: string): void;
}

/** `change` gets the new text; `last` is false while a slider is being dragged. */
export type Change = (key: string, text: string, last: boolean) => void;

interface ControlParts {
  inputs: HTMLElement[];
  show: (value: string, standard: string) => void;
}

/** Opens the editor over the canvas, or a file dialog. */
export type Edit = (parameter: Parameter) => void;

/** `pictures` are the small pictures of a choice's words. */
export function makeControl(parameter: Parameter, change: Change, edit: Edit, pictures?: Pictures): Control {
  const id = `p-${parameter.key}`;
  const { inputs, show } = waysOf(parameter, id, change, edit, pictures);
  const listed = inputs[0]?.tagName === 'SELECT';
  const numeric = parameter.kind === 'number' || parameter.kind === 'int';
  const name = make(numeric || listed ? 'label' : 'span', { class: 'name', id: `${id}-name` }, parameter.name);
  if (name instanceof HTMLLabelElement) name.htmlFor = id;
  if (parameter.symbol) name.append(' ', symbol(parameter.symbol));
  const reset = make('button', { type: 'button', class: 'reset' });
  const help = make('span', { class: 'said', id: `${id}-help` }, parameter.help);
  const element = make('div', { class: `control ${parameter.kind}${listed ? ' listed' : ''}`, 'data-key': parameter.key, title: parameter.help });
  element.append(name, reset, ...inputs, help);

  let known: string | undefined;
  const back = (): void => change(parameter.key, known ?? parameter.default, true);
  reset.addEventListener('click', () => {
    back();
    element.querySelector<HTMLElement>('input, select, .wide')?.focus();
  });
  for (const spot of [name, ...inputs.filter((input) => input.matches('[type=range]'))]) {
    spot.addEventListener('dblclick', (event) => {
      event.preventDefault();
      back();
    });
  }
  return {
    parameter,
    element,
    show: (value, standard) => {
      element.toggleAttribute('data-changed', differs(parameter, value, standard));
      if (standard !== known) {
        known = standard;
        reset.title = t('reset_title', { value: shown(parameter, standard) });
        reset.setAttribute('aria-label', t('reset', { name: parameter.name, value: shown(parameter, standard) }));
      }
      show(value, standard);
    },
  };
}

function waysOf(parameter: Parameter, id: string, change: Change, edit: Edit, pictures: Pictures | undefined): ControlParts {
  if (TYPED.includes(parameter.item)) return typedList(parameter, id, change);
  if (parameter.kind === 'text') return drawnList(parameter, id, edit);
  if (parameter.kind === 'choice') {
    if (pictures) return withPictures(segments(parameter, id, change), pictures);
    const letters = parameter.choices.reduce((sum, { label }) => sum + width(label) + SEGMENT_ROOM, 0);
    return letters > SEGMENT_LETTERS ? list(parameter, id, change) : segments(parameter, id, change);
  }
  return numberAndSlider(parameter, id, change);
}

/** A label's width in letters; kana and Chinese characters count twice. */
function width(label: string): number {
  return label.length + (label.match(/[\u3000-\u9fff]/g)?.length ?? 0);
}

function numberAndSlider(parameter: Parameter, id: string, change: Change): ControlParts {
  const { key, min, max, unit } = parameter;
  const box = make('input', {
    type: 'number',
    id,
    inputmode: min < 0 ? 'text' : 'decimal',
    min: String(min),
    max: String(max),
    step: String(stepOf(parameter)),
    'aria-describedby': `${id}-help ${id}-unit`,
  });
  const slider = make('input', {
    type: 'range',
    min: '0',
    max: String(PLACES),
    step: 'any',
    'aria-label': parameter.name,
    'aria-describedby': `${id}-help`,
  });
  const origin = String(toPlace(parameter, Math.max(min, 0)));
  slider.style.setProperty('--origin', isLogarithmic(parameter) ? '0' : origin);
  const value = make('span', { class: 'value' }, box, make('span', { class: 'unit', id: `${id}-unit` }, unit));
  const now = (): number => fromPlace(parameter, Number(slider.value) / PLACES);

  let held = '';
  box.addEventListener('change', () => {
    change(key, typedIn(box), true);
    // If the text was refused or clamped, shows the value that is in use.
    box.value = held;
  });
  whenMeant(slider, (last) => change(key, String(now()), last));
  slider.addEventListener('keydown', (event) => {
    const next = byKey(parameter, Number(box.value), event);
    if (next === undefined) return;
    event.preventDefault();
    change(key, String(next), true);
  });
  return {
    inputs: [value, slider],
    show: (text, standard) => {
      slider.style.setProperty('--default', String(toPlace(parameter, Number(standard))));
      const place = toPlace(parameter, Number(text));
      // A number that is being typed stays as it is. So does a dragged slider, if it means the same value.
      held = text;
      if (box.value !== text) box.value = text;
      if (now() !== Number(text) || document.activeElement !== slider) slider.value = String(place * PLACES);
      slider.style.setProperty('--place', String(place));
      slider.setAttribute('aria-valuetext', shown(parameter, text));
    },
  };
}

/**
 * A finger changes a slider's value only after it has moved this many pixels along the slider. A finger that scrolls
 * the page moves across the slider.
 */
const ALONG = 8;

/** Reports a slider's values, except those of a finger that only scrolls the page. */
function whenMeant(slider: HTMLInputElement, report: (last: boolean) => void): void {
  let open: { x: number; value: string } | undefined;
  let scrolled = false;
  slider.addEventListener('pointerdown', ({ pointerType, clientX }) => {
    open = pointerType === 'touch' ? { x: clientX, value: slider.value } : undefined;
    scrolled = false;
  });
  slider.addEventListener('pointermove', ({ clientX }) => {
    if (open && Math.abs(clientX - open.x) > ALONG) open = undefined;
  });
  slider.addEventListener('pointerup', () => (open = undefined));
  slider.addEventListener('pointercancel', () => {
    if (open) slider.value = open.value;
    scrolled = open !== undefined;
  });
  onSlide(slider, (last) => {
    if (!open && !scrolled) report(last);
  });
}

/**
 * The value after a key press: arrow keys move by the parameter's step, page keys by a tenth of the range, on any
 * scale of the slider.
 */
function byKey(parameter: Parameter, value: number, event: KeyboardEvent): number | undefined {
  const step = stepOf(parameter);
  const page = (way: number): number =>
    isLogarithmic(parameter)
      ? fromPlace(parameter, Math.min(1, Math.max(0, toPlace(parameter, value) + way / 10)))
      : onStep(parameter, value + (way * (parameter.max - parameter.min)) / 10);
  const fine = event.shiftKey ? 10 : 1;
  switch (event.key) {
    case 'ArrowRight':
    case 'ArrowUp':
      return onStep(parameter, value + step * fine);
    case 'ArrowLeft':
    case 'ArrowDown':
      return onStep(parameter, value - step * fine);
    case 'PageUp':
      return page(1);
    case 'PageDown':
      return page(-1);
    case 'Home':
      return parameter.min;
    case 'End':
      return parameter.max;
    default:
      return undefined;
  }
}

function list(parameter: Parameter, id: string, change: Change): ControlParts {
  const select = make('select', { id, 'aria-describedby': `${id}-help` });
  for (const { word, label } of parameter.choices) select.append(make('option', { value: word }, label));
  select.addEventListener('change', () => change(parameter.key, select.value, true));
  return { inputs: [select], show: (value) => void (select.value = value) };
}

function segments(parameter: Parameter, id: string, change: Change): ControlParts {
  const row = make('div', {
    class: 'segments',
    role: 'radiogroup',
    'aria-labelledby': `${id}-name`,
    'aria-describedby': `${id}-help`,
  });
  const radios = parameter.choices.map(({ word, label }) => {
    const radio = make('input', { type: 'radio', name: id, value: word });
    radio.addEventListener('change', () => change(parameter.key, word, true));
    row.append(make('label', {}, radio, make('span', {}, label)));
    return radio;
  });
  return {
    inputs: [row],
    show: (value) => {
      for (const radio of radios) radio.checked = radio.value === value;
    },
  };
}

/** A list that is edited over the canvas: its number of entries, and a button to edit them. */
function drawnList(parameter: Parameter, id: string, edit: Edit): ControlParts {
  const button = make('button', { type: 'button', class: 'wide', id, 'aria-labelledby': `${id}-name ${id}`, 'aria-describedby': `${id}-help` });
  button.addEventListener('click', () => edit(parameter));
  /** A file has a single entry and opens a file dialog. */
  const isFile = parameter.item === 'file';
  return {
    inputs: [button],
    // Dots separate the entries of a list's text.
    show: (value) => say(button, isFile ? t(value ? 'model_other' : 'model_open') : value ? t('list_edit', { n: value.split('.').length }) : t('list_add')),
  };
}

function typedList(parameter: Parameter, id: string, change: Change): ControlParts {
  const box = make('input', { type: 'text', class: 'wide', id, autocomplete: 'off', spellcheck: 'false', 'aria-labelledby': `${id}-name`, 'aria-describedby': `${id}-help` });
  box.addEventListener('change', () => change(parameter.key, box.value, true));
  return { inputs: [box], show: (value) => void (box.value = value) };
}
