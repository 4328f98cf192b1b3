/** The name of a file of the work. */
import type { Engine } from '../state/engine';
import { wordOf } from '../state/name';
import type { Store } from '../state/store';

export function nameOf(engine: Engine, store: Store, ending: string): string {
  const { preset, recipe, make: word } = store.state;
  const what = preset?.recipe === recipe ? preset.shown.name : wordOf(engine) || word;
  return `bubblestone-${what}-${engine.get('seed')}${ending}`;
}
