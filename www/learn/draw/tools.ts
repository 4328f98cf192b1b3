/** The timeline, the handles and the text of a figure as HTML. The build writes them, so that nothing shifts when they work. */
import type { ChoiceHandle, Figure, Handle, Language, NumberHandle, Words } from '../figures/figure';

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

export function stepWords(figure: Figure, step: number, language: Language): string {
  if (figure.steps === 'layer') return language === 'ja' ? `${step + 1} / ${figure.last + 1} 枚目` : `${step + 1} of ${figure.last + 1}`;
  return language === 'ja' ? `${step} / ${figure.last} ステップ` : `step ${step} of ${figure.last}`;
}

/** `value` has the value of a handle by its key. */
export function toolsOf(figure: Figure, language: Language, value: (key: string) => string): string {
  return `${timeline(figure, language)}${handles(figure, language, value)}`;
}

function key(name: 'again' | 'back' | 'on', language: Language): string {
  const words = TOOL_WORDS[name][language];
  return `<button type="button" class="time-key" data-do="${name}" aria-label="${words}" title="${words}">${icon(name)}</button>`;
}

function timeline(figure: Figure, language: Language): string {
  const w = (name: keyof typeof TOOL_WORDS): string => TOOL_WORDS[name][language];
  const play = `<button type="button" class="time-key play" data-do="play">${icon('play')}<span>${w('play')}</span></button>`;
  const range = `<div class="time-line"><div class="time-marks" aria-hidden="true"></div><input type="range" class="time" min="0" max="${figure.last}" step="1" value="${figure.opens}" aria-label="${w('time')}"></div>`;
  const speed = `<select class="speed" aria-label="${w('speed')}">${SPEEDS.map(([value, words]) => `<option value="${value}"${value === '1' ? ' selected' : ''}>${words}</option>`).join('')}</select>`;
  const stops = figure.stops.map(({ key: stop, name }) => `<button type="button" data-stop="${stop}">${name[language]}</button>`).join('');
  return `<div class="figure-time" role="group" aria-label="${w('time')}">${key('again', language)}${key('back', language)}${play}${key('on', language)}${speed}${range}<output class="time-said">${stepWords(figure, figure.opens, language)}</output></div><div class="figure-stops" role="group" aria-label="${w('stops')}">${stops}</div>`;
}

function handles(figure: Figure, language: Language, value: (key: string) => string): string {
  const all = (list: readonly Handle[]): string => list.map((handle) => (handle.kind === 'number' ? numberHandle(handle, language, Number(value(handle.key))) : choice(figure, handle, language, value(handle.key)))).join('');
  const more = figure.more.length ? `<details class="more"><summary>${TOOL_WORDS.more[language]}</summary><div class="handle-list">${all(figure.more)}</div></details>` : '';
  return figure.handles.length ? `<div class="figure-handles"><div class="handle-list">${all(figure.handles)}</div>${more}</div>` : '';
}

/** The name of a handle with its symbol. */
export function nameOf({ name, symbol }: NumberHandle, language: Language): string {
  return symbol ? `${name[language]} ${symbol}` : name[language];
}

/** The symbols of the equations, by the letters of handles. */
const SYMBOLS: Readonly<Record<string, string>> = { w: 'w', c: 'c', m: 'm', 'k₀': 'k0' };

function numberHandle(handle: NumberHandle, language: Language, value: number): string {
  const letters = handle.symbol ? ` <i class="letter"${SYMBOLS[handle.symbol] ? ` data-symbol="${SYMBOLS[handle.symbol] ?? ''}"` : ''}>${handle.symbol}</i>` : '';
  const bounds = `min="${handle.from}" max="${handle.to}" step="any" value="${value.toFixed(handle.digits)}"`;
  const label = nameOf(handle, language);
  return `<div class="handle" data-key="${handle.key}"><span class="handle-name">${handle.name[language]}${letters}</span><input type="range" ${bounds} aria-label="${label}"><input type="number" inputmode="decimal" ${bounds} aria-label="${label}"></div>`;
}

function choice(figure: Figure, handle: ChoiceHandle, language: Language, value: string): string {
  const buttons = handle.choices.map(({ word, name }) => `<label><input type="radio" name="${figure.name}-${handle.key}" value="${word}"${word === value ? ' checked' : ''}><span>${name[language]}</span></label>`);
  return `<fieldset class="handle choice" data-key="${handle.key}"><legend>${handle.name[language]}</legend>${buttons.join('')}</fieldset>`;
}
