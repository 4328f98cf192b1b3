/**
 * The page's words in its language. All are in strings/; English is always loaded.
 *
 * strings/en.json has two lists: `page`, which the build writes into the HTML, and `words`, which scripts use. Lazy
 * parts bring their own words. The module has the English of parameters and presets; other languages translate it by
 * key (strings/ja-module.ts). The module sends notices as a code with arguments; the tables in src/notice have their
 * words in all languages. Tests check that no word is missing.
 *
 * Each text that this file has given is remembered, with a function that gives it in the present language. So the words
 * on the page can change where they stand (base/retell.ts). The words of parameters and presets are getters for the
 * same reason.
 */
import type { Notice, Parameter, Preset } from '../module/types';
import { words as english } from '../strings/en.json';
import type { Foreign } from '../strings/foreign';

export type PageWord = keyof typeof english;

let words: Record<PageWord, string> = english;
let foreign: Foreign | undefined;

/** The most texts that are remembered. The oldest are forgotten first. If two look alike, the first one counts. */
const MOST = 10_000;
const given = new Map<string, () => string>();

function remembered(text: string, again: () => string): string {
  if (given.has(text)) return text;
  if (given.size >= MOST) given.delete(given.keys().next().value ?? '');
  given.set(text, again);
  return text;
}

/** A text that was given before, in the present language; undefined if it is unknown. */
export function again(text: string): string | undefined {
  return given.get(text)?.();
}

/** A value in the present language if it is a text that was given before; else the value itself. */
const anew = (value: string | number): string | number => (typeof value === 'string' ? (again(value) ?? value) : value);

/** The code of the page's language. */
export function language(): string {
  return document.documentElement.lang;
}

/** The words of a key, with `{name}` replaced by values. */
export function t(key: PageWord, values: Record<string, string | number> = {}): string {
  return remember(() => words[key], values);
}

/** Makes a function like `t` for a lazy part, which brings its words in both languages. */
export function wordsOf<Key extends string>(by: { en: Record<Key, string>; ja: Record<Key, string> }) {
  return (key: Key, values: Record<string, string | number> = {}): string => remember(() => by[language() === 'ja' ? 'ja' : 'en'][key], values);
}

/** Fills a pattern of the present language with values, and remembers the text. */
function remember(pattern: () => string, values: Record<string, string | number>): string {
  const text = filled(pattern(), values);
  // A text that is nothing but one of its values keeps the entry of that value.
  if (Object.values(values).includes(text)) return text;
  return remembered(text, () => remember(pattern, Object.fromEntries(Object.entries(values).map(([key, value]) => [key, anew(value)]))));
}

/** Remembers a word of the module; `word` gives it in the present language. */
function spoken(word: () => string): string {
  return remembered(word(), () => spoken(word));
}

/** A text with `{name}` replaced by values. */
function filled(text: string, values: Record<string, string | number>): string {
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}

/** Changes the language. Without `to`, the words are the English ones. */
export function translate(code: string, to?: { words: Record<PageWord, string>; foreign: Foreign }): void {
  words = to?.words ?? english;
  foreign = to?.foreign;
  document.documentElement.lang = code;
}

/** Adds translations of the second module's words. */
export function extend(more: Partial<Pick<Foreign, 'parameters' | 'presets' | 'groups' | 'notices'>>): void {
  if (!foreign) return;
  const { parameters, presets, groups, notices } = foreign;
  foreign = {
    ...foreign,
    parameters: { ...more.parameters, ...parameters },
    presets: { ...more.presets, ...presets },
    groups: { ...more.groups, ...groups },
    notices: { ...more.notices, ...notices },
  };
}

/** A stage's name in the page's language; its own word if it has no name. */
export function stageIn(word: string): string {
  return spoken(() => known(`stage_${word}`) ?? word);
}

/** A view's name in the page's language; its own word if it has no name. */
export function viewIn(word: string): string {
  return spoken(() => known(`view_${word}`) ?? word);
}

/** A generator's name in the page's language; the schema's `title` if the page has no words for it. */
export function makeIn(word: string, title: string): string {
  return spoken(() => foreign?.makes[word] ?? title);
}

function known(key: string): string | undefined {
  return (words as Partial<Record<string, string>>)[key];
}

/** A parameter with its names and help in the present language. */
export function parameterIn(generator: string, parameter: Parameter): Parameter {
  const { key, name, help, unit, choices } = parameter;
  const own = (): Foreign['parameters'][string] | undefined => foreign?.parameters[`${generator}.${key}`] ?? foreign?.parameters[key];
  return {
    ...parameter,
    get name() {
      return spoken(() => own()?.name ?? name);
    },
    get help() {
      return spoken(() => own()?.help ?? help);
    },
    get unit() {
      return unit && spoken(() => foreign?.units[unit] ?? unit);
    },
    choices: choices.map((choice) => ({
      ...choice,
      get label() {
        return spoken(() => own()?.choices?.[choice.word] ?? choice.label);
      },
    })),
  };
}

/** A group's title in the page's language. */
export function groupIn(group: string): string {
  return spoken(() => foreign?.groups[group] ?? group);
}

/** A preset with its title and note in the present language. */
export function presetIn(preset: Preset): Preset {
  const own = (): Foreign['presets'][string] | undefined => foreign?.presets[preset.name];
  const figureIn = (): string => (own() ? foreign?.figure(preset.figure) : undefined) ?? preset.figure;
  return {
    ...preset,
    get title() {
      return spoken(() => own()?.title || (own() ? figureIn() : preset.title));
    },
    get note() {
      return preset.note && spoken(() => own()?.note ?? preset.note);
    },
    get figure() {
      return preset.figure && spoken(figureIn);
    },
  };
}

/** A notice of the module in the page's language. */
export function said(notice: Notice): string {
  return spoken(() => foreign?.said(notice, foreign) ?? notice.text);
}

/** A paper's name for a part of its work, in the page's language. */
export function partIn(name: string): string {
  return spoken(() => foreign?.parts[name] ?? name);
}
