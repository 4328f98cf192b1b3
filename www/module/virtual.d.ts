/** What the build puts together: see vite.config.mjs. */

declare module 'virtual:generators' {
  const made: {
    /** As `make=` in the link. */
    word: string;
    /** In English. */
    title: string;
    /** The place of the first module that has it. */
    module: number;
    /** The name of the preset whose picture stands for it. */
    preset: string;
    /** Parameters that go along from one generator to another: seed, light and weather. */
    carried: string[];
  }[];
  export default made;
}

/** The second module, which has all there is. */
declare module 'virtual:house' {
  const house: { packed: string; script: string };
  export default house;
}
