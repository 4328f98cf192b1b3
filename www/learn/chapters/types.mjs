// The types of terms, papers and chapters.

/** A text in both languages. @typedef {{ en: string, ja: string }} Words */
/** A formula with its speech, or words. @typedef {{ math?: string, speech?: Words, text?: Words }} Side */
/**
 * A row of the page on papers, and where it can be seen: a state of a figure of its chapter, or of the studio.
 * @typedef {{ key: string, chapter?: string, isMisprint?: boolean, heading: Words, from: Words, printed: Side, ours: Side, note: Words, task?: { question: Words, answer: Words }, see: { link?: string, figure?: string, words: Words } }} Difference
 */
/** An entry of the glossary. @typedef {{ key: string, symbol?: string, chapter: string, name: Words, text: Words }} Term */

export {};
