/** The timeline, the handles and the text of a figure as HTML. The build writes them, so that nothing shifts when they work. */
import type { ChoiceHandle, Figure, Handle, Language, NumberHandle, PointHandle, Words } from '../figures/figure';

export const TOOL_WORDS = {
  time: { en: 'Timeline', ja: 'タイムライン' },
  again: { en: 'Start again', ja: '最初に戻す' },
  back: { en: 'Step back', ja: '一歩戻る' },
  on: { en: 'Step on', ja: '一歩進む' },
  play: { en: 'Play', ja: '再生' },
  pause: { en: 'Pause', ja: '一時停止' },
  speed: { en: 'Speed', ja: '速さ' },
  stops: { en: 'Stops', ja: '見どころ' },
  more: { en: 'More handles', ja: 'ほかの値' },
} as const satisfies Record<string, Words>;

const ICONS = { again: 'M4 3v10M13 3v10L6 8z', back: 'M10.5 3.5L6 8l4.5 4.5', on: 'M5.5 3.5L10 8l-4.5 4.5', play: 'M5 3v10l8-5z', pause: 'M5 3v10M11 3v10' };

/** The speeds, as factors. */
const SPEEDS = [['0.5', '½×'], ['1', '1×'], ['2', '2×'], ['4', '4×']] as const;

export function icon(name: keyof typeof ICONS): string {
  return `<svg class="icon icon-${name}" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="${ICONS[name]}"/></svg>`;
}

export function stepWords({ steps }: Figure, step: number, last: number, language: Language): string {
  if (steps === 'walk') return `${Math.round((360 * step) / last)}° ${language === 'ja' ? '/' : 'of'} 360°`;
  if (steps === 'layer') return language === 'ja' ? `${step + 1} / ${last + 1} 枚目` : `${step + 1} of ${last + 1}`;
  return language === 'ja' ? `${step} / ${last} ステップ` : `step ${step} of ${last}`;
}

/** The values of handles, the present step, and the last one. */
export interface Standing {
  readonly step: number;
  readonly last: number;
  readonly value: (key: string) => string;
  /** The points of a handle, in shares of the picture's side. */
  readonly points: (handle: PointHandle) => readonly (readonly [number, number])[];
}

export function toolsOf(figure: Figure, language: Language, standing: Standing): string {
  return `${timeline(figure, language, standing)}${handles(figure, language, standing)}`;
}

function key(name: 'again' | 'back' | 'on', language: Language): string {
  const words = TOOL_WORDS[name][language];
  return `<button type="button" class="time-key" data-do="${name}" aria-label="${words}" title="${words}">${icon(name)}</button>`;
}

function timeline(figure: Figure, language: Language, { step, last }: Standing): string {
  const w = (name: keyof typeof TOOL_WORDS): string => TOOL_WORDS[name][language];
  if (!figure.last) return `<div class="figure-time"><button type="button" class="time-key" data-do="again">${icon('again')}<span>${w('again')}</span></button></div>`;
  const play = `<button type="button" class="time-key play" data-do="play">${icon('play')}<span>${w('play')}</span></button>`;
  const range = `<div class="time-line"><div class="time-marks" aria-hidden="true"></div><input type="range" class="time" min="0" max="${last}" step="1" value="${step}" aria-label="${w('time')}"></div>`;
  const speed = `<select class="speed" aria-label="${w('speed')}">${SPEEDS.map(([value, words]) => `<option value="${value}"${value === '1' ? ' selected' : ''}>${words}</option>`).join('')}</select>`;
  const stops = figure.stops.map(({ key: stop, name }) => `<button type="button" data-stop="${stop}">${name[language]}</button>`).join('');
  return `<div class="figure-time" role="group" aria-label="${w('time')}">${key('again', language)}${key('back', language)}${play}${key('on', language)}${speed}${range}<output class="time-said">${stepWords(figure, step, last, language)}</output></div><div class="figure-stops" role="group" aria-label="${w('stops')}">${stops}</div>`;
}

function handles(figure: Figure, language: Language, standing: Standing): string {
  const all = (list: readonly Handle[]): string => list.map((handle) => handleOf(figure, handle, language, standing)).join('');
  const box = (list: readonly Handle[]): string => `<div class="handle-list${list.some(isNamed) ? ' named' : ''}">${all(list)}</div>`;
  const more = figure.more.length ? `<details class="more"><summary>${TOOL_WORDS.more[language]}</summary>${box(figure.more)}</details>` : '';
  return figure.handles.length ? `<div class="figure-handles">${box(figure.handles)}${more}</div>` : '';
}

function handleOf(figure: Figure, handle: Handle, language: Language, { value, points }: Standing): string {
  if (handle.kind === 'point') return pointHandle(handle, language, points(handle));
  return handle.kind === 'number' ? numberHandle(figure, handle, language, Number(value(handle.key))) : choice(figure, handle, language, value(handle.key));
}

/** A point's coordinates as they are shown. */
export function shownOf({ origin, scale }: PointHandle, point: readonly [number, number]): readonly [number, number] {
  return [(point[0] - origin[0]) / scale, (point[1] - origin[1]) / scale];
}

/** The rows of a list that a handle moves. */
export function rowsFor({ rows }: PointHandle, count: number): readonly number[] {
  return rows ?? Array.from({ length: count }, (_, row) => row);
}

/** The name of a point; points of a list have their numbers. */
export function pointName({ name }: PointHandle, language: Language, row: number, count: number): string {
  return count > 1 ? `${name[language]} ${row + 1}` : name[language];
}

/** A number for a box: 0 has no minus. */
export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** Two number boxes, and the choice of a point if there are several. */
function pointHandle(handle: PointHandle, language: Language, points: readonly (readonly [number, number])[]): string {
  const { key, name, from, to, digits } = handle;
  const rows = rowsFor(handle, points.length);
  const options = rows.map((row) => `<option value="${row}">${row + 1}</option>`).join('');
  const choice = rows.length > 1 ? `<select class="which" aria-label="${name[language]}">${options}</select>` : '';
  const shown = shownOf(handle, points[rows[0] ?? 0] ?? handle.origin);
  const boxes = (['x', 'y'] as const).map((axis, k) => `<label><i class="letter">${axis}</i> <input type="number" inputmode="decimal" data-axis="${k}" min="${from}" max="${to}" step="any" value="${fixed(shown[k] ?? 0, digits)}" aria-label="${name[language]} ${axis}"></label>`);
  return `<div class="handle point" data-key="${key}"><span class="handle-name">${name[language]}</span>${choice}${boxes.join('')}</div>`;
}

/** The name of a handle with its symbol. */
export function nameOf({ name, symbol }: NumberHandle, language: Language): string {
  return symbol ? `${name[language]} ${symbol}` : name[language];
}

/** The symbols of the equations, by the letters of handles. */
const SYMBOLS: Readonly<Record<string, string>> = { w: 'w', c: 'c', m: 'm', n: 'n', a: 'crowd', b: 'room', 'k₀': 'k0' };

function numberHandle({ name: figure }: Figure, handle: NumberHandle, language: Language, value: number): string {
  const letters = handle.symbol ? ` <i class="letter"${SYMBOLS[handle.symbol] ? ` data-symbol="${SYMBOLS[handle.symbol] ?? ''}"` : ''}>${handle.symbol}</i>` : '';
  const bounds = `min="${handle.from}" max="${handle.to}" step="any" value="${value.toFixed(handle.digits)}"`;
  const label = nameOf(handle, language);
  return `<div class="handle${isNamed(handle) ? ' named' : ''}" data-key="${handle.key}"><span class="handle-name">${handle.name[language]}${letters}</span><input type="range" ${bounds}${handle.marks ? ` list="${figure}-${handle.key}"` : ''} aria-label="${label}"><input type="number" inputmode="decimal" ${bounds} aria-label="${label}">${marksOf(figure, handle)}</div>`;
}

/** Whether values of a handle have a name. */
const isNamed = (handle: Handle): boolean => 'marks' in handle;

/** Ticks on the slider at the values that have a name, and buttons with these names, which stand in the equations for the handle. */
function marksOf(figure: string, { key: symbol, marks }: NumberHandle): string {
  if (!marks) return '';
  const ticks = `<datalist id="${figure}-${symbol}">${marks.map(({ value }) => `<option value="${value}"></option>`).join('')}</datalist>`;
  return `${ticks}${marks.map(({ value, name }) => `<button type="button" class="mark-key" data-symbol="${symbol}" data-value="${value}">${name}</button>`).join('')}`;
}

function choice(figure: Figure, handle: ChoiceHandle, language: Language, value: string): string {
  const buttons = handle.choices.map(({ word, name }) => `<label><input type="radio" name="${figure.name}-${handle.key}" value="${word}"${word === value ? ' checked' : ''}><span>${name[language]}</span></label>`);
  return `<fieldset class="handle choice" data-key="${handle.key}"><legend>${handle.name[language]}</legend><div class="options">${buttons.join('')}</div></fieldset>`;
}
