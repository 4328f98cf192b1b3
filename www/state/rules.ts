/** What the recipe in use makes sense to be edited of it. */
import type { Engine } from './engine';

/** The kinds of cells in use, those of parts as well. */
export function kindsIn(engine: Engine): string[] {
  const words = engine.schema.find(({ key }) => key === 'kind')?.choices.map(({ word }) => word) ?? [];
  return [engine.get('kind'), ...engine.list('parts').map((row) => words[row[2] ?? 0] ?? '')];
}

/** Whether a tool does something now: parts need lines, a tile has no outline. */
export function applies(engine: Engine, tool: string): boolean {
  if (tool === 'parts') return engine.get('lines') !== '';
  if (tool === 'stretch') return kindsIn(engine).some((kind) => kind === 'rectangle' || kind === 'ellipse');
  return ['lines', 'strokes', 'spots'].includes(tool) || engine.get('tile') !== '1';
}
