/** Figures for the build: their still pictures, the small ones of the glossary, and links to the studio. */
import { FIGURES, shownOf } from './draw/chapters';
import { stillOf } from './draw/still';
import { termOf } from './draw/terms';
import { studioWords } from './figure/address';

/** The studio's link with the state that a figure opens with. */
function studioLinkOf(name: string): string {
  const { figure } = shownOf(name);
  return `v=1&${studioWords(figure, { recipe: figure.recipe, step: figure.opens })}`;
}

export { FIGURES, stillOf, studioLinkOf, termOf };
