/** Describes a recipe without a name by its model's file and the values of its controls. */
import { t } from '../words/words';
import type { Parameter } from '../module/types';
import type { Engine } from '../state/engine';
import { telling } from '../state/name';
import { filesOf } from '../state/rules';
import { shown } from '../panel/shown';

export function described(engine: Engine): string {
  const files = filesOf(engine).length ? engine.files() : [];
  // The name of a file says more than the choice "From a file".
  const isFile = ({ key }: Parameter): boolean =>
    files.length > 0 && engine.schema.some(({ item, shownFor }) => item === 'file' && shownFor?.key === key && shownFor.words.includes(engine.get(key)));
  const told = telling(engine).filter((parameter) => !isFile(parameter));
  const labels = told.map((parameter) => shown(parameter, engine.get(parameter.key)));
  return t('own_recipe', { what: [...files.map(({ name }) => name), ...labels].join(' · ') });
}
