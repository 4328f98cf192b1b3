/**
 * The page's words in its language. All are in strings/; English is always loaded.
 *
 * strings/en.json has two lists: `page`, which the build writes into the HTML, and `words`, which scripts use. Lazy parts
 * bring their own words. The module has the English of parameters and presets; other languages translate it by key
 * (strings/ja-module.ts). The module sends notices as a code with arguments; src/notice/words.txt has their words in all
 * languages. Tests check that no word is missing.
 */
import type { Notice, Parameter, Preset } from '../module/types';
import { words as english } from '../strings/en.json';
import type { Foreign } from '../strings/foreign';

export type Word = keyof typeof english;

let words: Record<Word, string> = english;
let foreign: Foreign | undefined;

/** The code of the page's language. */
export function language(): string {
  return document.documentElement.lang;
}

/** The words of a key, with `{name}` replaced by values. */
export function t(key: Word, values: Record<string, string | number> = {}): string {
  return filled(words[key], values);
}

/** The same for a lazy part, which brings its words in all languages. */
export function wordsOf<Key extends string>(by: { en: Record<Key, string>; ja: Record<Key, string> }) {
  return (key: Key, values: Record<string, string | number> = {}): string => filled(by[language() === 'ja' ? 'ja' : 'en'][key], values);
}

/** A text with `{name}` replaced by values. */
function filled(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}

/** Changes the language. */
export function translate(code: string, to: { words: Record<Word, string>; foreign: Foreign }): void {
  ({ words, foreign } = to);
  document.documentElement.lang = code;
}

/** A stage's name in the page's language; its own word if it has no name. */
export function stageIn(word: string): string {
  return known(`stage_${word}`) ?? word;
}

/** The same for a view. */
export function viewIn(word: string): string {
  return known(`view_${word}`) ?? word;
}

/** The same for a generator; the schema's title if the page has no words for it. */
export function makeIn(word: string, title: string): string {
  return foreign?.makes[word] ?? title;
}

function known(key: string): string | undefined {
  return (words as Partial<Record<string, string>>)[key];
}

/** A parameter with its names and help in the page's language. */
export function parameterIn(generator: string, parameter: Parameter): Parameter {
  const own = foreign?.parameters[`${generator}.${parameter.key}`] ?? foreign?.parameters[parameter.key];
  if (!foreign || !own) return parameter;
  return {
    ...parameter,
    name: own.name,
    help: own.help,
    unit: foreign.units[parameter.unit] ?? parameter.unit,
    choices: parameter.choices.map((choice) => ({ ...choice, label: own.choices?.[choice.word] ?? choice.label })),
  };
}

/** A group's title in the page's language. */
export function groupIn(group: string): string {
  return foreign?.groups[group] ?? group;
}

/** A preset with its title and note in the page's language. */
export function presetIn(preset: Preset): Preset {
  const own = foreign?.presets[preset.name];
  return foreign && own ? { ...preset, title: own.title || foreign.figure(preset.figure), note: own.note, figure: foreign.figure(preset.figure) } : preset;
}

/** A notice of the module in the page's language. */
export function said(notice: Notice): string {
  return foreign?.said(notice) ?? notice.text;
}

/** A paper's name for a part of its work, in the page's language. */
export function partIn(name: string): string {
  return foreign?.parts[name] ?? name;
}
