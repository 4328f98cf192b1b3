/** Describes a recipe without a name by its model's file and the values of its controls. */
import { t } from '../words/words';
import type { Engine } from '../state/engine';
import { telling } from '../state/name';
import { filesOf } from '../state/rules';
import { shown } from '../panel/shown';

export function described(engine: Engine): string {
  const labels = telling(engine).map((parameter) => shown(parameter, engine.get(parameter.key)));
  const files = filesOf(engine).length ? engine.files() : [];
  return t('own_recipe', { what: [...files.map(({ name }) => name), ...labels].join(' · ') });
}
