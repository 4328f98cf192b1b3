/**
 * The names of all saved files: bubblestone-NAME-SEED[-SIZE][-VARIANT].ENDING.
 *
 * NAME is the English name that the page shows: that of the preset, else of the outline or shape, else of the model's
 * file. It is the same in all languages.
 */
import { moduleFor } from '../module/load';
import type { Preset } from '../module/types';
import type { Engine } from '../state/engine';
import { telling } from '../state/name';
import { filesOf } from '../state/rules';
import type { Store } from '../state/store';
import { fileName, type Kind } from './file-name';

export function nameOf(engine: Engine, store: Store, kind: Kind): string {
  const { preset, recipe } = store.state;
  const name = (preset?.recipe === recipe && presetName(engine, preset.shown)) || modelName(engine) || firstName(engine) || engine.generator.word;
  return fileName(name, engine.get('seed'), kind);
}

/** The preset's English title. */
function presetName(engine: Engine, { name }: Preset): string {
  const preset = moduleFor(engine.link())?.presets(engine.generator.word).find((one) => one.name === name);
  return preset ? preset.title || preset.figure : name;
}

/** The name of the model's file, without its ending. */
function modelName(engine: Engine): string {
  const [file] = filesOf(engine).length ? engine.files() : [];
  return file?.name.replace(/\.\w+$/, '') ?? '';
}

/** The English name of the value that describes a recipe best; of the parameter, if the value is a number. */
function firstName(engine: Engine): string {
  const [first] = telling(engine);
  if (!first) return '';
  const row = moduleFor(engine.link())?.schema(engine.generator.word).find(({ key }) => key === first.key);
  const value = engine.get(first.key);
  return row?.choices.find(({ word }) => word === value)?.label ?? row?.name ?? first.key;
}
