/** Figures for the build: their still pictures, the small ones of the glossary, and links to the studio. */
import { FIGURES, shownOf } from './draw/chapters';
import { stillOf } from './draw/still';
import { termOf } from './draw/terms';
import { studioWords } from './figure/address';
import type { Language } from './figures/figure';
import { expected } from './figures/words';

/** The studio's link with the state that a figure opens with. */
function studioLinkOf(name: string): string {
  const { figure } = shownOf(name);
  return `v=1&${studioWords(figure, { recipe: figure.recipe, step: figure.opens })}`;
}

/** The texts that a question may show when it is answered, each as its prediction and its sentence; none if the figure does not ask. */
function answersOf(name: string, key: string, language: Language): readonly (readonly [prediction: string, sentence: string])[] {
  return shownOf(name).figure.asks.filter((ask) => ask.key === key).flatMap((ask) => {
    const predictions = Object.keys(ask.answers).map((value) => expected(ask, value, language));
    return ask.longest(language).flatMap((sentence) => (predictions.length ? predictions : ['']).map((prediction) => [prediction, sentence] as const));
  });
}

export { answersOf, FIGURES, stillOf, studioLinkOf, termOf };
