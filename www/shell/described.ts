/** A recipe that has no name, in the words of its controls. */
import { t } from '../words/words';
import type { Engine } from '../state/engine';
import { shown } from '../panel/control';

export function described(engine: Engine): string {
  const keys = [engine.isSpace ? 'form' : engine.get('tile') === '1' ? 'tile' : 'outline', 'kind', 'stone', 'palette'];
  const labels = engine.schema.filter(({ key }) => keys.includes(key)).map((parameter) => shown(parameter, engine.get(parameter.key)));
  return t('own_recipe', { what: labels.join(' · ') });
}
