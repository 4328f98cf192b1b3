/** Modules that the build generates: see vite.config.mjs. */

declare module 'virtual:generators' {
  const made: {
    /** The word in `make=` of a link. */
    word: string;
    /** The English name. */
    title: string;
    /** The index of the first module that has it. */
    module: number;
    /** The preset whose picture represents it on the page. */
    preset: string;
    /** The link of that preset. */
    link: string;
    /** The parts of the page that serve it. */
    offers: string[];
  }[];
  export default made;
  /** The English notice about a link with an unknown generator, with places for words in braces. */
  export const unknown: string;
}

/** The second module, which can make everything. */
declare module 'virtual:house' {
  const house: { file: string; script: string };
  export default house;
}
