/** The figures of a chapter, loaded when the first of them comes near: a page has no code of other chapters' figures. */
import type { Drawings } from '../draw/plate';

const CHAPTERS: Readonly<Record<string, () => Promise<{ readonly drawings: Drawings }>>> = {
  'two-bubbles': () => import('../draw/of-two-bubbles'),
  'many-bubbles': () => import('../draw/of-many-bubbles'),
  mesh: () => import('../draw/of-mesh'),
  squares: () => import('../draw/of-squares'),
  'which-way': () => import('../draw/of-which-way'),
  'how-many': () => import('../draw/of-how-many'),
};

/** `undefined` if there is no such chapter, or no connection. */
export async function drawingsOf(chapter: string): Promise<Drawings | undefined> {
  return (await CHAPTERS[chapter]?.().catch(() => undefined))?.drawings;
}
