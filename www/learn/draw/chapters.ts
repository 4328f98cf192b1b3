/** All chapters with their figures, for the build. A page loads only its own chapter (`figure/chapters.ts`). */
import { drawings as howMany } from './of-how-many';
import { drawings as manyBubbles } from './of-many-bubbles';
import { drawings as mesh } from './of-mesh';
import { drawings as squares } from './of-squares';
import { drawings as twoBubbles } from './of-two-bubbles';
import { drawings as whichWay } from './of-which-way';
import { shownIn, type Shown } from './picture';
import type { Drawings } from './plate';

const CHAPTERS: Readonly<Record<string, Drawings>> = { 'two-bubbles': twoBubbles, 'many-bubbles': manyBubbles, mesh, squares, 'which-way': whichWay, 'how-many': howMany };

/** The figures of all chapters in their order. */
export const FIGURES = Object.values(CHAPTERS).flatMap(({ figures }) => figures);

/** A figure with its drawings, and the word of its chapter. */
export function shownOf(name: string): Shown & { readonly chapter: string } {
  for (const [chapter, drawings] of Object.entries(CHAPTERS)) {
    const shown = shownIn(drawings, name);
    if (shown) return { ...shown, chapter };
  }
  throw new Error(`There is no figure ${name}.`);
}
