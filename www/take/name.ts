/** What files of the work are called. */
import type { Engine } from '../state/engine';
import type { Store } from '../state/store';

export function nameOf(engine: Engine, store: Store, ending: string): string {
  const { preset, recipe, make: word } = store.state;
  const what = preset?.recipe === recipe ? preset.shown.name : engine.get('tile') === '1' ? 'tile' : engine.get('outline') || engine.get('form') || word;
  return `bubblestone-${what}-${engine.get('seed')}${ending}`;
}
