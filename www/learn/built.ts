/** Figures for the build: their still pictures, the small ones of the glossary, and links to the studio. */
import { stillOf } from './draw/still';
import { termOf } from './draw/terms';
import { FIGURES, figureOf } from './figures/figures';

/** The studio's link with the state that a figure opens with. */
function studioLinkOf(name: string): string {
  const figure = figureOf(name);
  if (!figure) throw new Error(`There is no figure ${name}.`);
  return `v=1&${figure.recipe}&view=packed${figure.steps === 'step' ? `&step=${figure.opens}` : ''}`;
}

export { FIGURES, stillOf, studioLinkOf, termOf };
