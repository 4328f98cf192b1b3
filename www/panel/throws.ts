/** New values by chance, for the dice of the panel. */
import type { Parameter } from '../module/types';
import { t } from '../words/words';
import { make } from '../base/dom';
import { clear, offerOf } from '../base/messages';
import { valuesIn } from '../state/link';
import { isLocked } from '../state/locks';
import { recipeOf } from '../state/rules';
import type { Work } from '../state/work';
import { thrown } from './chance';
import { drawnIn } from './drawn';
import { CHANCES } from './ranges';
import { SEED } from './seed';

/** The group of patterns, and the keys of colours in other groups. */
const PATTERNS = 'Colour';
const PAINTS = ['palette', 'vary', 'ground', 'f1', 'f2', 'f3', 'f4'];

/** New colours alone. `push` is called before the change. */
export function colours(work: Work, push: () => void): void {
  const { schema } = work.engine;
  const isPaint = ({ key, group }: Parameter): boolean => group === PATTERNS || PAINTS.includes(key);
  const stay = drawn(work);
  for (const row of schema) if (!isPaint(row)) stay.add(row.key);
  const values = thrownIn(work, [...new Set(schema.filter(isPaint).map(({ group }) => group))], stay);
  push();
  work.setAll(values);
}

/** New values for these groups. The visitor's own work stays, unless `all` is true. */
export function groups(work: Work, push: () => void, names: readonly string[], all = false): void {
  const { engine, store } = work;
  const free = names.filter((group) => !isLocked(store, group));
  const stay = all ? new Set<string>() : drawn(work);
  const values = thrownIn(work, free, stay);
  if (names.length > 1 && !isLocked(store, SEED)) values.push([SEED, String(engine.randomSeed())]);
  push();
  work.setAll(values);
  if (engine.schema.some(({ key, kind, group }) => kind === 'text' && stay.has(key) && free.includes(group))) tellKept(() => groups(work, push, names, true));
  // After all groups were randomised, the recipe no longer belongs to its preset.
  if (names.length > 1) store.update({ preset: undefined });
}

/** The keys of the visitor's own work: what the recipe's preset does not have. */
function drawn({ engine, store }: Work): Set<string> {
  return drawnIn(recipeOf(engine), valuesIn(store.state.preset?.recipe ?? ''));
}

function thrownIn({ engine }: Work, names: readonly string[], stay: ReadonlySet<string>): [key: string, text: string][] {
  return thrown(CHANCES[engine.generator.chance] ?? {}, Math.random, names, engine.schema, (key) => engine.get(key), stay);
}

/** Says that the visitor's own work was kept, and offers new values for it, too. */
function tellKept(again: () => void): void {
  const too = make('button', { type: 'button', id: 'throw-drawn' }, t('throw_drawn'));
  too.addEventListener('click', () => {
    clear('value');
    again();
  });
  offerOf('value', t('drawn_kept'), too);
}
