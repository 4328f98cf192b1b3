/** The values of parameters in sentences. */
import type { Parameter } from '../module/types';
import { t } from '../words/words';

/** A value as text for a sentence. */
export function shown(parameter: Parameter, value: string): string {
  const choice = parameter.choices.find(({ word }) => word === value);
  if (parameter.kind === 'text') return t('none');
  return choice?.label ?? `${value}${parameter.unit && ` ${parameter.unit}`}`;
}
