/** How the place 0..1 on a slider maps to a parameter's range, and how values are rounded. */
import type { Parameter } from '../module/types';

/** Ranges with this ratio of greatest to least, or more, get a logarithmic slider so that small values have room. */
const LOGARITHMIC_FROM = 12;

export function isLogarithmic(parameter: Parameter): boolean {
  return parameter.min > 0 && parameter.max / parameter.min >= LOGARITHMIC_FROM;
}

/** The place 0..1 of a value on its slider. */
export function toPlace(parameter: Parameter, value: number): number {
  const { min, max } = parameter;
  const place = isLogarithmic(parameter)
    ? Math.log(value / min) / Math.log(max / min)
    : (value - min) / (max - min);
  return Math.min(1, Math.max(0, place));
}

/** The value at a place 0..1 of the slider, on the parameter's step. */
export function fromPlace(parameter: Parameter, place: number): number {
  const { min, max } = parameter;
  const value = isLogarithmic(parameter) ? min * (max / min) ** place : min + (max - min) * place;
  return onStep(parameter, value);
}

/** The nearest value on the parameter's step, within its range. */
export function onStep(parameter: Parameter, value: number): number {
  const step = stepOf(parameter);
  const rounded = Number((Math.round(value / step) * step).toFixed(decimals(step)));
  return Math.min(parameter.max, Math.max(parameter.min, rounded));
}

export function stepOf(parameter: Parameter): number {
  return parameter.step > 0 ? parameter.step : parameter.kind === 'int' ? 1 : 0.01;
}

function decimals(step: number): number {
  return Math.max(0, (String(step).split('.')[1] ?? '').length);
}
