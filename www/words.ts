/** The page's words in the visitor's language. All of them stand in strings/; English is at hand, others come when asked for. */
import { byIdAs } from './dom';
import { choiceOf, choose } from './memory';
import type { Notice, Parameter, Preset } from './module/types';
import { words as english } from './strings/en.json';
import type { Foreign } from './strings/foreign';

export type Word = keyof typeof english;

let words: Record<Word, string> = english;
let foreign: Foreign | undefined;

/** The code of the language in use. */
export function language(): string {
  return document.documentElement.lang;
}

/** The words of a key, with `{name}` replaced by values. */
export function t(key: Word, values: Record<string, string | number> = {}): string {
  return filled(words[key], values);
}

/** The same for words that come later, in all languages, with what says them. */
export function wordsOf<Key extends string>(by: { en: Record<Key, string>; ja: Record<Key, string> }) {
  return (key: Key, values: Record<string, string | number> = {}): string => filled(by[language() === 'ja' ? 'ja' : 'en'][key], values);
}

/** A text with `{name}` replaced by values. */
function filled(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}

/** Takes the language that was chosen here before, or the first one of the browser's that the page has. */
export async function takeLanguage(): Promise<void> {
  const wanted = [choiceOf('language'), ...navigator.languages].map((code) => code?.slice(0, 2));
  const known = [...byIdAs('language', HTMLSelectElement).options].map(({ value }) => value);
  if (wanted.find((code) => code && known.includes(code)) !== 'ja') return;
  const root = document.documentElement;
  // Other words would flash by, and what is around them would jump.
  root.toggleAttribute('data-wordless', true);
  try {
    const japanese = await import('./strings/ja');
    words = japanese.words;
    foreign = japanese.foreign;
    root.lang = 'ja';
    for (const element of document.querySelectorAll<HTMLElement>('[data-t]')) fill(element, japanese.page);
  } finally {
    root.toggleAttribute('data-wordless', false);
  }
}

/** Loads the page anew in another language; the work stays. */
export function speak(code: string): void {
  choose('language', code);
  location.reload();
}

/** `data-t="key title=other"`: the element's text, then attributes. */
function fill(element: HTMLElement, page: Record<string, string>): void {
  for (const part of (element.dataset['t'] ?? '').split(' ')) {
    const [name = '', key] = part.split('=');
    if (key === undefined) element.textContent = page[name] ?? '';
    else element.setAttribute(name, page[key] ?? '');
  }
}

/** A parameter with its names and help in the language in use. */
export function parameterIn(parameter: Parameter): Parameter {
  const own = foreign?.parameters[parameter.key];
  if (!foreign || !own) return parameter;
  return {
    ...parameter,
    name: own.name,
    help: own.help,
    unit: foreign.units[parameter.unit] ?? parameter.unit,
    choices: parameter.choices.map((choice) => ({ ...choice, label: own.choices?.[choice.word] ?? choice.label })),
  };
}

/** A group's title in the language in use. */
export function groupIn(group: string): string {
  return foreign?.groups[group] ?? group;
}

/** A preset with its title and note in the language in use. */
export function presetIn(preset: Preset): Preset {
  const own = foreign?.presets[preset.name];
  return foreign && own ? { ...preset, title: own.title || foreign.figure(preset.figure), note: own.note, figure: foreign.figure(preset.figure) } : preset;
}

/** What the module says, in the language in use. */
export function said(notice: Notice): string {
  return foreign?.said(notice) ?? notice.text;
}

/** What a paper calls a part of its work, in the language in use. */
export function partIn(name: string): string {
  return foreign?.parts[name] ?? name;
}
