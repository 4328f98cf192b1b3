/** Describes a recipe without a name by the values of its controls. */
import { t } from '../words/words';
import type { Engine } from '../state/engine';
import { telling } from '../state/name';
import { shown } from '../panel/shown';

export function described(engine: Engine): string {
  const labels = telling(engine).map((parameter) => shown(parameter, engine.get(parameter.key)));
  return t('own_recipe', { what: labels.join(' · ') });
}
