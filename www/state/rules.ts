/** Decides which parameters, and which tools of the editor, have an effect in a recipe. */
import type { Parameter } from '../module/types';
import type { Engine } from './engine';

/** A recipe's values, or those of a recipe in the making. */
export interface Recipe {
  readonly schema: readonly Parameter[];
  /** A parameter's value, or several where parts of the picture differ. */
  valuesOf(key: string): readonly string[];
  defaultOf(parameter: Parameter): string;
}

/** Whether a parameter has an effect: its rule in the schema holds, and so does that of the parameter in this rule. */
export function applies({ shownFor: rule }: Parameter, recipe: Recipe): boolean {
  if (!rule) return true;
  const other = recipe.schema.find(({ key }) => key === rule.key);
  if (!other) return false;
  const fits = (value: string): boolean => (rule.words.length ? rule.words.includes(value) : differs(other, value, recipe.defaultOf(other)));
  return recipe.valuesOf(rule.key).some(fits) && applies(other, recipe);
}

/** Whether a value differs from the default, however the number is written. */
export function differs({ kind }: Parameter, value: string, standard: string): boolean {
  return kind === 'number' || kind === 'int' ? Number(value) !== Number(standard) : value !== standard;
}

/** The parameters that name a file of the present recipe. */
export function filesOf(engine: Engine): Parameter[] {
  const recipe = recipeOf(engine);
  return recipe.schema.filter((row) => row.item === 'file' && applies(row, recipe));
}

/** The present recipe. The kind of cells includes the kinds of its parts. */
export function recipeOf(engine: Engine): Recipe {
  return {
    schema: engine.schema,
    valuesOf: (key) => (key === 'kind' ? kindsIn(engine) : [engine.get(key)]),
    defaultOf: (parameter) => engine.defaultOf(parameter),
  };
}

function kindsIn(engine: Engine): string[] {
  const words = engine.schema.find(({ key }) => key === 'kind')?.choices.map(({ word }) => word) ?? [];
  return [engine.get('kind'), ...engine.list('parts').map((row) => words[row[2] ?? 0] ?? '')];
}

/** Whether a tool has an effect now: parts need lines, and a tile has no outline. */
export function toolApplies(engine: Engine, tool: string): boolean {
  if (tool === 'parts') return engine.get('lines') !== '';
  if (tool === 'stretch') return kindsIn(engine).some((kind) => kind === 'rectangle' || kind === 'ellipse');
  return ['lines', 'strokes', 'spots'].includes(tool) || engine.get('tile') !== '1';
}
